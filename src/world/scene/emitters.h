// SPDX-License-Identifier: Apache-2.0
// What lights are to paths that begin on them (paper 5.4): how often each is chosen, where it
// stands, and whither it sends.
#pragma once

#include "world/lights/emission_lobes.h"
#include "world/scene/light_sources.h"

#include <cstdint>
#include <string>
#include <vector>

namespace candela {

struct SceneState;

enum class EmitterForm : std::uint8_t {
    None,    ///< No path begins here; camera paths alone find the light.
    Surface, ///< A point of its shapes by area, directions by the cosine on the sides that shine.
    Point,   ///< One place; directions by the cones that the shader states.
    Distant, ///< One direction; a place on a disc as wide as the scene.
};

struct Emitter {
    EmitterForm form = EmitterForm::None;
    double probability = 0; ///< Of beginning a path here.
    double area = 0;        ///< Of a surface, m^2.
    LightSides sides = LightSides::Both;
    Vec3 place;          ///< Of a point light.
    EmissionLobes lobes; ///< Likewise.
    bool shows = true;   ///< Rays can meet it.
};

struct Emitters {
    std::vector<Emitter> lights; ///< By the lights' index.
    std::vector<double> cumulative;
    double discArea = 0; ///< Of what distant lights shine through, m^2.
};

/// Lights are estimated. In `silent` is, for each light that shines and yet begins no paths, why.
Emitters findEmitters(const SceneState &, std::vector<std::string> &silent);

} // namespace candela
