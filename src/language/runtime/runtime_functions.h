// SPDX-License-Identifier: Apache-2.0
// The runtime functions of functions.def: what they are called, how many floats they take and
// give, and where their code is.
#pragma once

#include "language/runtime/isa_level.h"

#include <optional>

namespace candela::runtime {

enum class RuntimeFunction {
#define RUNTIME_FUNCTION(name, inputs, outputs, coordinates, slopes, purity, cost, meaning) name,
#include "language/runtime/functions.def"
#undef RUNTIME_FUNCTION
    Count,
    NoSlopes = Count
};

enum class RuntimePurity {
    Pure ///< The same inputs give the same outputs, nothing else happens.
};

/// As functions.def explains them.
struct RuntimeFunctionInfo {
    const char *name;
    int inputs, outputs;
    int coordinates;
    RuntimeFunction slopes;
    RuntimePurity purity;
    int cost;
};

/// No function of functions.def has more inputs or outputs than these.
inline constexpr int maxRuntimeInputs = 13, maxRuntimeOutputs = 15;

const RuntimeFunctionInfo &info(RuntimeFunction);

/// How many of the inputs values change with smoothly; the others are periods. 0: they jump.
int coordinatesOf(RuntimeFunction);
/// The function that gives the values of this one and behind them their slopes, those of the first
/// value along each coordinate before those of the second. Nothing for cell noise, and for what
/// gives slopes already.
std::optional<RuntimeFunction> withSlopes(RuntimeFunction);

/// Evaluates at one point, exactly as compiled code does at every width: inputs[k] and outputs[k]
/// point to one float each.
void callScalar(RuntimeFunction, const float *const *inputs, float *const *outputs);

/// Code that works in memory: `inputs` are the function's inputs one after another, `width` floats
/// each, aligned to their size; likewise the outputs. The blocks must not overlap.
using RuntimeCode = void (*)(const float *inputs, float *outputs);

/// Code at width 1, or at registerLanes() of an instruction-set level (register_code.h). Both
/// widths agree bit by bit, and so do V3 and V4.
RuntimeCode code(RuntimeFunction, int width, IsaLevel);

} // namespace candela::runtime
