// SPDX-License-Identifier: Apache-2.0
// Asks a shader where it moves the points of one surface.
#pragma once

#include "world/displacement/displacement_bounds.h"
#include "world/geometry/displacement.h"
#include "world/points/evaluate.h"

#include <memory>

namespace candela {

/// What a shader displaces: a surface as it stands and looks.
struct DisplacedThing {
    std::shared_ptr<const Surface> surface;
    Matrix4 currentFromShape;
    std::shared_ptr<const Attributes> attributes;
    bool turned = false; ///< Its orientation is reversed.
    /// What a pixel spans where it is seen nearest, metres; 0: as the camera sees each point.
    float pixel = 0;
};

class ShaderDisplacement final : public Displacement {
public:
    /// The shader's code must be one that displaces. `bounds`, which hears of what moves, and the
    /// camera must outlive it.
    ShaderDisplacement(const ShaderInstance &, const DisplacedThing &, const Camera &,
                       std::shared_ptr<DisplacementBounds> bounds);

    bool movesPoints() const override { return code().displacement().movesP; }
    bool setsNormals() const override { return !isOfSurface() && code().displacement().setsN; }
    bool givesTrueNormals() const override { return isOfSurface() && code().displacement().setsN; }
    bool isOfSurface() const override { return code().shader().kind == sl::ShaderKind::Surface; }
    bool knowsSlopes() const override { return code().displacement().slopesKnown; }
    /// See ir::DisplacementFacts.
    bool readsOtherSpaces() const { return code().displacement().readsOtherSpaces; }
    void move(const SurfaceQuery &, Vec3Planes P) const override;
    void displace(const SurfaceQuery &, const SurfaceAnswer &) const override;
    float width(Vec3 P) const override;

private:
    struct Asked;
    const ShaderCode &code() const { return *tables_.codes.front().code; }
    void locate(const SurfaceQuery &, const SurfaceCode &, ShadingPoints &) const;
    void ask(ir::Question, ShadingPoints &, Asked &) const;
    void movePart(const SurfaceQuery &, Vec3Planes P) const;
    void displacePart(const SurfaceQuery &, const SurfaceAnswer &) const;

    /// Of one shape, with one appearance. Codes: what Displaced reads; and what Displace does,
    /// which is less.
    PointTables tables_;
    Matrix4 shapeFromCurrent_;
    const Camera &camera_;
    float pixel_, rate_; ///< As DisplacedThing has it; the root of ShadingRate.
    float sign_;         ///< -1: turned.
    std::shared_ptr<DisplacementBounds> bounds_;
};

} // namespace candela
