// SPDX-License-Identifier: Apache-2.0
// Pictures are written only where they may be: a stranger's file says how they are called.
#pragma once

#include <optional>
#include <string>

namespace candela {

/// Where pictures may be written, and whose word that is.
struct OutputFolder {
    std::string directory; ///< Empty: the working directory.
    /// The names are the user's own, or those of files that the user trusts: all but those that
    /// cannot be are taken as they are.
    bool isTrusted = false;
};

/// Where a picture of that name goes: relative names lie in the folder, which is made if it is
/// missing (as are folders in the name). Of names that nobody vouches for
/// - those that lead out of the folder, by "..", by an absolute path or by a link, count for their
///   last part, and `note` says so; so do names of other systems (with '\\'), whoever gives them;
/// - none may have control characters, or a part that begins with a dot or a dash;
/// - none may be that of a file that is there and no picture.
/// Nothing, and `problem` says why, if no file can be there.
std::optional<std::string> outputPath(const std::string &name, const OutputFolder &,
                                      std::string &note, std::string &problem);

} // namespace candela
