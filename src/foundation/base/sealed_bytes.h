// SPDX-License-Identifier: Apache-2.0
// Files that only this program reads again: a mark, a hash of what follows, and that.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace candela {

/// `mark` says what the file is, and of which version.
std::string sealed(std::string_view mark, std::string body);

/// The body; nothing, and `problem` ("it is damaged", or that it is no `what` of this version), if
/// the bytes are not those of a whole file with that mark.
std::optional<std::string_view> unsealed(std::string_view mark, const std::string &what,
                                         std::string_view bytes, std::string &problem);

} // namespace candela
