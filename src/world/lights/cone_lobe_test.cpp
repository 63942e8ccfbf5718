// SPDX-License-Identifier: Apache-2.0
#include "world/lights/cone_lobe.h"

#include <cmath>
#include <gtest/gtest.h>
#include <tuple>
#include <vector>

namespace candela {
namespace {

/// Integral of f(mu) over directions in the cone of half angle alpha (degrees), by Gauss-Legendre
/// on panels that crowd towards the axis.
template <class F> double overCone(double alpha, F f) {
    static const double x[4] = {.1834346424956498, .5255324099163290, .7966664774136267,
                                .9602898564975363};
    static const double w[4] = {.3626837833783620, .3137066458778873, .2223810344533745,
                                .1012285362903763};
    double a = alpha * M_PI / 180, sum = 0;
    const int panels = 4000;
    for (int i = 0; i < panels; ++i) {
        double low = a * std::pow(i / double(panels), 3), high = a * std::pow((i + 1.) / panels, 3);
        for (int j = 0; j < 4; ++j)
            for (double sign : {-1., 1.}) {
                double theta = (low + high) / 2 + sign * x[j] * (high - low) / 2;
                sum += w[j] * (high - low) / 2 * 2 * M_PI * std::sin(theta) *
                       f(1 - 2 * std::pow(std::sin(theta / 2), 2));
            }
    }
    return sum;
}

TEST(ConeLobe, pdfIntegratesToOne) { // I7
    for (double alpha : {1., 5., 30., 60., 85., 90., 120., 180.})
        for (double e : {0., .01, .5, 1., 2., 10., 100., 1000.}) {
            ConeLobe lobe(2 * alpha, e);
            EXPECT_NEAR(overCone(alpha, [&](double mu) { return lobe.pdf(mu); }), 1, 2e-6)
                << alpha << " " << e;
        }
}

TEST(ConeLobe, peakAndMeanCosine) { // I7
    for (auto [alpha, e, peak] : {std::tuple{30., 1., 2.375897},
                                  {30., 2., 2.434152},
                                  {60., 1., .636620},
                                  {60., 10., 1.759303},
                                  {10., 50., 23.912973}})
        EXPECT_NEAR(ConeLobe(2 * alpha, e).pdf(1), peak, 1e-6);
    for (auto [alpha, e, mean] :
         {std::tuple{30., 1., .955342}, {60., 1., 5 / 6.}, {60., 10., .917792}}) {
        ConeLobe lobe(2 * alpha, e);
        EXPECT_NEAR(overCone(alpha, [&](double mu) { return mu * lobe.pdf(mu); }), mean, 1e-6);
    }
}

TEST(ConeLobe, samplerInvertsTheDistribution) {
    for (double alpha : {.5, 5., 30., 60., 85., 90., 135., 180.})
        for (double e : {0., .1, .5, 1., 2., 10., 100., 1e4, 1e5}) {
            ConeLobe lobe(2 * alpha, e);
            double previous = -1;
            for (double xi = 0; xi < 1; xi += 1 / 16.) {
                double tau = lobe.sampleOneMinusMu(xi);
                EXPECT_GT(tau, previous) << alpha << " " << e << " " << xi;
                previous = tau;
                double theta = 2 * std::asin(std::sqrt(tau / 2)) * 180 / M_PI;
                double share = overCone(theta, [&](double mu) { return lobe.pdf(mu); });
                EXPECT_NEAR(share, xi, 1e-5) << alpha << " " << e << " " << xi;
            }
        }
}

TEST(ConeLobe, chiSquareOfTheSampler) { // I7: 32 cells in the cosine; 31 dof, 1e-4 quantile 70.
    for (auto [alpha, e] : {std::pair{30., 2.}, {60., 10.}, {90., 1.}, {120., 3.}, {10., 50.}}) {
        ConeLobe lobe(2 * alpha, e);
        double delta = 1 - std::cos(alpha * M_PI / 180);
        std::vector<double> found(32), expected(32);
        const int n = 1 << 16;
        std::uint32_t state = 12345;
        for (int i = 0; i < n; ++i) {
            state = state * 1664525u + 1013904223u;
            double tau = lobe.sampleOneMinusMu(state * 0x1p-32);
            ++found[std::min(31, int(std::sqrt(tau / delta) * 32))];
        }
        for (int cell = 0; cell < 32; ++cell) {
            double low = delta * cell * cell / 1024, high = delta * (cell + 1) * (cell + 1) / 1024;
            const int steps = 200;
            for (int s = 0; s < steps; ++s)
                expected[cell] += 2 * M_PI * n * (high - low) / steps *
                                  lobe.pdf(1 - low - (s + .5) * (high - low) / steps);
        }
        double chiSquare = 0;
        for (int cell = 0; cell < 32; ++cell)
            if (expected[cell] > 1)
                chiSquare += std::pow(found[cell] - expected[cell], 2) / expected[cell];
        EXPECT_LT(chiSquare, 70) << alpha << " " << e;
    }
}

} // namespace
} // namespace candela
