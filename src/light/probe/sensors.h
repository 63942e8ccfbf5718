// SPDX-License-Identifier: Apache-2.0
// A wave of samples that begin at points: sensors, which take the light of a hemisphere, and rays.
// A sensor is a vertex without a shader: white, Lambertian, one-sided.
#pragma once

#include "light/path/wave.h"

namespace candela {

/// Samples by slot, in current space; filled by who asks.
struct ProbeSlots {
    /// Half of a wave: mirrors and glass make branches.
    static constexpr int capacity = PathWave::capacity / 2;
    ProbeSlots();

    int count = 0;
    Planes<float> floats;
    MutableVec3Planes Ps;     ///< The point, as light shaders are told it,
    MutableVec3Planes origin; ///< and where rays begin: just off it, on the sensor's side.
    MutableVec3Planes aim;    ///< The sensor's unit normal, or the ray's unit direction.
    float *time;
    Planes<int> integers;
    int *point; ///< Number, for messages.
    Planes<std::uint32_t> keys;
    std::uint32_t *pixelKey, *sampleIndex; ///< The address of the sample's random numbers.
    /// What is found: irradiance W m^-2 or radiance W m^-2 sr^-1.
    Planes<float> value;
};

/// Room for the light of sensors: of some slots at a time,
struct SensorLight {
    SensorLight();

    ConeMixture mixture; ///< A cosine lobe.
    LightSampleStorage sample;
    ShadowRays shadow;
    Planes<float> floats, unit, ambient;
    float *one, *hemisphere; ///< What the lobe is, everywhere the same.
    float *choice, *u, *v, *ignored, *directionPdf, *factor;
    Planes<std::int32_t> integers;
    std::int32_t *lightSet, *air, *inShadow, *shadowed;
    /// Directions find lights, too, so that light samples share with them.
    bool sharesWithDirections = false;
    Planes<std::uint32_t> around; ///< Of those in air.
};

/// and of all slots: the rays that leave them.
struct ProbeRays {
    ProbeRays();

    Planes<float> direction, none, floats;
    float *pdf, *width, *spread;
    Planes<int> integers;
    int *lane, *depth, *lightSet;
};

/// What a sensor takes: all light; that of light sources; or that of ambient lights alone, where
/// the rest is known.
enum class SensorTakes { All, Sources, Ambient };

/// The irradiance at the slots: one light of each group by chance, and what comes along a direction
/// of the cosine lobe, weighted against each other as at any vertex. Light may be scattered
/// IntegratorSettings::maxDepth times on its way, and paths end on a solution where there is one.
/// Under `classic` it is every light, and no other surface. Ambient lights come from everywhere
/// alike.
void measureIrradiance(PathWave &, ProbeSlots &, SensorLight &, ProbeRays &,
                       SensorTakes = SensorTakes::All);

/// The radiance that comes to the slots against their directions.
void measureRadiance(PathWave &, ProbeSlots &, ProbeRays &);

} // namespace candela
