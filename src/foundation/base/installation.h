// SPDX-License-Identifier: Apache-2.0
// Where what comes with Candela lies: its shaders and modules.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace candela {

/// "share/candela/shaders" in the folder that the code itself lies in (the program, a library), in
/// those around it, or else in the prefix that was configured: an installation may be moved whole.
/// Nothing if it is nowhere.
std::optional<std::filesystem::path> installedPath(const std::string &relative);

} // namespace candela
