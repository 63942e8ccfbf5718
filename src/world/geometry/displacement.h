// SPDX-License-Identifier: Apache-2.0
// What moves the points of one surface, or turns its shading normals. Whoever knows shaders makes
// it (world/displacement); geometry and dicing ask it.
#pragma once

#include "world/geometry/surface.h"

namespace candela {

class Displacement {
public:
    virtual ~Displacement() = default;

    /// Else it changes shading normals alone.
    virtual bool movesPoints() const = 0;
    virtual bool setsNormals() const = 0;
    /// Normals are those of the points as they have been moved, whatever displace() says.
    virtual bool givesTrueNormals() const { return false; }
    /// It is by the surface's own shader, which moves the points again when it shades them.
    virtual bool isOfSurface() const = 0;
    /// displace() knows dPdu and dPdv exactly.
    virtual bool knowsSlopes() const = 0;

    /// Where the surface's points of these names are moved to; the surface's own space. Points that
    /// would go nowhere (not finite) stay. For dicing: prints what the shader prints.
    virtual void move(const SurfaceQuery &, Vec3Planes P) const = 0;
    /// P and N, with all that is wanted of them, of the displaced points: SurfaceAnswer's P, N,
    /// dPdu, dPdv; normals follow the natural orientation of the surface. Without knowsSlopes()
    /// dPdu and dPdv are left alone.
    virtual void displace(const SurfaceQuery &, const SurfaceAnswer &) const = 0;
    /// The width, in the surface's own units, that a sample spans where a point stands: what
    /// differences are taken over.
    virtual float width(Vec3 P) const = 0;
};

} // namespace candela
