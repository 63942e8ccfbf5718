// SPDX-License-Identifier: Apache-2.0
// What a Scene holds.
#pragma once

#include "world/points/evaluate.h"
#include "world/scene/emitters.h"
#include "world/scene/light_sources.h"
#include "world/scene/media.h"
#include "world/scene/scene.h"

#include <atomic>
#include <memory>
#include <vector>

namespace candela {

struct SceneState {
    explicit SceneState(const Options &o) : options(o), camera(o) {}

    Options options;
    Camera camera;
    bool classic = false;       ///< The integrator is "classic".
    bool bidirectional = false; ///< Paths begin on lights, too.
    bool solved = false;        ///< Light is solved for on surfaces: `radiosity`.
    bool hasMatte = false;
    bool dissolves = false; ///< Some shapes are there for some paths alone: levels of detail.

    PointTables points;
    std::vector<int> binOfAppearance, codeOfBin; ///< See Scene::bins.
    bool readsFootprints = false;                ///< Some of the codes do.
    std::vector<std::vector<int>> lightSets;     ///< Indices of the lights on, by lightSet.
    std::unique_ptr<RayWorld> rays;
    LightTable lights;
    Emitters emitters;                           ///< Empty where no paths begin on lights.
    std::vector<ShaderInstance> media;           ///< Volumes by their numbers; the first is none.
    std::vector<SurfaceMedia> mediaOfAppearance; ///< In the order of points.appearances.
    std::vector<std::int32_t> mediaOfLight;      ///< By index: the atmosphere of what shines.
    std::vector<const ShaderCode *> areaLightCodes; ///< Distinct shaders of Area lights.
    /// Samples of lights that were not finite, and counted as 0.
    mutable std::atomic<std::uint64_t> nonFiniteLight = 0;
    Scene::Statistics statistics;
    Box3 bound;  ///< Of the scene, current space; empty if there is nothing.
    Vec3 centre; ///< Of a sphere around it.
    float radius = 1;

    /// Numbers the bins, once it is known what is a light.
    void numberBins();
    /// Fills mediaOfLight, likewise.
    void findMediaOfLights();
    /// Lights::emission; `prints` as in ShaderCode::bind().
    void emission(int code, ShadingPoints &, float *const *radiance, bool prints = true) const;
};

} // namespace candela
