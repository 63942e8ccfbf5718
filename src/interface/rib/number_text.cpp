// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/number_text.h"

#include "foundation/base/letters.h"

#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <utility>

namespace candela {

static std::optional<double> specialNumber(std::string text) {
    double sign = 1;
    if (text.starts_with('-') || text.starts_with('+')) {
        sign = text.front() == '-' ? -1 : 1;
        text.erase(0, 1);
    }
    text = inSmallLetters(std::move(text));
    if (text == "nan")
        return std::numeric_limits<double>::quiet_NaN();
    if (text == "inf" || text == "infinity")
        return sign * std::numeric_limits<double>::infinity();
    return std::nullopt;
}

static std::optional<double> valueOf(const std::string &word) {
    const char *begin = word.data() + word.starts_with('+'), *end = word.data() + word.size();
    double value = 0;
    auto [stop, error] = std::from_chars(begin, end, value);
    if (stop != end || begin == end || (word.starts_with('+') && *begin == '-'))
        return specialNumber(word);
    if (error == std::errc::result_out_of_range)
        return std::strtod(word.c_str(), nullptr); // Infinity or zero, as it may be.
    return error == std::errc() ? std::optional(value) : std::nullopt;
}

/// Of a word with that value.
static float singleOf(const std::string &word, double value) {
    const char *begin = word.data() + word.starts_with('+'), *end = word.data() + word.size();
    float single = 0;
    const auto [stop, error] = std::from_chars(begin, end, single);
    return error == std::errc() ? single : float(value);
}

std::optional<TextNumber> parseNumber(const std::string &word) {
    if (const auto value = valueOf(word))
        return TextNumber{*value, singleOf(word, *value),
                          word.find_first_not_of("+-0123456789") == std::string::npos};
    return std::nullopt;
}

namespace {

bool isDigit(char c) { return unsigned(c - '0') < 10; }

/// Digits as one integer, as far as that is exact in a double.
struct Digits {
    static constexpr int most = 15;
    std::int64_t value = 0;
    int count = 0; ///< Leading zeros left out.

    const char *take(const char *at, const char *end) {
        for (; at != end && isDigit(*at); ++at) {
            value = value * 10 + (*at - '0');
            count += count > 0 || *at != '0';
            if (count > most)
                return nullptr;
        }
        return at;
    }
};

/// It may lie on the other side of the middle between two floats than what it was rounded from; of
/// very small ones nothing is said.
bool roundsTwice(double magnitude) {
    constexpr std::uint64_t beyondFloat = (std::uint64_t(1) << 29) - 1, middle = 1 << 28;
    return (std::bit_cast<std::uint64_t>(magnitude) & beyondFloat) == middle ||
           (magnitude < std::numeric_limits<float>::min() && magnitude != 0);
}

} // namespace

const char *parsePlainNumber(const char *begin, const char *end, TextNumber &number) {
    // Exact in a double: quotients and products of two exact numbers are rounded once.
    static constexpr std::array<double, 23> powers = {
        1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
        1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
    const char *at = begin;
    const bool negative = at != end && *at == '-';
    at += negative;
    Digits digits;
    const char *const first = at;
    at = digits.take(at, end);
    if (!at || at == end)
        return nullptr;
    int exponent = 0, written = int(at - first);
    number.whole = *at != '.' && *at != 'e' && *at != 'E';
    if (*at == '.') {
        const char *const point = ++at;
        at = digits.take(at, end);
        if (!at || at == end)
            return nullptr;
        exponent = int(point - at);
        written -= exponent;
    }
    if (written == 0)
        return nullptr;
    if (*at == 'e' || *at == 'E') {
        ++at;
        const bool down = at != end && *at == '-';
        at += at != end && (*at == '-' || *at == '+');
        int power = 0;
        const char *const ten = at;
        for (; at != end && isDigit(*at) && power < 1000; ++at)
            power = power * 10 + (*at - '0');
        if (at == ten || at == end)
            return nullptr;
        exponent += down ? -power : power;
    }
    if (exponent < -22 || exponent > 22)
        return nullptr;
    const double value = double(digits.value);
    const double magnitude = exponent < 0 ? value / powers[std::size_t(-exponent)]
                                          : value * powers[std::size_t(exponent)];
    if (roundsTwice(magnitude))
        return nullptr;
    number.value = negative ? -magnitude : magnitude;
    number.single = float(number.value);
    return at;
}

} // namespace candela
