// SPDX-License-Identifier: Apache-2.0
// What becomes of a path at a vertex: it follows the finite lobes, mirror-like requests, and what
// passes straight through, one kind of event after the other. How far each is worth following is
// decided by roulette, and deep in a path by its share of the importance.
#pragma once

#include "light/vertex/surface_vertices.h"

namespace candela {

/// Events besides finiteRequests (-1) and the numbers of delta requests.
inline constexpr std::int32_t straightThrough = -2;
inline constexpr std::int32_t pathEnds = -3;

/// 1 - Oi as luminance; false, and nothing filled, if all is opaque.
bool transmittedLight(int count, const std::array<const float *, colorSamples> &Oi,
                      float *transmission);

class ScatteringEvents {
public:
    explicit ScatteringEvents(int capacity);

    /// Takes the vertices' opacity and requests; must come first. transmission() is then 1 - Oi as
    /// luminance, or null if all of them are opaque.
    void look(const SurfaceVertices &);
    const float *transmission() const { return opaque_ ? nullptr : transmission_[0]; }

    /// Takes the sum of what all events are worth, for share(); `finiteTotal` is the importance of
    /// the finite lobes, null where they are not followed.
    void weigh(const SurfaceVertices &, const float *finiteTotal);
    /// The event becomes finiteRequests where their importance, `total`, is above 0. False if that
    /// is nowhere.
    bool takeFinite(int count, const float *total);
    /// Events of one direction: the delta requests that some lanes may have, and straightThrough.
    int kinds() const { return int(deltas_.size()) + (opaque_ ? 0 : 1); }
    /// The event becomes this kind, in lanes that have it. False if there are none.
    bool takeKind(SurfaceVertices &, int kind);

    /// What was taken last; pathEnds in other lanes.
    const std::int32_t *event() const { return events_[0]; }
    /// By importance, of the events that the vertex has: what was taken last, after weigh().
    const float *share() const { return share_[0]; }
    /// Filled by takeKind().
    MutableVec3Planes direction() const { return {direction_[0], direction_[1], direction_[2]}; }
    /// True if the events are finiteRequests.
    bool finite() const { return finite_; }

private:
    float weightOf(const SurfaceVertices &, int kind, int i) const;

    Planes<std::int32_t> events_;
    Planes<float> direction_, transmission_, total_, share_;
    std::vector<int> deltas_; ///< First cones of requests that may be delta ones.
    bool opaque_ = true, finite_ = false;
};

} // namespace candela
