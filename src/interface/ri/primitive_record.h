// SPDX-License-Identifier: Apache-2.0
// Geometric primitives as data, in object space, as the interface states them. The world turns
// them into surfaces. Polygon, GeneralPolygon and PointsPolygons arrive here as what they are
// special cases of: PointsGeneralPolygons; Patch as a PatchMesh of one.
#pragma once

#include "foundation/base/vec3.h"
#include "interface/ri/attributes.h"
#include "interface/ri/motion_of_numbers.h"
#include "interface/ri/parameter_list.h"

#include <array>
#include <memory>
#include <variant>
#include <vector>

namespace candela {

struct SphereRecord {
    float radius, zMin, zMax, thetaMax; ///< Angles in degrees, here and below.
};
struct ConeRecord {
    float height, radius, thetaMax;
};
struct CylinderRecord {
    float radius, zMin, zMax, thetaMax;
};
struct HyperboloidRecord {
    Vec3 point1, point2;
    float thetaMax;
};
struct ParaboloidRecord {
    float rMax, zMin, zMax, thetaMax;
};
struct DiskRecord {
    float height, radius, thetaMax;
};
struct TorusRecord {
    float majorRadius, minorRadius, phiMin, phiMax, thetaMax;
};
/// RiPointsGeneralPolygons: loops a polygon, vertices a loop, indices of all vertices.
struct PolygonsRecord {
    std::vector<int> loopCounts, vertexCounts, vertices;
};
struct PatchMeshRecord {
    bool bicubic = false;
    int uVertices = 2, vVertices = 2;
    bool uPeriodic = false, vPeriodic = false;
};

/// One direction of a RiNuPatch: a spline of this order over these knots, drawn from low to high.
struct SplineRecord {
    int vertices = 2, order = 2;
    std::vector<float> knots; ///< vertices + order of them, in increasing order.
    float low = 0, high = 1;

    /// What primitive variables are counted by: between knots, some of which may be equal.
    int segments() const { return vertices - order + 1; }
};
struct NuPatchRecord {
    SplineRecord u, v;
};

/// RiSubdivisionMesh with its tags read.
struct SubdivisionRecord {
    enum class Scheme { CatmullClark, Loop, Bilinear };
    struct Crease {
        std::vector<int> vertices; ///< A chain of edges.
        float sharpness = 0;
    };
    struct Corner {
        int vertex = 0;
        float sharpness = 0;
    };
    Scheme scheme = Scheme::CatmullClark;
    std::vector<int> vertexCounts, vertices; ///< Vertices a face; indices of all vertices.
    std::vector<int> holes;                  ///< Faces.
    std::vector<Crease> creases;
    std::vector<Corner> corners;
    /// 0: faces at the boundary only support those within. 1: the boundary is a sharp edge with
    /// sharp corners. 2: without these.
    int interpolateBoundary = 0;
    /// Face-varying variables: 0: bilinear on each face. Else smooth within regions over which they
    /// are continuous, whose outlines are as interpolateBoundary has them: 1 and 3 with sharp
    /// corners, 2 without.
    int faceVaryingBoundary = 0;
};
/// RiGeometry: what the renderer knows by name.
struct GeometryRecord {
    std::string type;
};
struct PointsRecord {
    int count = 0;
};
/// RiCurves: control points a curve, and whether curves close. Cubics are of the v basis.
struct CurvesRecord {
    bool cubic = false, periodic = false;
    std::vector<int> vertexCounts;
};
/// RiBlobby: a program that combines fields of blobs, see RI 3.2, 5.6.
struct BlobbyRecord {
    int leaves = 0; ///< Values a varying or vertex variable has, one a blob.
    std::vector<int> codes;
    std::vector<float> floats;
    std::vector<std::string> strings;
};

using ShapeRecord =
    std::variant<SphereRecord, ConeRecord, CylinderRecord, HyperboloidRecord, ParaboloidRecord,
                 DiskRecord, TorusRecord, PolygonsRecord, PatchMeshRecord, NuPatchRecord,
                 SubdivisionRecord, GeometryRecord, PointsRecord, CurvesRecord, BlobbyRecord>;

/// The highest order of splines; their polynomials are of one degree less.
inline constexpr int mostSplineOrder = 24;

/// The cubics or lines of a curve of so many control points, 0 if they make none. Those behind the
/// last whole step make none.
int curveSegments(const CurvesRecord &, int vertices, int step);

/// A shape with its primitive variables. Their counts have been checked against the shape (RI
/// 3.2, 5): wrong ones were reported and dropped, missing or non-finite P drops the primitive.
struct PrimitiveRecord {
    ShapeRecord shape;
    ParameterList variables;
    SourceLocation where;
    /// The same in time: all of one kind and of the same counts, this one the first. Null: it keeps
    /// its shape.
    SharedInTime<std::shared_ptr<const PrimitiveRecord>> motion;
};

/// The shape and variables at that time, which stay so.
std::shared_ptr<const PrimitiveRecord> recordAt(const std::shared_ptr<const PrimitiveRecord> &,
                                                double time);
/// Whether one can become the other: of one kind, with as many vertices, and variables alike.
bool canBecome(const PrimitiveRecord &, const PrimitiveRecord &);

} // namespace candela
