// SPDX-License-Identifier: Apache-2.0
// The predefined variables of the Shading Language (RI 3.2 section 11, and the paper's section 5),
// per kind of shader. The table is predefined.def.
#pragma once

#include <span>
#include <string_view>

#include "language/semantics/type.h"

namespace candela::sl {

/// One enumerator a variable, spelled as the variable: PredefinedId::dPdu.
enum class PredefinedId {
#define SL_PREDEFINED(name, type, detail, readable, writable, scope, start, doc) name,
#include "language/semantics/predefined.def"
#undef SL_PREDEFINED
};

/// Where the variable is known.
enum class PredefinedScope {
    Shader, ///< In the whole shader.
    Light   ///< Has a value in illuminance, illuminate and solar statements only.
};

struct PredefinedVariable {
    PredefinedId id;
    const char *name;
    Type type;
    unsigned readable; ///< Bit 1 << int(ShaderKind) for each kind that may read it.
    unsigned writable; ///< Likewise for kinds that may assign to it.
    PredefinedScope scope;
    const char *doc;

    bool readableIn(ShaderKind k) const { return readable >> int(k) & 1; }
    bool writableIn(ShaderKind k) const { return writable >> int(k) & 1; }
};

std::span<const PredefinedVariable> predefinedVariables();
const PredefinedVariable &predefinedVariable(PredefinedId);
/// The variable of that name if that kind of shader knows it, else null.
const PredefinedVariable *findPredefined(std::string_view name, ShaderKind);

} // namespace candela::sl
