// SPDX-License-Identifier: Apache-2.0
// The light that a volume shader asks for, wherever it does. No code calls the renderer to trace
// rays and waits: a first run notes the points at which light is wanted, and is told of none; then
// all of them are lit together, and another run gets the answers. Where a shader asks for more by
// what it was told, this is done again.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/base/vec3.h"
#include "foundation/units/color.h"
#include "language/runtime/services.h"

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// The points of one batch of segments, and their light.
class VolumeLights {
public:
    /// A segment gets light at so many points; at further ones it is dark.
    static constexpr int mostPoints = 1024;

    /// Forgets everything; `lanes` segments will ask.
    void begin(int lanes);
    /// The shader runs from its beginning.
    void beginRun();

    /// Services gatherlight and lightsample.
    void gather(const ServiceCall &);
    void sample(const ServiceCall &) const;

    /// The points that wait for light, behind those that have it.
    int points() const { return int(P_.size()); }
    int lit() const { return lit_; }
    Vec3 point(int k) const { return P_[std::size_t(k)]; }
    /// The segment that asks for it, and how many it asked for before.
    int lane(int k) const { return lane_[std::size_t(k)]; }
    int ordinal(int k) const { return ordinal_[std::size_t(k)]; }
    /// Some segment has asked at more than mostPoints.
    bool hasRefused() const { return refused_; }

    /// Row by row, `rows` samples for each point: all points are lit then. What the rows held is
    /// kept.
    void light(int rows);
    /// Of point k; Cl is black where there is no light. `number`: index + 1, as samples have it.
    void set(int row, int k, Vec3 L, const std::array<float, colorSamples> &Cl,
             std::int32_t number);

private:
    struct Sample {
        Vec3 L;
        std::array<float, colorSamples> Cl{};
        std::int32_t light = 0;
    };
    /// The point's number; -1 if it is not known.
    int find(int lane, Vec3 P);

    std::vector<Vec3> P_;
    std::vector<std::int32_t> lane_, ordinal_;
    std::vector<std::vector<std::int32_t>> pointsOf_; ///< By lane, as they were asked for.
    std::vector<std::size_t> next_; ///< By lane: which of them is likely to be asked for next.
    std::vector<Sample> samples_;   ///< Point by point.
    int lit_ = 0, rows_ = 0;
    bool refused_ = false;
};

} // namespace candela
