// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/moving_surface.h"

#include <algorithm>
#include <utility>

namespace candela {

namespace {

/// Some of a query's points, between two steps.
struct Between {
    std::vector<int> lane;
    std::vector<std::uint32_t> piece;
    std::vector<float> u, v, rest, share; ///< Rest and share: of the one step and of the next.

    SurfaceQuery query() const {
        return {int(lane.size()), piece.data(), u.data(), v.data(), nullptr};
    }
};

/// Planes of a query of so many points.
class OwnPlanes {
public:
    OwnPlanes(int count, std::size_t planes)
        : count_(std::size_t(count)), values_(count_ * planes) {}
    float *take() { return values_.data() + count_ * taken_++; }
    Vec3Planes take3() {
        float *x = take(), *y = take();
        return {x, y, take()};
    }

private:
    std::size_t count_, taken_ = 0;
    std::vector<float> values_;
};

constexpr Vec3Planes SurfaceAnswer::*vectors[] = {
    &SurfaceAnswer::P,    &SurfaceAnswer::dPdu,  &SurfaceAnswer::dPdv, &SurfaceAnswer::dNdu,
    &SurfaceAnswer::dNdv, &SurfaceAnswer::dNgdu, &SurfaceAnswer::dNgdv};
constexpr Vec3Planes SurfaceAnswer::*normals[] = {&SurfaceAnswer::N, &SurfaceAnswer::Ng};
constexpr float *SurfaceAnswer::*numbers[] = {&SurfaceAnswer::u, &SurfaceAnswer::v,
                                              &SurfaceAnswer::areaScale};
constexpr std::size_t answerPlanes =
    3 * (std::size(vectors) + std::size(normals)) + std::size(numbers);

/// Planes for what is wanted.
SurfaceAnswer like(const SurfaceAnswer &wanted, OwnPlanes &own) {
    SurfaceAnswer answer;
    for (auto member : vectors)
        if ((wanted.*member).x)
            answer.*member = own.take3();
    for (auto member : normals)
        if ((wanted.*member).x)
            answer.*member = own.take3();
    for (auto member : numbers)
        if (wanted.*member)
            answer.*member = own.take();
    return answer;
}

void mix(const Between &points, const SurfaceAnswer &a, const SurfaceAnswer &b,
         const SurfaceAnswer &to) {
    const auto mixed = [&](const Vec3Planes &from, const Vec3Planes &into, int k, bool unit) {
        const auto i = std::size_t(k);
        const Vec3 one = from.get(k), other = into.get(k);
        return (unit ? normalize(one) : one) * points.rest[i] +
               (unit ? normalize(other) : other) * points.share[i];
    };
    for (int k = 0; k < int(points.lane.size()); ++k) {
        const int lane = points.lane[std::size_t(k)];
        for (auto member : vectors)
            if ((to.*member).x)
                (to.*member).set(lane, mixed(a.*member, b.*member, k, false));
        for (auto member : normals)
            if ((to.*member).x)
                (to.*member).set(lane, mixed(a.*member, b.*member, k, true));
        for (auto member : numbers)
            if (to.*member)
                (to.*member)[lane] = (a.*member)[k] * points.rest[std::size_t(k)] +
                                     (b.*member)[k] * points.share[std::size_t(k)];
    }
}

} // namespace

MovingSurface::MovingSurface(std::vector<std::shared_ptr<const Surface>> steps)
    : steps_(std::move(steps)) {}

Box3 MovingSurface::bound() const {
    Box3 all;
    for (const auto &step : steps_)
        all.add(step->bound());
    return all;
}

/// Calls ask(points, step, next) for the points between each two steps.
template <class Ask> void MovingSurface::forSteps(const SurfaceQuery &query, Ask ask) const {
    const int last = int(steps_.size()) - 2;
    for (int step = 0; step <= last; ++step) {
        Between points;
        for (int i = 0; i < query.count; ++i) {
            const float place = query.share ? query.share[i] * float(last + 1) : 0;
            if (std::min(int(place), last) != step)
                continue;
            points.lane.push_back(i);
            points.piece.push_back(query.piece ? query.piece[i] : 0);
            points.u.push_back(query.u[i]), points.v.push_back(query.v[i]);
            points.share.push_back(place - float(step));
            points.rest.push_back(1 - points.share.back());
        }
        if (!points.lane.empty())
            ask(points, *steps_[std::size_t(step)], *steps_[std::size_t(step) + 1]);
    }
}

void MovingSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    forSteps(query, [&](const Between &points, const Surface &step, const Surface &next) {
        const SurfaceQuery asked = points.query();
        OwnPlanes own(asked.count, 2 * answerPlanes);
        const SurfaceAnswer a = like(answer, own), b = like(answer, own);
        step.evaluate(asked, a);
        next.evaluate(asked, b);
        mix(points, a, b, answer);
    });
}

void MovingSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                     float *const *valueDu, float *const *valueDv) const {
    const int components = variables()[std::size_t(index)].declaration.components();
    forSteps(query, [&](const Between &points, const Surface &step, const Surface &next) {
        const SurfaceQuery asked = points.query();
        OwnPlanes own(asked.count, 2 * std::size_t(components));
        std::vector<float *> a, b;
        for (int c = 0; c < components; ++c)
            a.push_back(own.take()), b.push_back(own.take());
        for (int slope = 0; slope < 3; ++slope) {
            float *const *to = slope == 0 ? value : slope == 1 ? valueDu : valueDv;
            if (!to)
                continue;
            for (auto [surface, planes] : {std::pair{&step, a.data()}, {&next, b.data()}})
                surface->evaluateVariable(index, asked, slope == 0 ? planes : nullptr,
                                          slope == 1 ? planes : nullptr,
                                          slope == 2 ? planes : nullptr);
            for (int c = 0; c < components; ++c)
                for (std::size_t k = 0; k < points.lane.size(); ++k)
                    to[c][points.lane[k]] = a[std::size_t(c)][k] * points.rest[k] +
                                            b[std::size_t(c)][k] * points.share[k];
        }
    });
}

bool haveSameNames(const Surface &one, const Surface &other) {
    const auto isSame = [](const VariableInfo &a, const VariableInfo &b) {
        return a.name == b.name && a.declaration == b.declaration;
    };
    return one.domain().pieces == other.domain().pieces && one.isRound() == other.isRound() &&
           one.hasOwnNormals() == other.hasOwnNormals() &&
           std::ranges::equal(one.variables(), other.variables(), isSame);
}

namespace {

/// Points that a mesh names, one after the other.
struct Named {
    std::vector<std::uint32_t> piece;
    std::vector<float> u, v;

    void add(std::uint32_t of, std::array<float, 2> at) {
        piece.push_back(of), u.push_back(at[0]), v.push_back(at[1]);
    }
    std::vector<Vec3> on(const Surface &surface) const {
        std::vector<float> planes(3 * piece.size());
        const Vec3Planes P{planes.data(), planes.data() + piece.size(),
                           planes.data() + 2 * piece.size()};
        SurfaceAnswer answer;
        answer.P = P;
        surface.evaluate({int(piece.size()), piece.data(), u.data(), v.data(), nullptr}, answer);
        std::vector<Vec3> points;
        for (int k = 0; k < int(piece.size()); ++k)
            points.push_back(P.get(k));
        return points;
    }
};

} // namespace

LaterMesh meshAtStep(const Surface &step, const DicedMesh &mesh) {
    constexpr std::array<float, 2> corners[] = {{0, 0}, {1, 0}, {0, 1}};
    const auto nameOf = [&](std::uint32_t triangle, int corner) {
        return mesh.vertexUv.empty() ? corners[corner]
                                     : mesh.vertexUv[mesh.triangles[triangle][corner]];
    };
    const auto pieceOf = [&](std::uint32_t triangle) {
        return !mesh.pieces.empty() ? mesh.pieces[triangle] : mesh.vertexUv.empty() ? triangle : 0;
    };
    Named vertices, middles;
    std::vector<int> number(mesh.positions.size(), -1);
    for (std::uint32_t triangle = 0; triangle < mesh.triangles.size(); ++triangle) {
        std::array<float, 2> sum{};
        for (int corner = 0; corner < 3; ++corner) {
            const std::array<float, 2> at = nameOf(triangle, corner);
            sum[0] += at[0] / 3, sum[1] += at[1] / 3;
            int &known = number[mesh.triangles[triangle][corner]];
            if (known >= 0)
                continue;
            known = int(vertices.piece.size());
            vertices.add(pieceOf(triangle), at);
        }
        middles.add(pieceOf(triangle), sum);
    }
    const std::vector<Vec3> moved = vertices.on(step), true_ = middles.on(step);
    LaterMesh later{mesh.positions, mesh.chordError};
    for (std::size_t k = 0; k < number.size(); ++k)
        if (number[k] >= 0)
            later.positions[k] = moved[std::size_t(number[k])];
    for (std::size_t t = 0; mesh.chordError > 0 && t < mesh.triangles.size(); ++t) {
        const auto &[a, b, c] = mesh.triangles[t];
        const Vec3 middle = (later.positions[a] + later.positions[b] + later.positions[c]) / 3;
        later.chordError = std::max(later.chordError, 1.5f * length(middle - true_[t]));
    }
    return later;
}

} // namespace candela
