// SPDX-License-Identifier: Apache-2.0
#include "world/points/shading_points.h"

#include <iterator>

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

/// What a displacement changes.
static constexpr ShaderInput movedInputs[] = {
    ShaderInput::P,    ShaderInput::N,    ShaderInput::Ng,    ShaderInput::dPdu, ShaderInput::dPdv,
    ShaderInput::dNdu, ShaderInput::dNdv, ShaderInput::dNgdu, ShaderInput::dNgdv};

void ShadingPoints::useUnmoved(bool use) {
    unmovedTable.clear();
    if (!use)
        return;
    if (unmoved.planes() == 0)
        unmoved = Planes<float>(3 * int(std::size(movedInputs)), inputs.lanes());
    unmovedTable = inputTable;
    int plane = 0;
    for (ShaderInput input : movedInputs)
        for (int c = 0; c < 3; ++c)
            unmovedTable[std::size_t(int(input) + c)] = unmoved[plane++];
}

void ShadingPoints::readFrom(int shaderInput, const float *plane) {
    inputTable[std::size_t(shaderInput)] = const_cast<float *>(plane);
    if (!unmovedTable.empty())
        unmovedTable[std::size_t(shaderInput)] = const_cast<float *>(plane);
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
