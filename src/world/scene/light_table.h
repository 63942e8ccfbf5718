// SPDX-License-Identifier: Apache-2.0
// The lights of a scene, and which of them is chosen how often.
#pragma once

#include "world/shading/shader_library.h"

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace candela {

enum class LightKind : std::uint8_t {
    None,        ///< Declared, but there is nothing of it (no geometry, faulty shader).
    Ambient,     ///< Only in ambient().
    Point,       ///< A light shader with illuminate().
    Distant,     ///< A light shader with solar().
    ClassicArea, ///< Primitives with a light shader in classic units: a mean over positions.
    Area,        ///< Primitives with a light shader that gives radiance.
    Emitter,     ///< A primitive whose surface shader emits.
};

/// See flat_light.h: columns of 16 floats, one a triangle, and the running sum of their shares.
struct FlatLight {
    std::vector<float> columns, cumulative;
    explicit operator bool() const { return !columns.empty(); }
};

struct SceneLight {
    LightKind kind = LightKind::None;
    ShaderInstance shader;
    bool si = true;
    bool castsShadow = true;
    bool finite() const { return kind == LightKind::Area || kind == LightKind::Emitter; }
    Matrix4 currentFromShader;
    /// With geometry: flat triangles and whole parametric surfaces (triangle = wholeSurface) of
    /// all its primitives, with the running sum of their shares of the area.
    struct Triangle {
        std::uint32_t primitive, triangle;
    };
    std::vector<Triangle> triangles;
    std::vector<double> cumulative; ///< cumulative[i] = share of triangles 0..i; ends with 1.
    double area = 0;                ///< Of all triangles, m^2.
    FlatLight flat;                 ///< If it can be sampled so.
    int surfaceCode = -1;           ///< The code of all its primitives; -1 = they differ.
    double power = 0;               ///< An estimate; W, or what would be W for classic units.
    float probability = 0;          ///< Of being chosen.
    int batch = 0;                  ///< Lights of one batch share kind and code.
};

/// Chooses index i with the probability that a running sum gives it; `sample` in [0,1) becomes a
/// new uniform sample.
int chooseByCumulative(std::span<const double> cumulative, double &sample);

struct LightTable {
    std::vector<SceneLight> lights; ///< LightRecords in order, then emitting surfaces.
    std::vector<double> cumulative; ///< Over lights that can be sampled (the others' share is 0).
    std::vector<int> ambient;       ///< Indices of the ambient lights.
    int batches = 0;
    int only = -1;                  ///< The index of the light, if there is but one to sample.
    std::vector<std::uint8_t> isOn; ///< [lightSet * (lights + 1) + index + 1].

    bool any() const { return !cumulative.empty() && cumulative.back() > 0; }
    bool on(std::int32_t lightSet, std::int32_t light) const {
        return isOn[std::size_t(lightSet) * (lights.size() + 1) + light] != 0;
    }
    /// On for every light set.
    bool onEverywhere(std::int32_t light) const {
        for (std::size_t at = light; at < isOn.size(); at += lights.size() + 1)
            if (!isOn[at])
                return false;
        return true;
    }
    /// There is one light to sample, flat and on for all: it needs no choice.
    bool isOneFlatLight() const { return only >= 0 && lights[only].flat && onEverywhere(only + 1); }
    /// Sets probabilities and batches once the powers are known.
    void finish();
};

} // namespace candela
