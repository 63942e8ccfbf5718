// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/lexer.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <utility>

namespace candela::sl {
namespace {

// Longest first, so that the first that fits is the right one. Some serve the preprocessor alone.
constexpr const char *punctuators[] = {
    "==", "!=", "<=", ">=", "&&", "||", "+=", "-=", "*=", "/=", "->", "##", "<<",
    ">>", "(",  ")",  "[",  "]",  "{",  "}",  ",",  ";",  ":",  "?",  ".",  "+",
    "-",  "*",  "/",  "^",  "=",  "<",  ">",  "!",  "#",  "%",  "&",  "|",  "~"};

/// Beyond so many flaws this is no text; the rest is not looked at.
constexpr int flawLimit = 10'000;

bool isLetter(char c) { return std::isalpha((unsigned char)c) && (unsigned char)c < 128; }
bool isDigit(char c) { return c >= '0' && c <= '9'; }
bool isWordPart(char c) { return c == '_' || isLetter(c) || isDigit(c); }

class Lexer {
public:
    Lexer(SourceFile &file, Reporter &reporter)
        : file_(file), reporter_(reporter), text_(file.text()) {
        skipJoints();
    }

    std::vector<Token> run() {
        std::vector<Token> tokens;
        while (true) {
            skipSpace();
            if (atEnd())
                break;
            if (flaws_ > flawLimit) {
                reporter_.error(here(), "so much of this file is unreadable that the rest is not "
                                        "looked at");
                break;
            }
            tokens.push_back(next());
        }
        Token end;
        end.where = here();
        end.startsLine = true;
        tokens.push_back(end);
        return tokens;
    }

private:
    bool atEnd() const { return at_ >= text_.size(); }
    char peek(size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    Place here() const { return {&file_, line_, column_, 1}; }

    void step() {
        if (text_[at_] == '\n') {
            ++line_;
            column_ = 1;
        } else {
            ++column_;
        }
        ++at_;
    }

    // A backslash at the end of a line makes one line of two, even inside a word. Blanks behind it
    // can't be seen, so they don't count.
    void skipJoints() {
        while (peek() == '\\') {
            size_t lineEnd = text_.find_first_not_of(" \t\v\f", at_ + 1);
            if (lineEnd == text_.npos || text_[lineEnd] != '\n')
                return;
            while (at_ <= lineEnd)
                step();
        }
    }

    void advance() {
        step();
        skipJoints();
    }

    void skipSpace() {
        while (!atEnd()) {
            char c = peek();
            if (c == '\n')
                startsLine_ = true;
            if (c == ' ' || c == '\t' || c == '\n' || c == '\f' || c == '\v') {
                space_ = true;
                advance();
            } else if (c == '/' && peek(1) == '/') {
                lineComment();
            } else if (c == '/' && peek(1) == '*') {
                blockComment();
            } else {
                return;
            }
        }
    }

    void keepComment(int firstLine, std::string text) {
        auto blank = [](char c) { return std::isspace((unsigned char)c) || c == '*' || c == '/'; };
        auto first = std::find_if_not(text.begin(), text.end(), blank);
        auto last = std::find_if_not(text.rbegin(), text.rend(), blank).base();
        if (first < last)
            file_.comments.push_back({firstLine, line_, std::string(first, last)});
    }

    void lineComment() {
        int firstLine = line_;
        std::string text;
        while (!atEnd() && peek() != '\n') {
            text += peek();
            advance();
        }
        keepComment(firstLine, text);
        space_ = true;
    }

    // As good as a blank: its line ends end neither a line nor a directive.
    void blockComment() {
        Place start = here();
        start.length = 2;
        std::string text;
        advance();
        advance();
        while (!atEnd() && !(peek() == '*' && peek(1) == '/')) {
            text += peek();
            advance();
        }
        space_ = true;
        if (atEnd()) {
            reporter_.error(start, "comment is not closed; expected '*/' before the end of file");
            return;
        }
        advance();
        advance();
        keepComment(start.line, text);
    }

    Token next() {
        Token token;
        token.where = here();
        token.startsLine = std::exchange(startsLine_, false);
        token.spaceBefore = std::exchange(space_, false);
        char c = peek();
        if (c == '_' || isLetter(c))
            word(token);
        else if (isDigit(c) || (c == '.' && isDigit(peek(1))))
            number(token);
        else if (c == '"')
            string(token);
        else
            punctuator(token);
        bool sameLine = token.where.line == line_;
        token.where.length = sameLine ? std::max(1, column_ - token.where.column) : 1;
        return token;
    }

    void mark(Token &token, const Place &where, std::string message) {
        ++flaws_;
        token.flaw = std::make_shared<Flaw>(where, std::move(message));
    }

    void take(Token &token) {
        token.spelling += peek();
        advance();
    }

    void word(Token &token) {
        token.kind = TokenKind::Identifier;
        while (isWordPart(peek()))
            take(token);
    }

    void digits(Token &token) {
        while (isDigit(peek()))
            take(token);
    }

    void number(Token &token) {
        token.kind = TokenKind::Number;
        digits(token);
        if (peek() == '.')
            take(token);
        digits(token);
        bool sign = peek(1) == '+' || peek(1) == '-';
        if ((peek() == 'e' || peek() == 'E') && isDigit(peek(sign ? 2 : 1))) {
            take(token);
            if (sign)
                take(token);
            digits(token);
        }
        const std::string &s = token.spelling;
        auto [end, error] = std::from_chars(s.data(), s.data() + s.size(), token.number);
        if (error == std::errc::result_out_of_range && token.number == 0)
            token.number = s.find("e-") != s.npos || s.find("E-") != s.npos ? 0 : HUGE_VAL;
        if ((peek() == 'f' || peek() == 'F') && !isWordPart(peek(1)))
            take(token); // 0.5f, as in C.
        if (isWordPart(peek())) {
            Place where = here();
            while (isWordPart(peek()))
                advance();
            where.length = std::max(1, column_ - where.column);
            mark(token, where,
                 "letters stand directly after the number " + s +
                     "; expected an operator between them");
        }
    }

    void string(Token &token) {
        token.kind = TokenKind::Text;
        take(token);
        while (!atEnd() && peek() != '"' && peek() != '\n') {
            if (peek() == '\\')
                escape(token);
            else {
                token.text += peek();
                take(token);
            }
        }
        if (peek() != '"') {
            mark(token, token.where,
                 "string is not closed; expected '\"' before the end of the line");
            return;
        }
        take(token);
    }

    void escape(Token &token) {
        take(token);
        char c = peek();
        if (c >= '0' && c <= '7') {
            int value = 0;
            for (int i = 0; i < 3 && peek() >= '0' && peek() <= '7'; ++i) {
                value = value * 8 + (peek() - '0');
                take(token);
            }
            token.text += char(value);
            return;
        }
        if (atEnd() || c == '\n')
            return;
        static constexpr std::string_view letters = "nrtbf", meanings = "\n\r\t\b\f";
        size_t found = letters.find(c);
        token.text += found == letters.npos ? c : meanings[found];
        take(token);
    }

    bool fits(const char *punctuator) const {
        return peek() == punctuator[0] && (!punctuator[1] || peek(1) == punctuator[1]);
    }

    void punctuator(Token &token) {
        token.kind = TokenKind::Punctuator;
        for (const char *candidate : punctuators) {
            if (!fits(candidate))
                continue;
            take(token);
            if (candidate[1])
                take(token);
            return;
        }
        unsigned char c = (unsigned char)peek();
        std::string what = std::isprint(c) ? std::string("'") + char(c) + "'"
                                           : "with code " + std::to_string(int(c));
        mark(token, token.where, "stray character " + what + " outside of a string or comment");
        token.kind = TokenKind::Stray;
        take(token);
    }

    SourceFile &file_;
    Reporter &reporter_;
    const std::string &text_;
    size_t at_ = 0;
    int line_ = 1, column_ = 1;
    int flaws_ = 0;
    bool startsLine_ = true;
    bool space_ = false;
};

} // namespace

std::vector<Token> tokenize(SourceFile &file, Reporter &reporter) {
    return Lexer(file, reporter).run();
}

} // namespace candela::sl
