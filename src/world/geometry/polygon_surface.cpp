// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/polygon_surface.h"

#include <algorithm>
#include <cmath>

namespace candela {

PolygonSurface::PolygonSurface(PolygonMesh mesh, const PrimitiveRecord &record,
                               DiagnosticSink &diagnostics)
    : mesh_(std::move(mesh)) {
    takeVariables(record, diagnostics);
    addPieces();
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
                    0,  0,       0};
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
    // A loop an answer: what is not wanted is decided once, not at every point.
    auto fill = [&](Vec3Planes to, auto valueOf) {
        if (to.x)
            for (int k = 0; k < query.count; ++k)
                to.set(k, valueOf(pieces_[query.piece[k]], k));
    };
    auto normalOf = [](const Piece &piece, int) { return cross(piece.edgeA, piece.edgeB); };
    fill(answer.P, [&](const Piece &piece, int k) {
        return piece.origin + piece.edgeA * query.u[k] + piece.edgeB * query.v[k];
    });
    fill(answer.Ng, normalOf);
    if (answer.N.x && answer.Ng.x) {
        std::copy_n(answer.Ng.x, query.count, answer.N.x);
        std::copy_n(answer.Ng.y, query.count, answer.N.y);
        std::copy_n(answer.Ng.z, query.count, answer.N.z);
    } else {
        fill(answer.N, normalOf);
    }
    fill(answer.dPdu,
         [](const Piece &piece, int) { return piece.edgeA * piece.aDu + piece.edgeB * piece.bDu; });
    fill(answer.dPdv,
         [](const Piece &piece, int) { return piece.edgeA * piece.aDv + piece.edgeB * piece.bDv; });
    auto interpolate = [&](float *to, auto cornersOf) {
        for (int k = 0; to && k < query.count; ++k) {
            const std::array<float, 3> &c = cornersOf(pieces_[query.piece[k]]);
            to[k] = c[0] + query.u[k] * (c[1] - c[0]) + query.v[k] * (c[2] - c[0]);
        }
    };
    interpolate(
        answer.u, [](const Piece &piece) -> auto & { return piece.s; });
    interpolate(
        answer.v, [](const Piece &piece) -> auto & { return piece.t; });
    if (answer.N.x && normal_)
        overrideNormals(query, answer.N);
}

void PolygonSurface::overrideNormals(const SurfaceQuery &query, Vec3Planes N) const {
    for (int k = 0; k < query.count; ++k) {
        Vec3 normal;
        for (int axis = 0; axis < 3; ++axis) {
            auto c = normal_->corners(mesh_, query.piece[k], axis);
            normal[axis] = c[0] + query.u[k] * (c[1] - c[0]) + query.v[k] * (c[2] - c[0]);
        }
        if (dot(normal, normal) > 0)
            N.set(k, normal);
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
