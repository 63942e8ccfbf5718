// SPDX-License-Identifier: Apache-2.0
// Shader sources and macros as command lines name them.
#pragma once

#include "language/semantics/front.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace candela {

/// The text of a file or pipe, or of standard input ("-").
std::optional<std::string> readSource(const std::string &name, std::string &problem);
/// The same; a name that is no file is looked for, with ".sl" behind it, in the folders.
std::optional<sl::SourceText>
readShader(const std::string &name, const std::vector<std::string> &folders, std::string &problem);

/// What is wrong with the argument of -D; empty if nothing is.
std::string flawOfDefine(const std::string &text);
/// "NAME=VALUE" or "NAME", which stands for NAME=1.
std::pair<std::string, std::string> defineOf(const std::string &text);

} // namespace candela
