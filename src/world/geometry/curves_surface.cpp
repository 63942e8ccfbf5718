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

float largest(const CurveOrdinates &values) { return *std::ranges::max_element(values); }

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
    shareWidth();
    if (isRound())
        chooseAxes();
    measure();
}

/// Millions of hairs need not have their widths twice.
void CurvesSurface::shareWidth() {
    const auto same = std::ranges::find_if(variables_, [this](const NumericVariable &variable) {
        return variable.name == width_.name && variable.values == width_.values;
    });
    if (same == variables_.end())
        return;
    sharedWidth_ = int(same - variables_.begin());
    width_.values = {};
}

std::vector<NumericVariable *> CurvesSurface::numbers() {
    if (sharedWidth_ >= 0)
        width_.values = width().values, sharedWidth_ = -1;
    std::vector<NumericVariable *> all{&position_, &width_};
    for (NumericVariable &variable : variables_)
        all.push_back(&variable);
    if (normal_)
        all.push_back(&*normal_);
    return all;
}

CurvesSurface::CurvesSurface(const CurvesSurface &like, Moment moment)
    : layout_(like.layout_), position_(like.position_), width_(like.width_),
      variables_(like.variables_), infos_(like.infos_), normal_(like.normal_),
      textureCoordinates_(like.textureCoordinates_), defaultS_(like.defaultS_),
      defaultT_(like.defaultT_), sharedWidth_(like.sharedWidth_), axes_(like.axes_) {
    for (NumericVariable *variable : numbers())
        keepMoment(*variable, like.times_, moment);
    measure();
    splits_ = like.splits_;
}

CurvesSurface::CurvesSurface(const std::vector<std::shared_ptr<const Surface>> &steps)
    : CurvesSurface(dynamic_cast<const CurvesSurface &>(*steps.front()), Moment{}) {
    for (std::size_t k = 1; k < steps.size(); ++k) {
        CurvesSurface next(dynamic_cast<const CurvesSurface &>(*steps[k]), Moment{});
        const std::vector<NumericVariable *> all = numbers(), later = next.numbers();
        for (std::size_t i = 0; i < all.size(); ++i)
            addStep(*all[i], *later[i]);
    }
    times_ = int(steps.size());
    if (isRound())
        chooseAxes();
    measure();
    finer_ = chooseFiner();
}

std::shared_ptr<const Surface> CurvesSurface::step(int number) const {
    if (times_ == 1)
        return nullptr;
    const Moment moment{number / finer_, float(number % finer_) / float(finer_)};
    return std::shared_ptr<const CurvesSurface>(new CurvesSurface(*this, moment));
}

/// Where lines meet at an angle they are made longer, so that their outer sides meet too: a mitre.
/// Beyond a right angle it is cut short.
void CurvesSurface::extendLine(std::uint32_t number, int time, CurveSegment &segment) const {
    auto wayOf = [&](std::uint32_t line) {
        Vec3 way;
        for (int c = 0; c < 3; ++c) {
            const CurveOrdinates ordinates = layout_.ordinates(position_, line, c, time);
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

CurveSegment CurvesSurface::segmentOf(std::uint32_t number, int time) const {
    CurveSegment segment;
    for (int c = 0; c < 3; ++c)
        segment.position[c] = layout_.ordinates(position_, number, c, time);
    segment.width = layout_.ordinates(width(), number, 0, time);
    if (!layout_.isCubic() && layout_.segmentsBeside(number) > 1)
        extendLine(number, time, segment);
    for (int c = 0; normal_ && c < 3; ++c)
        segment.normal[c] = layout_.ordinates(*normal_, number, c, time);
    return segment;
}

CurveSegment CurvesSurface::segmentAt(std::uint32_t number, Moment moment) const {
    const CurveSegment from = segmentOf(number, moment.step);
    return moment.share == 0 ? from
                             : between(from, segmentOf(number, moment.step + 1), moment.share);
}

void CurvesSurface::chooseAxes() {
    std::vector<Vec3> along(layout_.curves());
    forSegments([&](std::uint32_t i, const CurveSegment &segment) {
        for (float v : {0.0f, 0.5f, 1.0f}) {
            const Vec3 tangent = segment.tangentAt(v);
            for (int c = 0; c < 3; ++c)
                along[layout_.curveOf(i)][c] =
                    std::max(along[layout_.curveOf(i)][c], std::fabs(tangent[c]));
        }
    });
    axes_.assign(along.size(), 0);
    for (std::size_t i = 0; i < along.size(); ++i)
        for (int c = 1; c < 3; ++c)
            if (along[i][c] < along[i][axes_[i]])
                axes_[i] = std::uint8_t(c);
}

void CurvesSurface::measure() {
    double lengths = 0, radii = 0;
    forSegments([&](std::uint32_t, const CurveSegment &segment) {
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
    });
    if (radii > 0)
        splits_ =
            int(std::clamp(std::ceil(lengths / (radii * slenderest)), 1.0, double(mostSplits)));
}

/// So many that between two of them nothing turns by more than a fifth of a radian: then chords are
/// within half a percent of a radius of the arcs.
int CurvesSurface::chooseFiner() const {
    constexpr float most = 0.2f;
    constexpr int mostSteps = 128;
    float cosine = 1;
    for (int time = 0; time + 1 < times_; ++time)
        for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
            const CurveSegment from = segmentOf(i, time), to = segmentOf(i, time + 1);
            for (float v : {0.0f, 0.5f, 1.0f}) {
                cosine = std::min(cosine, dot(from.tangentAt(v), to.tangentAt(v)));
                if (normal_)
                    cosine = std::min(cosine, dot(normalize(ribbonPoint(from, 0, v).dPdu),
                                                  normalize(ribbonPoint(to, 0, v).dPdu)));
            }
        }
    const float turn = std::acos(std::clamp(cosine, -1.0f, 1.0f));
    return std::clamp(int(std::ceil(turn / most)), 1, std::max(1, mostSteps / (times_ - 1)));
}

SectionPoint CurvesSurface::pointOn(const CurveSegment &segment, std::uint32_t number, float u,
                                    float v) const {
    return normal_ ? ribbonPoint(segment, u, v) : tubePoint(segment, axisOf(number), u, v);
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
        const CurveSegment segment = segmentAt(number, momentAt(query.share, k, times_));
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
        const Moment moment = momentAt(query.share, k, times_);
        for (int c = 0; c < variable.components; ++c) {
            const CubicAt at = cubicAt(layout_.ordinates(variable, number, c, moment), query.v[k]);
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
        const CurveSegment segment = segmentOf(i, 0);
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

} // namespace candela
