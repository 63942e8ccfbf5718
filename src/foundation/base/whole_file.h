// SPDX-License-Identifier: Apache-2.0
// Files that are read whole and written whole or not at all.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// Writes the bytes under a temporary name in the same folder and renames the file when all of it
/// is there. On failure nothing is left behind, a file that was there before stays as it was, and
/// `problem` says what went wrong. So does it beyond RLIMIT_FSIZE if the process ignores SIGXFSZ.
bool writeWholeFile(const std::string &path, std::string_view bytes, std::string &problem);

/// True if writeWholeFile() could begin: for what is to be known before long work. Otherwise
/// `problem` says why not.
bool canWriteFile(const std::string &path, std::string &problem);

/// No more than can be held.
inline constexpr std::uintmax_t anyFileSize = std::uintmax_t(1) << 40;

/// What an open file still holds; nothing, and `problem` says why, if reading fails or there are
/// more than `limit` bytes: neither the size that a file claims nor one without an end costs more.
std::optional<std::string> readAll(int file, std::string &problem,
                                   std::uintmax_t limit = anyFileSize);

/// The content of a regular file, likewise; `problem` names the file.
std::optional<std::string> readWholeFile(const std::string &path, std::string &problem,
                                         std::uintmax_t limit = anyFileSize);

} // namespace candela
