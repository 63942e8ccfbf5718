// SPDX-License-Identifier: Apache-2.0
// Constructs of RSL 2.0 (shader classes, structures, shader objects, arrays that grow), which are
// told by name where they would otherwise be errors of grammar.
#pragma once

#include <string>

#include "language/syntax/token_cursor.h"

namespace candela::sl {

/// What begins at the cursor and is of RSL 2.0 alone, as messages name it ("class wood"); empty for
/// all else. These words are names in the language that shaders are written in here.
std::string rsl2Construct(const TokenCursor &);

/// "class wood is of RSL 2.0, which ..."
std::string rsl2Message(const std::string &construct);

} // namespace candela::sl
