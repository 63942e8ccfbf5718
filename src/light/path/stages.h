// SPDX-License-Identifier: Apache-2.0
// The stages of a wave: free functions on the record, in the order of the flow (docs/flow.md).
#pragma once

#include "light/path/wave.h"

namespace candela {

// ---- Where paths begin ----

/// Of a pixel's samples, those of even numbers, those of odd ones, or all.
enum class Halves : std::uint8_t { None, Even, Odd, Both };

/// The samples [first, last) of pixels (x[i], y[i]). Without `halves` they are one sequence.
/// Otherwise the two halves of a pixel are sequences that know nothing of each other: sample k of
/// the even half is the pixel's 2 k, that of the odd half its 2 k + 1; `first` is even.
struct CameraSamples {
    int pixels;
    const int *x, *y;
    int first, last;
    const Halves *halves = nullptr; ///< Of each pixel: what is taken.
};
/// Camera paths, pixel by pixel.
void startCamera(PathWave &, const CameraSamples &);
/// Paths along the rays of vertices lane[0..count), which take slots in this order.
void startGathering(PathWave &, int count, const int *lane, const GatheringRays &);

// ---- All paths at once ----

/// Hits of the active rays.
void trace(PathWave &);
/// What rays bring that have met nothing: skies (world/scene/skies.h).
void escape(PathWave &);
/// Sorts the hits by what is shaded together.
void bin(PathWave &);

// ---- One chunk of vertices ----

/// Shading points, and what the stages need of their paths.
void meet(PathWave &);
/// What volumes make of the segments to the vertices: what they send joins the light gathered, what
/// they let through is what the vertices' light is worth.
void cross(PathWave &);
/// What lamps and emitting surfaces send along the rays that met them.
void emit(PathWave &);
/// Asks the shader for importance, opacity and the answer to ambient light.
void ask(PathWave &);
/// What the camera sees at first hand: opacity, and the channels of the first surface. Points at
/// which a loop was ended are black from there on.
void see(PathWave &);
/// Output parameters of shaders that displays show, of all surfaces that the camera sees. Where all
/// light has been given already, it is the same; else what they want of it is gathered for them.
void seeOutputParameters(PathWave &);
/// The density of directions, from the cones that the shader has stated.
void stateLobes(PathWave &);
/// Ambient light, and one light by chance.
void light(PathWave &);
/// Every light at once, as RI 3.1 has it.
void lightClassic(PathWave &);
/// What the solution says of the vertices: irradiance, as irradiance() answers it.
void lookUpSolution(PathWave &);
/// The solution's light, reflected as a uniform field is, but for shaders that have called
/// irradiance(), which have it.
void takeSolution(PathWave &);
/// Many samples at once, for shaders that no single one can be asked about.
void lightGathered(PathWave &);
/// The paths go on along finite lobes, trace() and what shines through.
void scatter(PathWave &);
/// The same where all finite light has been given: along trace() and what shines through alone,
void scatterBesidesFiniteLobes(PathWave &);
/// and without noise as long as the paths carry much.
void branch(PathWave &);
/// The light gathered joins what the paths have.
void deliver(PathWave &);

// ---- The flow ----

/// The StageList of `path` and `classic`.
std::span<const Stage> stagesOfIntegrator(const PathWave &, const ShaderCode &);
/// Follows all paths to their ends. Their rays lead to the vertex of this number: where paths have
/// begun at points rather than with the camera, those points are vertex 0.
void follow(PathWave &, int vertex = 0);

} // namespace candela
