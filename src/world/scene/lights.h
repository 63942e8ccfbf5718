// SPDX-License-Identifier: Apache-2.0
// Light sampling as estimators see it: points ask, samples answer, in batches.
#pragma once

#include "foundation/base/diagnostics.h"
#include "foundation/base/planes.h"
#include "foundation/base/vec3.h"
#include "foundation/units/color.h"

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

struct SceneState;
struct ShadingPoints;
struct EmissionGuide;
struct LightStartDensities;
struct LightStartNumbers;
struct LightStarts;

/// Lights come in groups, and each point takes a sample of each group: lamps, and what shines from
/// far and wide (suns, domes, ceilings). So neither leaves the other too few samples.
inline constexpr int lightGroups = 2;
enum LightGroup { lampGroup, wideGroup };

/// The points that ask for light.
struct LightQuery {
    int count = 0;
    std::array<const float *, 3> P{};  ///< Where rays to lights start, just off the surface.
    std::array<const float *, 3> Ps{}; ///< The point on the surface: what light shaders are told.
    std::array<const float *, 3> N{};  ///< Unit, facing; 0 where light from both sides counts.
    /// What light shaders without a surface are told besides: the shading normal at Ps, null where
    /// no surface asks; and from the viewer to Ps, null where none looks.
    std::array<const float *, 3> Ns{}, I{};
    /// Above 0 where scattered rays look for light beside these samples; null: nowhere.
    const float *scattered = nullptr;
    const std::int32_t *lightSet = nullptr;
    const float *time = nullptr;
    /// Uniform samples: which light, and where on it.
    const float *choice = nullptr;
    std::array<const float *, 2> position{};
};

/// One light sample for each point; planes are the caller's.
struct LightSamples {
    /// From LightQuery::P towards the light, as far as a shadow ray may go: finite lights end it a
    /// little before their own surface (docs/ray-offset.md).
    std::array<float *, 3> L{};
    float *distance = nullptr; ///< Length of L in metres; infinity for distant lights.
    /// What a loop's Cl is worth before the shadow: for finite pdf the radiance L_i (W m^-2
    /// sr^-1), undivided, since the pdf includes the choice; for delta lights (pdfSolidAngle = 0)
    /// E_perp / pi, or in classic units the number the light shader wrote, divided by the
    /// probability of choosing the light; of one in pieces, of the piece over its share of the
    /// area.
    std::array<float *, colorSamples> value{};
    float *pdfSolidAngle = nullptr; ///< Of this direction, choice included; 0 = delta light.
    std::int32_t *light = nullptr;  ///< Index + 1; 0 = no sample (black).
    /// 1 if a shadow ray is due (else the light shines through everything, as classic ones may).
    std::uint8_t *castsShadow = nullptr;
    /// For who weighs samples against paths from lights, else null: the probability of choosing
    /// what the sample lies on, and the unit normal there, 0 of delta lights.
    float *probability = nullptr;
    std::array<float *, 3> normal{};
};

/// What a light at infinity sends along rays that escape; planes are the caller's.
struct SkyAnswer {
    std::array<float *, colorSamples> radiance{}; ///< W m^-2 sr^-1; black where it is off.
    float *probability = nullptr;  ///< With which sample() chooses the light.
    float *directionPdf = nullptr; ///< Per steradian, of the direction once it is chosen.
};

/// What is told of a light in messages.
struct LightFacts {
    std::string title; ///< 'light "key" ("pointlight")'
    SourceLocation where;
    bool isThere = false;     ///< It has something to shine with; a faulty shader has not,
    bool lacksShapes = false; ///< nor has an area light around no shape.
    bool isEverOn = false;    ///< For some shape but its own, or there are no others.
    bool isTurnedOff = false; ///< Somewhere, by Illuminate.
    bool isAmbient = false;
    bool isSurface = false; ///< A surface that shines by its own shader: no light source.
    bool castsShadow = false;
    bool looksUpShadows = false; ///< Its shader finds its shadows, as it wants them.
    /// Of an area light: what the shaders of its surfaces send besides, W m^-2 sr^-1, and its share
    /// of all that the light sends. Estimates.
    double surfaceRadiance = 0, surfaceShare = 0;
};

/// The lights of a scene: samples of them, what they emit, and how likely samples would have met
/// what a ray has.
class Lights {
public:
    bool hasAmbient() const;
    /// The groups that have lights: whoever gathers light takes a sample of each.
    std::span<const LightGroup> groupsInUse() const;
    /// One sample a point, of one of the group's lights that are on for it, chosen by what they may
    /// bring.
    void sample(LightGroup, const LightQuery &, LightSamples &) const;
    /// sample() reads LightQuery::choice: which light, and where on it.
    bool readsChoice() const;
    /// How many samples were not finite so far; they count as 0.
    std::uint64_t nonFiniteSamples() const;
    /// `classic`: one sample of light `index` (of count()) at every point, no choice. Lamps
    /// that cast no shadows hide nothing but parts of themselves.
    int count() const;
    void sampleOne(int index, const LightQuery &, LightSamples &) const;
    LightFacts facts(int index) const;
    /// pdf[i] per steradian with which sample(), asked by `query` (of which count, P, N,
    /// lightSet and scattered are read), would have sent to the points, which rays from query.P
    /// have met on elements at `elementPoint`. 0 where the point is no light, or off.
    void density(const LightQuery &query, const ShadingPoints &,
                 const std::array<const float *, 3> &elementPoint, float *pdf) const;
    /// The same of points that are known by source and element (LightStarts); of delta lights,
    /// which have no element, the probability of choosing them. Whether they are on is not asked.
    void densityOf(const LightQuery &query, const std::int32_t *source, const std::int32_t *element,
                   const std::array<const float *, 3> &elementPoint, float *pdf) const;
    /// radiance[c][i] that area lights (si) and emitting surfaces send from the points to the
    /// viewers they were hit from (I), W m^-2 sr^-1; added to what is there.
    void emission(int code, ShadingPoints &, float *const *radiance) const;
    /// The lights at infinity that rays meet which escape, by index + 1.
    std::span<const std::int32_t> skies() const;
    /// What one of them sends along rays in these unit directions. Of the query count (at most 512),
    /// P, Ps, N, lightSet, scattered and time are read; light sets are there. Lights that cast no
    /// shadow are sampled as if no ray met them.
    void sky(std::int32_t number, const LightQuery &query,
             const std::array<const float *, 3> &direction, const SkyAnswer &) const;
    /// It casts shadows; `light` is index + 1.
    bool castsShadow(std::int32_t light) const;
    /// Sum of the ambient lights at the points, as ambient() returns it. Of the query count, Ps,
    /// Ns, I and lightSet are read.
    void ambient(const LightQuery &, float *const *ambient) const;
    /// `light` as in ShadingPoints and LightSamples: index + 1, and 0 (indirect) is always on.
    bool isOn(std::int32_t lightSet, std::int32_t light) const;
    /// The light set of points that hear every light that is on for some surface; in a world
    /// without surfaces, every light.
    std::int32_t setOfAll() const;
    /// Scattered rays bring nothing of lights: some surfaces stop those and let shadow rays pass.
    bool areLeftToSamples() const;

    // ---- Paths that begin on lights (world/scene/light_starts.h) ----

    /// Some light begins paths.
    bool startPaths() const;
    /// `guide`, here and below: what is known of where paths are worth beginning; null = nothing.
    void start(int count, const LightStartNumbers &, const EmissionGuide *guide,
               LightStarts &) const;
    /// The densities with which start() begins paths at light[i] (index + 1) that leave along unit
    /// directions, from points with these normals, and pass the points P; 0 where it never does.
    void startDensities(int count, const std::int32_t *light,
                        const std::array<const float *, 3> &direction,
                        const std::array<const float *, 3> &normal,
                        const std::array<const float *, 3> &P, const EmissionGuide *guide,
                        const LightStartDensities &) const;
    /// Where on the square of its light's grid a path begins; and one that leaves the light for P,
    /// of lights that have one place. None where there is no grid to be had.
    std::optional<std::array<double, 2>> guidedPlace(std::int32_t light, const Vec3 &direction,
                                                     const Vec3 &P) const;
    std::optional<std::array<double, 2>> guidedPlaceFor(std::int32_t light, const Vec3 &P) const;
    /// A radiance of the order of what there is: as if all light were spread over a sphere around
    /// the scene. 0 if none is known.
    double typicalRadiance() const;
    /// How likely paths begin at the lights, by index, as long as nothing is learned.
    std::vector<double> startProbabilities() const;
    /// What light[i] (index + 1), which has no extent, sends to the points; black where it is off.
    /// `query.position` is LightStarts::lightSample, its choice is not read.
    void sampleGiven(const std::int32_t *light, const LightQuery &query, LightSamples &) const;
    bool isDistant(std::int32_t light) const;

private:
    friend class Scene;
    explicit Lights(const SceneState &state) : state_(&state) {}
    const SceneState *state_;
};

} // namespace candela
