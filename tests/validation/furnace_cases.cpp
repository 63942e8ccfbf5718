// SPDX-License-Identifier: Apache-2.0
#include "tests/validation/cases.h"

#include <cmath>
#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;

std::string glow(const std::string &shader, double rho, double emission) {
    return "Surface \"" + shader + "\" \"float Kd\" [" + number(rho) + "] \"float emission\" [" +
           number(emission) + "]\n";
}

const std::string unitSphere = "Sphere 1 -1 1 360\n";

/// A closed box of half-width 1, its faces in one mesh.
const std::string box =
    "PointsPolygons [4 4 4 4 4 4] [0 1 3 2 4 6 7 5 0 4 5 1 2 3 7 6 0 2 6 4 1 5 "
    "7 3] \"P\" [-1 -1 -1 1 -1 -1 -1 1 -1 1 1 -1 -1 -1 1 1 -1 1 -1 1 1 1 1 1]\n";

/// Sees walls at right and slanting angles.
Probe wholeView(double expected) {
    return {"view", "Projection \"perspective\" \"fov\" [100]\nRotate 20 1 1 0\n", expected};
}

std::string maxDepth(int depth) {
    return "Option \"trace\" \"integer maxdepth\" [" + std::to_string(depth) + "]\n";
}

/// A1: L = Le / (1 - rho). The usual 64 reflections would leave out a thousandth of it at .9.
Case furnace(const std::string &name, double rho, double emission, const std::string &walls,
             int samples) {
    return {"A1_" + name,
            siUnits + maxDepth(1000),
            glow("glow", rho, emission) + walls,
            {wholeView(emission / (1 - rho))},
            Accuracy::Global,
            samples};
}

/// A1 with at most `depth` reflections: a finite sum, without chance.
Case truncatedFurnace(int depth) {
    Case test = furnace("Truncated" + std::to_string(depth), 0.5, 1, unitSphere, 64);
    test.options += maxDepth(depth);
    test.probes[0].expected = 2 * (1 - std::pow(0.5, depth + 1));
    return test;
}

/// A2: something lossless in the furnace cannot be seen.
Case insertion(const std::string &name, const std::string &object, int samples) {
    return {"A2_" + name,
            siUnits,
            glow("glow", 0.5, 0.5) + unitSphere + "AttributeBegin\n" + object + "AttributeEnd\n",
            {{"object", "Projection \"perspective\" \"fov\" [60]\nTranslate 0 0 .9\n", 1}},
            Accuracy::Global,
            samples};
}

/// A3: a surface that emits one minus its albedo, all around or in a furnace of radiance 1.
Case phongFurnace(const std::string &name, int exponent, bool inside, int samples) {
    std::string phong = "Surface \"glowphong\" \"float exponent\" [" + number(exponent) + "]\n";
    std::string world = inside
                            ? glow("glow", 0.5, 0.5) + unitSphere + phong + "Sphere .4 -.4 .4 360\n"
                            : phong + unitSphere;
    std::string eye = inside ? "Projection \"perspective\" \"fov\" [60]\nTranslate 0 0 .9\n"
                             : "Projection \"perspective\" \"fov\" [100]\nTranslate .3 .2 -.4\n";
    return {"A3_" + name, siUnits, world, {{"view", eye, 1}}, Accuracy::Global, samples};
}

std::string diffuseSphere(double x, double intensity, double rho) {
    return "LightSource \"pointlight\" 1 \"float intensity\" [" + number(intensity) +
           "] \"point from\" [" + number(x) +
           " 0 0]\nSurface \"matte\" \"float Ka\" [0] \"float Kd\" [" + number(rho) + "]\n" +
           unitSphere;
}

/// A5: a source of intensity pi W/sr in the centre of a sphere of rho = .5 makes L = 1.
Case centredSource() {
    return {"A5_CentredSource", siUnits,          diffuseSphere(0, pi, 0.5),
            {wholeView(1)},     Accuracy::Global, 128};
}

/// A6: wherever the source is, the indirect irradiance is the same all over.
Case offCentreSource() {
    constexpr double rho = 0.5, x = 0.5;
    constexpr double indirect = rho / (1 - rho); // of intensity 1: Phi = 4 pi
    Case test{"A6_OffCentreSource", siUnits, diffuseSphere(x, 1, rho), {}, Accuracy::Global, 256};
    double toSide = 1 + x * x;
    test.probes = {
        {"far", lookFromOrigin(90), 1 / ((1 + x) * (1 + x)) + indirect, pi / rho},
        {"near", lookFromOrigin(-90), 1 / ((1 - x) * (1 - x)) + indirect, pi / rho},
        {"side", lookFromOrigin(0), 1 / (toSide * std::sqrt(toSide)) + indirect, pi / rho}};
    return test;
}

} // namespace

std::vector<Case> furnaceCases() {
    const std::string ball = "Sphere .4 -.4 .4 360\n";
    return {furnace("SphereHalf", 0.5, 1, unitSphere, 64),
            furnace("SphereEight", 0.8, 1, unitSphere, 640),
            furnace("SphereNine", 0.9, 1, unitSphere, 1024), // only with Russian roulette
            furnace("BoxEight", 0.8, 1, box, 768),
            truncatedFurnace(1),
            truncatedFurnace(8),
            insertion("Matte", "Surface \"matte\" \"float Ka\" [0]\n" + ball, 192),
            insertion("Mirror", "Surface \"mirror\"\n" + ball, 192),
            insertion("Glass", "Surface \"glass\"\n" + ball, 192),
            phongFurnace("PhongAllAround", 2, false, 640),
            phongFurnace("PhongAllAroundNarrow", 10, false, 128),
            phongFurnace("PhongInFurnace", 10, true, 128),
            centredSource(),
            offCentreSource()};
}

} // namespace candela::test
