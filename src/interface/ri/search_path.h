// SPDX-License-Identifier: Apache-2.0
// Option "searchpath": lists of folders as text, "a:b:@" (RI 3.2, 4.1.4).
#pragma once

#include "interface/ri/options.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candela {

/// A path has so many folders at most: each name that is not found is looked for in all of them.
inline constexpr std::size_t mostSearchFolders = 256;

/// The folders of a path as a flat list "a:b:c", with '&' replaced by the previous value of the
/// path, '@' by the default one, %NAME% and ${NAME} by the environment variable of that name
/// (nothing if it is not set) and a leading ~ by the home folder. Empty and repeated entries
/// vanish, and those behind the first mostSearchFolders; ';' parts entries as ':' does.
std::string expandSearchPath(std::string_view text, std::string_view previous,
                             std::string_view standard);
/// The entries of an expanded path.
std::vector<std::string> splitSearchPath(std::string_view expanded);
/// The folders of Option "searchpath" `kind` ("shader", "texture", "archive"...), in order.
std::vector<std::string> searchFolders(const Options &, const std::string &kind);
/// The regular file as it stands if absolute; else the first folder that holds it. Nothing if none
/// does.
std::optional<std::string> findFile(const std::string &name,
                                    const std::vector<std::string> &folders);
/// For a file that is not where its name says: names of other systems and other people's folders.
/// The name with '/' for '\\', else its last part. Nothing if the name names no folder.
std::optional<std::string> findNamesake(const std::string &name,
                                        const std::vector<std::string> &folders);
/// An expanded path in which each relative folder is followed by that of the same name as seen from
/// the folder of `file`, if there is one: scenes are rendered from anywhere.
std::string withFoldersBeside(const std::string &expanded, const std::string &file);

} // namespace candela
