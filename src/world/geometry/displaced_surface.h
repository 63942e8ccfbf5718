// SPDX-License-Identifier: Apache-2.0
// A surface whose points a displacement shader has moved, as it was diced. Its pieces are the
// triangles of that dicing, its query coordinates their barycentrics.
//
// P is the point of the triangle: rays meet it there, and others start there, so that nothing leaks
// where faces fold. Its normals and derivatives are what the shader says of the point of that name,
// as long as that lies close to the triangle. Where it does not (a step of the shader's between two
// vertices; an edge at which two faces were joined) the triangle is the surface, its normal is Ng,
// and N if the shader sets that.
#pragma once

#include "world/geometry/displacement.h"
#include "world/geometry/surface_view.h"

namespace candela {

/// Triangles of a displaced surface, in its own space.
struct DisplacedMesh {
    std::vector<Vec3> positions; ///< By vertex.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    /// Of each triangle, the piece of the surface behind it; empty if all is one piece.
    std::vector<std::uint32_t> pieces;
    std::vector<std::array<float, 2>> vertexUv; ///< Query coordinates of the surface behind.
    /// Times the triangles' (p1 - p0) x (p2 - p0): along the natural normal.
    float sign = 1;
};

/// Close is within this share of a triangle's longest edge.
inline constexpr float displacedTolerance = 1.0f / 16;
/// And no farther turned than so from the triangle's normal.
inline constexpr float displacedCosine = 0.7f;

class DisplacedSurface final : public SurfaceView {
public:
    DisplacedSurface(std::shared_ptr<const Surface> behind,
                     std::shared_ptr<const Displacement> displacement, DisplacedMesh);

    /// If the displacement is by the surface's own shader.
    bool evaluateUnmoved(const SurfaceQuery &, const SurfaceAnswer &) const override;

    SurfaceDomain domain() const override { return {std::uint32_t(mesh_.triangles.size()), true}; }
    Box3 bound() const override { return bound_; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override { return double(mesh_.triangles.size()); }
    float area() const override { return area_; }
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool isRound() const override { return false; }
    bool isFlat() const override { return false; }
    bool hasOwnNormals() const override { return true; }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    class Names;
    void displace(const Names &, const SurfaceQuery &, const SurfaceAnswer &) const;
    void differentiatePoints(const Names &, const SurfaceQuery &, const SurfaceAnswer &) const;
    void differentiateNormals(const Names &, const SurfaceQuery &, const SurfaceAnswer &) const;
    void keepToTriangles(const SurfaceQuery &, const SurfaceAnswer &) const;

    std::shared_ptr<const Displacement> displacement_;
    DisplacedMesh mesh_;
    Box3 bound_;
    float area_ = 0;
};

} // namespace candela
