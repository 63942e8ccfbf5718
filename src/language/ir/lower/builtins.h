// SPDX-License-Identifier: Apache-2.0
// Built-in functions: each subject has a file of its own.
#pragma once

#include "language/ir/lower/lowering.h"

#include <string>
#include <vector>

namespace candela::ir {

/// A call of a built-in function, its arguments evaluated.
struct BuiltinCall {
    Lowering &lowering;
    Builder &b;
    const sl::Expr &expr;
    std::vector<Components> arguments;

    sl::BuiltinId id() const { return expr.overload->function->id; }
    sl::BaseType result() const { return expr.overload->result; }
    size_t count() const { return arguments.size(); }
    ValueId number(size_t i) const { return arguments[i][0]; }
    Triple triple(size_t i) const { return tripleOf(arguments[i]); }
    bool isText(size_t i) const { return expr.operands[i]->type.base == sl::BaseType::String; }
    std::string text(size_t i, const char *what) const;
    /// The first string from argument `from` on, where names of optional arguments begin; count()
    /// if there is none.
    size_t firstText(size_t from) const;
    /// Assigns to an output argument.
    void assign(size_t i, const Components &) const;
};

using BuiltinLowering = Components (*)(BuiltinCall &);

// Each gives the lowering of the functions that are its subject, null for others.
BuiltinLowering mathsBuiltin(sl::BuiltinId);
BuiltinLowering geometryBuiltin(sl::BuiltinId);
BuiltinLowering spaceBuiltin(sl::BuiltinId);
BuiltinLowering colorBuiltin(sl::BuiltinId);
BuiltinLowering matrixBuiltin(sl::BuiltinId);
BuiltinLowering noiseBuiltin(sl::BuiltinId);
BuiltinLowering splineBuiltin(sl::BuiltinId);
BuiltinLowering lightBuiltin(sl::BuiltinId);
BuiltinLowering derivativeBuiltin(sl::BuiltinId);
BuiltinLowering textBuiltin(sl::BuiltinId);
BuiltinLowering informationBuiltin(sl::BuiltinId);
BuiltinLowering imageBuiltin(sl::BuiltinId);
BuiltinLowering rayBuiltin(sl::BuiltinId);
BuiltinLowering filterstepBuiltin(sl::BuiltinId);
BuiltinLowering textureBuiltin(sl::BuiltinId);
BuiltinLowering messageBuiltin(sl::BuiltinId);

/// A call of any of them.
Components builtin(Lowering &, const sl::Expr &);

/// A point, vector, normal or matrix of current space that the text gives in another.
Components fromSpace(Lowering &, sl::BaseType, const Components &, const std::string &space,
                     const sl::Place &);
/// The three numbers of a colour, from the named colour space to another; of unknown
/// names it warns, and the numbers stay.
Triple convertColor(Lowering &, const Triple &, const std::string &from, const std::string &to,
                    const sl::Place &);

} // namespace candela::ir
