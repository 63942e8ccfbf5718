// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/runtime_functions.h"

#include "language/runtime/level_code.h"

#include <array>

namespace candela::runtime {

static constexpr RuntimeFunctionInfo table[] = {
#define RUNTIME_FUNCTION(name, inputs, outputs, coordinates, slopes, purity, cost, meaning)        \
    {#name, inputs, outputs, coordinates, RuntimeFunction::slopes, RuntimePurity::purity, cost},
#include "language/runtime/functions.def"
#undef RUNTIME_FUNCTION
};

const RuntimeFunctionInfo &info(RuntimeFunction function) { return table[int(function)]; }

int coordinatesOf(RuntimeFunction function) { return info(function).coordinates; }

std::optional<RuntimeFunction> withSlopes(RuntimeFunction function) {
    const RuntimeFunction slopes = info(function).slopes;
    return slopes == RuntimeFunction::NoSlopes ? std::nullopt : std::optional(slopes);
}

static LevelCode codeOf(RuntimeFunction function, int width, IsaLevel level) {
    const bool wide = width > 1, isNoise = function < firstBound;
    switch (level) {
    case IsaLevel::V2: return (isNoise ? noiseV2 : boundV2)(function, wide);
    case IsaLevel::V3: return (isNoise ? noiseV3 : boundV3)(function, wide);
    case IsaLevel::V4: break;
    }
    return (isNoise ? noiseV4 : boundV4)(function, wide);
}

RuntimeCode code(RuntimeFunction function, int width, IsaLevel level) {
    return codeOf(function, width, level).throughMemory;
}

const void *registerCode(RuntimeFunction function, int width, IsaLevel level) {
    return codeOf(function, width, level).inRegisters;
}

void callScalar(RuntimeFunction function, const float *const *inputs, float *const *outputs) {
    static const IsaLevel level = hostIsaLevel();
    const RuntimeFunctionInfo &facts = info(function);
    std::array<float, maxRuntimeInputs> inputBlock;
    std::array<float, maxRuntimeOutputs> outputBlock;
    for (int k = 0; k < facts.inputs; ++k)
        inputBlock[k] = *inputs[k];
    code(function, 1, level)(inputBlock.data(), outputBlock.data());
    for (int k = 0; k < facts.outputs; ++k)
        *outputs[k] = outputBlock[k];
}

} // namespace candela::runtime
