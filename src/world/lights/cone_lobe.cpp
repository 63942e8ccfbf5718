// SPDX-License-Identifier: Apache-2.0
#include "world/lights/cone_lobe.h"

#include <algorithm>
#include <cmath>

namespace candela {

ConeLobe::ConeLobe(double fullAngle, double exponent) {
    if (!(exponent > 0))
        exponent = 0;
    exponent_ = std::min(exponent, 1e6);
    if (fullAngle == 180) { // What nearly all lobes of a surface are.
        cosine_ = logCosine_ = 0, delta_ = 1;
        shape_ = exponent_ == 0 ? Shape::Uniform : Shape::Power;
        return;
    }
    double alpha = std::clamp(fullAngle, 1e-4, 360.0) * (M_PI / 360);
    double halfSine = std::sin(alpha / 2);
    delta_ = 2 * halfSine * halfSine;
    cosine_ = 1 - delta_;
    logCosine_ = cosine_ > 0 ? std::log1p(-delta_) : 0;

    // c^e below double precision leaves the plain lobe, and the general formula would overflow.
    bool rimMatters = cosine_ > 0 && -exponent_ * logCosine_ <= 36;
    shape_ = exponent_ == 0 ? Shape::Uniform : rimMatters ? Shape::PowerMinusRim : Shape::Power;
    if (shape_ == Shape::PowerMinusRim)
        normal_ = -std::expm1(exponent_ * logCosine_ + std::log1p(exponent_ * delta_));
}

double ConeLobe::pdf(double mu) const {
    if (!(mu >= cosine_))
        return 0;
    mu = std::min(mu, 1.0);
    switch (shape_) {
    case Shape::Uniform: return 1 / (2 * M_PI * delta_);
    case Shape::Power: {
        // Beyond a right angle the lobe is shifted; a narrow one with a high exponent is the
        // unshifted lobe, whose rim is below precision.
        double m = cosine_ <= 0 ? (mu - cosine_) / delta_ : mu;
        double width = cosine_ <= 0 ? delta_ : 1;
        return (exponent_ + 1) * std::pow(m, exponent_) / (2 * M_PI * width);
    }
    case Shape::PowerMinusRim: {
        // (mu^e - c^e) as c^e ((mu/c)^e - 1), exact near the rim.
        double rim = std::exp(exponent_ * logCosine_);
        double rise = std::expm1(exponent_ * std::log1p((mu - cosine_) / cosine_));
        return (exponent_ + 1) * rim * rise / (2 * M_PI * normal_);
    }
    }
    return 0;
}

double ConeLobe::sampleOneMinusMu(double xi) const {
    switch (shape_) {
    case Shape::Uniform: return xi * delta_;
    case Shape::Power: return powerTau(xi) * (cosine_ <= 0 ? delta_ : 1);
    case Shape::PowerMinusRim: return rimTau(xi);
    }
    return 0;
}

double ConeLobe::powerTau(double xi) const {
    return -std::expm1(std::log1p(-xi) / (exponent_ + 1));
}

double ConeLobe::rimTau(double xi) const {
    const double e = exponent_, c = cosine_;
    if (e == 1)
        return delta_ * (1 - std::sqrt(1 - xi));
    // Solve S(tau) = 1 - xi for the share S of the lobe beyond tau, with x = (delta - tau) / c:
    // S = c^(e+1) [ (1+x)^(e+1) - 1 - (e+1) x ] / D. Newton on S^(1/k), kept in a bracket.
    const double scale = std::exp((e + 1) * logCosine_) / normal_;
    const double target = 1 - xi;
    const double k = target * normal_ < 4 * std::exp((e + 1) * logCosine_) ? 2 : e + 1;
    auto share = [&](double tau) {
        double x = std::max(0.0, (delta_ - tau) / c);
        return scale * (std::expm1((e + 1) * std::log1p(x)) - (e + 1) * x);
    };
    auto slope = [&](double tau) { // dS / dtau
        double x = std::max(0.0, (delta_ - tau) / c);
        return -scale * (e + 1) / c * std::expm1(e * std::log1p(x));
    };
    double low = 0, high = delta_;
    double tau =
        std::min(-std::expm1(std::log1p(-xi * (1 - std::exp((e + 1) * logCosine_))) / (e + 1)),
                 delta_ * (1 - std::sqrt(1 - xi)));
    const double root = std::pow(target, 1 / k);
    for (int iteration = 0; iteration < 40; ++iteration) {
        double s = share(tau);
        (s > target ? low : high) = tau;
        double step = 0;
        if (s > 0) {
            double powered = std::pow(s, 1 / k);
            step = (powered - root) / (powered / (k * s) * slope(tau));
        }
        double next = tau - step;
        if (!(next > low && next < high) || s <= 0)
            next = 0.5 * (low + high);
        if (std::fabs(next - tau) <= 1e-14 * delta_)
            return next;
        tau = next;
    }
    return tau;
}

} // namespace candela
