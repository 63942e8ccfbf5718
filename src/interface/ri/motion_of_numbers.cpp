// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/motion_of_numbers.h"

#include <cmath>

namespace candela {

KnotPlace placeAmong(const std::vector<double> &times, double time) {
    const auto later = std::ranges::upper_bound(times, time);
    const std::size_t next = std::size_t(later - times.begin());
    if (next == 0)
        return {};
    if (next == times.size())
        return {next - 1, next - 1, 0};
    const double begin = times[next - 1];
    return {next - 1, next, (time - begin) / (times[next] - begin)};
}

int stepsThrough(const std::vector<double> &times, double open, double close) {
    constexpr int most = 32;
    for (int steps = 1; steps < most; ++steps) {
        const bool meetsAll = std::ranges::all_of(times, [&](double time) {
            const double place = (time - open) / (close - open) * steps;
            return !(place > 0 && place < steps) || std::fabs(place - std::round(place)) < 1e-3;
        });
        if (meetsAll)
            return steps;
    }
    return most;
}

} // namespace candela
