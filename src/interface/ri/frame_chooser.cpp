// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/frame_chooser.h"

#include <charconv>

namespace candela {

std::optional<FrameNumbers> parseFrameNumbers(const std::string &text) {
    FrameNumbers numbers;
    const char *at = text.data(), *const end = at + text.size();
    const auto number = [&](int &value) {
        const auto [stop, error] = std::from_chars(at, end, value);
        at = stop;
        return error == std::errc();
    };
    do {
        std::pair<int, int> range;
        if (!number(range.first))
            return std::nullopt;
        range.second = range.first;
        if (at < end && *at == '-' && (++at, !number(range.second)))
            return std::nullopt;
        if (range.second < range.first)
            return std::nullopt;
        numbers.push_back(range);
    } while (at < end && *at++ == ',');
    return at == end && text.back() != ',' ? std::optional(numbers) : std::nullopt;
}

FrameChooser::FrameChooser(RequestSink &sink, FrameNumbers wanted)
    : ForwardingSink(sink), wanted_(std::move(wanted)), found_(wanted_.size()) {}

void FrameChooser::frameBegin(const SourceLocation &where, int number) {
    isSkipping_ = true;
    for (std::size_t k = 0; k < wanted_.size(); ++k)
        if (number >= wanted_[k].first && number <= wanted_[k].second)
            found_[k] = true, isSkipping_ = false;
    ForwardingSink::frameBegin(where, number);
}

bool FrameChooser::admits(RequestId request) {
    const bool skipped = isSkipping_;
    if (request == RequestId::FrameEnd)
        isSkipping_ = false;
    return !skipped;
}

FrameNumbers FrameChooser::missing() const {
    FrameNumbers missing;
    for (std::size_t k = 0; k < wanted_.size(); ++k)
        if (!found_[k])
            missing.push_back(wanted_[k]);
    return missing;
}

} // namespace candela
