// SPDX-License-Identifier: Apache-2.0
// Tubes as rays meet them: elements along cubics, and what points on them are called.
#include "world/geometry/curves_surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

/// The part of a cubic between two places, as a cubic of its own.
CurveOrdinates partOf(const CurveOrdinates &whole, float from, float to) {
    const CubicAt begin = cubicAt(whole, from), end = cubicAt(whole, to);
    const float third = (to - from) / 3;
    return {begin.value, begin.value + third * begin.slope, end.value - third * end.slope,
            end.value};
}

/// The tube of a part of a segment.
std::array<std::array<float, 4>, 4> knotsOf(const CurveSegment &segment, float from, float to) {
    std::array<std::array<float, 4>, 4> knots;
    for (int c = 0; c < 4; ++c) {
        const auto ordinates = partOf(c < 3 ? segment.position[c] : segment.width, from, to);
        for (int k = 0; k < 4; ++k)
            knots[k][c] = c < 3 ? ordinates[k] : std::max(ordinates[k] / 2, 0.0f);
    }
    return knots;
}

} // namespace

RoundElements CurvesSurface::roundElements() const {
    RoundElements elements;
    elements.tubes.reserve(std::size_t(layout_.segments()) * splits_);
    elements.later.resize(std::size_t(times_ - 1));
    elements.forSteps(
        [&](auto &knots) { knots.reserve(3 * elements.tubes.capacity() + layout_.curves()); });
    std::vector<CurveSegment> inTime(static_cast<std::size_t>(times_));
    for (std::uint32_t i = 0; i < layout_.segments(); ++i) {
        for (int time = 0; time < times_; ++time)
            inTime[std::size_t(time)] = segmentOf(i, time);
        for (int part = 0; part < splits_; ++part) {
            const float from = float(part) / splits_, to = float(part + 1) / splits_;
            // Where one begins at the end of the last, at all steps, they share a knot.
            bool shares = !elements.knots.empty();
            const CurveSegment *segment = inTime.data();
            elements.forSteps([&](auto &knots) {
                shares = shares && knots.back() == knotsOf(*segment++, from, to)[0];
            });
            elements.tubes.push_back(std::uint32_t(elements.knots.size()) - shares);
            segment = inTime.data();
            elements.forSteps([&](auto &knots) {
                const auto own = knotsOf(*segment++, from, to);
                knots.insert(knots.end(), own.begin() + shares, own.end());
            });
        }
    }
    return elements;
}

void CurvesSurface::nameRound(int count, const Vec3Planes &P, const float *share,
                              std::uint32_t *piece, float *u, float *v) const {
    for (int k = 0; k < count; ++k) {
        const std::uint32_t number = piece[k] / splits_;
        const CurveSegment segment = segmentAt(number, momentAt(share, k, times_));
        const float along = std::clamp((float(piece[k] % splits_) + u[k]) / splits_, 0.0f, 1.0f);
        const TubeFrame frame = tubeFrame(segment, axisOf(number), along);
        const Vec3 out = P.get(k) - segment.at(along);
        const float turns =
            std::atan2(dot(out, frame.y), dot(out, frame.x)) / (2 * std::numbers::pi_v<float>);
        piece[k] = number;
        u[k] = std::clamp(turns < 0 ? turns + 1 : turns, 0.0f, 1.0f);
        v[k] = along;
    }
}

} // namespace candela
