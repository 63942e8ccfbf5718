// SPDX-License-Identifier: Apache-2.0
#include "tests/validation/cases.h"

#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;

const std::string plate = "Surface \"matte\" \"float Ka\" [0] \"float Kd\" [1]\n"
                          "Polygon \"P\" [-5 -5 0 5 -5 0 5 5 0 -5 5 0]\n";
const std::string sunAbove =
    "LightSource \"distantlight\" 1 \"point from\" [0 0 1] \"point to\" [0 0 0]\n";
const std::string bulbTwoAbove = "LightSource \"pointlight\" 1 \"point from\" [0 0 2]\n";

Case litPlate(const std::string &name, const std::string &options, const std::string &light,
              double expected) {
    return {name,
            options,
            light + plate,
            {{"plate", lookDownAt(0, 0, 1e-3), expected}},
            Accuracy::Exact};
}

/// I5: irradiance() gathers what the loops of matte would. Without loops, and without emission of
/// its own, the furnace's middle is the same to both.
Case irradianceFurnace() {
    return {"I5_IrradianceInAFurnace",
            siUnits,
            "Surface \"glow\" \"float Kd\" [.5] \"float emission\" [.5]\nSphere 1 -1 1 360\n"
            "Surface \"glowbyirradiance\" \"float Kd\" [.8] \"float emission\" [.2]\n"
            "Sphere .4 -.4 .4 360\n",
            {{"ball", "Projection \"perspective\" \"fov\" [40]\nTranslate 0 0 .9\n", 1}},
            Accuracy::Global,
            128};
}

/// I6: what figure 2's lobe reflects of uniform radiance 1, seen along the normal.
Case phongLobe(int exponent) {
    return {"I6_PhongLobe" + std::to_string(exponent),
            siUnits,
            "Surface \"constant\"\nSphere 4 -4 4 360\n"
            "Surface \"phong\" \"float Kd\" [0] \"float Ks\" [1] \"float exp\" [" +
                std::to_string(exponent) + "]\nPolygon \"P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0]\n",
            {{"plate", lookDownAt(0, 0, .5), 2.0 / (exponent + 1)}},
            Accuracy::Global,
            128};
}

} // namespace

std::vector<Case> unitCases() {
    return {litPlate("I1_ClassicDistant", "", sunAbove, 1),
            litPlate("I2_ClassicPoint", "", bulbTwoAbove, 0.25),
            litPlate("I1_ClassicDistantByPath",
                     "Option \"render\" \"string integrator\" [\"path\"]\n", sunAbove, 1),
            litPlate("I3_SolarInSi", siUnits, sunAbove, 1 / pi),
            litPlate("I4_PointInSi", siUnits, bulbTwoAbove, 0.25 / pi),
            irradianceFurnace(),
            phongLobe(1),
            phongLobe(2),
            phongLobe(10),
            phongLobe(50)};
}

} // namespace candela::test
