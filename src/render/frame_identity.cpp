// SPDX-License-Identifier: Apache-2.0
#include "render/frame_identity.h"

#include "foundation/base/raw_bytes.h"

#include <algorithm>
#include <cstdint>

namespace candela {

void appendIdentity(std::string &bytes, const FrameIdentity &identity) {
    appendRaw(bytes, std::uint64_t(identity.size()));
    for (const auto &[name, value] : identity)
        appendText(bytes, name), appendText(bytes, value);
}

bool takeIdentity(std::string_view &bytes, FrameIdentity &identity) {
    std::uint64_t facts = 0;
    if (!takeRaw(bytes, facts))
        return false;
    for (; facts > 0; --facts) {
        auto &[name, value] = identity.emplace_back();
        if (!takeText(bytes, name) || !takeText(bytes, value))
            return false;
    }
    return true;
}

std::string differenceOf(const FrameIdentity &saved, const FrameIdentity &now) {
    const auto valueIn = [](const FrameIdentity &identity, const std::string &name) {
        const auto found =
            std::ranges::find(identity, name, &std::pair<std::string, std::string>::first);
        return found == identity.end() ? std::string() : found->second;
    };
    for (const auto &[name, value] : now) {
        const std::string before = valueIn(saved, name);
        if (before == value)
            continue;
        const bool isFingerprint = name == "scene" || name == "shaders";
        return isFingerprint
                   ? "the " + name + (name == "scene" ? " is" : " are") + " not the same"
                   : "it is of " + name + " " + before + ", and this render is of " + value;
    }
    return {};
}

} // namespace candela
