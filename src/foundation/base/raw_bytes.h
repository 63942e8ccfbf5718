// SPDX-License-Identifier: Apache-2.0
// Numbers as the bytes of this machine, for files that only it reads again.
#pragma once

#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace candela {

template <class Value> void appendRaw(std::string &bytes, std::span<const Value> values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes.append(reinterpret_cast<const char *>(values.data()), values.size_bytes());
}
template <class Value> void appendRaw(std::string &bytes, const Value &value) {
    appendRaw(bytes, std::span<const Value>(&value, 1));
}

/// From the front of `bytes`, which becomes what is left; false if there is too little.
template <class Value> bool takeRaw(std::string_view &bytes, std::span<Value> values) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (bytes.size() < values.size_bytes())
        return false;
    std::memcpy(values.data(), bytes.data(), values.size_bytes());
    bytes.remove_prefix(values.size_bytes());
    return true;
}
template <class Value> bool takeRaw(std::string_view &bytes, Value &value) {
    return takeRaw(bytes, std::span<Value>(&value, 1));
}

} // namespace candela
