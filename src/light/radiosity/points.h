// SPDX-License-Identifier: Apache-2.0
// Points on faces of one code, to be asked about together.
#pragma once

#include "light/radiosity/mesh.h"

namespace candela::radiosity {

class PointBatch {
public:
    int size() const { return int(u_.size()); }
    void add(const Mesh &, int element, Place inFace, Vec3 N);
    /// All nodes of the element.
    void addNodes(const Mesh &, int element);
    SurfacePlaces places() const {
        return {size(), instance_.data(), shape_.data(), piece_.data(), u_.data(), v_.data()};
    }
    Vec3Planes N() { return {nx_.data(), ny_.data(), nz_.data()}; }

private:
    std::vector<std::uint32_t> instance_, shape_, piece_;
    std::vector<float> u_, v_, nx_, ny_, nz_;
};

/// Those elements in batches of one code, each with `most` points at most.
std::vector<std::vector<int>> batchesByCode(const Mesh &, std::span<const int> elements, int most);

} // namespace candela::radiosity
