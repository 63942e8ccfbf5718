// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/regular_expression_tree.h"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace candela::ir {
namespace {

using Node = RegularExpressionNode;
using Bytes = RegularExpression::Bytes;

constexpr int nestingLimit = 100;
constexpr int countLimit = 255; // POSIX: RE_DUP_MAX.

struct CharacterClass {
    std::string_view name;
    int (*holds)(int);
};

constexpr CharacterClass classes[] = {
    {"alpha", std::isalpha}, {"digit", std::isdigit}, {"alnum", std::isalnum},
    {"upper", std::isupper}, {"lower", std::islower}, {"space", std::isspace},
    {"blank", std::isblank}, {"punct", std::ispunct}, {"print", std::isprint},
    {"graph", std::isgraph}, {"cntrl", std::iscntrl}, {"xdigit", std::isxdigit}};

class Parser {
public:
    explicit Parser(const std::string &pattern) : pattern_(pattern) {}

    std::optional<Node> run() {
        Node result = choice();
        if (at_ < pattern_.size())
            failed_ = true;
        return failed_ ? std::nullopt : std::optional(std::move(result));
    }

private:
    bool atEnd() const { return failed_ || at_ >= pattern_.size(); }
    bool at(std::string_view text) const {
        return !atEnd() && std::string_view(pattern_).substr(at_).starts_with(text);
    }
    bool accept(std::string_view text) {
        const bool is = at(text);
        at_ += is ? text.size() : 0;
        return is;
    }
    unsigned char take() {
        if (atEnd()) {
            failed_ = true;
            return 0;
        }
        return (unsigned char)pattern_[at_++];
    }

    Node choice() {
        Node result{Node::Kind::Choice, {}, {}};
        do
            result.parts.push_back(sequence());
        while (accept("|"));
        return result;
    }

    Node sequence() {
        Node result{Node::Kind::Sequence, {}, {}};
        while (!atEnd() && !at("|") && !at(")"))
            result.parts.push_back(repeated());
        return result;
    }

    Node repeated() {
        Node body = single();
        Node result{Node::Kind::Repeat, {}, {}};
        if (accept("*"))
            result.least = 0;
        else if (accept("+"))
            result.least = 1;
        else if (accept("?"))
            result.most = 1;
        else if (accept("{"))
            counts(result);
        else
            return body;
        result.parts.push_back(std::move(body));
        return result;
    }

    /// n}, n,} or n,m}
    void counts(Node &repeat) {
        repeat.least = repeat.most = count();
        if (accept(","))
            repeat.most = at("}") ? Node::unbounded : count();
        const bool ordered = repeat.most == Node::unbounded || repeat.least <= repeat.most;
        if (!accept("}") || !ordered)
            failed_ = true;
    }

    int count() {
        int result = 0;
        const size_t first = at_;
        while (!atEnd() && std::isdigit((unsigned char)pattern_[at_]) && result <= countLimit)
            result = result * 10 + (take() - '0');
        failed_ |= at_ == first || result > countLimit;
        return result;
    }

    Node single() {
        if (accept("("))
            return group();
        if (accept("["))
            return {Node::Kind::Bytes, bracket(), {}};
        if (accept("^"))
            return {Node::Kind::AtStart, {}, {}};
        if (accept("$"))
            return {Node::Kind::AtEnd, {}, {}};
        Node result{Node::Kind::Bytes, {}, {}};
        if (accept(".")) {
            result.bytes.set();
            return result;
        }
        failed_ |= at("*") || at("+") || at("?") || at("{"); // They repeat nothing.
        accept("\\");
        result.bytes.set(take());
        return result;
    }

    Node group() {
        failed_ |= ++depth_ > nestingLimit;
        Node result = choice();
        --depth_;
        failed_ |= !accept(")");
        return result;
    }

    /// Behind the '['. A ']' that stands first is one of the letters.
    Bytes bracket() {
        const bool others = accept("^");
        Bytes result;
        do {
            if (accept("[:"))
                result |= characterClass();
            else
                result |= range();
        } while (!atEnd() && !at("]"));
        failed_ |= !accept("]");
        return others ? ~result : result;
    }

    Bytes characterClass() {
        for (const CharacterClass &candidate : classes)
            if (accept(std::string(candidate.name) + ":]")) {
                Bytes result;
                for (int byte = 0; byte < 128; ++byte)
                    result[size_t(byte)] = candidate.holds(byte) != 0;
                return result;
            }
        failed_ = true;
        return {};
    }

    Bytes range() {
        failed_ |= at("[.") || at("[="); // Collation is a matter of locales, which shaders lack.
        const int first = take();
        const bool more = at("-") && at_ + 1 < pattern_.size() && pattern_[at_ + 1] != ']';
        const int last = more && accept("-") ? take() : first;
        failed_ |= last < first;
        Bytes result;
        for (int byte = first; byte <= last; ++byte)
            result.set(size_t(byte));
        return result;
    }

    const std::string &pattern_;
    size_t at_ = 0;
    int depth_ = 0;
    bool failed_ = false;
};

} // namespace

std::optional<RegularExpressionNode> parseRegularExpression(const std::string &pattern) {
    return Parser(pattern).run();
}

} // namespace candela::ir
