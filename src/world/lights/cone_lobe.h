// SPDX-License-Identifier: Apache-2.0
// The paper's importance cones (equation 4): a power-cosine lobe inside a cone, as a density over
// directions that is exact to evaluate and to sample. ALGORITHMS section 1 fixes the limits.
#pragma once

namespace candela {

/// One lobe about its axis, in double precision: everything that depends on angle and exponent
/// alone. Directions are given by their cosine with the axis.
class ConeLobe {
public:
    /// `fullAngle` in degrees, clamped to (0, 360]; `exponent` clamped to [0, 1e6], 0 = uniform.
    ConeLobe(double fullAngle, double exponent);

    /// Density per steradian at a direction whose cosine with the axis is `mu`.
    double pdf(double mu) const;
    /// 1 - mu for the uniform number xi in [0,1): inverts the cumulative distribution, monotone.
    /// (The azimuth is 2 pi times a second number.) 1 - mu keeps its precision in narrow cones.
    double sampleOneMinusMu(double xi) const;

private:
    enum class Shape { Uniform, Power, PowerMinusRim };
    double powerTau(double xi) const;
    double rimTau(double xi) const;

    Shape shape_;
    double cosine_;     ///< c = cos(alpha), alpha = half the full angle.
    double delta_;      ///< 1 - c without cancellation.
    double exponent_;   ///< e
    double logCosine_;  ///< ln c for c > 0.
    double normal_ = 0; ///< D of ALGORITHMS 1 for PowerMinusRim, else 0.
};

} // namespace candela
