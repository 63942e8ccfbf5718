// SPDX-License-Identifier: Apache-2.0
#include "render/probe_points.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <unistd.h>

namespace candela {

namespace {

constexpr std::size_t bytesAtOnce = 1 << 16;
/// The squares of such coordinates are floats.
constexpr double farthest = 1e15;

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r'; }
bool isComma(char c) { return c == ',' || c == ';'; }

/// The numbers of a line, one after the other.
class NumberReader {
public:
    explicit NumberReader(std::string_view line) : line_(line) { skipBlanks(); }

    bool atEnd() const { return at_ == line_.size(); }
    std::size_t at() const { return at_; }
    /// Nothing, and the place stays, if there is none.
    std::optional<double> next() {
        std::size_t from = at_;
        from += from < line_.size() && line_[from] == '+';
        double value = 0;
        const char *end = line_.data() + line_.size();
        const auto [rest, error] = std::from_chars(line_.data() + from, end, value);
        if (error == std::errc::invalid_argument ||
            (rest != end && !isBlank(*rest) && !isComma(*rest)))
            return std::nullopt;
        if (error == std::errc::result_out_of_range)
            value = INFINITY;
        at_ = std::size_t(rest - line_.data());
        skipBlanks();
        if (!atEnd() && isComma(line_[at_])) {
            ++at_;
            skipBlanks();
        }
        return value;
    }

private:
    void skipBlanks() {
        while (at_ < line_.size() && isBlank(line_[at_]))
            ++at_;
    }

    std::string_view line_;
    std::size_t at_ = 0;
};

/// A row of names over the columns.
bool namesColumns(std::string_view line) {
    return std::ranges::any_of(line, isComma) &&
           std::ranges::any_of(line, [](unsigned char c) { return std::isalpha(c) != 0; });
}

PointLine flawed(std::string flaw, std::size_t at) {
    return {PointLine::Kind::Flawed, {}, std::move(flaw), int(at) + 1};
}

} // namespace

std::optional<std::string_view> LineReader::next() {
    line_.clear();
    bool any = false, ended = false;
    while (!ended && (at_ < buffer_.size() || fill())) {
        const std::size_t newline = buffer_.find('\n', at_);
        const std::size_t end = std::min(newline, buffer_.size());
        const std::size_t room = longestLine - std::min(longestLine, line_.size());
        line_.append(buffer_, at_, std::min(end - at_, room));
        any = true;
        ended = newline != std::string::npos;
        at_ = ended ? newline + 1 : buffer_.size();
    }
    if (!any)
        return std::nullopt;
    ++number_;
    return line_;
}

bool LineReader::fill() {
    buffer_.resize(bytesAtOnce);
    ssize_t got;
    do
        got = read(file_, buffer_.data(), buffer_.size());
    while (got < 0 && errno == EINTR);
    if (got < 0)
        problem_ = std::strerror(errno);
    buffer_.resize(std::size_t(std::max<ssize_t>(0, got)));
    at_ = 0;
    return got > 0;
}

PointLine readPointLine(std::string_view line, int number) {
    constexpr const char *expected =
        "expected six numbers, a point and a direction: x y z dx dy dz";
    NumberReader numbers(line);
    if (numbers.atEnd() || line[numbers.at()] == '#')
        return {};
    std::array<double, 6> six{};
    for (std::size_t k = 0; k < six.size(); ++k) {
        const std::size_t at = numbers.at();
        if (numbers.atEnd())
            return flawed(fmt::format("{}; there are {}", expected, k), at);
        const std::optional<double> value = numbers.next();
        if (!value && number == 1 && namesColumns(line))
            return {};
        if (!value)
            return flawed(fmt::format("{}; this is no number", expected), at);
        if (!std::isfinite(*value) || std::fabs(*value) > farthest)
            return flawed(fmt::format("expected a number within {:g}", farthest), at);
        six[k] = *value;
    }
    if (!numbers.atEnd())
        return flawed(fmt::format("{}; this is one too many", expected), numbers.at());
    PointLine result{PointLine::Kind::Point,
                     {{six[0], six[1], six[2]}, {six[3], six[4], six[5]}, number},
                     {},
                     0};
    if (six[3] == 0 && six[4] == 0 && six[5] == 0)
        return flawed("the direction is 0 0 0: give the normal of the sensor, or where the ray "
                      "goes",
                      0);
    return result;
}

} // namespace candela
