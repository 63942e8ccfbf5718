// SPDX-License-Identifier: Apache-2.0
// A batch of surface points ready to be asked: the inputs of one shader's code for points on any
// shapes that share it.
#pragma once

#include "foundation/base/planes.h"
#include "language/runtime/shader_abi.h"
#include "world/shading/moving_parameters.h"

#include <cstdint>
#include <vector>

namespace candela {

struct ShadingPoints {
    explicit ShadingPoints(int capacity);

    int count = 0;
    /// All ShaderInput planes; only those the shader reads are filled, but P, N, Ng, I always. N
    /// and Ng are of unit length.
    Planes<float> inputs;
    std::vector<float *> inputTable; ///< inputs as ShaderArgs wants it.
    /// The same for shaders that move the points themselves: they are given those that they move.
    /// Empty otherwise.
    std::vector<float *> unmovedTable;
    Planes<float> unmoved; ///< The planes that differ.
    Planes<std::int32_t> integers;
    std::int32_t *parameterOffset, *objectIndex;
    std::int32_t *lightSet; ///< Which lights shine on it: index for Lights::isOn.
    std::int32_t *id;       ///< Which placed shape, from 1.
    std::int32_t *light;    ///< The light that the point belongs to: index + 1, 0 = none.
    /// Where on the light, for Lights::density: instance, shape and element that it lies on.
    std::uint32_t *instance, *shape, *element;
    Planes<std::uint32_t> places;
    /// Half of the thickness of the zone around P in which a new ray would meet the very
    /// surface it leaves (dicing error plus rounding): see Scene::offsetOrigin.
    float *offset;
    float *u, *v; ///< On the element; see HitBatch.
    /// The caller has named the points itself: element, u and v are the surface's own (piece, u,
    /// v).
    bool named = false;
    Planes<float> floats;
    Planes<float> variables;     ///< Planes that override parameters.
    MovingParameters parameters; ///< At the points' times, where the shader's change.
    std::vector<float *> variableTable;
    /// "object" space of points on instances, if the code reads it: see objectIndex.
    std::vector<float> objectMatrices;

    /// How many planes override parameters is known only when a shader is at hand. What the planes
    /// held is lost.
    void makeRoomForVariables(int planes);
    /// Whether the shader moves the points itself.
    void useUnmoved(bool);
    /// Lets the shader read this plane from elsewhere.
    void readFrom(int shaderInput, const float *plane);
    float *input(int shaderInput) { return inputTable[shaderInput]; }
    float *input(ShaderInput first, int component) { return inputTable[int(first) + component]; }
};

} // namespace candela
