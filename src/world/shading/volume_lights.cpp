// SPDX-License-Identifier: Apache-2.0
#include "world/shading/volume_lights.h"

#include "language/runtime/shader_abi.h"

#include <algorithm>
#include <bit>

namespace candela {

void VolumeLights::begin(int lanes) {
    P_.clear(), lane_.clear(), ordinal_.clear(), samples_.clear();
    pointsOf_.resize(std::max(pointsOf_.size(), std::size_t(lanes)));
    for (std::vector<std::int32_t> &points : pointsOf_)
        points.clear();
    next_.assign(pointsOf_.size(), 0);
    lit_ = rows_ = 0;
    refused_ = false;
}

void VolumeLights::beginRun() { std::fill(next_.begin(), next_.end(), 0); }

/// Runs ask in one order, so that the search seldom goes on.
int VolumeLights::find(int lane, Vec3 P) {
    const std::vector<std::int32_t> &points = pointsOf_[std::size_t(lane)];
    std::size_t &next = next_[std::size_t(lane)];
    const auto same = [&](std::int32_t k) {
        const Vec3 at = P_[std::size_t(k)];
        for (int c = 0; c < 3; ++c)
            if (std::bit_cast<std::uint32_t>(at[c]) != std::bit_cast<std::uint32_t>(P[c]))
                return false;
        return true;
    };
    for (std::size_t tried = 0; tried < points.size(); ++tried) {
        const std::size_t at = (next + tried) % points.size();
        if (same(points[at])) {
            next = at + 1;
            return points[at];
        }
    }
    return -1;
}

void VolumeLights::gather(const ServiceCall &call) {
    for (int k = 0; k < call.laneCount; ++k) {
        if (!call.asks(k))
            continue;
        const int lane = call.firstLane + k;
        const Vec3 P{call.operand(0, k).number, call.operand(1, k).number,
                     call.operand(2, k).number};
        int point = find(lane, P);
        std::vector<std::int32_t> &asked = pointsOf_[std::size_t(lane)];
        if (point < 0 && int(asked.size()) >= mostPoints) {
            refused_ = true;
            continue;
        }
        if (point < 0) {
            point = points();
            P_.push_back(P);
            lane_.push_back(lane), ordinal_.push_back(std::int32_t(asked.size()));
            asked.push_back(point);
        }
        call.result(0, k) = float(point);
        call.result(1, k) = float(point < lit_ ? rows_ : 0);
    }
}

void VolumeLights::sample(const ServiceCall &call) const {
    const ShaderArgs &args = *call.args;
    for (int k = 0; k < call.laneCount; ++k) {
        if (!call.asks(k))
            continue;
        const auto at = std::size_t(call.operand(0, k).number) * std::size_t(rows_) +
                        std::size_t(call.operand(1, k).number);
        const int category = int(call.operand(2, k).number);
        if (at >= samples_.size())
            continue;
        const Sample &sample = samples_[at];
        const bool isLit =
            sample.light != 0 && std::ranges::any_of(sample.Cl, [](float c) { return c != 0; });
        const bool isHeard =
            category < 0 || !args.categoryAccepts ||
            args.categoryAccepts[std::size_t(category) * (std::size_t(args.lightCount) + 1) +
                                 std::size_t(sample.light)] != 0;
        if (!isLit || !isHeard)
            continue;
        call.result(0, k) = 1;
        for (int c = 0; c < 3; ++c)
            call.result(1 + c, k) = sample.L[c];
        for (int c = 0; c < colorSamples; ++c)
            call.result(4 + c, k) = sample.Cl[std::size_t(c)];
        call.result(4 + colorSamples, k) = float(sample.light);
    }
}

void VolumeLights::light(int rows) {
    rows_ = rows;
    samples_.resize(std::size_t(points()) * std::size_t(rows));
    lit_ = points();
}

void VolumeLights::set(int row, int k, Vec3 L, const std::array<float, colorSamples> &Cl,
                       std::int32_t number) {
    samples_[std::size_t(k) * std::size_t(rows_) + std::size_t(row)] = {L, Cl, number};
}

} // namespace candela
