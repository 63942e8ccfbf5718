// SPDX-License-Identifier: Apache-2.0
// Powers in doubles, in plain arithmetic that compilers vectorise.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace candela {

/// ln x for normal x above 0; error below 1e-14 + 1e-15 |ln x|.
[[gnu::always_inline]] inline double logOf(double x) {
    // x = m 2^k with m in [sqrt(1/2), sqrt(2)): the exponent of x / sqrt(1/2), rounded down.
    constexpr std::uint64_t half = 0x3fe6a09e667f3bcd; // sqrt(1/2)
    const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
    const std::uint64_t k = (bits - half) >> 52 << 52;
    const double m = std::bit_cast<double>(bits - k);
    // k as a double: it is put into the mantissa of 2^52 and a half more, whose last place is 1.
    const double power = std::bit_cast<double>(((k >> 52 & 0xfff) ^ 0x800) | 0x4338000000000000) -
                         (0x1.8p52 + 0x800);
    const double z = (m - 1) / (m + 1), z2 = z * z;
    double sum = 1.0 / 19;
#pragma GCC unroll 9
    for (int n = 17; n > 0; n -= 2)
        sum = 1.0 / n + z2 * sum;
    return 2 * z * sum + power * std::numbers::ln2;
}

/// e^x for x in [-700, 700]; relative error below 1e-13.
[[gnu::always_inline]] inline double expOf(double x) {
    // The sum's last bits hold the power of 2, rounded to an integer.
    const double biased = x * std::numbers::log2e + 0x1.8p52;
    const double r = x - (biased - 0x1.8p52) * std::numbers::ln2;
    double sum = 1;
#pragma GCC unroll 12
    for (int n = 12; n > 0; --n)
        sum = 1 + r / n * sum;
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(sum) +
                                 (std::bit_cast<std::uint64_t>(biased) << 52));
}

} // namespace candela
