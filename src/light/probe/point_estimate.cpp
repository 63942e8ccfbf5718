// SPDX-License-Identifier: Apache-2.0
#include "light/probe/point_estimate.h"

#include "foundation/base/student.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {
constexpr double significance = 0.05;
} // namespace

std::array<double, colorSamples> PointEstimate::mean() const {
    std::array<double, colorSamples> result{};
    for (int c = 0; c < colorSamples; ++c) {
        for (const auto &sum : sums_)
            result[c] += sum[c];
        result[c] /= double(samples());
    }
    return result;
}

double PointEstimate::luminance() const {
    double sum = 0;
    for (int batch = 0; batch < batches; ++batch)
        sum += luminanceOf(batch);
    return sum / batches;
}

double PointEstimate::standardError() const {
    const double mean = luminance();
    double squares = 0;
    for (int batch = 0; batch < batches; ++batch)
        squares += (luminanceOf(batch) - mean) * (luminanceOf(batch) - mean);
    return std::sqrt(squares / (batches - 1) / batches);
}

double PointEstimate::luminanceOf(int batch) const {
    double sum = 0;
    for (int c = 0; c < colorSamples; ++c)
        sum += double(luminanceWeights[c]) * sums_[batch][c];
    return sum / samples_;
}

StoppingRule::StoppingRule(int limit, std::optional<double> relativeAccuracy)
    : limit_(std::max(1, (limit + PointEstimate::batches - 1) / PointEstimate::batches)),
      accuracy_(relativeAccuracy) {
    for (int look = 0;; ++look) {
        const double part = accuracy_ ? 1 / (double(look + 1) * double(look + 2)) : 1;
        quantiles_.push_back(studentQuantile(significance * part, PointEstimate::batches - 1));
        if (isLast(look))
            return;
    }
}

int StoppingRule::samplesAt(int look) const {
    return accuracy_ ? std::min(1 << look, limit_) : limit_;
}

double StoppingRule::halfWidth(const PointEstimate &estimate, int look) const {
    return quantiles_[std::size_t(look)] * estimate.standardError();
}

bool StoppingRule::suffices(const PointEstimate &estimate, int look) const {
    const double value = estimate.luminance();
    return accuracy_ && value > 0 && halfWidth(estimate, look) <= *accuracy_ * value;
}

} // namespace candela
