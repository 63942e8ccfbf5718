// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/polygon_surface.h"

#include "foundation/base/hot.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace candela {

namespace {

/// Floats of a Piece, by which the loops below step from one to the next. They read the pieces as
/// rows of floats, so that a vector of points becomes gathers of one column each.
constexpr int pieceFloats = 22;

/// origin + a edgeA + b edgeB, one axis.
CANDELA_HOT void evaluateAffine(int count, const float *__restrict pieces,
                                const std::uint32_t *__restrict index, const float *__restrict a,
                                const float *__restrict b, float *__restrict to) {
    for (int k = 0; k < count; ++k) {
        int at = int(index[k]) * pieceFloats;
        to[k] = pieces[at] + pieces[at + 3] * a[k] + pieces[at + 6] * b[k];
    }
}

/// edgeA wA + edgeB wB, one axis, for the two weights that stand together.
CANDELA_HOT void combineEdges(int count, const float *__restrict pieces,
                              const float *__restrict weights,
                              const std::uint32_t *__restrict index, float *__restrict to) {
    for (int k = 0; k < count; ++k) {
        int at = int(index[k]) * pieceFloats;
        to[k] = pieces[at + 3] * weights[at] + pieces[at + 6] * weights[at + 1];
    }
}

CANDELA_HOT void gatherFrom(int count, const float *__restrict column,
                            const std::uint32_t *__restrict index, float *__restrict to) {
    for (int k = 0; k < count; ++k)
        to[k] = column[int(index[k]) * pieceFloats];
}

/// From the values at the three corners.
CANDELA_HOT void interpolate(int count, const float *__restrict corners,
                             const std::uint32_t *__restrict index, const float *__restrict a,
                             const float *__restrict b, float *__restrict to) {
    for (int k = 0; k < count; ++k) {
        int at = int(index[k]) * pieceFloats;
        to[k] = corners[at] + a[k] * (corners[at + 1] - corners[at]) +
                b[k] * (corners[at + 2] - corners[at]);
    }
}

} // namespace

PolygonSurface::PolygonSurface(PolygonMesh mesh, const PrimitiveRecord &record,
                               DiagnosticSink &diagnostics)
    : mesh_(std::move(mesh)) {
    takeVariables(record, diagnostics);
    addPieces();
}

std::shared_ptr<const PolygonSurface> PolygonSurface::movedTo(const PrimitiveRecord &record,
                                                              DiagnosticSink &diagnostics) const {
    PolygonMesh mesh = mesh_;
    mesh.points = pointsOf(record, diagnostics);
    if (mesh.points.size() + mesh.made.size() != mesh_.points.size())
        return nullptr;
    addMadePoints(mesh);
    return std::make_shared<PolygonSurface>(std::move(mesh), record, diagnostics);
}

void PolygonSurface::takeVariables(const PrimitiveRecord &record, DiagnosticSink &diagnostics) {
    for (const NumericVariable &variable : numericVariables(record, diagnostics)) {
        auto onMesh = onPolygons(variable, mesh_, record.where, diagnostics);
        if (!onMesh)
            continue;
        if (variable.name == "N" || (variable.name == "Np" && !normal_)) {
            normal_ = std::move(onMesh);
        } else if (variable.name != "Np") {
            infos_.push_back({variable.name, variable.declaration});
            variables_.push_back(std::move(*onMesh));
        }
    }
    addDefault("s", 0);
    addDefault("t", 1);
}

/// Texture coordinates of polygons are the object-space x and y, unless they are given.
void PolygonSurface::addDefault(const char *name, int axis) {
    if (std::ranges::find(infos_, name, &VariableInfo::name) != infos_.end())
        return;
    PolygonVariable variable{PolygonVariable::Rate::Point, 1, {}};
    for (Vec3 p : mesh_.points)
        variable.values.push_back(p[axis]);
    infos_.push_back({name, {StorageClass::Vertex, ValueType::Float, 1}});
    variables_.push_back(std::move(variable));
}

void PolygonSurface::addPieces() {
    auto find = [&](const char *name) {
        return std::ranges::find(infos_, name, &VariableInfo::name) - infos_.begin();
    };
    const PolygonVariable &s = variables_[find("s")], &t = variables_[find("t")];
    double area = 0;
    pieces_.reserve(mesh_.triangles.size());
    for (std::uint32_t k = 0; k < mesh_.triangles.size(); ++k) {
        auto [i0, i1, i2] = mesh_.triangles[k];
        Vec3 p0 = mesh_.points[i0], p1 = mesh_.points[i1], p2 = mesh_.points[i2];
        Piece piece{p0, p1 - p0, p2 - p0, s.corners(mesh_, k, 0), t.corners(mesh_, k, 0), 0,
                    0,  0,       0,       cross(p1 - p0, p2 - p0)};
        setFrame(piece);
        pieces_.push_back(piece);
        bound_.add(p0), bound_.add(p1), bound_.add(p2);
        area += 0.5 * length(cross(piece.edgeA, piece.edgeB));
    }
    area_ = float(area);
}

/// Derivatives of the barycentrics along dPdu and dPdv, in double since slivers are common.
void PolygonSurface::setFrame(Piece &piece) {
    double sa = double(piece.s[1]) - piece.s[0], sb = double(piece.s[2]) - piece.s[0];
    double ta = double(piece.t[1]) - piece.t[0], tb = double(piece.t[2]) - piece.t[0];
    double determinant = sa * tb - sb * ta;
    double size = std::sqrt((sa * sa + ta * ta) * (sb * sb + tb * tb));
    double aDs = tb / determinant, bDs = -ta / determinant;
    double aDt = -sb / determinant, bDt = sa / determinant;
    double limit = 1e12 / std::max(1e-6, double(length(piece.edgeA) + length(piece.edgeB)));
    if (std::abs(determinant) > 1e-6 * size && std::abs(aDs) + std::abs(bDs) < limit &&
        std::abs(aDt) + std::abs(bDt) < limit) {
        double sign = determinant > 0 ? 1 : -1;
        piece.aDu = float(aDs), piece.bDu = float(bDs);
        piece.aDv = float(sign * aDt), piece.bDv = float(sign * bDt);
        return;
    }
    // Gram-Schmidt on the edges: du along the first, dv the rest of the second.
    auto dotOf = [](Vec3 p, Vec3 q) {
        return double(p.x) * q.x + double(p.y) * q.y + double(p.z) * q.z;
    };
    double aa = dotOf(piece.edgeA, piece.edgeA), ab = dotOf(piece.edgeA, piece.edgeB);
    double rest = dotOf(piece.edgeB, piece.edgeB) - ab * ab / aa;
    double height = std::sqrt(std::max(rest, 1e-12 * aa));
    piece.aDu = float(1 / std::sqrt(aa)), piece.bDu = 0;
    piece.aDv = float(-ab / aa / height), piece.bDv = float(1 / height);
}

DicedMesh PolygonSurface::dice(const DiceRate &) const {
    DicedMesh diced;
    diced.positions = mesh_.points;
    diced.triangles = mesh_.triangles;
    return diced;
}

void PolygonSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    static_assert(sizeof(Piece) == pieceFloats * sizeof(float));
    const int count = query.count;
    const float *pieces = reinterpret_cast<const float *>(pieces_.data());
    auto place = [&](const Vec3Planes &to, int axis) {
        evaluateAffine(count, pieces + axis, query.piece, query.u, query.v, (&to.x)[axis]);
    };
    auto combine = [&](const Vec3Planes &to, int axis, int weights) {
        combineEdges(count, pieces + axis, pieces + weights, query.piece, (&to.x)[axis]);
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (answer.P.x)
            place(answer.P, axis);
        if (answer.dPdu.x)
            combine(answer.dPdu, axis, offsetof(Piece, aDu) / sizeof(float));
        if (answer.dPdv.x)
            combine(answer.dPdv, axis, offsetof(Piece, aDv) / sizeof(float));
        if (answer.Ng.x)
            gatherFrom(count, pieces + offsetof(Piece, normal) / sizeof(float) + axis, query.piece,
                       (&answer.Ng.x)[axis]);
        if (answer.N.x)
            gatherFrom(count, pieces + offsetof(Piece, normal) / sizeof(float) + axis, query.piece,
                       (&answer.N.x)[axis]);
    }
    if (answer.u)
        interpolate(count, pieces + offsetof(Piece, s) / sizeof(float), query.piece, query.u,
                    query.v, answer.u);
    if (answer.v)
        interpolate(count, pieces + offsetof(Piece, t) / sizeof(float), query.piece, query.u,
                    query.v, answer.v);
    if (answer.areaScale)
        for (int k = 0; k < count; ++k)
            answer.areaScale[k] = length(pieces_[query.piece[k]].normal);
    for (const Vec3Planes &derivative : {answer.dNdu, answer.dNdv, answer.dNgdu, answer.dNgdv})
        for (int axis = 0; derivative.x && axis < 3; ++axis)
            std::fill_n((&derivative.x)[axis], count, 0.0f);
    if (normal_ && (answer.N.x || answer.dNdu.x || answer.dNdv.x))
        overrideNormals(query, answer);
}

void PolygonSurface::overrideNormals(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    for (int k = 0; k < query.count; ++k) {
        const Piece &piece = pieces_[query.piece[k]];
        Vec3 normal, alongA, alongB;
        for (int axis = 0; axis < 3; ++axis) {
            auto c = normal_->corners(mesh_, query.piece[k], axis);
            alongA[axis] = c[1] - c[0], alongB[axis] = c[2] - c[0];
            normal[axis] = c[0] + query.u[k] * alongA[axis] + query.v[k] * alongB[axis];
        }
        if (!(dot(normal, normal) > 0))
            continue;
        if (answer.N.x)
            answer.N.set(k, normal);
        if (answer.dNdu.x)
            answer.dNdu.set(k, unitDerivative(normal, alongA * piece.aDu + alongB * piece.bDu));
        if (answer.dNdv.x)
            answer.dNdv.set(k, unitDerivative(normal, alongA * piece.aDv + alongB * piece.bDv));
    }
}

void PolygonSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                      float *const *valueDu, float *const *valueDv) const {
    const PolygonVariable &variable = variables_[index];
    for (int component = 0; component < variable.components; ++component)
        for (int k = 0; k < query.count; ++k) {
            const Piece &piece = pieces_[query.piece[k]];
            auto c = variable.corners(mesh_, query.piece[k], component);
            float alongA = c[1] - c[0], alongB = c[2] - c[0];
            if (value)
                value[component][k] = c[0] + query.u[k] * alongA + query.v[k] * alongB;
            if (valueDu)
                valueDu[component][k] = alongA * piece.aDu + alongB * piece.bDu;
            if (valueDv)
                valueDv[component][k] = alongA * piece.aDv + alongB * piece.bDv;
        }
}

} // namespace candela
