// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/hash.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace candela {

void ContentHash::add(std::uint64_t value) {
    high_ = mixBits(high_ ^ value) + low_;
    low_ = mixBits(low_ + value * 0x9e3779b97f4a7c15) ^ high_;
}

void ContentHash::add(std::string_view bytes) {
    add(std::uint64_t(bytes.size()));
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
        add(word);
    }
}

std::string ContentHash::text() const {
    char digits[33];
    std::snprintf(digits, sizeof digits, "%016llx%016llx", (unsigned long long)high_,
                  (unsigned long long)low_);
    return digits;
}

} // namespace candela
