// SPDX-License-Identifier: Apache-2.0
// The files that #include names: how they are named, and where they are.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "language/syntax/reporter.h"
#include "language/syntax/source.h"
#include "language/syntax/token.h"

namespace candela::sl {

/// A file of more bytes is no shader.
inline constexpr std::uintmax_t sourceSizeLimit = 16 << 20;

struct IncludeName {
    std::string name;    ///< Empty if the line names no file.
    bool angled = false; ///< <file>, not "file".
};

/// From what stands behind the word "include", its macros expanded.
IncludeName includeName(const std::vector<Token> &line);

/// Reads the file from the first folder that has it: that of the file in which `where` is, then the
/// given ones, or these first if the name is angled. Null if it is nowhere or cannot be read, which
/// is reported.
std::unique_ptr<SourceFile> readInclude(const IncludeName &, const Place &where,
                                        const std::vector<std::string> &folders, Reporter &);

} // namespace candela::sl
