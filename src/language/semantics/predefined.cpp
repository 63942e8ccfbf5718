// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/predefined.h"

namespace candela::sl {

static unsigned maskOf(std::string_view letters) {
    unsigned mask = 0;
    for (int kind = 0; kind < shaderKindCount; ++kind)
        if (letters.find(letterOf(ShaderKind(kind))) != std::string_view::npos)
            mask |= 1u << kind;
    return mask;
}

static const PredefinedVariable table[] = {
#define SL_PREDEFINED(name, type, detail, readable, writable, scope, start, doc)                   \
    {PredefinedId::name,                                                                           \
     #name,                                                                                        \
     {BaseType::type, Detail::detail, 0},                                                          \
     maskOf(readable),                                                                             \
     maskOf(writable),                                                                             \
     PredefinedScope::scope,                                                                       \
     doc},
#include "language/semantics/predefined.def"
#undef SL_PREDEFINED
};

std::span<const PredefinedVariable> predefinedVariables() { return table; }

const PredefinedVariable &predefinedVariable(PredefinedId id) { return table[int(id)]; }

const PredefinedVariable *findPredefined(std::string_view name, ShaderKind kind) {
    for (const PredefinedVariable &variable : table)
        if (variable.name == name && variable.readableIn(kind))
            return &variable;
    return nullptr;
}

} // namespace candela::sl
