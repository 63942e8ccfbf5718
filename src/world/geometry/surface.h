// SPDX-License-Identifier: Apache-2.0
// The one protocol that every geometric primitive speaks. A primitive is turned into a Surface:
// bounded, diced into triangles for Embree, and evaluated on the true surface where rays hit.
// Everything is in object space; whoever holds the transformation applies it.
#pragma once

#include "foundation/base/box3.h"
#include "foundation/base/round_elements.h"
#include "foundation/base/shutter.h"
#include "interface/ri/primitive_record.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// How finely to dice: the longest edge and the largest distance between a triangle and the true
/// surface, both in object units.
struct DiceRate {
    float edgeLength = 1;
    float chordError = 0.1f;
};

/// Triangles that approximate a surface. A point of a triangle names a point of the surface as
/// (piece, u, v): if `vertexUv` is empty, the piece is the triangle and (u,v) are its barycentric
/// coordinates (weights of corners 1 and 2); otherwise the piece is that of the triangle, and (u,v)
/// is interpolated from the corners, whose triangles are all of that piece.
struct DicedMesh {
    std::vector<Vec3> positions;
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 2>> vertexUv;
    std::vector<std::uint32_t> pieces; ///< Of each triangle; empty: they are 0.
    float chordError = 0; ///< No triangle is farther than this from the surface; 0 = exact.

    /// Of each vertex, where they have a vertexUv.
    std::vector<std::uint32_t> piecesOfVertices() const {
        std::vector<std::uint32_t> result(positions.size(), 0);
        for (std::size_t k = 0; k < pieces.size(); ++k)
            for (std::uint32_t vertex : triangles[k])
                result[vertex] = pieces[k];
        return result;
    }
};

/// A primitive variable that a caller may ask for besides the geometry.
struct VariableInfo {
    std::string name;
    Declaration declaration;
};

/// What (piece, u, v) range over: u and v in [0,1]; of triangles u + v <= 1, as barycentric
/// coordinates are.
struct SurfaceDomain {
    std::uint32_t pieces = 1;
    bool triangles = false;
};

/// Where to evaluate: `count` points as (piece, u, v), structure of arrays.
struct SurfaceQuery {
    int count = 0;
    const std::uint32_t *piece = nullptr;
    const float *u = nullptr, *v = nullptr;
    /// Of surfaces that change their shape: how much of the shutter's interval has passed; null =
    /// 0.
    const float *share = nullptr;
};

/// Three planes of floats, one a component.
struct Vec3Planes {
    float *x = nullptr, *y = nullptr, *z = nullptr;
    Vec3 get(int i) const { return {x[i], y[i], z[i]}; }
    void set(int i, Vec3 value) const { x[i] = value.x, y[i] = value.y, z[i] = value.z; }
};

/// The planes from that place on; planes that are null stay so.
inline Vec3Planes from(const Vec3Planes &planes, int first) {
    return planes.x ? Vec3Planes{planes.x + first, planes.y + first, planes.z + first} : planes;
}

/// The derivative of n / |n|, given those of n.
inline Vec3 unitDerivative(Vec3 n, Vec3 derivative) {
    // Squares of a normal, an area, leave the range of floats long before it does.
    float scale = 1 / std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)});
    Vec3 scaled = n * scale, change = derivative * scale;
    float squared = dot(scaled, scaled);
    return (change - scaled * (dot(scaled, change) / squared)) / std::sqrt(squared);
}

/// Where the answers go; null planes are not wanted. Normals follow the natural orientation
/// dPdu x dPdv (of the parametrisation, before Attributes::flipNormal) and need not have length
/// one.
struct SurfaceAnswer {
    Vec3Planes P;          ///< The point on the true surface.
    Vec3Planes Ng;         ///< dPdu x dPdv, finite and non-zero also at poles and apexes.
    Vec3Planes N;          ///< Shading normal: the primitive variable "N", else as Ng.
    Vec3Planes dPdu, dPdv; ///< With respect to the surface's own u and v, as shaders see them.
    /// Derivatives of N / |N|, N as it is handed over, by the shaders' u and v. They are at right
    /// angles to N and turn round with it.
    Vec3Planes dNdu, dNdv;
    Vec3Planes dNgdu, dNgdv;          ///< The same of Ng.
    float *u = nullptr, *v = nullptr; ///< u and v as shaders see them, in [0,1].
    /// |dP/da x dP/db| by the query's own coordinates (a,b): area per unit of them, 0 at poles.
    float *areaScale = nullptr;
};

class Surface {
public:
    virtual ~Surface() = default;

    virtual SurfaceDomain domain() const { return {}; }
    /// Contains the whole surface.
    virtual Box3 bound() const = 0;
    virtual DicedMesh dice(const DiceRate &) const = 0;
    /// How many triangles dice() returns at this rate, found without dicing.
    virtual double triangleCount(const DiceRate &) const = 0;
    /// Total area in object units; quadrics in closed form, others as their dicing has it.
    virtual float area() const = 0;
    virtual void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const = 0;
    /// What the surface's own shader is given, which moves the points itself: they and all about
    /// them as they were before. False: the shader is given what evaluate() says.
    virtual bool evaluateUnmoved(const SurfaceQuery &, const SurfaceAnswer &) const {
        return false;
    }

    /// Rays may meet roundElements() instead of triangles; nameRound() names the hits.
    virtual bool isRound() const { return false; }
    virtual RoundElements roundElements() const { return {}; }
    /// The names of points on round elements, or near them: the query's piece and (u,v). `piece` is
    /// the element on entry, and `u`, of tubes, how far along it the ray has met it, from 0 to 1;
    /// `share` as a query has it. Only for round surfaces.
    virtual void nameRound(int /*count*/, const Vec3Planes & /*P*/, const float * /*share*/,
                           std::uint32_t * /*piece*/, float * /*u*/, float * /*v*/) const {}
    /// A hair or a grain rather than a body: its opacity is that of all of it, so a ray meets it
    /// once, where it comes from outside, and leaves it unseen.
    virtual bool isStroke() const { return false; }

    /// It changes its shape while the shutter is open: what it is at that many even steps, between
    /// which its points go straight, or nearly. dice() names points of the first.
    virtual int steps() const { return 1; }
    /// A surface that stays as this one is then. Null: the surface itself.
    virtual std::shared_ptr<const Surface> step(int) const { return nullptr; }

    /// Made of flat faces: dicing leaves them as they are, whatever the rate.
    virtual bool isFlat() const { return false; }
    /// The user has given normals ("N"): N is not Ng.
    virtual bool hasOwnNormals() const = 0;
    /// The primitive variables other than position and normal: Cs, Os, s, t (of "st" too) and
    /// user-declared ones, numeric types only.
    virtual std::span<const VariableInfo> variables() const = 0;
    /// Values of variables()[index], and if wanted their derivatives by u and v. Plane c of each
    /// is component c (floats of a color, point, ...); planes have `count` floats.
    virtual void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                                  float *const *valueDu, float *const *valueDv) const = 0;
};

/// The surfaces of a primitive: one, as a rule. Reports what makes it unusable (degenerate, not
/// finite) and then returns nothing. `attributes` gives bases and texture coordinates: s and t
/// default to the bilinear map of Attributes::textureCoordinates over (u,v), for polygons to the
/// object-space x and y (RI 3.2, 5.1 and table 5.2).
std::vector<std::shared_ptr<const Surface>> makeSurfaces(std::shared_ptr<const PrimitiveRecord>,
                                                         const Attributes &, DiagnosticSink &);
/// The same of a primitive that may change its shape while the shutter is open.
std::vector<std::shared_ptr<const Surface>>
makeSurfaces(const std::shared_ptr<const PrimitiveRecord> &, const Attributes &, const Shutter &,
             DiagnosticSink &);

} // namespace candela
