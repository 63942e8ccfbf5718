// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/runtime_functions.h"

#include "language/runtime/noise_code.h"

#include <array>

namespace candela::runtime {

static constexpr RuntimeFunctionInfo table[] = {
#define RUNTIME_FUNCTION(name, inputs, outputs, meaning) {#name, inputs, outputs},
#include "language/runtime/functions.def"
#undef RUNTIME_FUNCTION
};

RuntimeFunctionInfo info(RuntimeFunction function) { return table[int(function)]; }

// In functions.def noise without slopes comes first, noise with slopes in the same order after it,
// cell noise last; in both halves functions without periods come first.
static constexpr int plainFunctions = int(RuntimeFunction::noise1_slopes);

int coordinatesOf(RuntimeFunction function) {
    if (function >= RuntimeFunction::cellnoise1)
        return 0;
    const bool periodic = int(function) % plainFunctions >= int(RuntimeFunction::pnoise1);
    return info(function).inputs / (periodic ? 2 : 1);
}

std::optional<RuntimeFunction> withSlopes(RuntimeFunction function) {
    if (int(function) >= plainFunctions)
        return std::nullopt;
    return RuntimeFunction(int(function) + plainFunctions);
}

static NoiseCode noiseCode(RuntimeFunction function, int width, IsaLevel level) {
    const bool wide = width > 1;
    switch (level) {
    case IsaLevel::V2: return noiseV2(function, wide);
    case IsaLevel::V3: return noiseV3(function, wide);
    case IsaLevel::V4: break;
    }
    return noiseV4(function, wide);
}

RuntimeCode code(RuntimeFunction function, int width, IsaLevel level) {
    return noiseCode(function, width, level).throughMemory;
}

const void *registerCode(RuntimeFunction function, int width, IsaLevel level) {
    return noiseCode(function, width, level).inRegisters;
}

void callScalar(RuntimeFunction function, const float *const *inputs, float *const *outputs) {
    static const IsaLevel level = hostIsaLevel();
    const RuntimeFunctionInfo facts = info(function);
    std::array<float, maxRuntimeInputs> inputBlock;
    std::array<float, maxRuntimeOutputs> outputBlock;
    for (int k = 0; k < facts.inputs; ++k)
        inputBlock[k] = *inputs[k];
    code(function, 1, level)(inputBlock.data(), outputBlock.data());
    for (int k = 0; k < facts.outputs; ++k)
        *outputs[k] = outputBlock[k];
}

} // namespace candela::runtime
