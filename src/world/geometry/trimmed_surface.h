// SPDX-License-Identifier: Apache-2.0
// A NuPatch that trim curves have cut.
#pragma once

#include "world/geometry/surface_view.h"
#include "world/geometry/trim_region.h"

namespace candela {

/// A query's (u,v) run from 0 to 1 over the box round what is left, in which there is no area
/// beyond the curves. Dicing cuts the whole surface's triangles along the curves, so that their
/// bound still holds, and follows the curves as closely.
class TrimmedSurface final : public SurfaceView {
public:
    /// `longest` bounds the whole surface's derivatives by its query's u and v.
    TrimmedSurface(std::shared_ptr<const Surface> whole, TrimRecord, const PatchGrid &,
                   TrimOutline::Place longest, bool trimsInside);

    /// Loops that were not closed.
    int openLoops() const { return fine_.openLoops(); }

    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override;
    float area() const override { return area_; }
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    class Names;
    TrimOutline outlineAt(double chord) const;
    /// With the whole surface's names.
    DicedMesh cutAt(const DiceRate &) const;

    TrimRecord curves_;
    PatchGrid grid_;
    TrimOutline::Place longest_;
    double size_;
    TrimOutline fine_;
    TrimRule rule_;
    /// The box, in the whole surface's query coordinates: where it begins, and its sides.
    std::array<float, 2> begin_{0, 0}, extent_{1, 1};
    float area_ = 0;
};

} // namespace candela
