// SPDX-License-Identifier: Apache-2.0
// The lights of a scene, the sources that they consist of, and what these are made of: points
// choose among sources, aim at elements, and shaders are asked about lights.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/lights/light_choice.h"
#include "world/lights/sky_cones.h"
#include "world/points/point_tables.h"
#include "world/scene/lights.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

enum class LightKind : std::uint8_t {
    None,        ///< Declared, but there is nothing of it (no geometry, faulty shader).
    Ambient,     ///< Only in ambient().
    Point,       ///< A light shader with illuminate().
    Distant,     ///< A light shader with solar().
    ClassicArea, ///< Shapes with a light shader in classic units: a mean over positions.
    Area,        ///< Shapes with a light shader that gives radiance.
    Emitter,     ///< A shape whose surface shader emits.
};

/// The sides of its surfaces that a light shines from, as far as samples tell.
enum class LightSides : std::uint8_t { Both, Front, Back };

/// What rays meet of a light, a triangle or a sphere, or the rectangle that a triangle is half of;
/// of a light without geometry, nothing. A cache line, read as a row.
struct alignas(64) LightElement {
    enum class Form : std::int32_t { NoShape, Triangle, Rectangle, Sphere };
    std::int32_t source = 0; ///< The one that it belongs to.
    Form form = Form::NoShape;
    std::uint32_t instance = noHit, shape = 0, element = 0; ///< The place of a triangle's points.
    /// Current space. Spheres: the centre, the radius as edgeA.x, and as edgeB.x how often those
    /// outside aim at the wall that is farther off.
    Vec3 corner, edgeA, edgeB;
    float offset = 0; ///< Rays towards it end so far before it: see ShadingPoints::offset.
    float area = 0;   ///< Of its whole source, m^2.
};

/// What is chosen: a light without geometry, a piece of one with it. A piece is an element, or
/// several, which are drawn by area.
struct LightSource {
    std::int32_t light = 0;                    ///< Index.
    std::int32_t firstMember = 0, members = 0; ///< In LightTable::members; at least one.
    std::int32_t bin = 0;                      ///< Index into LightTable::bins.
    double area = 0;                           ///< m^2; 0 without geometry.
    float handedness = 1;                      ///< Of the instance that it lies on.
};

/// What sources that are asked together have in common.
struct SourceBin {
    enum class Asked : std::int32_t {
        Surface,     ///< Shading points of surfaces that shine, by `surfaceCode`.
        PlainShader, ///< Light shaders that look at positions and normals alone.
        PointShader, ///< Light shaders without shapes.
        ClassicArea, ///< Light shaders in classic units, at points of shapes.
    };
    Asked asked = Asked::PointShader;
    int surfaceCode = -1;
    const ShaderCode *shader = nullptr; ///< Of the light.
    bool castsShadow = true, si = true, distant = false;
    bool isSky = false; ///< Samples share with rays that escape.
    float elementSign = 1; ///< Appearance::elementSign.
    float frontSign = 0; ///< RayShape::frontSign: what is seen from one side shines to that alone.

    bool operator==(const SourceBin &) const = default;
};

struct SceneLight {
    LightKind kind = LightKind::None;
    ShaderInstance shader;
    bool si = true;
    bool castsShadow = true;
    bool looksUpShadows = false; ///< Its shader does.
    /// Shader and surfaces look at position and normals alone: elements tell all, and the sources
    /// may be rectangles.
    bool plain = false;
    Matrix4 currentFromShader;     ///< When the shutter opens.
    std::vector<Matrix4> steps;    ///< The same over its interval; empty where it stands still.
    bool parametersChange = false; ///< With time: it may shine from elsewhere then.
    std::int32_t firstSource = 0, sources = 0;
    std::vector<double> cumulative; ///< With geometry: running sum of the sources' share of area.
    double area = 0;                ///< Of all sources, m^2.
    double areaLeft = 0;            ///< The same without what solids have cut away.
    std::int32_t elements = 0;      ///< Of all sources.
    bool opaque = true;             ///< All its shapes.
    int surfaceCode = -1;           ///< The code of all its shapes; -1 = they differ.
    Box3 place;                     ///< Without geometry: where it stands; empty = not known.
    Vec3 axis;                      ///< Without geometry: unit vector, or zero.
    float spread = 3.14159274f;     ///< Nearly all of its light leaves within this of the axis.
    LightSides sides = LightSides::Both;
    std::optional<SkyCones> sky; ///< Of what rays meet that escape (world/scene/skies.h).
    double power = 0; ///< An estimate; W, or what would be W for classic units.
    /// Of area lights: what their surfaces' shaders send besides; an estimate of its mean.
    double surfaceRadiance = 0;
    /// For messages: 'light "key" ("pointlight")', and where it stands.
    std::string title{};
    SourceLocation where{};
    bool isTurnedOff = false; ///< As LightRecord has it.

    bool finite() const { return kind == LightKind::Area || kind == LightKind::Emitter; }
    bool hasGeometry() const { return finite() || kind == LightKind::ClassicArea; }
    bool isSampled() const { return kind != LightKind::None && kind != LightKind::Ambient; }
};

/// Chooses index i with the probability that a running sum gives it; `sample` in [0,1) becomes a
/// new uniform sample.
int chooseByCumulative(std::span<const double> cumulative, double &sample);

struct LightTable {
    std::vector<SceneLight> lights; ///< LightRecords in order, then emitting surfaces.
    std::vector<LightSource> sources;
    /// Those of a placed shape are consecutive, in the order of its own (Appearance::firstElement).
    std::vector<LightElement> elements;
    /// The sources' elements, and for each the share of the source's area up to and with it.
    std::vector<std::int32_t> members;
    std::vector<double> memberShares;
    std::vector<SourceBin> bins;
    /// By light set: among the lights of each group.
    std::vector<std::array<LightChoice, lightGroups>> choices;
    std::vector<LightGroup> groups;              ///< Those that have lights.
    std::vector<int> ambient;                    ///< Indices of the ambient lights.
    std::vector<std::int32_t> skies;             ///< Index + 1 of those that have SceneLight::sky.
    std::vector<std::vector<std::uint8_t>> isOn; ///< [lightSet][index + 1].
    std::int32_t setOfAll = 0;                   ///< See Lights::setOfAll(),
    bool leftToSamples = false;                  ///< and areLeftToSamples().
    bool isSingle = false; ///< There is one source at most, on for all: none has to be chosen.

    bool on(std::int32_t lightSet, std::int32_t light) const { return isOn[lightSet][light] != 0; }
    /// One of the source's elements, by area.
    std::int32_t drawElement(const LightSource &, float &sample) const;
    const LightElement &firstElementOf(const LightSource &source) const {
        return elements[members[source.firstMember]];
    }
    /// Sorts the sources into bins, lists the ambient lights.
    void number(const PointTables &);
};

} // namespace candela
