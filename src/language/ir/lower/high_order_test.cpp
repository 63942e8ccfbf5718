// SPDX-License-Identifier: Apache-2.0
// Derivatives of derivatives.
#include "language/ir/lower/patch_points.h"

#include <array>
#include <cmath>

namespace candela::ir {
namespace {

double at(const std::string &body, double u, double v) {
    ShaderRun run(surfaceWith("float", body), 1);
    EXPECT_TRUE(run.lowered) << body << run.diagnostics.text();
    if (!run.lowered)
        return NAN;
    placeOnPatch(run, 0, u, v);
    return run.run().at("result")[0][0];
}

struct ClosedForm {
    const char *body;
    double (*value)(double u, double v);
};

const ClosedForm closedForms[] = {
    {"result = Du(Du(u * u * u)) + 10 * Dv(Du(u * v * v));",
     [](double u, double v) { return 6 * u + 20 * v; }},
    {"result = Du(Du(Du(sin(u * v))));",
     [](double u, double v) { return -v * v * v * std::cos(u * v); }},
    {"result = Dv(Du(sin(u * v)));",
     [](double u, double v) { return std::cos(u * v) - u * v * std::sin(u * v); }},
    {"result = Du(Dv(Dv(exp(u * v * 2))));",
     [](double u, double v) { return (8 * u + 8 * u * u * v) * std::exp(2 * u * v); }},
    {"result = Dv(Du(u / (1 + v)));", [](double, double v) { return -1 / (1 + v) / (1 + v); }},
    {"result = Du(Du(log(2 + u * v)));",
     [](double u, double v) { return -v * v / (2 + u * v) / (2 + u * v); }},
    {"result = Du(Du(sqrt(1 + u)));",
     [](double u, double) { return -0.25 * std::pow(1 + u, -1.5); }},
    {"result = Du(Du(Du(pow(1 + u, 3.5))));",
     [](double u, double) { return 3.5 * 2.5 * 1.5 * std::sqrt(1 + u); }},
    {"result = Du(Du(pow(2, u)));",
     [](double u, double) { return std::log(2.) * std::log(2.) * std::pow(2, u); }},
    {"result = Du(Du(tan(u)));",
     [](double u, double) { return 2 * std::tan(u) / std::cos(u) / std::cos(u); }},
    {"result = Du(Du(asin(u))) - Du(Du(acos(u)));",
     [](double u, double) { return 2 * u * std::pow(1 - u * u, -1.5); }},
    {"result = Du(Du(atan(u)));",
     [](double u, double) { return -2 * u / (1 + u * u) / (1 + u * u); }},
    {"result = Dv(Du(atan(u, v)));",
     [](double u, double v) {
         const double r = u * u + v * v;
         return (u * u - v * v) / r / r;
     }},
    {"float x; if (u > 0) x = u * u * v; else x = 0; result = Dv(Du(x));",
     [](double u, double) { return 2 * u; }},
    {"float i, x = 1; for (i = 0; i < 3; i += 1) x *= u; result = Du(Du(x));",
     [](double u, double) { return 6 * u; }},
    {"float a[3], i; for (i = 0; i < 3; i += 1) a[i] = i * u * u * v;"
     " result = Dv(Du(a[floor(2 + 0 * s)]));",
     [](double u, double) { return 4 * u; }},
};

TEST(LowerHighOrder, AgreesWithClosedForms) {
    for (const ClosedForm &form : closedForms)
        for (auto [u, v] : {std::pair{0.5, 0.25}, std::pair{0.125, 0.75}}) {
            const double expected = form.value(u, v);
            EXPECT_NEAR(at(form.body, u, v), expected, 2e-5 * std::max(1.0, std::abs(expected)))
                << form.body;
        }
}

/// Noise has second derivatives, from differences of its slopes.
TEST(LowerHighOrder, OfNoise) {
    const double h = 1.0 / 4096, u = 0.3, v = 0.4;
    const auto slope = [&](double at_u) { return at("result = Dv(noise(3 * s, t));", at_u, v); };
    EXPECT_NEAR(at("result = Du(Dv(noise(3 * s, t)));", u, v),
                (slope(u + h) - slope(u - h)) / (2 * h), 0.05);
}

std::string repeated(const std::string &step, int times) {
    std::string body = "float x = exp(u);";
    for (int k = 0; k < times; ++k)
        body += step;
    return body + "result = x;";
}

/// Each line differentiates all lines before it.
TEST(LowerHighOrder, SixteenInARow) {
    EXPECT_NEAR(at(repeated("x = 2 * x + Du(x);", 16), 0.25, 0) / std::pow(3, 16), std::exp(0.25),
                1e-4);
    // x = 1 + x Du(x): series of rationals, followed in double.
    std::array<double, 18> x{};
    double factorial = 1;
    for (int k = 0; k < 18; factorial *= ++k)
        x[size_t(k)] = 1 / factorial;
    for (int line = 0; line < 6; ++line) {
        std::array<double, 18> next{};
        for (size_t k = 0; k < 17; ++k)
            for (size_t i = 0; i <= k; ++i)
                next[k] += x[i] * double(k - i + 1) * x[k - i + 1];
        next[0] += 1;
        x = next;
    }
    EXPECT_NEAR(at(repeated("x = 1 + x * Du(x);", 6), 0, 0) / x[0], 1, 1e-4);
}

/// Cost grows with the cube of the lines.
TEST(LowerHighOrder, SixteenInARowAreFewInstructions) {
    const auto values = [](int lines) {
        ShaderRun run(surfaceWith("float", repeated("x = sin(x) + Du(x);", lines)), 1);
        EXPECT_TRUE(run.lowered) << run.diagnostics.text();
        return run.lowered ? run.lowered->whole.values.size() : 0;
    };
    EXPECT_LT(values(8), 1000u);
    EXPECT_LT(values(16), 4000u);
}

/// In both directions there are too many orders.
TEST(LowerHighOrder, TooManyValuesAreAnError) {
    std::string body = "float x = u * v;";
    for (int k = 0; k < 8; ++k)
        body += "x = sin(x) + Du(x);\nx = sin(x) + Dv(x);\n";
    ShaderRun run(surfaceWith("float", body + "result = x;"), 1);
    EXPECT_FALSE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("with its derivatives the shader is too large"),
              std::string::npos)
        << run.diagnostics.text();
}

} // namespace
} // namespace candela::ir
