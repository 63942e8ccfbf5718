// SPDX-License-Identifier: Apache-2.0
// Student's t: how sure a mean is.
#pragma once

#include <vector>

namespace candela {

struct MeanAndError {
    double mean = 0;
    double standardError = 0; ///< Of the mean.
};
/// Of independent results; at least two.
MeanAndError meanAndError(const std::vector<double> &values);

/// Probability that |T| > t for T of Student's distribution with that many degrees of freedom.
double studentTail(double t, int degreesOfFreedom);

/// The t with studentTail(t) = probability, which lies in (0, 1).
double studentQuantile(double probability, int degreesOfFreedom);

} // namespace candela
