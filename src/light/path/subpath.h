// SPDX-License-Identifier: Apache-2.0
// Paths that are made from both of their ends: what a vertex must know of the ways in which the
// path up to it might have been found (Veach 1997, section 10.2; kept incrementally as Georgiev
// 2012 has it).
//
// A path with the vertices x_0 (on a light) to x_k (on the lens) is found by technique s if its
// first s vertices come from the light and the others from the eye. Techniques count by the square
// of n p, their densities in area measure times how often each is tried. With f_i the density of a
// vertex from its own end and r_i that from the other, the techniques that take fewer vertices from
// the end of x_m add up, over the square of the one that ends there, to
//
//     r_m^2 (last_m + r_(m-1)^2 earlier_m)
//     last_m    = n^2 / f_m^2                                        0 where the edge is no
//     connection earlier_m = (last_(m-1) + r_(m-2)^2 earlier_(m-1)) / f_m^2
//
// Vertex merging (Georgiev 2012) takes x_m from both ends: n paths from lights are tried, each of
// which is there if it meets a disc of the radius r, so its density is that of the technique that
// ends at x_m times r_m pi r^2, and with eta = pi r^2 n (TechniqueCounts::merging)
//
//     last_m + eta^2     stands in the place of last_m
//
// of vertices that may be merged, those with finite lobes. The sum over all other techniques, over
// the square of merging at x_m, is (last_m + r_(m-1)^2 earlier_m) / eta^2 of both ends together.
//
// Straight on through a surface is no vertex: the edge goes on. A vertex of one direction has the
// density 1 both ways and no connections; one that light cannot pass the other way forgets what was
// before it.
#pragma once

#include "light/path/paths.h"
#include "light/path/settings.h"
#include "light/vertex/finite_lobes.h"

namespace candela {

struct PathWave;

struct Subpaths {
    Subpaths(int capacity, TechniqueCounts);

    TechniqueCounts counts;
    Planes<double> doubles;
    /// As above, of the chunk's vertices, and of those that go on what SubpathHistory keeps.
    /// Without what merging at the vertex adds.
    double *last, *earlier, *nextEarlier, *nextConnections;
    /// `earlier` with the techniques alone that `path` has, too: of paths from lights.
    double *earlierOfPath, *nextEarlierOfPath;
    Planes<float> floats;
    float *back; ///< r_(m-1) over the density per steradian of the direction to x_(m-1).
    MutableVec3Planes toPrevious, seenAlong; ///< Unit vectors; I of `other`.
    float *reversePdf, *nextPdf, *nextCosine;
    float *startPosition, *startDirection; ///< Lights::startDensities.
    Planes<std::int32_t> integers;
    std::int32_t *reverseRequest; ///< By which delta vertices are passed the other way.
    VertexView other;             ///< Of the chunk's vertices, from where paths go on.
};

/// Stage: densities as far as the chunk's vertices.
void arrive(PathWave &);
/// The weights of emission that rays have met, beside paths from lights, too.
void weighEmissionAmongAll(PathWave &, float *weight);
/// Likewise the factors of light samples (chunk.direct).
void weighLightSamplesAmongAll(PathWave &);
/// last_m + r_(m-1)^2 earlier_m of vertex i, without merging there; `reversePdf` is the density per
/// steradian towards x_(m-1).
double techniquesUpTo(const Subpaths &, int i, double reversePdf);
/// r_m^2 (last_m + eta^2 + r_(m-1)^2 earlier_m), `reached` being r_m.
double techniquesBefore(const Subpaths &, int i, double reached, double reversePdf);
/// The part of them that `path` has: of a path from a light whose first vertex it is, if `isFirst`.
double pathTechniquesBefore(const Subpaths &, int i, double reached, double reversePdf,
                            bool isFirst);
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
