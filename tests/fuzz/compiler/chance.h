// SPDX-License-Identifier: Apache-2.0
// Random choices that are the same on every machine: the standard's distributions need not be.
#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace candela::fuzz {

class Chance {
public:
    explicit Chance(std::uint64_t seed) : bits_(seed) {}

    std::uint64_t bits() { return bits_(); }
    /// One of 0 to n - 1; n >= 1.
    std::size_t below(std::size_t n) { return std::size_t(bits_() % n); }
    bool oneIn(std::size_t n) { return below(n) == 0; }
    /// An element of what is not empty.
    template <typename Choices> const auto &pick(const Choices &choices) {
        return *(std::begin(choices) + std::ptrdiff_t(below(std::size(choices))));
    }

private:
    std::mt19937_64 bits_;
};

} // namespace candela::fuzz
