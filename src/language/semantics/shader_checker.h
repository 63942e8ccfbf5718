// SPDX-License-Identifier: Apache-2.0
// The type checker of one shader.
#pragma once

#include <memory>
#include <string>

#include "language/semantics/typed_ast.h"
#include "language/syntax/ast.h"
#include "language/syntax/reporter.h"

namespace candela::sl {

/// The typed form of a shader of the file; of use only if the reporter has counted no errors.
/// `headersRead` is what messages about unknown functions end with.
std::unique_ptr<TypedShader> checkShader(const ast::Shader &, const ast::File &,
                                         const SourceFile &mainFile, const std::string &headersRead,
                                         Reporter &);

} // namespace candela::sl
