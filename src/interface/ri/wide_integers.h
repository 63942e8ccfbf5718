// SPDX-License-Identifier: Apache-2.0
// Integers that floats cannot hold: parameters keep them beside their floats
// (TokenValue::integers).
#pragma once

#include "interface/ri/request_types.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace candela {

/// Whether an int can hold a whole number, and a float cannot.
inline bool isWideInteger(double whole) {
    constexpr double beyondFloats = 1 << 24;
    return std::fabs(whole) > beyondFloats && double(float(whole)) != whole &&
           whole >= std::numeric_limits<int>::min() && whole <= std::numeric_limits<int>::max();
}

/// Those, if there is one among them.
inline Integers wideIntegers(std::span<const int> integers) {
    if (std::ranges::none_of(integers, [](int integer) { return isWideInteger(integer); }))
        return {};
    return {integers.begin(), integers.end()};
}

} // namespace candela
