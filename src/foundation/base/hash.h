// SPDX-License-Identifier: Apache-2.0
// A 128-bit content hash for cache keys: stable between runs and machines; not cryptographic.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace candela {

class ContentHash {
public:
    void add(std::string_view bytes);
    void add(std::uint64_t value);
    /// 32 hexadecimal digits.
    std::string text() const;

private:
    std::uint64_t high_ = 0x6a09e667f3bcc908, low_ = 0xbb67ae8584caa73b;
};

/// A well mixed 64-bit permutation (Stafford's variant 13 of the Murmur finaliser).
inline std::uint64_t mixBits(std::uint64_t x) {
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9;
    x = (x ^ (x >> 27)) * 0x94d049bb133111eb;
    return x ^ (x >> 31);
}

} // namespace candela
