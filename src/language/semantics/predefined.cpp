// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/predefined.h"

namespace candela::sl {

// The letters of ShaderKind's enumerators, in their order.
static constexpr std::string_view kindLetters = "SLVDITF";

static constexpr unsigned maskOf(std::string_view letters) {
    unsigned mask = 0;
    for (char letter : letters)
        mask |= 1u << kindLetters.find(letter);
    return mask;
}

static constexpr PredefinedVariable table[] = {
#define SL_PREDEFINED(name, type, detail, readable, writable, scope, doc)                          \
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
