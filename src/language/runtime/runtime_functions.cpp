// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/runtime_functions.h"

#include <array>

namespace candela::runtime {

RuntimeCode noiseV2(RuntimeFunction, int width);
RuntimeCode noiseV3(RuntimeFunction, int width);
RuntimeCode noiseV4(RuntimeFunction, int width);

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

RuntimeCode code(RuntimeFunction function, int width, IsaLevel level) {
    switch (level) {
    case IsaLevel::V2: return noiseV2(function, width);
    case IsaLevel::V3: return noiseV3(function, width);
    case IsaLevel::V4: break;
    }
    return noiseV4(function, width);
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
