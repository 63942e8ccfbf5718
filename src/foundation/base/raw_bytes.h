// SPDX-License-Identifier: Apache-2.0
// Numbers as the bytes of this machine, for files that only it reads again.
#pragma once

#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

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

/// With its length.
inline void appendText(std::string &bytes, std::string_view text) {
    appendRaw(bytes, std::uint64_t(text.size()));
    bytes += text;
}
inline bool takeText(std::string_view &bytes, std::string &text) {
    std::uint64_t size = 0;
    if (!takeRaw(bytes, size) || size > bytes.size())
        return false;
    text = bytes.substr(0, size);
    bytes.remove_prefix(size);
    return true;
}

/// With their number.
template <class Value> void appendList(std::string &bytes, const std::vector<Value> &values) {
    appendRaw(bytes, std::uint64_t(values.size()));
    appendRaw(bytes, std::span<const Value>(values));
}
template <class Value> bool takeList(std::string_view &bytes, std::vector<Value> &values) {
    std::uint64_t count = 0;
    if (!takeRaw(bytes, count) || count > bytes.size() / sizeof(Value))
        return false;
    values.resize(count);
    return takeRaw(bytes, std::span<Value>(values));
}

} // namespace candela
