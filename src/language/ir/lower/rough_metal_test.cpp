// SPDX-License-Identifier: Apache-2.0
// The shipped shader "roughmetal" in a uniform field, by quadrature over microfacets: it may lose
// what would scatter more than once, and may gain nothing.
#include "language/ir/lower/test_support.h"

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace candela::ir {
namespace {

constexpr double pi = std::numbers::pi;

std::string shaderText() {
    std::ifstream file(CANDELA_SOURCE_DIR "/shaders/surface/roughmetal.sl");
    std::ostringstream text;
    text << file.rdbuf();
    return text.str();
}

/// Facets distributed as GGX has them at that width, each lit from where it mirrors the eye to:
/// together the integral over all light, where Cl is radiance / pi.
std::vector<ShaderRun::Sample> mirroredLight(const Vec3 &toEye, double alpha, int rows) {
    std::vector<ShaderRun::Sample> samples;
    for (int i = 0; i < rows; ++i)
        for (int j = 0; j < rows; ++j) {
            const double share = (i + 0.5) / rows, turn = 2 * pi * (j + 0.5) / rows;
            const double tangent2 = alpha * alpha * share / (1 - share);
            const double cosine = 1 / std::sqrt(1 + tangent2), sine = std::sqrt(tangent2) * cosine;
            const double h[3] = {sine * std::cos(turn), sine * std::sin(turn), cosine};
            const double along = toEye.x * h[0] + toEye.y * h[1] + toEye.z * h[2];
            if (along <= 0)
                continue;
            const double width = alpha * alpha, spread = cosine * cosine * width + sine * sine;
            const double density = width / (pi * spread * spread) * cosine / (4 * along);
            const float Cl = float(1 / (pi * density * rows * rows));
            samples.push_back(
                {{float(2 * along * h[0] - toEye.x), float(2 * along * h[1] - toEye.y),
                  float(2 * along * h[2] - toEye.z)},
                 {Cl, Cl, Cl}});
        }
    return samples;
}

double reflected(ShaderRun &run, double alpha, double cosEye, int rows) {
    const double sine = std::sqrt(1 - cosEye * cosEye);
    const Vec3 toEye{float(sine), 0, float(cosEye)};
    run.setInput(ShaderInput::N, {0, 0, 1});
    run.setInput(ShaderInput::Ng, {0, 0, 1});
    run.setInput(ShaderInput::I, {-toEye.x, -toEye.y, -toEye.z});
    run.setInput(ShaderInput::Cs, {1, 1, 1});
    run.setInput(ShaderInput::Os, {1, 1, 1});
    run.setParameter("alpha", {float(alpha)});
    // The shader draws no lobe narrower than that.
    run.setSamples(mirroredLight(toEye, std::max(alpha, 1e-3), rows));
    return run.run().at("Ci")[0][0];
}

TEST(RoughMetal, GainsNoEnergyAtAnyWidthAndAngle) {
    ShaderRun run(shaderText(), 1);
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    for (double alpha : {1e-4, 1e-3, 3e-3, .01, .03, .1, .3, 1.0})
        for (double cosEye : {1.0, .99, .8, .5, .2, .05, .01, 1e-3, 1e-4}) {
            const double albedo = reflected(run, alpha, cosEye, 48);
            EXPECT_TRUE(std::isfinite(albedo)) << alpha << " " << cosEye;
            // Single precision: the direction of a facet, and that of a lobe an alpha wide.
            EXPECT_LT(albedo, 1 + 1e-3) << alpha << " " << cosEye;
            EXPECT_GT(albedo, 0.3) << alpha << " " << cosEye;
            if (alpha <= .01 && cosEye == 1) {
                EXPECT_NEAR(albedo, 1, .01) << alpha;
            }
        }
}

} // namespace
} // namespace candela::ir
