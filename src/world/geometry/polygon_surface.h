// SPDX-License-Identifier: Apache-2.0
// Polygons of every kind (RI 3.2, 5.1) as triangles.
#pragma once

#include "world/geometry/polygon_mesh.h"
#include "world/geometry/surface.h"

namespace candela {

/// A query's piece is a triangle, its (u,v) are barycentric coordinates.
///
/// The natural normal is (P1 - P0) x (P2 - P0) of the face's vertices, by components: in RI's
/// left-handed default coordinates the vertices appear clockwise from the side it points to.
///
/// Shaders see u = s and v = t. dPdu and dPdv are the derivatives of P by those; where a face's
/// (s,t) are mirrored dPdv is turned round, so that dPdu x dPdv is along the natural normal all the
/// same, and where they do not span the face (default (s,t) = (x,y) on a face along z) the two are
/// an orthonormal frame of the face. Derivatives of variables are always those along dPdu and dPdv.
class PolygonSurface final : public Surface {
public:
    PolygonSurface(PolygonMesh, const PrimitiveRecord &, DiagnosticSink &);

    /// The same faces, cut into the same triangles, with the record's points and variables. Null if
    /// it has not as many.
    std::shared_ptr<const PolygonSurface> movedTo(const PrimitiveRecord &, DiagnosticSink &) const;

    Box3 bound() const override { return bound_; }
    SurfaceDomain domain() const override { return {std::uint32_t(mesh_.triangles.size()), true}; }
    DicedMesh dice(const DiceRate &) const override;
    double triangleCount(const DiceRate &) const override { return double(pieces_.size()); }
    float area() const override { return area_; }
    void evaluate(const SurfaceQuery &, const SurfaceAnswer &) const override;
    bool isFlat() const override { return true; }
    bool hasOwnNormals() const override { return normal_.has_value(); }
    std::span<const VariableInfo> variables() const override { return infos_; }
    void evaluateVariable(int index, const SurfaceQuery &, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override;

private:
    /// All that evaluate() needs of a triangle: P and (s,t) are linear in the barycentrics (a,b).
    struct Piece {
        Vec3 origin, edgeA, edgeB;
        std::array<float, 3> s, t; ///< At the corners.
        float aDu, bDu, aDv, bDv;  ///< Derivatives of (a,b) along dPdu and dPdv.
        Vec3 normal{};             ///< edgeA x edgeB
    };

    void takeVariables(const PrimitiveRecord &, DiagnosticSink &);
    void addDefault(const char *name, int axis);
    void addPieces();
    static void setFrame(Piece &);
    void overrideNormals(const SurfaceQuery &, const SurfaceAnswer &) const;

    PolygonMesh mesh_;
    std::vector<Piece> pieces_;
    std::vector<VariableInfo> infos_;
    std::vector<PolygonVariable> variables_;
    std::optional<PolygonVariable> normal_;
    Box3 bound_;
    float area_ = 0;
};

} // namespace candela
