// SPDX-License-Identifier: Apache-2.0
// What the lowering has to know of a piece of the tree before it lowers it.
#pragma once

#include "language/semantics/typed_ast.h"

#include <set>
#include <string>
#include <vector>

namespace candela::ir {

/// The variable that an lvalue or a by-reference argument is, or is a part of; null if none.
const sl::Symbol *rootSymbol(const sl::Expr &);

/// What running a loop's body may change beyond itself.
struct LoopEffects {
    /// Variables that live outside and may be assigned, in the order of their first assignment.
    std::vector<const sl::Symbol *> assigned;
    /// Loops and light statements that it may break or continue: itself or around it.
    std::vector<const sl::Stmt *> breaks, continues;
    bool returns = false;
    bool drawsAnew = false; ///< It draws random numbers, and is a Loop or has some.
};

/// Of a Loop (condition, body and steps) or a light statement (body).
LoopEffects loopEffects(const sl::Stmt &);

/// Whether the expression may be evaluated although nobody wants its value: no effects, no light
/// requests, and less work than a branch is worth.
bool isCheapAndPure(const sl::Expr &);

/// Whether the shader gets light by loops, diffuse() and its kin, or irradiance().
bool gathersLight(const sl::TypedShader &);

/// Whether a loop's rounds make or choose strings, which have to be known when it is compiled.
bool choosesTexts(const sl::Stmt &loop);

/// Arrays of strings that nothing assigns once they are declared.
std::set<const sl::Symbol *> fixedTexts(const sl::TypedShader &);

/// Arrays that are somewhere indexed by computed indices, or passed on to a formal that is.
std::set<const sl::Symbol *> computedArrays(const sl::TypedShader &);

} // namespace candela::ir
