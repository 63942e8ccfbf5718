// SPDX-License-Identifier: Apache-2.0
// The built-in functions of the Shading Language. The table itself is builtins.def; semantics, IR,
// code generation and the reference page all read it through this header.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "language/syntax/base_type.h"

namespace candela::sl {

/// One enumerator a function, spelled as the function: BuiltinId::smoothstep.
enum class BuiltinId {
#define SL_BUILTIN(name, when, lowering, uniformity, derivative, bound, types, signatures, doc)    \
    name,
#include "language/semantics/builtins.def"
#undef SL_BUILTIN
};

/// What a call of the function gets.
enum class Available {
    Now, ///< What it asks for.
    Zero ///< Calls give zero, with one warning a file; the doc line says what is missing.
};

/// Who does the work.
enum class Lowering {
    Inline,  ///< The lowering expands it into IR operations.
    Runtime, ///< A function of the runtime library: noise, splines, transcendental functions.
    Context, ///< Asks the renderer for state: transformations, names, attributes.
    Light,   ///< Is, or answers from, a numbered light request; irradiance() among them.
    Derive,  ///< Needs derivatives of its argument in u and v.
    Effect,  ///< Is called for what it does: printf, setimage.
    Texture, ///< Reads or writes files of pixels or points.
    Trace    ///< Asks for rays outside a light request.
};

/// When the result is uniform.
enum class Uniformity {
    ByArguments, ///< If all arguments are.
    Uniform,     ///< Always.
    Varying      ///< Never.
};

/// How the function carries derivatives.
enum class Derivative {
    Chain,   ///< By the chain rule, differentiable but for isolated points.
    Zero,    ///< Constant or piecewise constant.
    Lattice, ///< From the noise lattice, together with the value.
    Opaque   ///< None known: the derivative counts as zero.
};

/// How the function carries affine bounds (ALGORITHMS 7).
enum class Bounding {
    Affine,   ///< Exactly, up to rounding.
    MinRange, ///< Linearised on the interval of its argument.
    Product,  ///< Built of products: radii multiply.
    Hull,     ///< Hull of the values, with a test for crossings.
    Lattice,  ///< From the lattice's second-derivative bound.
    Light,    ///< Over the unit field of light.
    Constant, ///< Does not change over the box.
    Infinite  ///< Nothing is known.
};

struct BuiltinParameter {
    std::string name;
    BaseType type = BaseType::Float;
    bool output = false;  ///< The argument is a variable that the function writes.
    bool array = false;   ///< The argument is a whole array of any length.
    bool uniform = false; ///< The argument must be uniform.
    bool anyType = false; ///< Any type is accepted, `type` does not count.
    /// The argument is of this type by itself: a float is not promoted, and what may be a float
    /// (noise(), say) is taken for one.
    bool proper = false;
};

struct Builtin;

/// One way to call a function.
struct BuiltinOverload {
    const Builtin *function = nullptr;
    int index = 0; ///< Position among the function's overloads.
    BaseType result = BaseType::Void;
    std::vector<BuiltinParameter> parameters;
    /// The last parameter may be repeated: spline(t, v, v, v, v, v...), max(a, b, c...).
    bool repeatsLast = false;
    /// Arguments of any type may follow: printf(format, ...), texture(name, "blur", b, ...).
    bool openEnded = false;

    /// "color mix(color x, color y, float alpha)".
    std::string signature() const;
};

struct Builtin {
    BuiltinId id;
    const char *name;
    Available available;
    Lowering lowering;
    Uniformity uniformity;
    Derivative derivative;
    Bounding bound;
    const char *doc; ///< One line for the reference page.
    std::vector<BuiltinOverload> overloads;
};

/// The whole table, in the order of builtins.def.
std::span<const Builtin> builtins();
const Builtin &builtin(BuiltinId);
/// Null if no function has that name.
const Builtin *findBuiltin(std::string_view name);

} // namespace candela::sl
