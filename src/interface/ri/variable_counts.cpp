// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/variable_counts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numeric>

namespace candela {

namespace {

/// Four corners are all that counts.
bool isQuadric(const ShapeRecord &shape) {
    return !std::holds_alternative<PolygonsRecord>(shape) &&
           !std::holds_alternative<PatchMeshRecord>(shape) &&
           !std::holds_alternative<NuPatchRecord>(shape) &&
           !std::holds_alternative<SubdivisionRecord>(shape) &&
           !std::holds_alternative<PointsRecord>(shape) &&
           !std::holds_alternative<CurvesRecord>(shape) &&
           !std::holds_alternative<BlobbyRecord>(shape);
}

/// The defect of a quadric: non-finite numbers, or one of these that must not be zero is.
std::string quadricDefect(std::initializer_list<float> all, std::initializer_list<float> nonZero) {
    for (float value : all)
        if (!std::isfinite(value))
            return "expected finite numbers";
    for (float value : nonZero)
        if (value == 0)
            return "it is degenerate: it has no area";
    return {};
}

std::string defect(const SphereRecord &s) {
    std::string found = quadricDefect({s.radius, s.zMin, s.zMax, s.thetaMax},
                                      {s.radius, s.thetaMax, s.zMax - s.zMin});
    float r = std::fabs(s.radius);
    if (found.empty() && (std::min(s.zMin, s.zMax) >= r || std::max(s.zMin, s.zMax) <= -r))
        return "it is degenerate: zmin and zmax cut all of it away";
    return found;
}
std::string defect(const ConeRecord &c) {
    return quadricDefect({c.height, c.radius, c.thetaMax}, {c.radius, c.thetaMax});
}
std::string defect(const CylinderRecord &c) {
    return quadricDefect({c.radius, c.zMin, c.zMax, c.thetaMax},
                         {c.radius, c.zMax - c.zMin, c.thetaMax});
}
std::string defect(const HyperboloidRecord &h) {
    Vec3 a = h.point1, b = h.point2;
    // A line on the axis sweeps nothing.
    return quadricDefect({a.x, a.y, a.z, b.x, b.y, b.z, h.thetaMax},
                         {h.thetaMax, length(a - b), std::hypot(a.x, a.y) + std::hypot(b.x, b.y)});
}
std::string defect(const ParaboloidRecord &p) {
    std::string found = quadricDefect({p.rMax, p.zMin, p.zMax, p.thetaMax},
                                      {p.rMax, p.zMax, p.zMax - p.zMin, p.thetaMax});
    if (found.empty() && (p.zMin < 0) != (p.zMax < 0) && p.zMin != 0)
        return "expected zmin and zmax on one side of the apex";
    return found;
}
std::string defect(const DiskRecord &d) {
    return quadricDefect({d.height, d.radius, d.thetaMax}, {d.radius, d.thetaMax});
}
std::string defect(const TorusRecord &t) {
    return quadricDefect({t.majorRadius, t.minorRadius, t.phiMin, t.phiMax, t.thetaMax},
                         {t.minorRadius, t.phiMax - t.phiMin, t.thetaMax});
}

/// The sum, or nothing if an entry is below `minimum` or the sum too large to be true.
std::optional<std::int64_t> checkedSum(const std::vector<int> &counts, int minimum) {
    std::int64_t sum = 0;
    for (int count : counts) {
        if (count < minimum)
            return std::nullopt;
        sum += count;
    }
    return sum <= INT32_MAX ? std::optional(sum) : std::nullopt;
}

std::string defect(const PolygonsRecord &p) {
    if (p.loopCounts.empty())
        return "there are no polygons";
    auto loops = checkedSum(p.loopCounts, 1);
    if (!loops)
        return "expected at least one loop in each polygon";
    if (*loops != std::int64_t(p.vertexCounts.size()))
        return "the polygons have " + std::to_string(*loops) + " loops, but there are " +
               std::to_string(p.vertexCounts.size()) + " counts of vertices";
    auto vertices = checkedSum(p.vertexCounts, 3);
    if (!vertices)
        return "expected at least three vertices in each loop";
    if (*vertices != std::int64_t(p.vertices.size()))
        return "the loops have " + std::to_string(*vertices) + " vertices, but there are " +
               std::to_string(p.vertices.size()) + " vertex indices";
    if (*std::ranges::min_element(p.vertices) < 0)
        return "a vertex index is negative";
    return {};
}

/// Patches along one direction of a mesh; 0 if the number of vertices does not fit.
int patchesAlong(int vertices, bool periodic, bool bicubic, int step) {
    if (!bicubic)
        return vertices < 2 ? 0 : periodic ? vertices : vertices - 1;
    if (vertices < 4)
        return 0;
    int rest = periodic ? vertices : vertices - 4;
    return rest % step ? 0 : rest / step + (periodic ? 0 : 1);
}

int uPatches(const PatchMeshRecord &m, const Attributes &a) {
    return patchesAlong(m.uVertices, m.uPeriodic, m.bicubic, a.uBasis.step);
}
int vPatches(const PatchMeshRecord &m, const Attributes &a) {
    return patchesAlong(m.vVertices, m.vPeriodic, m.bicubic, a.vBasis.step);
}

std::string meshDefect(const PatchMeshRecord &m, const Attributes &a) {
    if (m.uVertices > 1 << 15 || m.vVertices > 1 << 15)
        return "expected at most 32768 vertices each way";
    auto says = [&](char direction, int vertices, int step) {
        std::string text =
            std::to_string(vertices) + " vertices in " + direction +
            (m.bicubic ? " do not make whole cubic patches with basis step " + std::to_string(step)
                       : " do not make a patch");
        return text;
    };
    if (uPatches(m, a) == 0)
        return says('u', m.uVertices, a.uBasis.step);
    if (vPatches(m, a) == 0)
        return says('v', m.vVertices, a.vBasis.step);
    return {};
}

std::string splineDefect(const SplineRecord &s, char direction) {
    const std::string in = std::string(" in ") + direction;
    if (s.vertices < 2 || s.vertices > 1 << 15)
        return "expected 2 to 32768 vertices" + in;
    if (s.order < 2 || s.order > mostSplineOrder)
        return "expected an order from 2 to " + std::to_string(mostSplineOrder) + in;
    const int knots = s.vertices + s.order;
    if (int(s.knots.size()) != knots)
        return "expected " + std::to_string(knots) + " knots" + in +
               ", vertices and order, found " + std::to_string(s.knots.size());
    if (!std::ranges::all_of(s.knots, [](float knot) { return std::isfinite(knot); }) ||
        !std::ranges::is_sorted(s.knots))
        return "expected knots in increasing order" + in;
    const float first = std::max(s.low, s.knots[s.order - 1]);
    const float last = std::min(s.high, s.knots[s.vertices]);
    if (!(first < last))
        return "nothing of its knots' range is between minimum and maximum" + in;
    return {};
}

std::string defect(const NuPatchRecord &n) {
    std::string found = splineDefect(n.u, 'u');
    return found.empty() ? splineDefect(n.v, 'v') : found;
}

std::string defect(const SubdivisionRecord &s) {
    if (s.vertexCounts.empty())
        return "there are no faces";
    const auto vertices = checkedSum(s.vertexCounts, 3);
    if (!vertices)
        return "expected at least three vertices in each face";
    if (*vertices != std::int64_t(s.vertices.size()))
        return "the faces have " + std::to_string(*vertices) + " vertices, but there are " +
               std::to_string(s.vertices.size()) + " vertex indices";
    if (*std::ranges::min_element(s.vertices) < 0)
        return "a vertex index is negative";
    return {};
}

std::string defect(const GeometryRecord &) { return {}; }

std::string defect(const PointsRecord &p) {
    return p.count < 1 ? "there are no points" : std::string();
}

std::string defect(const BlobbyRecord &b) {
    return b.leaves < 1 ? "expected at least one primitive blob" : std::string();
}

std::string curvesDefect(const CurvesRecord &c, const Attributes &a) {
    if (c.vertexCounts.empty())
        return "there are no curves";
    for (int count : c.vertexCounts)
        if (curveSegments(c, count, a.vBasis.step) == 0)
            return "a curve of " + std::to_string(count) + " vertices: expected at least " +
                   (c.cubic      ? "4, of a cubic"
                    : c.periodic ? "3, of lines that close"
                                 : "2");
    return checkedSum(c.vertexCounts, 1) ? std::string() : "there are too many vertices";
}

VariableCounts curvesCounts(const CurvesRecord &c, const Attributes &a, int vertexCount) {
    std::int64_t varying = 0;
    for (int count : c.vertexCounts)
        varying += curveSegments(c, count, a.vBasis.step) + (c.periodic ? 0 : 1);
    const int ends = int(varying);
    return {int(c.vertexCounts.size()), ends, vertexCount, ends, vertexCount};
}

} // namespace

int curveSegments(const CurvesRecord &curves, int vertices, int step) {
    if (!curves.cubic)
        return vertices < (curves.periodic ? 3 : 2) ? 0 : vertices - (curves.periodic ? 0 : 1);
    if (vertices < 4)
        return 0;
    return curves.periodic ? vertices / step : (vertices - 4) / step + 1;
}

int VariableCounts::of(StorageClass storage) const {
    switch (storage) {
    case StorageClass::Constant: return 1;
    case StorageClass::Uniform: return uniform;
    case StorageClass::Varying: return varying;
    case StorageClass::Vertex: return vertex;
    case StorageClass::FaceVarying: return faceVarying;
    case StorageClass::FaceVertex: return faceVertex;
    }
    return 1;
}

std::string defectOf(const ShapeRecord &shape, const Attributes &attributes) {
    return std::visit(
        [&](const auto &record) {
            using Record = std::decay_t<decltype(record)>;
            if constexpr (std::is_same_v<Record, PatchMeshRecord>)
                return meshDefect(record, attributes);
            else if constexpr (std::is_same_v<Record, CurvesRecord>)
                return curvesDefect(record, attributes);
            else
                return defect(record);
        },
        shape);
}

std::int64_t verticesNeeded(const ShapeRecord &shape, const Attributes &) {
    if (const auto *polygons = std::get_if<PolygonsRecord>(&shape))
        return std::int64_t(*std::ranges::max_element(polygons->vertices)) + 1;
    if (const auto *mesh = std::get_if<SubdivisionRecord>(&shape))
        return std::int64_t(*std::ranges::max_element(mesh->vertices)) + 1;
    if (const auto *mesh = std::get_if<PatchMeshRecord>(&shape))
        return std::int64_t(mesh->uVertices) * mesh->vVertices;
    if (const auto *patch = std::get_if<NuPatchRecord>(&shape))
        return std::int64_t(patch->u.vertices) * patch->v.vertices;
    if (const auto *points = std::get_if<PointsRecord>(&shape))
        return points->count;
    if (const auto *curves = std::get_if<CurvesRecord>(&shape))
        return std::reduce(curves->vertexCounts.begin(), curves->vertexCounts.end());
    return 4;
}

VariableCounts countsOf(const ShapeRecord &shape, const Attributes &attributes, int vertexCount) {
    if (isQuadric(shape))
        return {};
    if (const auto *polygons = std::get_if<PolygonsRecord>(&shape)) {
        int corners = int(polygons->vertices.size());
        return {int(polygons->loopCounts.size()), vertexCount, vertexCount, corners, corners};
    }
    if (const auto *mesh = std::get_if<SubdivisionRecord>(&shape)) {
        const int corners = int(mesh->vertices.size());
        return {int(mesh->vertexCounts.size()), vertexCount, vertexCount, corners, corners};
    }
    if (const auto *patch = std::get_if<NuPatchRecord>(&shape)) {
        const int u = patch->u.segments(), v = patch->v.segments();
        return {u * v, (u + 1) * (v + 1), vertexCount, 4 * u * v, 4 * u * v, true};
    }
    if (std::holds_alternative<PointsRecord>(shape)) // Each value is a point's, whatever its class.
        return {1, vertexCount, vertexCount, vertexCount, vertexCount};
    if (const auto *blobby = std::get_if<BlobbyRecord>(&shape)) {
        const int leaves = blobby->leaves;
        return {1, leaves, leaves, leaves, leaves};
    }
    if (const auto *curves = std::get_if<CurvesRecord>(&shape))
        return curvesCounts(*curves, attributes, vertexCount);
    const auto &mesh = std::get<PatchMeshRecord>(shape);
    int u = uPatches(mesh, attributes), v = vPatches(mesh, attributes);
    int corners = (u + (mesh.uPeriodic ? 0 : 1)) * (v + (mesh.vPeriodic ? 0 : 1));
    return {u * v, corners, mesh.uVertices * mesh.vVertices, 4 * u * v, 4 * u * v};
}

} // namespace candela
