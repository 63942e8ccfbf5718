// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/trim_region.h"

#include "world/geometry/bezier_net.h"
#include "world/geometry/spline_spans.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

using Place = TrimOutline::Place;

/// Homogeneous Bezier ordinates of a span, u and v over the unit square.
std::vector<std::array<double, 3>> ordinatesOf(const TrimCurveRecord &curve, const SplineSpan &span,
                                               const PatchGrid &grid) {
    const int order = curve.spline.order;
    std::vector<std::array<double, 3>> ordinates(static_cast<std::size_t>(order));
    for (int k = 0; k < order; ++k) {
        std::array<double, 3> sum{};
        for (int i = 0; i < order; ++i) {
            const double weight = span.ordinates[std::size_t(k * order + i)];
            const std::size_t vertex = std::size_t(span.segment + i);
            sum[0] += weight * curve.u[vertex], sum[1] += weight * curve.v[vertex];
            sum[2] += weight * curve.w[vertex];
        }
        ordinates[std::size_t(k)] = {
            (sum[0] - grid.u.low * sum[2]) / (double(grid.u.high) - grid.u.low),
            (sum[1] - grid.v.low * sum[2]) / (double(grid.v.high) - grid.v.low), sum[2]};
    }
    return ordinates;
}

Place pointAt(std::vector<std::array<double, 3>> b, double t) {
    for (std::size_t level = b.size() - 1; level > 0; --level)
        for (std::size_t i = 0; i < level; ++i)
            for (int c = 0; c < 3; ++c)
                b[i][c] = (1 - t) * b[i][c] + t * b[i + 1][c];
    return {b[0][0] / b[0][2], b[0][1] / b[0][2]};
}

/// A chord of n steps is off by no more than the second derivative over 8 n^2.
int stepsFor(const std::vector<std::array<double, 3>> &ordinates, Place tolerance) {
    if (ordinates.size() == 2)
        return 1;
    std::vector<BezierNet> nets(4, BezierNet(int(ordinates.size()), 1));
    for (std::size_t i = 0; i < ordinates.size(); ++i) {
        nets[0].ordinates[i] = ordinates[i][0] / tolerance[0];
        nets[1].ordinates[i] = ordinates[i][1] / tolerance[1];
        nets[3].ordinates[i] = ordinates[i][2];
    }
    const double steps = std::ceil(std::sqrt(rationalDerivatives(std::move(nets)).duu / 8));
    return int(std::clamp(steps, 4.0, 1024.0));
}

} // namespace

TrimOutline::TrimOutline(const TrimRecord &loops, const PatchGrid &grid, Place tolerance)
    : byRow_(rows) {
    for (const auto &loop : loops)
        addLoop(loop, grid, tolerance);
    for (std::uint32_t k = 0; k < segments_.size(); ++k) {
        const auto [low, high] = std::minmax(segments_[k].from[1], segments_[k].to[1]);
        for (int row = rowOf(low); row <= rowOf(high); ++row)
            byRow_[std::size_t(row)].push_back(k);
    }
}

void TrimOutline::addLoop(const std::vector<TrimCurveRecord> &loop, const PatchGrid &grid,
                          Place tolerance) {
    std::vector<Place> points;
    bool isOpen = false;
    const auto isFar = [](Place a, Place b) {
        return std::abs(a[0] - b[0]) > 1e-3 || std::abs(a[1] - b[1]) > 1e-3;
    };
    for (const TrimCurveRecord &curve : loop) {
        bool begins = true;
        for (const SplineSpan &span : splineSpans(curve.spline)) {
            const auto ordinates = ordinatesOf(curve, span, grid);
            const int steps = stepsFor(ordinates, tolerance);
            const Place first = pointAt(ordinates, 0);
            isOpen |= begins && !points.empty() && isFar(first, points.back());
            begins = false;
            for (int step = 0; step <= steps; ++step)
                points.push_back(pointAt(ordinates, double(step) / steps));
        }
    }
    isOpen |= !points.empty() && isFar(points.front(), points.back());
    openLoops_ += isOpen;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Place next = points[(i + 1) % points.size()];
        if (points[i] != next)
            segments_.push_back({points[i], next});
    }
}

int TrimOutline::rowOf(double v) const {
    return int(std::clamp(v * rows, 0.0, double(rows - 1))); // Beyond the square, the last one.
}

int TrimOutline::winding(Place place) const {
    int winding = 0;
    for (std::uint32_t k : byRow_[std::size_t(rowOf(place[1]))]) {
        const auto &[a, b] = segments_[k];
        if ((a[1] <= place[1]) == (b[1] <= place[1]))
            continue;
        const double left = (b[0] - a[0]) * (place[1] - a[1]) - (place[0] - a[0]) * (b[1] - a[1]);
        if (a[1] <= place[1] && left > 0)
            ++winding;
        if (a[1] > place[1] && left < 0)
            --winding;
    }
    return winding;
}

std::span<const std::uint32_t> TrimOutline::near(double lowV, double highV,
                                                 std::vector<std::uint32_t> &found) const {
    const int first = rowOf(lowV), last = rowOf(highV);
    if (first == last)
        return byRow_[std::size_t(first)];
    found.clear();
    for (int row = first; row <= last; ++row)
        found.insert(found.end(), byRow_[std::size_t(row)].begin(), byRow_[std::size_t(row)].end());
    std::ranges::sort(found);
    found.erase(std::ranges::unique(found).begin(), found.end());
    return found;
}

TrimRule::TrimRule(const TrimOutline &outline, bool trimsInside) {
    double area = 0; // To the left of curves, less what is to their right.
    for (const auto &[a, b] : outline.segments())
        area += (a[0] * b[1] - a[1] * b[0]) / 2;
    bool isOpenSquare = false; // Something of it lies outside of all loops.
    for (double u : {1e-4, 1 - 1e-4})
        for (double v : {1e-4, 1 - 1e-4})
            isOpenSquare |= outline.winding({u, v}) == 0;
    offset_ = int(area < -1e-9 && isOpenSquare) + int(trimsInside);
}

} // namespace candela
