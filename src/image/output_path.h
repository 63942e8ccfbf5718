// SPDX-License-Identifier: Apache-2.0
// Pictures are written only where they may be.
#pragma once

#include <optional>
#include <string>

namespace candela {

/// Where a picture of that name goes: relative names lie in `directory`, which is made if it is
/// missing (as are folders in the name). Names that lead out of `directory`, by "..", by an
/// absolute path or by a link, need `allowOutside`; otherwise, as names of other systems (with
/// '\\'), they count for their last part, and `note` says so. Nothing, and `problem` says why, if
/// no file can be there.
std::optional<std::string> outputPath(const std::string &name, const std::string &directory,
                                      bool allowOutside, std::string &note, std::string &problem);

} // namespace candela
