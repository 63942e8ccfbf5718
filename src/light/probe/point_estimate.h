// SPDX-License-Identifier: Apache-2.0
// What is known of a point after some samples, how sure that is, and when it is enough.
#pragma once

#include "foundation/units/color.h"

#include <array>
#include <optional>
#include <vector>

namespace candela {

/// The samples of a point in batches that are scrambled independently of each other. Within a batch
/// samples are stratified, so that batches, not samples, tell how sure the mean is.
class PointEstimate {
public:
    static constexpr int batches = 16;

    void add(int batch, const Color &sample) {
        for (int c = 0; c < colorSamples; ++c)
            sums_[batch][c] += double(sample[c]);
    }
    /// So many samples have come to each batch in all.
    void setSamples(int ofEachBatch) { samples_ = ofEachBatch; }
    int samples() const { return batches * samples_; }

    std::array<double, colorSamples> mean() const;
    double luminance() const;
    /// Of luminance(), from how the batches differ: `batches - 1` degrees of freedom.
    double standardError() const;

private:
    double luminanceOf(int batch) const;

    std::array<std::array<double, colorSamples>, batches> sums_{};
    int samples_ = 0; ///< Of each batch.
};

/// When a point has been looked at enough. With an accuracy, looks are taken after 16 2^k samples,
/// k = 0, 1, ... and at the limit; look k is allowed to be wrong with probability
/// 0.05 / ((k + 1) (k + 2)). These add to 0.05, so that the interval at which sampling stops holds
/// the expectation in 95 cases of 100, although it was the samples that told when to stop; and
/// later looks are allowed more of it than if each had half of what is left. Without an accuracy
/// there is one look, at the limit.
class StoppingRule {
public:
    /// `limit` samples at most, rounded up to whole batches of one size.
    StoppingRule(int limit, std::optional<double> relativeAccuracy);

    /// Samples that each batch has at a look.
    int samplesAt(int look) const;
    /// The expectation of the luminance lies within this of the mean, but with the probability that
    /// the look may be wrong: Student's t of the batches.
    double halfWidth(const PointEstimate &, int look) const;
    bool isLast(int look) const { return samplesAt(look) == limit_; }
    /// The interval's half width is at most so much of the value. No light at all is no accuracy:
    /// who has found none looks on.
    bool suffices(const PointEstimate &, int look) const;

private:
    int limit_; ///< Of each batch.
    std::optional<double> accuracy_;
    std::vector<double> quantiles_; ///< Of Student's t, by look.
};

} // namespace candela
