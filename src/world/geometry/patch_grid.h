// SPDX-License-Identifier: Apache-2.0
// Which patch of a mesh a place lies on.
#pragma once

#include <array>
#include <vector>

namespace candela {

/// The patches along one side of a mesh.
struct PatchAxis {
    int patches = 1;
    bool periodic = false;
    /// Mesh coordinates at which patches begin and end, from 0 to 1; empty: all are as wide.
    std::vector<float> breaks;
    /// What shaders call the ends of the mesh.
    float low = 0, high = 1;
    /// The values of primitive variables are those of segments, some of which may be empty or
    /// beyond the ends and so have no patch (NURBS): of each patch its segment. Empty: the patches
    /// are the segments.
    std::vector<int> segmentOf;
    int segmentCount = 0; ///< Where segmentOf is not empty.

    int segments() const { return segmentOf.empty() ? patches : segmentCount; }
    int corners() const { return periodic ? segments() : segments() + 1; }
    int segment(int patch) const { return segmentOf.empty() ? patch : segmentOf[patch]; }
    /// The mesh coordinate at a share of the way from a patch's beginning to its end.
    double at(int patch, double share) const {
        if (breaks.empty())
            return (patch + share) / patches;
        return breaks[patch] + share * (double(breaks[patch + 1]) - breaks[patch]);
    }
    /// How fast a patch's own coordinate runs by what shaders call the mesh's.
    float speed(int patch) const {
        const float range = high - low;
        return breaks.empty() ? float(patches) / range
                              : 1 / ((breaks[patch + 1] - breaks[patch]) * range);
    }
};

/// How many patches a mesh has and which way it closes; a quadric is a mesh of one patch.
struct PatchGrid {
    PatchAxis u, v;

    int patches() const { return u.patches * v.patches; }
    int segments() const { return u.segments() * v.segments(); }
    int corners() const { return u.corners() * v.corners(); }
};

/// Some points of a mesh, each by its patch and its place within it.
struct PatchPoints {
    static constexpr int capacity = 128;
    int count = 0;
    std::array<int, capacity> patch;
    std::array<float, capacity> u, v;           ///< Within the patch, in [0,1].
    std::array<float, capacity> speedU, speedV; ///< PatchAxis::speed() there.
    std::array<float, capacity> meshU, meshV;   ///< Over the mesh, in [0,1].
    float meshSpeedU = 1, meshSpeedV = 1;       ///< Of meshU and meshV by what shaders call them.
};

/// Locates up to PatchPoints::capacity mesh coordinates; what lies outside [0,1] is clamped.
void locate(const PatchGrid &, const float *meshU, const float *meshV, int count, PatchPoints &);

} // namespace candela
