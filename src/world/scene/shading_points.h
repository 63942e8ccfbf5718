// SPDX-License-Identifier: Apache-2.0
// A batch of surface points ready to be asked: the inputs of one shader's code for hits on any
// primitives that share it.
#pragma once

#include "foundation/base/planes.h"
#include "language/runtime/shader_abi.h"

#include <cstdint>
#include <vector>

namespace candela {

struct ShadingPoints {
    explicit ShadingPoints(int capacity);

    int count = 0;
    /// All ShaderInput planes; only those the shader reads are filled, but P, N, Ng, I always.
    Planes<float> inputs;
    std::vector<float *> inputTable; ///< inputs as ShaderArgs wants it.
    Planes<std::int32_t> integers;
    std::int32_t *parameterOffset, *objectIndex;
    std::int32_t *lightSet;  ///< Which lights shine on it: index for Scene::lightIsOn.
    std::int32_t *primitive; ///< Index of the primitive.
    /// Half of the thickness of the zone around P in which a new ray would meet the very
    /// surface it leaves (dicing error plus rounding): see Scene::offsetOrigin.
    float *offset;
    /// pdf, per unit area, with which light sampling chooses this point; 0 = not a light.
    float *lightPdfArea;
    /// The light this point belongs to (index + 1 of LightRecord order, emitting surfaces after
    /// them), 0 = none.
    std::int32_t *light;
    Planes<float> floats;
    Planes<float> variables; ///< Planes that override parameters.
    std::vector<float *> variableTable;

    /// How many planes override parameters is known only when a shader is at hand. What the planes
    /// held is lost.
    void makeRoomForVariables(int planes);
    float *input(int shaderInput) { return inputTable[shaderInput]; }
};

} // namespace candela
