// SPDX-License-Identifier: Apache-2.0
// A surface as a displacement shader says that it is, under the names that it had before: one whose
// shading normals are turned and whose points stay (bumps); or, for what displaces it once more,
// one whose points are moved, though its own dicing and bound are still those of the surface
// behind.
#pragma once

#include "world/geometry/displacement.h"
#include "world/geometry/surface_view.h"

namespace candela {

class MovedSurface final : public SurfaceView {
public:
    MovedSurface(std::shared_ptr<const Surface> behind,
                 std::shared_ptr<const Displacement> displacement)
        : SurfaceView(std::move(behind)), displacement_(std::move(displacement)) {}

    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool hasOwnNormals() const override { return true; }

private:
    void evaluateSlopes(const SurfaceQuery &, const SurfaceAnswer &) const;

    std::shared_ptr<const Displacement> displacement_;
};

} // namespace candela
