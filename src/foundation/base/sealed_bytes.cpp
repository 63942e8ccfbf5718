// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/sealed_bytes.h"

#include "foundation/base/hash.h"

namespace candela {

static constexpr std::size_t hashSize = 32;

static std::string hashOf(std::string_view bytes) {
    ContentHash hash;
    hash.add(bytes);
    return hash.text();
}

std::string sealed(std::string_view mark, std::string body) {
    const std::string hash = hashOf(body);
    body.insert(0, std::string(mark) + hash);
    return body;
}

std::optional<std::string_view> unsealed(std::string_view mark, const std::string &what,
                                         std::string_view bytes, std::string &problem) {
    if (!bytes.starts_with(mark)) {
        problem = "it is no " + what + " of this version";
        return std::nullopt;
    }
    bytes.remove_prefix(mark.size());
    const std::string_view hash = bytes.substr(0, hashSize);
    bytes.remove_prefix(hash.size());
    if (hash != hashOf(bytes)) {
        problem = "it is damaged";
        return std::nullopt;
    }
    return bytes;
}

} // namespace candela
