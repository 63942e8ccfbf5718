// SPDX-License-Identifier: Apache-2.0
// noise(), pnoise() and cellnoise(): calls of the runtime's lattice functions.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/lower/builtins.h"
#include "language/ir/lower/color.h"
#include "language/runtime/runtime_functions.h"

namespace candela::ir {
namespace {

using runtime::RuntimeFunction;

/// In functions.def the functions of two, three and four coordinates follow that of one.
Components lattice(BuiltinCall &call, RuntimeFunction ofNumber, RuntimeFunction ofTriple,
                   int dimensions) {
    Components coordinates;
    for (const Components &argument : call.arguments)
        coordinates.insert(coordinates.end(), argument.begin(), argument.end());
    const auto first = call.result() == sl::BaseType::Float ? ofNumber : ofTriple;
    const Components values = callRuntime(call.b, int(first) + dimensions - 1, coordinates);
    return call.result() == sl::BaseType::Color ? colorOf(call.b, tripleOf(values)) : values;
}

int coordinatesOf(const BuiltinCall &call) {
    int count = 0;
    for (const Components &argument : call.arguments)
        count += int(argument.size());
    return count;
}

Components noise(BuiltinCall &call) {
    return lattice(call, RuntimeFunction::noise1, RuntimeFunction::vnoise1, coordinatesOf(call));
}

Components pnoise(BuiltinCall &call) {
    return lattice(call, RuntimeFunction::pnoise1, RuntimeFunction::vpnoise1,
                   coordinatesOf(call) / 2);
}

Components cellnoise(BuiltinCall &call) {
    return lattice(call, RuntimeFunction::cellnoise1, RuntimeFunction::vcellnoise1,
                   coordinatesOf(call));
}

} // namespace

BuiltinLowering noiseBuiltin(sl::BuiltinId id) {
    switch (id) {
    case sl::BuiltinId::noise: return noise;
    case sl::BuiltinId::pnoise: return pnoise;
    case sl::BuiltinId::cellnoise: return cellnoise;
    default: return nullptr;
    }
}

} // namespace candela::ir
