// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/displaced_surface.h"

#include "world/geometry/slopes_between.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

float cosine(Vec3 a, Vec3 b) {
    // Areas of small triangles leave the range of floats when they are squared.
    const auto most = [](Vec3 v) {
        return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
    };
    return dot(normalize(a / most(a)), normalize(b / most(b)));
}

/// Planes of a call's own.
class OwnPlanes {
public:
    OwnPlanes(int planes, int count)
        : values_(std::size_t(planes) * std::size_t(count)), count_(count) {}
    float *next() { return values_.data() + std::size_t(taken_++) * std::size_t(count_); }
    Vec3Planes nextThree() {
        float *x = next(), *y = next();
        return {x, y, next()};
    }

private:
    std::vector<float> values_;
    int count_, taken_ = 0;
};

} // namespace

/// What the surface behind calls the points.
class DisplacedSurface::Names {
public:
    Names(const DisplacedMesh &mesh, const SurfaceQuery &query)
        : piece_(std::size_t(query.count), 0), u_(piece_.size()), v_(piece_.size()) {
        for (std::size_t k = 0; k < piece_.size(); ++k) {
            const auto [a, b, c] = mesh.triangles[query.piece[k]];
            const auto &pa = mesh.vertexUv[a], &pb = mesh.vertexUv[b], &pc = mesh.vertexUv[c];
            u_[k] = pa[0] + query.u[k] * (pb[0] - pa[0]) + query.v[k] * (pc[0] - pa[0]);
            v_[k] = pa[1] + query.u[k] * (pb[1] - pa[1]) + query.v[k] * (pc[1] - pa[1]);
            if (!mesh.pieces.empty())
                piece_[k] = mesh.pieces[query.piece[k]];
        }
    }
    SurfaceQuery query() const { return {int(piece_.size()), piece_.data(), u_.data(), v_.data()}; }

private:
    std::vector<std::uint32_t> piece_;
    std::vector<float> u_, v_;
};

namespace {

/// The same points moved along one barycentric coordinate, within their triangles.
class Beside {
public:
    Beside(const SurfaceQuery &query, bool alongU)
        : query_(query), moved_(std::size_t(query.count)) {
        const float *from = alongU ? query.u : query.v;
        for (std::size_t k = 0; k < moved_.size(); ++k)
            moved_[k] = from[k] < 1 / 3.0f ? from[k] + step : from[k] - step;
        (alongU ? query_.u : query_.v) = moved_.data();
    }
    const SurfaceQuery &query() const { return query_; }

private:
    static constexpr float step = 0.25f;
    SurfaceQuery query_;
    std::vector<float> moved_;
};

} // namespace

DisplacedSurface::DisplacedSurface(std::shared_ptr<const Surface> behind,
                                   std::shared_ptr<const Displacement> displacement,
                                   DisplacedMesh mesh)
    : SurfaceView(std::move(behind)), displacement_(std::move(displacement)),
      mesh_(std::move(mesh)) {
    double area = 0;
    for (Vec3 position : mesh_.positions)
        bound_.add(position);
    for (auto [a, b, c] : mesh_.triangles)
        area += 0.5 * length(cross(mesh_.positions[b] - mesh_.positions[a],
                                   mesh_.positions[c] - mesh_.positions[a]));
    area_ = float(area);
}

DicedMesh DisplacedSurface::dice(const DiceRate &) const {
    return {mesh_.positions, mesh_.triangles, {}, {}, 0};
}

void DisplacedSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    const Names names(mesh_, query);
    SurfaceAnswer passed;
    passed.u = answer.u, passed.v = answer.v;
    if (passed.u || passed.v)
        behind().evaluate(names.query(), passed);
    if (answer.P.x || answer.Ng.x || answer.N.x || answer.dPdu.x || answer.dPdv.x)
        displace(names, query, answer);
    if (answer.dNdu.x || answer.dNdv.x || answer.dNgdu.x || answer.dNgdv.x)
        differentiateNormals(names, query, answer);
    for (int k = 0; answer.areaScale && k < query.count; ++k) {
        const auto [a, b, c] = mesh_.triangles[query.piece[k]];
        const Vec3 p = mesh_.positions[a];
        answer.areaScale[k] = length(cross(mesh_.positions[b] - p, mesh_.positions[c] - p));
    }
}

bool DisplacedSurface::evaluateUnmoved(const SurfaceQuery &query,
                                       const SurfaceAnswer &answer) const {
    if (displacement_->isOfSurface())
        behind().evaluate(Names(mesh_, query).query(), answer);
    return displacement_->isOfSurface();
}

/// P, N, Ng and the derivatives of P.
void DisplacedSurface::displace(const Names &names, const SurfaceQuery &query,
                                const SurfaceAnswer &answer) const {
    OwnPlanes own(9, query.count);
    SurfaceAnswer displaced;
    displaced.N = answer.N;
    displaced.P = answer.P.x ? answer.P : own.nextThree();
    displaced.dPdu = answer.dPdu.x ? answer.dPdu : own.nextThree();
    displaced.dPdv = answer.dPdv.x ? answer.dPdv : own.nextThree();
    displacement_->displace(names.query(), displaced);
    if (!displacement_->knowsSlopes())
        differentiatePoints(names, query, displaced);
    displaced.Ng = answer.Ng;
    keepToTriangles(query, displaced);
}

/// Derivatives of P, which is known, by differences.
void DisplacedSurface::differentiatePoints(const Names &names, const SurfaceQuery &query,
                                           const SurfaceAnswer &answer) const {
    OwnPlanes own(6, query.count);
    const Vec3Planes P[3] = {answer.P, own.nextThree(), own.nextThree()};
    const Names a(mesh_, Beside(query, true).query()), b(mesh_, Beside(query, false).query());
    SurfaceAnswer position;
    position.P = P[1];
    displacement_->displace(a.query(), position);
    position.P = P[2];
    displacement_->displace(b.query(), position);
    slopesBetween(behind(), {names.query(), a.query(), b.query()}, P, answer.dPdu, answer.dPdv);
}

void DisplacedSurface::differentiateNormals(const Names &names, const SurfaceQuery &query,
                                            const SurfaceAnswer &answer) const {
    OwnPlanes own(21, query.count);
    const Beside alongA(query, true), alongB(query, false);
    const Names a(mesh_, alongA.query()), b(mesh_, alongB.query());
    const Vec3Planes N[3] = {own.nextThree(), own.nextThree(), own.nextThree()};
    const Vec3Planes Ng[3] = {own.nextThree(), own.nextThree(), own.nextThree()};
    const Vec3Planes spare = own.nextThree();
    const SurfaceQuery *where[3] = {&query, &alongA.query(), &alongB.query()};
    for (int side = 0; side < 3; ++side) {
        SurfaceAnswer normals;
        normals.N = N[side], normals.Ng = Ng[side];
        evaluate(*where[side], normals);
        for (int k = 0; k < query.count; ++k)
            for (const Vec3Planes &unit : {N[side], Ng[side]})
                unit.set(k, normalize(unit.get(k)));
    }
    const Neighbours points{names.query(), a.query(), b.query()};
    auto orSpare = [&](const Vec3Planes &wanted) { return wanted.x ? wanted : spare; };
    if (answer.dNdu.x || answer.dNdv.x)
        slopesBetween(behind(), points, N, orSpare(answer.dNdu), orSpare(answer.dNdv));
    if (answer.dNgdu.x || answer.dNgdv.x)
        slopesBetween(behind(), points, Ng, orSpare(answer.dNgdu), orSpare(answer.dNgdv));
}

void DisplacedSurface::keepToTriangles(const SurfaceQuery &query,
                                       const SurfaceAnswer &answer) const {
    for (int k = 0; k < query.count; ++k) {
        const auto [a, b, c] = mesh_.triangles[query.piece[k]];
        const Vec3 p = mesh_.positions[a], edgeA = mesh_.positions[b] - p;
        const Vec3 edgeB = mesh_.positions[c] - p, edgeC = edgeB - edgeA;
        const float longest = std::max({dot(edgeA, edgeA), dot(edgeB, edgeB), dot(edgeC, edgeC)});
        const float tolerance = displacedTolerance * std::sqrt(longest);
        const Vec3 met = p + edgeA * query.u[k] + edgeB * query.v[k];
        const bool isClose = length(answer.P.get(k) - met) <= tolerance;
        answer.P.set(k, met);
        const Vec3 element = cross(edgeA, edgeB) * mesh_.sign;
        const Vec3 Ng = cross(answer.dPdu.get(k), answer.dPdv.get(k));
        const bool isSurface = !isClose || !(cosine(Ng, element) >= displacedCosine);
        if (answer.Ng.x)
            answer.Ng.set(k, isSurface ? element : Ng);
        if (answer.N.x && displacement_->givesTrueNormals())
            answer.N.set(k, isSurface ? element : Ng);
        if (!answer.N.x || !displacement_->setsNormals())
            continue;
        // What calculatenormal(P) says is the very Ng, but for rounding, and is to stay so where Ng
        // is turned to the side that was met.
        if (isSurface)
            answer.N.set(k, element);
        else if (cosine(answer.N.get(k), Ng) > 1 - 1e-6f)
            answer.N.set(k, Ng);
    }
}

void DisplacedSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                        float *const *valueDu, float *const *valueDv) const {
    behind().evaluateVariable(index, Names(mesh_, query).query(), value, valueDu, valueDv);
}

} // namespace candela
