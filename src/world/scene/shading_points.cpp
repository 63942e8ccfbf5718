// SPDX-License-Identifier: Apache-2.0
#include "world/scene/shading_points.h"

namespace candela {

ShadingPoints::ShadingPoints(int capacity)
    : inputs(int(ShaderInput::Count), capacity), integers(5, capacity), floats(2, capacity) {
    for (int plane = 0; plane < int(ShaderInput::Count); ++plane)
        inputTable.push_back(inputs[plane]);
    parameterOffset = integers[0], objectIndex = integers[1], lightSet = integers[2];
    primitive = integers[3], light = integers[4];
    offset = floats[0], lightPdfArea = floats[1];
}

void ShadingPoints::makeRoomForVariables(int planes) {
    if (planes <= variables.planes())
        return;
    variables = Planes<float>(planes, inputs.lanes());
    variableTable.clear();
    for (int plane = 0; plane < planes; ++plane)
        variableTable.push_back(variables[plane]);
}

} // namespace candela
