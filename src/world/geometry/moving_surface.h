// SPDX-License-Identifier: Apache-2.0
// A surface that changes its shape while the shutter is open.
#pragma once

#include "world/geometry/surface.h"

#include <memory>
#include <vector>

namespace candela {

/// Surfaces of one primitive at even steps of time. Points of one name go straight from one step to
/// the next, and so do variables and derivatives; of normals the directions do.
class MovingSurface final : public Surface {
public:
    /// At least two, whose names (piece, u, v) mean the same.
    explicit MovingSurface(std::vector<std::shared_ptr<const Surface>> steps);

    int steps() const override { return int(steps_.size()); }
    std::shared_ptr<const Surface> step(int number) const override {
        return steps_[std::size_t(number)];
    }
    SurfaceDomain domain() const override { return first().domain(); }
    Box3 bound() const override;
    DicedMesh dice(const DiceRate &rate) const override { return first().dice(rate); }
    double triangleCount(const DiceRate &rate) const override {
        return first().triangleCount(rate);
    }
    float area() const override { return first().area(); }
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool isFlat() const override { return first().isFlat(); }
    bool hasOwnNormals() const override { return first().hasOwnNormals(); }
    std::span<const VariableInfo> variables() const override { return first().variables(); }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    const Surface &first() const { return *steps_.front(); }
    template <class Ask> void forSteps(const SurfaceQuery &, Ask) const;

    std::vector<std::shared_ptr<const Surface>> steps_;
};

/// Whether points and variables of the one have the names that the other's have.
bool haveSameNames(const Surface &, const Surface &);

/// Where the vertices of a mesh that names points of the surface are at a later step, in the
/// surface's own space, and how far its triangles are from the surface then.
struct LaterMesh {
    std::vector<Vec3> positions;
    float chordError = 0;
};
LaterMesh meshAtStep(const Surface &step, const DicedMesh &);

} // namespace candela
