// SPDX-License-Identifier: Apache-2.0
// The renderer's version, as shaders are told it.
#pragma once

#include <array>
#include <string>

namespace candela::sl {

/// Major, minor, patch.
std::array<int, 3> version();
/// "1.2.3".
std::string versionText();

} // namespace candela::sl
