// SPDX-License-Identifier: Apache-2.0
// What a Scene holds: primitives in current space, the codes that shade them, and the lights.
#pragma once

#include "world/geometry/surface.h"
#include "world/rays/ray_world.h"
#include "world/scene/flat_points.h"
#include "world/scene/light_table.h"
#include "world/scene/scene.h"
#include "world/scene/surface_points.h"
#include "world/scene/uv_density.h"

#include <array>
#include <memory>
#include <vector>

namespace candela {

/// A surface with everything that evaluation of whole runs of points needs.
struct ScenePrimitive {
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const Attributes> attributes;
    Matrix4 currentFromObject, objectFromCurrent;
    /// -1 if the natural normal is to be turned round.
    float normalSign = 1;
    /// Empty unless points of triangles are named by interpolated (u,v): see DicedMesh.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 2>> vertexUv;
    /// Lights only: the density with which light sampling chooses its points. Surfaces whose
    /// points are named by (u,v) have it over (u,v), others per unit area, a triangle each.
    std::shared_ptr<UvDensity> uvDensity;
    std::vector<float> density;
    /// Index into Surface::variables(), -1 = none.
    int s = -1, t = -1, Cs = -1, Os = -1;
    /// For each distinct name in the code's variables: which variable of the surface it is.
    std::vector<int> overriding;
};

/// What every single point needs of its primitive, in a cache line.
struct alignas(64) PrimitiveSummary {
    std::int32_t parameterOffset = 0;
    std::int32_t lightSet = 0;
    std::int32_t light = 0; ///< Index + 1, 0 = none.
    std::int32_t code = 0;
    float offset = 0; ///< See ShadingPoints::offset, without the share that depends on P.
    std::array<float, colorSamples> Cs{}, Os{};
};

/// Inputs that evaluation may leave out.
struct WantedInputs {
    bool dPd = false, uv = false, footprint = false, st = false, Cs = false, Os = false;
    bool stDerivatives = false, orientation = false;
    bool time = false, E = false;

    /// Adds what a shader reads.
    void add(const ShaderCode &);
};

/// A surface shader's code and what was worked out about it once.
struct SceneCode {
    std::shared_ptr<ShaderCode> code;
    /// Distinct names among the code's variables, and for each variable plane its name's number.
    std::vector<std::string> variableNames;
    std::vector<int> variableName, variableComponent;
    /// What this code reads, and the shaders of area lights on its primitives.
    WantedInputs wanted;
    bool flat = false; ///< Served by SceneState::flatTable.
};

/// Instead of a triangle's number: (u,v) are the surface's own.
inline constexpr std::uint32_t wholeSurface = noTriangle;

/// Eight roundings of a float, for what evaluation, transformation and intersection lose.
inline constexpr float roundingShare = 8 * 0x1p-24f;

/// Points named by where they lie on the dicing; arrays of `count`.
struct TrianglePoints {
    int count = 0;
    const std::uint32_t *primitive = nullptr, *triangle = nullptr;
    const float *u = nullptr, *v = nullptr;
};

struct SceneState {
    explicit SceneState(const Options &o) : options(o), camera(o) {}

    Options options;
    Camera camera;
    bool classic = false; ///< The integrator is "classic".

    std::vector<ScenePrimitive> primitives;
    std::vector<PrimitiveSummary> summaries;
    std::vector<float> objectMatrices; ///< 32 floats a primitive, as ShaderArgs wants them.
    std::vector<SceneCode> codes;
    std::vector<int> binOfPrimitive, codeOfBin; ///< See Scene::bins.
    std::vector<std::vector<int>> lightSets;    ///< Indices of the lights on, by lightSet.
    std::unique_ptr<RayWorld> rays;
    std::vector<std::uint32_t> triangleCounts; ///< Of each primitive's dicing.
    FlatTable flatTable;
    LightTable lights;
    std::vector<const ShaderCode *> areaLightCodes; ///< Distinct shaders of Area lights.
    Scene::Statistics statistics;
    Vec3 centre; ///< Of a sphere around the scene, current space.
    float radius = 1;

    /// Numbers the bins, once it is known what is a light.
    void numberBins();
    /// Fills the points' inputs (but I, E and time) and the rest of the ShadingPoints.
    void evaluate(const TrianglePoints &, const SceneCode &, ShadingPoints &) const;
    /// Scene::bind and Scene::emission.
    void bind(int code, const ShadingPoints &, ShaderArgs &) const;
    void emission(int code, const ShadingPoints &, float *const *radiance) const;
    /// A point of a finite or classic area light: which triangle, and where on it. `choice` and
    /// the position are uniform samples.
    void placeOnLight(const SceneLight &, double choice, float x, float y, std::uint32_t &primitive,
                      std::uint32_t &triangle, float &u, float &v) const;
};

/// Bytes of a thread's own, kept from call to call so that hot paths do not allocate.
template <class T> class Scratch {
public:
    T *get(std::size_t count) {
        if (values_.size() < count)
            values_.resize(count + count / 2);
        return values_.data();
    }

private:
    std::vector<T> values_;
};

} // namespace candela
