// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/points_surface.h"

#include "world/geometry/dice_counts.h"
#include "world/geometry/texture_defaults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// Rounding of evaluate() in floats, relative to the extent.
constexpr double roundingError = 2e-6;

/// Longitude and latitude of a query's (u,v).
struct Direction {
    float c, s, up, out; ///< Of the longitude; of the latitude, sine first.

    Direction(float u, float v)
        : c(std::cos(2 * pi * u)), s(std::sin(2 * pi * u)), up(std::sin(pi * (v - 0.5f))),
          out(std::cos(pi * (v - 0.5f))) {}
    Vec3 outwards() const { return {out * c, out * s, up}; }
    Vec3 byU() const { return Vec3{-s, c, 0} * (2 * pi * out); }
    Vec3 byV() const { return Vec3{-up * c, -up * s, out} * pi; }
};

} // namespace

PointsSurface::PointsSurface(std::vector<std::array<float, 4>> knots,
                             std::vector<NumericVariable> variables,
                             std::optional<NumericVariable> normal,
                             const std::array<float, 8> &textureCoordinates)
    : elements_{std::move(knots), {}}, variables_(std::move(variables)), normal_(std::move(normal)),
      textureCoordinates_(textureCoordinates) {
    for (const NumericVariable &variable : variables_)
        infos_.push_back({variable.name, variable.declaration});
    defaultS_ = addDefault("s", infos_), defaultT_ = addDefault("t", infos_);
    measure();
}

PointsSurface::PointsSurface(const PointsSurface &like, int step)
    : elements_{like.knotsOf(step), {}}, variables_(like.variables_), infos_(like.infos_),
      normal_(like.normal_), textureCoordinates_(like.textureCoordinates_),
      defaultS_(like.defaultS_), defaultT_(like.defaultT_) {
    for (NumericVariable &variable : variables_)
        keepMoment(variable, like.steps(), {step, 0});
    if (normal_)
        keepMoment(*normal_, like.steps(), {step, 0});
    measure();
}

PointsSurface::PointsSurface(const std::vector<std::shared_ptr<const Surface>> &steps)
    : PointsSurface(dynamic_cast<const PointsSurface &>(*steps.front()), 0) {
    for (std::size_t k = 1; k < steps.size(); ++k) {
        const auto &next = dynamic_cast<const PointsSurface &>(*steps[k]);
        elements_.later.push_back(next.elements_.knots);
        for (std::size_t i = 0; i < variables_.size(); ++i)
            addStep(variables_[i], next.variables_[i]);
        if (normal_)
            addStep(*normal_, *next.normal_);
    }
    measure();
}

std::shared_ptr<const Surface> PointsSurface::step(int number) const {
    if (steps() == 1)
        return nullptr;
    return std::shared_ptr<const PointsSurface>(new PointsSurface(*this, number));
}

void PointsSurface::measure() {
    elements_.forSteps([this](const std::vector<Knot> &knots) {
        for (const auto &[x, y, z, radius] : knots) {
            const float far = std::max({std::fabs(x), std::fabs(y), std::fabs(z)});
            const float margin = radius + float(roundingError) * (radius + far);
            bound_.add(Vec3{x, y, z} - Vec3{margin, margin, margin});
            bound_.add(Vec3{x, y, z} + Vec3{margin, margin, margin});
            largestRadius_ = std::max(largestRadius_, radius);
        }
    });
}

PointsSurface::Knot PointsSurface::knotAt(std::uint32_t point, Moment moment) const {
    Knot knot = knotsOf(moment.step)[point];
    for (std::size_t k = 0; moment.share != 0 && k < knot.size(); ++k)
        knot[k] = knot[k] * (1 - moment.share) + knotsOf(moment.step + 1)[point][k] * moment.share;
    return knot;
}

void PointsSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    for (int k = 0; k < query.count; ++k) {
        const Moment moment = momentAt(query.share, k, steps());
        const auto [x, y, z, radius] = knotAt(query.piece[k], moment);
        const Direction direction(query.u[k], query.v[k]);
        const Vec3 outwards = direction.outwards();
        auto set = [k](const Vec3Planes &planes, Vec3 value) {
            if (planes.x)
                planes.set(k, value);
        };
        set(answer.P, Vec3{x, y, z} + outwards * radius);
        set(answer.dPdu, direction.byU() * radius), set(answer.dPdv, direction.byV() * radius);
        set(answer.Ng, outwards);
        set(answer.dNgdu, direction.byU()), set(answer.dNgdv, direction.byV());
        Vec3 given;
        for (int c = 0; normal_ && c < 3; ++c)
            given[c] = valueAt(*normal_, query.piece[k], c, moment);
        const bool isGiven = dot(given, given) > 0;
        set(answer.N, isGiven ? given : outwards);
        set(answer.dNdu, isGiven ? Vec3{} : direction.byU());
        set(answer.dNdv, isGiven ? Vec3{} : direction.byV());
        if (answer.u)
            answer.u[k] = query.u[k];
        if (answer.v)
            answer.v[k] = query.v[k];
        if (answer.areaScale)
            answer.areaScale[k] = 2 * pi * pi * radius * radius * std::max(direction.out, 0.0f);
    }
}

void PointsSurface::nameRound(int count, const Vec3Planes &P, const float *share,
                              std::uint32_t *piece, float *u, float *v) const {
    for (int k = 0; k < count; ++k) {
        const auto [x, y, z, radius] = knotAt(piece[k], momentAt(share, k, steps()));
        const Vec3 out = P.get(k) - Vec3{x, y, z};
        const float turns = std::atan2(out.y, out.x) / (2 * pi);
        const float latitude = std::atan2(out.z, std::hypot(out.x, out.y));
        u[k] = std::clamp(turns < 0 ? turns + 1 : turns, 0.0f, 1.0f);
        v[k] = std::clamp(latitude / pi + 0.5f, 0.0f, 1.0f);
    }
}

float PointsSurface::valueAt(const NumericVariable &variable, std::uint32_t point, int component,
                             Moment moment) const {
    const std::size_t size = variable.values.size() / std::size_t(steps());
    const bool isOne = size == std::size_t(variable.components);
    const float *from = variable.values.data() + std::size_t(moment.step) * size +
                        (isOne ? 0 : std::size_t(point) * variable.components) + component;
    return moment.share == 0 ? *from : *from * (1 - moment.share) + from[size] * moment.share;
}

void PointsSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                     float *const *valueDu, float *const *valueDv) const {
    if (index == defaultS_ || index == defaultT_)
        return evaluateDefault(textureCoordinates_, index == defaultT_, query.count, query.u,
                               query.v, value, valueDu, valueDv);
    const NumericVariable &variable = variables_[index];
    for (int k = 0; k < query.count; ++k) {
        const Moment moment = momentAt(query.share, k, steps());
        for (int c = 0; c < variable.components; ++c) {
            if (value)
                value[c][k] = valueAt(variable, query.piece[k], c, moment);
            if (valueDu)
                valueDu[c][k] = 0;
            if (valueDv)
                valueDv[c][k] = 0;
        }
    }
}

float PointsSurface::area() const {
    double sum = 0;
    for (const Knot &knot : elements_.knots)
        sum += 4 * std::numbers::pi * knot[3] * knot[3];
    return float(sum);
}

/// The surface of a ball of radius 1 cut along so many circles each way.
static double areaOfCells(int around, int along) {
    double area = 0;
    for (int v = 0; v < along; ++v) {
        const double low = std::numbers::pi * v / along, high = std::numbers::pi * (v + 1) / along;
        const double half = std::numbers::pi / around;
        // The chords of both circles, and the way between their middles.
        const double below = 2 * std::sin(low) * std::sin(half);
        const double above = 2 * std::sin(high) * std::sin(half);
        const double across = (std::sin(high) - std::sin(low)) * std::cos(half);
        area += around * (below + above) / 2 * std::hypot(across, std::cos(low) - std::cos(high));
    }
    return area;
}

PointsSurface::Cells PointsSurface::cellsAt(const DiceRate &rate) const {
    const double r = largestRadius_, turn = 2 * std::numbers::pi, half = std::numbers::pi;
    const DerivativeBounds bounds{
        turn * r, half * r, turn * turn * r, turn * half * r, half * half * r, false, false};
    const double cells = std::max(15.0, maximalCells / double(count()));
    DiceCounts counts = chooseCounts(bounds, rate, {5, 3}, cells);
    const double scale = std::sqrt(4 * std::numbers::pi / areaOfCells(counts.u, counts.v));
    return {counts.u, counts.v, scale, cellError(bounds, counts) + (scale - 1) * r};
}

/// Two a cell, one at the poles.
double PointsSurface::triangleCount(const DiceRate &rate) const {
    const Cells cells = cellsAt(rate);
    return double(count()) * cells.around * (2.0 * cells.along - 2);
}

DicedMesh PointsSurface::dice(const DiceRate &rate) const {
    const Cells cells = cellsAt(rate);
    const std::uint32_t row = std::uint32_t(cells.around) + 1;
    DicedMesh mesh;
    for (std::uint32_t piece = 0; piece < count(); ++piece) {
        const auto &[x, y, z, radius] = elements_.knots[piece];
        const auto first = std::uint32_t(mesh.positions.size());
        for (int v = 0; v <= cells.along; ++v)
            for (int u = 0; u <= cells.around; ++u) {
                const float across = float(u) / cells.around, up = float(v) / cells.along;
                const bool isPole = v == 0 || v == cells.along;
                // The seam is one line, each pole one point.
                Vec3 out = Direction(u < cells.around ? across : 0, up).outwards();
                if (isPole)
                    out = {0, 0, v == 0 ? -1.0f : 1.0f};
                mesh.positions.push_back(Vec3{x, y, z} + out * (radius * float(cells.scale)));
                mesh.vertexUv.push_back({across, up});
            }
        const std::size_t before = mesh.triangles.size();
        for (std::uint32_t v = 0; v < std::uint32_t(cells.along); ++v)
            for (std::uint32_t u = 0; u + 1 < row; ++u) {
                const std::uint32_t corner = first + v * row + u;
                if (v > 0)
                    mesh.triangles.push_back({corner, corner + 1, corner + row});
                if (v + 1 < std::uint32_t(cells.along))
                    mesh.triangles.push_back({corner + 1, corner + row + 1, corner + row});
            }
        mesh.pieces.insert(mesh.pieces.end(), mesh.triangles.size() - before, piece);
    }
    const Vec3 extent = bound_.extent();
    mesh.chordError = float(cells.error + roundingError * std::max({extent.x, extent.y, extent.z}));
    return mesh;
}

} // namespace candela
