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
//     last_m    = n^2 / f_m^2                           0 where the edge is no connection
//     earlier_m = (last_(m-1) + r_(m-2)^2 earlier_(m-1)) / f_m^2
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
// before it. At infinity directions stand for places: densities are per steradian there.
#pragma once

#include "light/path/settings.h"
#include "light/vertex/vectors.h"

#include <cmath>

namespace candela {

/// What a ray knows of the vertex that it left.
struct PathEdge {
    double earlier = 0; ///< PathVertex::earlier of the next vertex, times its density squared,
    double earlierOfPath = 0; ///< and this likewise.
    double connections = 0;   ///< The square of how often this edge is a connection; 0 = never.
    double pdf = 1;           ///< Of the direction, per steradian; 1 = it had no choice.
    double cosine = 0;        ///< With the geometric normal, >= 0.
    bool parallel = false;    ///< pdf is that of the ray's place across it, per m^2.
};

/// Of a vertex, seen from where the path came from.
struct PathVertex {
    double last = 0, earlier = 0; ///< As above, without what merging at the vertex adds.
    /// `earlier` with the techniques alone that `path` has, too: of paths from lights.
    double earlierOfPath = 0;
    double back = 0; ///< r_(m-1) over the density per steradian of the direction to x_(m-1).

    /// last_m + r_(m-1)^2 earlier_m, without merging; `reversePdf` is the density per steradian
    /// towards x_(m-1).
    double techniques(double reversePdf) const {
        return last + square(reversePdf * back) * earlier;
    }
    /// r_m^2 (last_m + eta^2 + r_(m-1)^2 earlier_m), `reached` being r_m.
    double techniquesBefore(const TechniqueCounts &counts, double reached,
                            double reversePdf) const {
        return square(reached) * (techniques(reversePdf) + square(counts.merging));
    }
    /// The part of them that `path` has: of a path from a light whose first vertex it is, if
    /// `isFirst`.
    double techniquesOfPath(double reached, double reversePdf, bool isFirst) const {
        return square(reached) * ((isFirst ? last : 0) + square(reversePdf * back) * earlierOfPath);
    }
};

/// The vertex that the edge leads to; `cosine` is with its geometric normal, of any sign.
inline PathVertex arriveAlong(const PathEdge &edge, double cosine, double distance) {
    const double perArea = edge.parallel ? 1 : 1 / square(distance);
    const double density = edge.pdf * std::fabs(cosine) * perArea;
    const double inverse = density > 0 ? 1 / square(density) : 0;
    return {edge.connections * inverse, edge.earlier * inverse, edge.earlierOfPath * inverse,
            edge.cosine * perArea};
}

/// What rays meet at infinity, where directions stand for places.
inline PathVertex arriveAtSky(const PathEdge &edge) {
    const double inverse = edge.pdf > 0 ? 1 / square(edge.pdf) : 0;
    return {edge.connections * inverse, edge.earlier * inverse, edge.earlierOfPath * inverse,
            edge.cosine};
}

/// How a path goes on from a vertex.
struct PathEvent {
    bool isFinite = true;   ///< A direction that was drawn; else one without a choice.
    bool isPassable = true; ///< From the other end, too.
    bool isFirst = false;   ///< Of a path from a light: the first vertex.
    double pdf = 1, reversePdf = 1, cosine = 0; ///< As in PathEdge and PathVertex.
};

inline PathEdge leaveAlong(const PathVertex &vertex, const PathEvent &event,
                           const TechniqueCounts &counts) {
    const double last = event.isFinite ? vertex.last : 0;
    const double back = square(event.reversePdf * vertex.back);
    const double merged = event.isFinite ? square(counts.merging) : 0;
    PathEdge edge;
    if (event.isPassable) {
        edge.earlier = last + merged + back * vertex.earlier;
        edge.earlierOfPath = (event.isFirst ? last : 0) + back * vertex.earlierOfPath;
    }
    edge.connections = event.isFinite ? square(counts.connections) : 0;
    edge.pdf = event.isFinite ? event.pdf : 1;
    edge.cosine = event.cosine;
    return edge;
}

// ---- All other techniques, over the square of one ----

/// Of emission that a path from the eye has met: but for light samples. The densities are those
/// with which a path would begin there.
inline double othersOfEmission(const PathVertex &light, double startPosition,
                               double startDirection) {
    return square(startPosition * startDirection * light.back) * light.earlier;
}

/// Of a light sample, but for directions that might have met it: `started` is the density with
/// which a path that begins on the light reaches the vertex, over that of the sample.
inline double othersOfLightSample(const PathVertex &vertex, const TechniqueCounts &counts,
                                  double started, double reversePdf) {
    return vertex.techniquesBefore(counts, started, reversePdf);
}

/// Of what one end's vertex knows, for a connection: the density with which the other end would
/// reach it, and from it x_(m-1).
struct ReachedVertex {
    PathVertex vertex;
    double reached = 0, reversePdf = 0;
};
inline double othersOfConnection(const ReachedVertex &fromEye, const ReachedVertex &fromLight,
                                 const TechniqueCounts &counts) {
    const auto before = [&](const ReachedVertex &end) {
        return end.vertex.techniquesBefore(counts, end.reached, end.reversePdf);
    };
    return (before(fromEye) + before(fromLight)) / square(counts.connections);
}

/// Of merging: both are the same vertex.
inline double othersOfMerging(const PathVertex &fromEye, double eyeReversePdf,
                              const PathVertex &fromLight, double lightReversePdf,
                              const TechniqueCounts &counts) {
    return (fromEye.techniques(eyeReversePdf) + fromLight.techniques(lightReversePdf)) /
           square(counts.merging);
}

/// Of a vertex that a path from a light shows to the camera, which would have reached it.
inline double othersOfLightImage(const ReachedVertex &fromLight, const TechniqueCounts &counts) {
    return fromLight.vertex.techniquesBefore(counts, fromLight.reached, fromLight.reversePdf) /
           square(counts.lightImage);
}

// ---- Ends ----

/// Of camera rays.
inline PathEdge edgeOfCamera(const TechniqueCounts &counts, double pdf, bool isParallel) {
    PathEdge edge;
    edge.connections = square(counts.lightImage), edge.pdf = pdf, edge.parallel = isParallel;
    return edge;
}

/// How a path begins on a light.
struct LightStart {
    double position = 1;  ///< Density per m^2, or a probability.
    double direction = 1; ///< Per steradian, or per m^2 across.
    bool isParallel = false;
    /// Rays may meet it: with the cosine of surfaces, and of skies the density of the direction.
    double cosine = 0, skyPdf = 0;
};
inline PathEdge edgeOfLight(const LightStart &start) {
    const bool isSky = start.skyPdf > 0, shows = isSky || start.cosine > 0;
    const double perPlace = 1 / square(start.position);
    PathEdge edge;
    edge.connections = perPlace; // Of a sky, given the direction.
    edge.earlier = edge.earlierOfPath = shows ? perPlace / (isSky ? square(start.skyPdf) : 1) : 0;
    edge.pdf = start.direction, edge.parallel = start.isParallel;
    edge.cosine = isSky ? 1 : start.cosine;
    return edge;
}
/// last_1 of such a path, from what arriveAlong() says of it: `sampled` is the density of light
/// samples, per steradian of lights with an extent, else the probability of their choice.
inline double lastOfLit(const PathVertex &vertex, double sampled, bool hasExtent) {
    return vertex.last * square(hasExtent ? sampled * vertex.back : sampled);
}

} // namespace candela
