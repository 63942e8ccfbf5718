// SPDX-License-Identifier: Apache-2.0
#include "world/points/shading_points.h"

namespace candela {

ShadingPoints::ShadingPoints(int capacity)
    : inputs(int(ShaderInput::Count), capacity), integers(5, capacity), places(3, capacity),
      floats(3, capacity) {
    for (int plane = 0; plane < int(ShaderInput::Count); ++plane)
        inputTable.push_back(inputs[plane]);
    parameterOffset = integers[0], objectIndex = integers[1], lightSet = integers[2];
    id = integers[3], light = integers[4];
    instance = places[0], shape = places[1], element = places[2];
    offset = floats[0], u = floats[1], v = floats[2];
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
