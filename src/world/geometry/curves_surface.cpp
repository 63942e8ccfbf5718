// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/curves_surface.h"

#include "world/geometry/texture_defaults.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// Rounding of evaluate() in floats, relative to the extent.
constexpr double roundingError = 2e-6;

/// No longer than so many radii are round elements on the mean: what meets them computes with the
/// squares of both.
constexpr float slenderest = 256;
constexpr int mostSplits = 32;

Vec3 axisNumber(int number) { return {float(number == 0), float(number == 1), float(number == 2)}; }

float largest(const CurveOrdinates &values) { return *std::ranges::max_element(values); }

/// The part of a cubic between two places, as a cubic of its own.
CurveOrdinates partOf(const CurveOrdinates &whole, float from, float to) {
    const CubicAt begin = cubicAt(whole, from), end = cubicAt(whole, to);
    const float third = (to - from) / 3;
    return {begin.value, begin.value + third * begin.slope, end.value - third * end.slope,
            end.value};
}

} // namespace

CurvesSurface::CurvesSurface(CurveLayout layout, NumericVariable position, NumericVariable width,
                             std::vector<NumericVariable> variables,
                             std::optional<NumericVariable> normal,
                             const std::array<float, 8> &textureCoordinates)
    : layout_(std::move(layout)), position_(std::move(position)), width_(std::move(width)),
      variables_(std::move(variables)), normal_(std::move(normal)),
      textureCoordinates_(textureCoordinates) {
    for (const NumericVariable &variable : variables_)
        infos_.push_back({variable.name, variable.declaration});
    defaultS_ = addDefault("s", infos_), defaultT_ = addDefault("t", infos_);
    if (isRound())
        chooseAxes();
    measure();
}

/// Where lines meet at an angle they are made longer, so that their outer sides meet too: a mitre.
/// Beyond a right angle it is cut short.
void CurvesSurface::extendLine(std::uint32_t number, CurveSegment &segment) const {
    auto wayOf = [this](std::uint32_t line) {
        Vec3 way;
        for (int c = 0; c < 3; ++c) {
            const CurveOrdinates ordinates = layout_.ordinates(position_, line, c);
            way[c] = ordinates[3] - ordinates[0];
        }
        return normalize(way);
    };
    const Vec3 way = wayOf(number);
    auto reach = [&](std::optional<std::uint32_t> beside, float width) {
        if (!beside)
            return 0.0f;
        const Vec3 other = wayOf(*beside);
        const float half = length(way - other) / std::max(length(way + other), 1e-6f);
        return width / 2 * std::min(half, 1.0f);
    };
    const float before = reach(layout_.previous(number), segment.width[0]);
    const float behind = reach(layout_.next(number), segment.width[3]);
    for (int c = 0; c < 3; ++c) {
        CurveOrdinates &line = segment.position[c];
        const float from = line[0] - way[c] * before, to = line[3] + way[c] * behind;
        line = {from, from + (to - from) / 3, to - (to - from) / 3, to};
    }
}

CurveSegment CurvesSurface::segmentAt(std::uint32_t number) const {
    CurveSegment segment;
    for (int c = 0; c < 3; ++c)
        segment.position[c] = layout_.ordinates(position_, number, c);
    segment.width = layout_.ordinates(width_, number, 0);
    if (!layout_.isCubic() && layout_.segmentsBeside(number) > 1)
        extendLine(number, segment);
    for (int c = 0; normal_ && c < 3; ++c)
        segment.normal[c] = layout_.ordinates(*normal_, number, c);
    return segment;
}

void CurvesSurface::chooseAxes() {
    std::vector<Vec3> along(layout_.curves());
    for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
        const CurveSegment segment = segmentAt(i);
        for (float v : {0.0f, 0.5f, 1.0f}) {
            const Vec3 tangent = segment.tangentAt(v);
            for (int c = 0; c < 3; ++c)
                along[layout_.curveOf(i)][c] =
                    std::max(along[layout_.curveOf(i)][c], std::fabs(tangent[c]));
        }
    }
    axes_.resize(along.size());
    for (std::size_t i = 0; i < along.size(); ++i)
        for (int c = 1; c < 3; ++c)
            if (along[i][c] < along[i][axes_[i]])
                axes_[i] = std::uint8_t(c);
}

void CurvesSurface::measure() {
    double lengths = 0, radii = 0;
    for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
        const CurveSegment segment = segmentAt(i);
        // Ribbons reach out by half of their width, tubes by as much; rounding included.
        const float reach = largest(segment.width) / 2;
        for (int k = 0; k < 4; ++k) {
            const Vec3 knot{segment.position[0][k], segment.position[1][k], segment.position[2][k]};
            const float far = std::max({std::fabs(knot.x), std::fabs(knot.y), std::fabs(knot.z)});
            const float margin = reach + float(roundingError) * (far + reach);
            bound_.add(knot - Vec3{margin, margin, margin});
            bound_.add(knot + Vec3{margin, margin, margin});
        }
        if (reach > 0)
            lengths += segment.largestSlope(), radii += reach;
    }
    if (radii > 0)
        splits_ =
            int(std::clamp(std::ceil(lengths / (radii * slenderest)), 1.0, double(mostSplits)));
}

SectionPoint CurvesSurface::pointOn(const CurveSegment &segment, std::uint32_t number, float u,
                                    float v) const {
    return normal_ ? ribbonPoint(segment, u, v)
                   : tubePoint(segment, axisNumber(axes_[layout_.curveOf(number)]), u, v);
}

/// The unit normal that shaders see: the given one, where there is one.
Vec3 CurvesSurface::normalOn(const CurveSegment &segment, std::uint32_t number, float u,
                             float v) const {
    if (normal_) {
        const Vec3 given{cubicAt(segment.normal[0], v).value, cubicAt(segment.normal[1], v).value,
                         cubicAt(segment.normal[2], v).value};
        if (dot(given, given) > 0)
            return normalize(given);
    }
    return normalize(pointOn(segment, number, u, v).Ng);
}

void CurvesSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    for (int k = 0; k < query.count; ++k) {
        const std::uint32_t number = query.piece[k];
        const CurveSegment segment = segmentAt(number);
        const SectionPoint point = pointOn(segment, number, query.u[k], query.v[k]);
        const float along = float(layout_.segmentsBeside(number));
        auto set = [k](const Vec3Planes &planes, Vec3 value) {
            if (planes.x)
                planes.set(k, value);
        };
        set(answer.P, point.P), set(answer.Ng, point.Ng);
        set(answer.dPdu, point.dPdu), set(answer.dPdv, point.dPdv * along);
        if (answer.u)
            answer.u[k] = query.u[k];
        if (answer.v)
            answer.v[k] = (float(layout_.segmentsBefore(number)) + query.v[k]) / along;
        if (answer.areaScale)
            answer.areaScale[k] = length(cross(point.dPdu, point.dPdv));
        answerNormals(segment, query, k, answer);
    }
}

void CurvesSurface::answerNormals(const CurveSegment &segment, const SurfaceQuery &query, int k,
                                  const SurfaceAnswer &answer) const {
    const std::uint32_t number = query.piece[k];
    const float u = query.u[k], v = query.v[k], along = float(layout_.segmentsBeside(number));
    if (answer.N.x)
        answer.N.set(k, normalOn(segment, number, u, v));
    // Cubics go on beyond their ends, and so do differences.
    constexpr float step = 1e-3f;
    auto differ = [&](const Vec3Planes &byU, const Vec3Planes &byV, auto normal) {
        const Vec3 here = normal(u, v);
        auto across = [&](Vec3 change) { return change - here * dot(here, change); };
        if (byU.x)
            byU.set(k, across((normal(u + step, v) - normal(u - step, v)) * (0.5f / step)));
        if (byV.x)
            byV.set(k, across((normal(u, v + step) - normal(u, v - step)) * (0.5f * along / step)));
    };
    if (answer.dNdu.x || answer.dNdv.x)
        differ(answer.dNdu, answer.dNdv,
               [&](float a, float b) { return normalOn(segment, number, a, b); });
    if (answer.dNgdu.x || answer.dNgdv.x)
        differ(answer.dNgdu, answer.dNgdv,
               [&](float a, float b) { return normalize(pointOn(segment, number, a, b).Ng); });
}

void CurvesSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                     float *const *valueDu, float *const *valueDv) const {
    for (int k = 0; k < query.count; ++k) {
        const std::uint32_t number = query.piece[k];
        const float along = float(layout_.segmentsBeside(number));
        if (index == defaultS_ || index == defaultT_) {
            const float v = (float(layout_.segmentsBefore(number)) + query.v[k]) / along;
            float *values[] = {value ? value[0] + k : nullptr, valueDu ? valueDu[0] + k : nullptr,
                               valueDv ? valueDv[0] + k : nullptr};
            evaluateDefault(textureCoordinates_, index == defaultT_, 1, query.u + k, &v,
                            value ? values : nullptr, valueDu ? values + 1 : nullptr,
                            valueDv ? values + 2 : nullptr);
            continue;
        }
        const NumericVariable &variable = variables_[index];
        for (int c = 0; c < variable.components; ++c) {
            const CubicAt at = cubicAt(layout_.ordinates(variable, number, c), query.v[k]);
            if (value)
                value[c][k] = at.value;
            if (valueDu)
                valueDu[c][k] = 0;
            if (valueDv)
                valueDv[c][k] = at.slope * along;
        }
    }
}

float CurvesSurface::area() const {
    // Two points of Gauss in each of eight cells along; across the area is even but where a tube
    // bends, and there one side has what the other lacks.
    constexpr int cells = 8;
    double sum = 0;
    for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
        const CurveSegment segment = segmentAt(i);
        for (int node = 0; node < 2 * cells; ++node) {
            const double within = 0.5 + (node % 2 ? 1 : -1) * 0.5 / std::numbers::sqrt3;
            const float v = float((node / 2 + within) / cells);
            double around = 0;
            for (float u : {0.0f, 0.25f, 0.5f, 0.75f}) {
                const SectionPoint point = pointOn(segment, i, u + 0.125f, v);
                around += length(cross(point.dPdu, point.dPdv)) / 4;
            }
            sum += around / (2 * cells);
        }
    }
    return float(sum);
}

RoundElements CurvesSurface::roundElements() const {
    RoundElements elements;
    elements.tubes.reserve(std::size_t(layout_.segments()) * splits_);
    elements.knots.reserve(3 * elements.tubes.capacity() + layout_.curves());
    for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
        const CurveSegment segment = segmentAt(i);
        for (int part = 0; part < splits_; ++part) {
            const float from = float(part) / splits_, to = float(part + 1) / splits_;
            std::array<std::array<float, 4>, 4> knots;
            for (int c = 0; c < 4; ++c) {
                const auto ordinates =
                    partOf(c < 3 ? segment.position[c] : segment.width, from, to);
                for (int k = 0; k < 4; ++k)
                    knots[k][c] = c < 3 ? ordinates[k] : std::max(ordinates[k] / 2, 0.0f);
            }
            // Where one begins at the end of the last they share a knot.
            const bool shares = !elements.knots.empty() && elements.knots.back() == knots[0];
            elements.tubes.push_back(std::uint32_t(elements.knots.size()) - shares);
            elements.knots.insert(elements.knots.end(), knots.begin() + shares, knots.end());
        }
    }
    return elements;
}

void CurvesSurface::nameRound(int count, const Vec3Planes &P, std::uint32_t *piece, float *u,
                              float *v) const {
    for (int k = 0; k < count; ++k) {
        const std::uint32_t number = piece[k] / splits_;
        const CurveSegment segment = segmentAt(number);
        const float along = std::clamp((float(piece[k] % splits_) + u[k]) / splits_, 0.0f, 1.0f);
        const TubeFrame frame =
            tubeFrame(segment, axisNumber(axes_[layout_.curveOf(number)]), along);
        const Vec3 out = P.get(k) - segment.at(along);
        const float turns =
            std::atan2(dot(out, frame.y), dot(out, frame.x)) / (2 * std::numbers::pi_v<float>);
        piece[k] = number;
        u[k] = std::clamp(turns < 0 ? turns + 1 : turns, 0.0f, 1.0f);
        v[k] = along;
    }
}

} // namespace candela
