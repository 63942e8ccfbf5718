// SPDX-License-Identifier: Apache-2.0
// Paths that are made from both of their ends, a chunk of vertices at a time; techniques.h has what
// is computed.
#pragma once

#include "light/path/paths.h"
#include "light/path/techniques.h"
#include "light/vertex/finite_lobes.h"

#include <vector>

namespace candela {

struct PathWave;

struct Subpaths {
    Subpaths(int capacity, TechniqueCounts);

    TechniqueCounts counts;
    /// Of the chunk's vertices, and what those that go on leave on their rays.
    std::vector<PathVertex> vertices;
    std::vector<PathEdge> leaving;
    Planes<float> floats;
    MutableVec3Planes toPrevious, seenAlong; ///< Unit vectors; I of `other`.
    float *reversePdf, *nextPdf, *nextCosine;
    float *startPosition, *startDirection; ///< Lights::startDensities.
    Planes<std::int32_t> integers;
    std::int32_t *reverseRequest; ///< By which delta vertices are passed the other way.
    VertexView other;             ///< Of the chunk's vertices, from where paths go on.

    /// Some of the first vertices have been found in other ways, too.
    bool anyEarlier(int count) const;
};

/// Stage: densities as far as the chunk's vertices.
void arrive(PathWave &);
/// The weights of emission that rays have met, beside paths from lights, too.
void weighEmissionAmongAll(PathWave &, float *weight);
/// Likewise of what an active ray has met at infinity; the densities are per steradian, of the
/// direction, and per m^2 across.
float weightAmongLightPaths(const PathWave &, int ray, float weight, double startPosition,
                            double startDirection);
/// Likewise the factors of light samples (chunk.direct).
void weighLightSamplesAmongAll(PathWave &);
/// What the chunk's paths would be from their other ends if they went on along the events in these
/// directions, looked at by `other`; before roulette.
void lookBack(PathWave &, const ConstVec3Planes &direction);
/// Gives it to the paths that append() has put at next[first] on.
void leaveHistory(PathWave &, int count, int first);
/// Histories of camera rays.
void beginHistory(PathWave &);
/// Of rays from points that no path from a light meets, nor is connected with.
void beginHistoryAtPoints(PathWave &);

} // namespace candela
