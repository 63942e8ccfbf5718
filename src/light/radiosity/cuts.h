// SPDX-License-Identifier: Apache-2.0
// What stands on surfaces: walls and blocks that cut elements in two, each with a light of its own.
#pragma once

#include "light/radiosity/mesh.h"

namespace candela::radiosity {

/// Rays just above elements, from point to point: does anything stand between?
class GroundRays {
public:
    static constexpr int capacity = 1024;
    GroundRays();

    void clear() { rays_.count = 0; }
    bool isFull() const { return rays_.count == capacity; }
    int count() const { return rays_.count; }
    /// Two points of a flat element, or of its neighbour. Must not be full.
    void add(const Mesh &, int element, Vec3 from, Vec3 to);
    void trace(const Scene &);
    /// Of the ray that was added as the i-th: something opaque stands there.
    bool isStopped(int i) const { return isStopped_[std::size_t(i)]; }

private:
    RayBatch rays_;
    Planes<float> transmittance_;
    std::vector<std::uint8_t> isStopped_;
};

/// Of elements from `first` on: 1 for flat ones that something stands on so that it parts them.
std::vector<std::uint8_t> cutElements(const Mesh &, int first);

/// Of cut elements that have children.
std::vector<Sides> sidesOf(const Mesh &, std::span<const int> parents);

} // namespace candela::radiosity
