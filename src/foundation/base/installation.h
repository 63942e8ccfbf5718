// SPDX-License-Identifier: Apache-2.0
// Where what comes with Candela lies: its shaders and modules.
#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace candela {

/// The folder that an installation (or a build, which is laid out alike) with this file is: a
/// program lies in its bin, a library in its lib or up to four folders below that. Empty for a file
/// that lies elsewhere: what happens to lie around it is nobody's.
std::filesystem::path prefixOf(const std::filesystem::path &file);

/// "share/candela/shaders" in the installation that the code itself belongs to (the program, a
/// library), which may be moved whole, or else in the prefix that was configured. Nothing if it is
/// in neither.
std::optional<std::filesystem::path> installedPath(const std::string &relative);

} // namespace candela
