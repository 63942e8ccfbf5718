// SPDX-License-Identifier: Apache-2.0
#include "world/camera/pixel_filter.h"

#include <array>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <numbers>

namespace candela {
namespace {

const std::vector<PixelFilterRecord> records{
    {"box", 1, 1},          {"box", 3, 2},         {"triangle", 2, 2},
    {"gaussian", 2, 2},     {"gaussian", 3, 5},    {"sinc", 4, 4},
    {"sinc", 7, 3},         {"mitchell", 4, 4},    {"catmull-rom", 4, 4},
    {"disk", 2, 2},         {"catmull-rom", 3, 3}, {"disk", 1, 3},
    {"bessel", 3.2f, 3.2f}, {"bessel", 6, 4},      {"blackman-harris", 3, 3},
};

PixelFilterSampler make(const PixelFilterRecord &record) {
    DiagnosticList list;
    PixelFilterSampler sampler(record, list);
    EXPECT_EQ(list.count(Severity::Error), 0) << list.text();
    return sampler;
}

/// Integral of kernel times g over the kernel's support. Polar where the support is an ellipse,
/// so that the rule meets no edge.
double kernelIntegral(const PixelFilterRecord &f, const std::function<double(double, double)> &g) {
    constexpr int n = 300;
    const bool radial = f.name == "disk" || f.name == "catmull-rom" || f.name == "bessel";
    const double a = f.xWidth / 2.0, b = f.yWidth / 2.0;
    double sum = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            const double s = (i + 0.5) / n, t = (j + 0.5) / n;
            const double angle = 2 * std::numbers::pi * t;
            const double x = radial ? a * s * std::cos(angle) : a * (2 * s - 1);
            const double y = radial ? b * s * std::sin(angle) : b * (2 * t - 1);
            sum += pixelFilterKernel(f, x, y) * g(x, y) * (radial ? s * std::numbers::pi / 2 : 1);
        }
    return sum * 4 * a * b / (double(n) * n);
}

/// Point i of a rank-1 sequence (the plastic number's): no lattice line lies along a change of
/// sign, so that lobes get their share.
std::array<float, 2> sequence(int i) {
    const double u = 0.5 + i * 0.7548776662466927, v = 0.5 + i * 0.5698402909980532;
    return {std::min(float(u - std::floor(u)), 0x1.fffffep-1f),
            std::min(float(v - std::floor(v)), 0x1.fffffep-1f)};
}

double sampledMean(const PixelFilterSampler &f, const std::function<double(double, double)> &g) {
    constexpr int n = 400000;
    double sum = 0;
    for (int i = 0; i < n; ++i) {
        const auto [u, v] = sequence(i);
        const FilterSample s = f.sample(u, v);
        sum += double(s.weight) * g(s.dx, s.dy);
    }
    return sum / n;
}

TEST(PixelFilter, WeightedMeansAreTheFilterIntegrals) {
    const std::vector<std::function<double(double, double)>> functions{
        [](double, double) { return 1.0; }, [](double x, double y) { return x * x + 0.5 * y * y; },
        [](double x, double y) { return std::cos(1.3 * x + 0.2) * std::exp(0.3 * y); },
        [](double x, double y) { return x + y * y * y; }};
    for (const PixelFilterRecord &record : records) {
        const PixelFilterSampler sampler = make(record);
        const double norm = kernelIntegral(record, functions[0]);
        for (std::size_t k = 0; k < functions.size(); ++k)
            EXPECT_NEAR(sampledMean(sampler, functions[k]),
                        kernelIntegral(record, functions[k]) / norm,
                        2e-3 * std::abs(sampler.sample(0, 0).weight))
                << record.name << " " << record.xWidth << " function " << k;
    }
}

TEST(PixelFilter, WeightIsConstantUpToItsSign) {
    for (const PixelFilterRecord &record : records) {
        const PixelFilterSampler sampler = make(record);
        const float size = std::abs(sampler.sample(0.5f, 0.5f).weight);
        bool negative = false;
        for (int i = 0; i < 300; ++i)
            for (int j = 0; j < 300; ++j) {
                const FilterSample s = sampler.sample(i / 300.0f, j / 300.0f);
                ASSERT_EQ(std::abs(s.weight), size) << record.name;
                const double kernel = pixelFilterKernel(record, s.dx, s.dy);
                if (std::abs(kernel) > 2e-2) {
                    ASSERT_EQ(s.weight > 0, kernel > 0) << record.name << s.dx << " " << s.dy;
                }
                negative |= s.weight < 0;
            }
        EXPECT_EQ(negative, sampler.hasNegativeLobes()) << record.name;
        if (!negative) {
            EXPECT_EQ(size, 1.0f) << record.name;
        }
    }
}

TEST(PixelFilter, ChiSquareOfTheDensity) {
    constexpr int cells = 12, samples = 400000;
    for (const PixelFilterRecord &record : records) {
        const PixelFilterSampler sampler = make(record);
        // The sequence is more even than independent samples, whose upper quantile is a valid
        // bound therefore.
        std::vector<double> count(cells * cells), expected(cells * cells);
        for (int i = 0; i < samples; ++i) {
            const auto [u, v] = sequence(i);
            const FilterSample s = sampler.sample(u, v);
            const int cx = std::min(cells - 1, int((s.dx / record.xWidth + 0.5f) * cells));
            const int cy = std::min(cells - 1, int((s.dy / record.yWidth + 0.5f) * cells));
            ASSERT_TRUE(cx >= 0 && cy >= 0);
            count[cy * cells + cx] += 1;
        }
        constexpr int sub = 60;
        double total = 0;
        for (int y = 0; y < cells * sub; ++y)
            for (int x = 0; x < cells * sub; ++x) {
                const double value = std::abs(
                    pixelFilterKernel(record, ((x + 0.5) / (cells * sub) - 0.5) * record.xWidth,
                                      ((y + 0.5) / (cells * sub) - 0.5) * record.yWidth));
                expected[(y / sub) * cells + x / sub] += value;
                total += value;
            }
        double chiSquare = 0;
        int freedom = -1;
        for (int k = 0; k < cells * cells; ++k) {
            const double e = expected[k] / total * samples;
            if (e < 5)
                continue;
            chiSquare += (count[k] - e) * (count[k] - e) / e;
            ++freedom;
        }
        EXPECT_LT(chiSquare, freedom + 4 * std::sqrt(2.0 * freedom)) << record.name;
    }
}

TEST(PixelFilter, SeparableMapsAreMonotone) {
    for (const PixelFilterRecord &record : records) {
        if (record.name == "disk" || record.name == "catmull-rom" || record.name == "bessel")
            continue;
        const PixelFilterSampler sampler = make(record);
        float last = -1e9f;
        for (int i = 0; i < 5000; ++i) {
            const float x = sampler.sample(i / 5000.0f, 0.3f).dx;
            ASSERT_GE(x, last) << record.name;
            last = x;
        }
        EXPECT_NEAR(sampler.sample(0.5f, 0.5f).dx, 0, 1e-3) << record.name;
    }
}

TEST(PixelFilter, BoxIsTheIdentity) {
    const PixelFilterSampler sampler = make({"box", 1, 1});
    for (float u : {0.0f, 0.1f, 0.5f, 0.7318f, 0.99999f}) {
        EXPECT_NEAR(sampler.sample(u, 0.25f).dx, u - 0.5f, 1e-6f);
        EXPECT_NEAR(sampler.sample(u, 0.25f).dy, -0.25f, 1e-6f);
    }
}

TEST(PixelFilter, BadRecordsAreReportedAndTheDefaultServes) {
    DiagnosticList list;
    const PixelFilterSampler unknown({"lanczos9", 2, 2}, list);
    EXPECT_EQ(unknown.record().name, "gaussian");
    EXPECT_NE(list.text().find("lanczos9"), std::string::npos);
    for (float width : {0.0f, -1.0f, NAN, INFINITY})
        EXPECT_EQ(PixelFilterSampler({"box", width, 1}, list).record().name, "gaussian");
    EXPECT_EQ(list.count(Severity::Error), 5);
}

} // namespace
} // namespace candela
