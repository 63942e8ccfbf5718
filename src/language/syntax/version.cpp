// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/version.h"

namespace candela::sl {

std::array<int, 3> version() {
    return {CANDELA_VERSION_MAJOR, CANDELA_VERSION_MINOR, CANDELA_VERSION_PATCH};
}

std::string versionText() {
    const auto [major, minor, patch] = version();
    return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(patch);
}

} // namespace candela::sl
