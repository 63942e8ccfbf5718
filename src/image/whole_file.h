// SPDX-License-Identifier: Apache-2.0
// Files that are there whole or not at all, and only where they may be.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// Writes the bytes under a temporary name in the same folder and renames the file when all of it
/// is there. On failure nothing is left behind, a file that was there before stays as it was, and
/// `problem` says what went wrong. A full disk and RLIMIT_FSIZE are failures, not signals.
bool writeWholeFile(const std::string &path, std::string_view bytes, std::string &problem);

/// True if writeWholeFile() could begin: for what is to be known before long work. Otherwise
/// `problem` says why not.
bool canWriteFile(const std::string &path, std::string &problem);

/// The content of a regular file; nothing, and `problem` says why, if it cannot be read.
std::optional<std::string> readWholeFile(const std::string &path, std::string &problem);

/// Where a picture of that name goes: relative names lie in `directory`, which is made if it is
/// missing (as are folders in the name). Names that lead out of `directory`, by "..", by an
/// absolute path or by a link, need `allowOutside`; otherwise nothing, and `problem` says so.
std::optional<std::string> outputPath(const std::string &name, const std::string &directory,
                                      bool allowOutside, std::string &problem);

} // namespace candela
