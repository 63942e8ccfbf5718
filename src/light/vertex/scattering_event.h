// SPDX-License-Identifier: Apache-2.0
// What becomes of a path at a vertex: it follows a finite lobe, a mirror-like request, passes
// straight through, or ends. One event a vertex, chosen by importance; or each of those that have
// one direction, in turn.
#pragma once

#include "light/vertex/surface_vertices.h"

namespace candela {

/// Events besides finiteRequests (-1) and the numbers of delta requests.
inline constexpr std::int32_t straightThrough = -2;
inline constexpr std::int32_t pathEnds = -3;

class ScatteringEvents {
public:
    explicit ScatteringEvents(int capacity);

    /// Takes the vertices' opacity; must come first. transmission() is then 1 - Oi as luminance,
    /// or null if all of them are opaque.
    void look(const SurfaceVertices &);
    const float *transmission() const { return opaque_ ? nullptr : transmission_[0]; }
    /// True if a random number is needed: not all lanes have but one event to choose.
    bool needsChoice() const { return !opaque_ || mayBeDelta_; }
    /// Chooses by the uniform number u of each lane. `finiteTotal` is the mixture's importance.
    /// Direction is filled for delta requests and for straightThrough.
    void choose(SurfaceVertices &, const float *finiteTotal, const float *u);

    /// Events of one direction: the delta requests that some lanes may have, and straightThrough.
    int kinds() const { return int(deltas_.size()) + (opaque_ ? 0 : 1); }
    /// The event becomes this kind, with certainty, in lanes that are wanted and have it, and
    /// pathEnds in others. False if there are none.
    bool takeAll(SurfaceVertices &, int kind, const int *wanted);
    /// The event becomes pathEnds where `marked` is not 0.
    void end(int count, const int *marked);
    /// Every other event becomes pathEnds.
    void endAllBut(std::int32_t event, int count);

    const std::int32_t *event() const { return events_[0]; }
    const float *probability() const { return probability_[0]; } ///< Of the event chosen.
    /// Probability of finiteRequests, whatever was chosen: part of its pdf.
    const float *finiteProbability() const { return finiteProbability_[0]; }
    MutableVec3Planes direction() const { return {direction_[0], direction_[1], direction_[2]}; }
    /// True if any lane chose the event.
    bool any(std::int32_t event, int count) const;

private:
    Planes<std::int32_t> events_;
    Planes<float> probability_, finiteProbability_, direction_, transmission_;
    std::vector<int> deltas_; ///< First cones of requests that may be delta ones.
    bool opaque_ = true, mayBeDelta_ = false;
};

} // namespace candela
