// SPDX-License-Identifier: Apache-2.0
#include "world/scene/shading_points.h"

namespace candela {

namespace {
constexpr int maximumVariables = 32;
}

ShadingPoints::ShadingPoints(int capacity)
    : inputs(int(ShaderInput::Count), capacity), integers(5, capacity), floats(2, capacity),
      variables(maximumVariables, capacity) {
    for (int plane = 0; plane < int(ShaderInput::Count); ++plane)
        inputTable.push_back(inputs[plane]);
    for (int plane = 0; plane < maximumVariables; ++plane)
        variableTable.push_back(variables[plane]);
    parameterOffset = integers[0], objectIndex = integers[1], lightSet = integers[2];
    primitive = integers[3], light = integers[4];
    offset = floats[0], lightPdfArea = floats[1];
}

} // namespace candela
