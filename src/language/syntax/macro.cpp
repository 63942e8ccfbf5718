// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/macro.h"

#include <algorithm>

#include "language/syntax/lexer.h"

namespace candela::sl {

// A few macros that call each other twice can ask for 2^n tokens; arguments can nest for ever.
static constexpr size_t tokenBudget = 200'000;
static constexpr size_t namesAToken = 16; // A long chain of macros copies ever more hidden names.
static constexpr int depthLimit = 64;

const Token &TokenStream::peek() const {
    if (!front_.empty())
        return front_.back();
    return at_ < tokens_.size() ? tokens_[at_] : end_;
}

Token TokenStream::take() {
    if (!front_.empty()) {
        Token token = std::move(front_.back());
        front_.pop_back();
        return token;
    }
    if (at_ >= tokens_.size())
        return end_;
    return tokens_[at_].kind == TokenKind::End ? tokens_[at_] : tokens_[at_++];
}

void TokenStream::putBack(const std::vector<Token> &tokens) {
    front_.insert(front_.end(), tokens.rbegin(), tokens.rend());
}

bool MacroTable::overBudget(const Place &where, size_t more) {
    produced_ += more;
    if (produced_ > tokenBudget)
        reporter_.error(where, "macros expand to too many words");
    return produced_ > tokenBudget;
}

// No token that came out of a macro calls that macro again. Tokens of one origin share their set.
static void hide(std::vector<Token> &tokens, const Token &name) {
    using Names = std::set<std::string>;
    std::map<const Names *, std::shared_ptr<const Names>> extended;
    for (Token &token : tokens) {
        auto &set = extended[token.hidden.get()];
        if (!set) {
            auto names = std::make_shared<Names>(token.hidden ? *token.hidden : Names());
            if (name.hidden)
                names->insert(name.hidden->begin(), name.hidden->end());
            names->insert(name.spelling);
            set = std::move(names);
        }
        token.hidden = set;
        token.startsLine = false;
    }
}

/// What __LINE__ or __FILE__ stands for: out of a macro, the place where that was used.
static Token placeOf(const Token &name) {
    Token result;
    result.where = name.where;
    result.spaceBefore = name.spaceBefore;
    if (name.spelling == "__LINE__") {
        result.kind = TokenKind::Number;
        result.number = name.where.line;
        result.spelling = std::to_string(name.where.line);
        return result;
    }
    result.kind = TokenKind::Text;
    result.text = name.where.file->name();
    for (char c : result.text)
        result.spelling += (c == '"' || c == '\\' ? "\\" : "") + std::string(1, c);
    result.spelling = '"' + result.spelling + '"';
    return result;
}

bool MacroTable::expand(const Token &name, TokenStream &stream) {
    if (name.isIdentifier() && isOfPlace(name.spelling)) {
        if (!overBudget(name.where, 1))
            stream.putBack({placeOf(name)});
        return true;
    }
    auto found = name.isIdentifier() ? macros_.find(name.spelling) : macros_.end();
    if (found == macros_.end() || (name.hidden && name.hidden->contains(name.spelling)))
        return false;
    const Macro &macro = found->second;
    if (macro.takesArguments && !stream.peek().is("("))
        return false;
    Arguments arguments;
    if (macro.takesArguments) {
        auto collected = collectArguments(name, macro, stream);
        if (!collected)
            return true; // Reported; the call is dropped.
        arguments = std::move(*collected);
    }
    std::vector<Token> result = substitute(name, macro, arguments);
    const size_t hidden = name.hidden ? name.hidden->size() : 0;
    if (overBudget(name.where, result.size() + 1 + hidden / namesAToken))
        return true;
    hide(result, name);
    if (!result.empty())
        result.front().spaceBefore = name.spaceBefore;
    stream.putBack(result);
    return true;
}

std::optional<MacroTable::Arguments>
MacroTable::collectArguments(const Token &name, const Macro &macro, TokenStream &stream) {
    stream.take(); // (
    Arguments arguments(1);
    for (int depth = 0;;) {
        Token token = stream.take();
        if (token.kind == TokenKind::End) {
            reporter_.error(name.where,
                            "call of macro " + name.spelling + " is not closed; expected ')'");
            return std::nullopt;
        }
        if (depth == 0 && token.is(")"))
            break;
        if (depth == 0 && token.is(",")) {
            arguments.emplace_back();
            continue;
        }
        depth += token.is("(") - token.is(")");
        arguments.back().push_back(std::move(token));
    }
    if (macro.parameters.empty() && arguments.size() == 1 && arguments[0].empty())
        arguments.clear();
    if (arguments.size() != macro.parameters.size()) {
        reporter_.error(name.where, "macro " + name.spelling + " takes " +
                                        std::to_string(macro.parameters.size()) +
                                        " arguments, but is given " +
                                        std::to_string(arguments.size()));
        return std::nullopt;
    }
    return arguments;
}

static Token quoted(const std::vector<Token> &tokens, const Place &where) {
    Token result;
    result.kind = TokenKind::Text;
    result.where = where;
    for (size_t i = 0; i < tokens.size(); ++i)
        result.text += (i && tokens[i].spaceBefore ? " " : "") + tokens[i].spelling;
    result.spelling = '"' + result.text + '"';
    return result;
}

void MacroTable::paste(std::vector<Token> &left, const std::vector<Token> &right,
                       const Place &where) {
    if (left.empty() || right.empty()) {
        left.insert(left.end(), right.begin(), right.end());
        return;
    }
    std::string spelling = left.back().spelling + right.front().spelling;
    SourceFile scratch("", spelling);
    std::vector<Token> tokens = tokenize(scratch, reporter_);
    if (tokens.size() != 2 || tokens[0].flaw) {
        reporter_.error(where, "'##' makes '" + spelling + "', which is not one word");
        return;
    }
    tokens[0].where = where;
    left.back() = tokens[0];
    left.insert(left.end(), right.begin() + 1, right.end());
}

std::vector<Token> MacroTable::substitute(const Token &name, const Macro &macro,
                                          const Arguments &arguments) {
    auto parameterAt = [&](size_t i) -> const std::vector<Token> * {
        if (i >= macro.body.size() || !macro.body[i].isIdentifier())
            return nullptr;
        auto found = std::ranges::find(macro.parameters, macro.body[i].spelling);
        return found == macro.parameters.end()
                   ? nullptr
                   : &arguments[size_t(found - macro.parameters.begin())];
    };
    std::vector<Token> result;
    bool pasting = false;
    for (size_t i = 0; i < macro.body.size(); ++i) {
        const Token &token = macro.body[i];
        if (token.is("##") && i > 0 && i + 1 < macro.body.size()) {
            pasting = true;
            continue;
        }
        std::vector<Token> piece{token};
        const std::vector<Token> *argument = parameterAt(i);
        if (macro.takesArguments && token.is("#") && parameterAt(i + 1)) {
            piece = {quoted(*parameterAt(i + 1), name.where)};
            ++i;
        } else if (argument) {
            bool raw = pasting || (i + 1 < macro.body.size() && macro.body[i + 1].is("##"));
            piece = raw ? *argument : expandAll(*argument);
            if (!piece.empty())
                piece[0].spaceBefore = token.spaceBefore;
        } else {
            piece[0].where = name.where;
        }
        if (pasting)
            paste(result, piece, name.where);
        else
            result.insert(result.end(), piece.begin(), piece.end());
        pasting = false;
        if (overBudget(name.where, piece.size()))
            return {};
    }
    return result;
}

std::vector<Token> MacroTable::expandAll(std::vector<Token> tokens) {
    if (tokens.empty())
        return tokens;
    if (depth_ >= depthLimit) {
        reporter_.error(tokens.front().where,
                        "macro calls are nested more than " + std::to_string(depthLimit) + " deep");
        return {};
    }
    ++depth_;
    TokenStream stream(std::move(tokens));
    std::vector<Token> result;
    while (stream.peek().kind != TokenKind::End) {
        Token token = stream.take();
        if (!expand(token, stream))
            result.push_back(std::move(token));
    }
    --depth_;
    return result;
}

} // namespace candela::sl
