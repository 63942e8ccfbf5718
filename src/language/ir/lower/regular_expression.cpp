// SPDX-License-Identifier: Apache-2.0
// Thompson's construction: all states that the machine may be in go through the subject together.
#include "language/ir/lower/regular_expression.h"

#include "language/ir/lower/regular_expression_tree.h"

#include <utility>

namespace candela::ir {
namespace {

using Kind = RegularExpression::Kind;
using State = RegularExpression::State;
using Node = RegularExpressionNode;

/// Lays the tree out as states, each part leading to the one behind it. Repetitions are written
/// out, so nested ones multiply: a budget stops them.
class Layout {
public:
    static constexpr int budget = 4000;

    bool add(const Node &node) {
        if (++steps_ > budget)
            return false;
        switch (node.kind) {
        case Node::Kind::Bytes: return append(Kind::Bytes, node.bytes);
        case Node::Kind::AtStart: return append(Kind::AtStart);
        case Node::Kind::AtEnd: return append(Kind::AtEnd);
        case Node::Kind::Sequence:
            for (const Node &part : node.parts)
                if (!add(part))
                    return false;
            return true;
        case Node::Kind::Choice: return addChoice(node);
        case Node::Kind::Repeat: return addRepeat(node);
        }
        return false;
    }

    std::vector<State> finish() {
        append(Kind::Found);
        return std::move(states_);
    }

private:
    int end() const { return int(states_.size()); }

    bool append(Kind kind, const RegularExpression::Bytes &bytes = {}) {
        states_.push_back({kind, bytes, end() + 1, end() + 1});
        return true;
    }

    bool addChoice(const Node &node) {
        std::vector<int> exits;
        for (size_t i = 0; i < node.parts.size(); ++i) {
            const bool last = i + 1 == node.parts.size();
            const int fork = end();
            if (!last)
                append(Kind::Fork);
            if (!add(node.parts[i]))
                return false;
            if (last)
                break;
            exits.push_back(end());
            append(Kind::Fork);
            states_[fork].second = end();
        }
        for (int exit : exits)
            states_[exit].next = states_[exit].second = end();
        return true;
    }

    bool addRepeat(const Node &node) {
        for (int i = 0; i < node.least; ++i)
            if (!add(node.parts[0]))
                return false;
        if (node.most == Node::unbounded)
            return addLoop(node.parts[0]);
        std::vector<int> exits;
        for (int i = node.least; i < node.most; ++i) {
            exits.push_back(end());
            append(Kind::Fork);
            if (!add(node.parts[0]))
                return false;
        }
        for (int exit : exits)
            states_[exit].second = end();
        return true;
    }

    bool addLoop(const Node &body) {
        const int fork = end();
        append(Kind::Fork);
        if (!add(body))
            return false;
        append(Kind::Fork);
        states_.back().next = states_.back().second = fork;
        states_[fork].second = end();
        return true;
    }

    std::vector<State> states_;
    int steps_ = 0;
};

/// The states that read the next byte, each once.
class Front {
public:
    Front(const std::vector<State> &states) : states_(states), seen_(states.size(), -1) {}

    /// Enters a state and all that follow it without reading, at that place of the subject.
    void enter(int first, int place, int length) {
        open_.push_back(first);
        while (!open_.empty()) {
            const int at = open_.back();
            open_.pop_back();
            if (seen_[at] == place)
                continue;
            seen_[at] = place;
            const State &state = states_[at];
            found_ |= state.kind == Kind::Found;
            if (state.kind == Kind::Bytes)
                reading_.push_back(at);
            if (state.kind == Kind::Fork)
                open_.push_back(state.second);
            if (state.kind == Kind::Fork || (state.kind == Kind::AtStart && place == 0) ||
                (state.kind == Kind::AtEnd && place == length))
                open_.push_back(state.next);
        }
    }

    bool found() const { return found_; }
    std::vector<int> takeReading() { return std::exchange(reading_, {}); }

private:
    const std::vector<State> &states_;
    std::vector<int> seen_; ///< At which place of the subject a state was entered last.
    std::vector<int> open_, reading_;
    bool found_ = false;
};

} // namespace

std::optional<RegularExpression> RegularExpression::parse(const std::string &pattern) {
    const std::optional<Node> tree = parseRegularExpression(pattern);
    Layout layout;
    if (!tree || !layout.add(*tree))
        return std::nullopt;
    RegularExpression result;
    result.states_ = layout.finish();
    return result;
}

bool RegularExpression::foundIn(const std::string &subject) const {
    const int length = int(subject.size());
    Front front(states_);
    for (int place = 0;; ++place) {
        front.enter(0, place, length); // A match may begin at each place.
        if (front.found() || place == length)
            return front.found();
        const auto byte = (unsigned char)subject[place];
        for (int at : front.takeReading())
            if (states_[at].bytes[byte])
                front.enter(states_[at].next, place + 1, length);
    }
}

} // namespace candela::ir
