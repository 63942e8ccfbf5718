// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/condition.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <limits>
#include <regex.h>
#include <string_view>

namespace candela {

namespace {

/// Nothing: a name that is not set.
using Value = std::optional<StateValue>;

constexpr int maximumDepth = 200;

bool isLetter(char c) { return std::isalpha((unsigned char)c) || c == '_'; }
bool isNamePart(char c) { return isLetter(c) || std::isdigit((unsigned char)c) || c == ':'; }

bool holds(const Value &value) {
    if (!value)
        return false;
    const double *number = std::get_if<double>(&*value);
    return number ? *number != 0 : !std::get<std::string>(*value).empty();
}

std::string textOf(const Value &value) {
    if (!value)
        return {};
    if (const auto *text = std::get_if<std::string>(&*value))
        return *text;
    std::array<char, 32> digits;
    const double number = std::get<double>(*value);
    return {digits.data(), std::to_chars(digits.begin(), digits.end(), number).ptr};
}

/// Not-a-number for what is none, so that no comparison with it holds.
double numberOf(const Value &value) {
    const double *number = value ? std::get_if<double>(&*value) : nullptr;
    return number ? *number : std::numeric_limits<double>::quiet_NaN();
}

/// Whether a regular expression (POSIX, extended) is to be found in the text. What could take time
/// or memory without bound, back references and counted repetition, is none.
bool isFoundIn(const std::string &text, const std::string &expression) {
    regex_t compiled;
    const bool isSafe = expression.size() <= 1000 && expression.find('{') == std::string::npos &&
                        expression.find('\\') == std::string::npos;
    if (!isSafe || regcomp(&compiled, expression.c_str(), REG_EXTENDED | REG_NOSUB) != 0)
        throw ConditionError("'" + expression.substr(0, 40) + "' is no pattern");
    const bool found = regexec(&compiled, text.c_str(), 0, nullptr, 0) == 0;
    regfree(&compiled);
    return found;
}

Value compared(std::string_view how, const Value &a, const Value &b) {
    if (how == "=~")
        return double(a && isFoundIn(textOf(a), textOf(b)));
    if (how == "==" || how == "!=")
        return double((a && b && *a == *b) == (how == "=="));
    const bool texts = a && b && a->index() == 1 && b->index() == 1;
    const double x = texts ? double(textOf(a).compare(textOf(b))) : numberOf(a);
    const double y = texts ? 0 : numberOf(b);
    return double(how == "<" ? x < y : how == "<=" ? x <= y : how == ">" ? x > y : x >= y);
}

Value computed(std::string_view how, const Value &a, const Value &b) {
    const double x = numberOf(a), y = numberOf(b);
    return how == "+" ? x + y : how == "-" ? x - y : how == "*" ? x * y : x / y;
}

/// Operators of one precedence, from the weakest; longer ones before their beginnings.
constexpr std::array<std::array<std::string_view, 4>, 6> levels{
    {{"||"}, {"&&"}, {"==", "!=", "=~"}, {"<=", ">=", "<", ">"}, {"+", "-"}, {"*", "/"}}};

/// By descent. What does not count (the right of "0 &&") is read all the same.
class Evaluation {
public:
    Evaluation(std::string_view text, const ConditionNames &names) : text_(text), names_(names) {}

    bool run() {
        const Value value = binary(0);
        if (!atEnd())
            fail("the end or an operator");
        return holds(value);
    }

private:
    bool atEnd() {
        while (at_ < text_.size() && std::isspace((unsigned char)text_[at_]))
            ++at_;
        return at_ == text_.size();
    }
    bool take(std::string_view word) {
        if (atEnd() || !text_.substr(at_).starts_with(word))
            return false;
        at_ += word.size();
        return true;
    }
    void expect(std::string_view word) {
        if (!take(word))
            fail("'" + std::string(word) + "'");
    }
    [[noreturn]] void fail(const std::string &what) {
        const std::string found =
            atEnd() ? "the end" : "'" + std::string(text_.substr(at_, 20)) + "'";
        throw ConditionError("expected " + what + ", found " + found);
    }

    Value binary(std::size_t level) {
        if (level == levels.size())
            return unary();
        Value left = binary(level + 1);
        for (;;) {
            const auto found = std::ranges::find_if(
                levels[level], [&](std::string_view word) { return !word.empty() && take(word); });
            if (found == levels[level].end())
                return left;
            const Value right = binary(level + 1);
            left = level == 0   ? double(holds(left) || holds(right))
                   : level == 1 ? double(holds(left) && holds(right))
                   : level <= 3 ? compared(*found, left, right)
                                : computed(*found, left, right);
        }
    }

    Value unary() {
        if (++depth_ > maximumDepth)
            throw ConditionError("it is nested more than " + std::to_string(maximumDepth) +
                                 " deep");
        Value value;
        if (take("!"))
            value = double(!holds(unary()));
        else if (take("-"))
            value = -numberOf(unary());
        else
            value = primary();
        --depth_;
        return value;
    }

    Value primary() {
        if (take("("))
            return closed(binary(0));
        if (take("$"))
            return names_(name());
        if (take("defined"))
            return defined();
        if (take("concat"))
            return concatenated();
        if (atEnd())
            fail("a value");
        const char c = text_[at_];
        if (c == '\'' || c == '"')
            return quoted(c);
        return number();
    }

    Value closed(Value value) {
        expect(")");
        return value;
    }

    /// Behind a '$'.
    std::string name() {
        if (take("("))
            return textOf(closed(binary(0)));
        const bool braces = take("{");
        if (atEnd() || !isLetter(text_[at_]))
            fail("the name of an option or attribute");
        const std::size_t begin = at_;
        while (at_ < text_.size() && isNamePart(text_[at_]))
            ++at_;
        std::string result(text_.substr(begin, at_ - begin));
        if (braces)
            expect("}");
        return result;
    }

    Value defined() {
        expect("(");
        take("$");
        return closed(double(names_(name()).has_value()));
    }

    Value concatenated() {
        expect("(");
        std::string all = textOf(binary(0));
        while (take(","))
            all += textOf(binary(0));
        return closed(all);
    }

    Value quoted(char quote) {
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == std::string_view::npos)
            fail("a string with its closing quote");
        std::string value(text_.substr(at_ + 1, end - at_ - 1));
        at_ = end + 1;
        return value;
    }

    Value number() {
        double value = 0;
        const char *begin = text_.data() + at_;
        const auto [end, error] = std::from_chars(begin, text_.data() + text_.size(), value);
        if (error != std::errc())
            fail("a value");
        at_ += std::size_t(end - begin);
        return value;
    }

    std::string_view text_;
    const ConditionNames &names_;
    std::size_t at_ = 0;
    int depth_ = 0;
};

} // namespace

bool conditionHolds(const std::string &expression, const ConditionNames &names) {
    return Evaluation(expression, names).run();
}

} // namespace candela
