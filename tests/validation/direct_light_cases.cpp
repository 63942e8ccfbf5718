// SPDX-License-Identifier: Apache-2.0
#include "tests/validation/cases.h"

#include <cmath>
#include <numbers>

namespace candela::test {

namespace {

constexpr double pi = std::numbers::pi;

/// A white plane at z = 0: E = pi L.
const std::string receiver = "Surface \"matte\" \"float Ka\" [0]\n"
                             "Polygon \"P\" [-50 -50 0 50 -50 0 50 50 0 -50 50 0]\n";

std::string atDistance(double d) {
    std::string text = number(d);
    for (char &c : text)
        c = c == '.' ? 'p' : c;
    return "d" + text;
}

/// E at (d, 0, 0), over a square of 2 * halfWidth.
Probe irradianceAt(double d, double expected, double halfWidth = 1e-2) {
    return {atDistance(d), lookDownAt(d, 0, halfWidth), expected, pi};
}

/// The same so near the point that the mean over the view is the point's to five digits.
Probe exactlyAt(double d, double expected) { return irradianceAt(d, expected, 1e-3); }

enum class Emitter { AreaLight, Surface };

/// The shape as a lamp of that radiance: by RI's area light, or as a surface that shines. An area
/// light is switched on for what comes after it: its own block has ended.
std::string lamp(Emitter emitter, double radiance, const std::string &shape) {
    std::string shaders = emitter == Emitter::AreaLight
                              ? "AreaLightSource \"arealight\" 1 \"float radiance\" [" +
                                    number(radiance) +
                                    "]\nSurface \"matte\" \"float Ka\" [0] \"float Kd\" [0]\n"
                              : "Color [" + number(radiance) + " " + number(radiance) + " " +
                                    number(radiance) + "]\nSurface \"constant\"\n";
    std::string on = emitter == Emitter::AreaLight ? "Illuminate 1 1\n" : "";
    return "AttributeBegin\n" + shaders + shape + "AttributeEnd\n" + on;
}

std::string nameOf(Emitter emitter) {
    return emitter == Emitter::AreaLight ? "AreaLight" : "Surface";
}

/// A disc at height h above the origin that faces down.
std::string disc(double h, double radius) {
    return "Translate 0 0 " + number(h) + "\nRotate 180 1 0 0\nDisk 0 " + number(radius) + " 360\n";
}

/// E under a disc of radius R and radiance 1 at height h, at distance d from its axis.
double underDisc(double R, double h, double d) {
    double sum = d * d + h * h + R * R;
    return pi / 2 * (1 - (d * d + h * h - R * R) / std::sqrt(sum * sum - 4 * R * R * d * d));
}

Case pointCase() {
    return {"C1_Point",
            siUnits,
            "LightSource \"pointlight\" 1 \"point from\" [0 0 2]\n" + receiver,
            {exactlyAt(0, 0.25), exactlyAt(2, 0.0883883476)},
            Accuracy::Exact};
}

Case distantCase() {
    return {"C2_Distant",
            siUnits,
            "LightSource \"distantlight\" 1 \"float intensity\" [3] \"point from\" [1 0 1] "
            "\"point to\" [0 0 0]\n" +
                receiver,
            {exactlyAt(0, 3 / std::sqrt(2.0))},
            Accuracy::Exact};
}

Case discOnAxis(Emitter emitter, double h) {
    return {"C3_DiscOnAxis" + nameOf(emitter) + "_h" + atDistance(h),
            siUnits,
            lamp(emitter, 1, disc(h, 1)) + receiver,
            {irradianceAt(0, underDisc(1, h, 0))},
            Accuracy::Direct,
            64};
}

Case discOffAxis(Emitter emitter) {
    Case test{"C3_DiscOffAxis" + nameOf(emitter),
              siUnits,
              lamp(emitter, 1, disc(1, 1)) + receiver,
              {},
              Accuracy::Direct,
              128};
    for (double d : {0.5, 0.707107, 1.0, 2.0})
        test.probes.push_back(irradianceAt(d, underDisc(1, 1, d)));
    return test;
}

/// The unit square about (0, 0, h), facing down.
std::string square(double h) {
    std::string z = " " + number(h) + " ";
    return "Polygon \"P\" [-.5 -.5" + z + "-.5 .5" + z + ".5 .5" + z + ".5 -.5" + z + "]\n";
}

Case squareCase(Emitter emitter, double h, std::vector<Probe> probes) {
    return {"C4_Square" + nameOf(emitter) + "_h" + atDistance(h),
            siUnits,
            lamp(emitter, 1, square(h)) + receiver,
            std::move(probes),
            Accuracy::Direct,
            1024};
}

std::vector<Case> squareCases(Emitter emitter) {
    Probe corner{"corner", lookDownAt(0.5, 0.5, 1e-3), 0.4352098947, pi};
    return {squareCase(emitter, 1,
                       {exactlyAt(0, 0.7522746759), corner, exactlyAt(1, 0.2650048523),
                        exactlyAt(2, 0.0437426483)}),
            squareCase(emitter, 2, {exactlyAt(0, 0.2308368)}),
            squareCase(emitter, 0.1, {exactlyAt(0, 3.0421284)})};
}

Case sphereCase(Emitter emitter) {
    Case test{"C5_Sphere" + nameOf(emitter),
              siUnits,
              lamp(emitter, 1, "Translate 0 0 2\nSphere .5 -.5 .5 360\n") + receiver,
              {},
              Accuracy::Direct,
              256};
    for (double d : {0.0, 1.0, 3.0}) {
        double square = d * d + 4;
        test.probes.push_back(exactlyAt(d, pi * 0.25 * (2 / std::sqrt(square)) / square));
    }
    return test;
}

/// The same sphere where its far wall is seen: alone, from behind one-sided walls that face
/// inwards, or through the near one, which lets half of the light through. Nearly a sphere, it is
/// diced.
std::vector<Case> sphereWallCases(Emitter emitter) {
    struct Walls {
        const char *name, *attributes;
        double radiance; ///< Seen from outside, for walls of radiance 1.
    };
    const double half = emitter == Emitter::AreaLight ? 1.5 : .75; // `constant` is dimmed by Os.
    const Walls all[] = {{"TurnedInwards", "Sides 1\nReverseOrientation\n", 1},
                         {"Mirrored", "Sides 1\nScale -1 1 1\nReverseOrientation\n", 1},
                         {"OneSided", "Sides 1\n", 1},
                         {"HalfClear", "Opacity .5 .5 .5\n", half}};
    std::vector<Case> cases;
    for (const Walls &walls : all)
        for (const char *form : {"", "Scale 1 1.00001 1\n"}) {
            const std::string shape = std::string("Translate 0 0 2\n") + walls.attributes + form +
                                      "Sphere .5 -.5 .5 360\n";
            std::string text = lamp(emitter, 1, shape);
            if (const auto at = text.find("\"arealight\" 1"); at != std::string::npos)
                text.insert(at + 13, " \"float onesided\" [0]");
            Case test{std::string("C5_Sphere") + walls.name + (*form ? "Diced" : "") +
                          nameOf(emitter),
                      siUnits,
                      text + receiver,
                      {},
                      Accuracy::Direct,
                      256};
            for (double d : {0.0, 1.0}) {
                const double square = d * d + 4;
                test.probes.push_back(
                    exactlyAt(d, walls.radiance * pi * 0.25 * (2 / std::sqrt(square)) / square));
            }
            cases.push_back(std::move(test));
        }
    return cases;
}

/// C6: 100 lm at 1 m from four kinds of source, E in lx by K = 179 lm/W. A Lambertian emitter
/// gives 100 / pi lx on its axis, a source that is the same all around 100 / (4 pi).
std::vector<Case> photometricTrio() {
    constexpr double efficacy = 179, watts = 100 / efficacy, radius = 1e-3;
    const Probe lambertian{"axis", lookDownAt(0, 0, 1e-3), 100 / pi, pi * efficacy};
    const Probe isotropic{"axis", lookDownAt(0, 0, 1e-3), 100 / (4 * pi), pi * efficacy};
    const double radiance = watts / (pi * pi * radius * radius);
    const auto intensity = [](double value) {
        return "\"float intensity\" [" + number(value) + "] ";
    };
    return {{"C6_SmallAreaLight",
             siUnits,
             lamp(Emitter::AreaLight, radiance, disc(1, radius)) + receiver,
             {lambertian},
             Accuracy::Direct},
            {"C6_SmallSurface",
             siUnits,
             lamp(Emitter::Surface, radiance, disc(1, radius)) + receiver,
             {lambertian},
             Accuracy::Direct},
            {"C6_CosineSpot",
             siUnits,
             "LightSource \"spotlight\" 1 " + intensity(watts / pi) +
                 "\"point from\" [0 0 1] \"point to\" [0 0 0] \"float coneangle\" [1.5707] "
                 "\"float conedeltaangle\" [0.001] \"float beamdistribution\" [1]\n" +
                 receiver,
             {lambertian},
             Accuracy::Exact},
            {"C6_IsotropicPoint",
             siUnits,
             "LightSource \"pointlight\" 1 " + intensity(watts / (4 * pi)) +
                 "\"point from\" [0 0 1]\n" + receiver,
             {isotropic},
             Accuracy::Exact}};
}

/// C7: mean irradiance of one of two facing unit discs, two apart, by the other's radiance 1. The
/// view is the square around the disc, of which the disc is pi / 4: its rim has to be a circle
/// beyond what so few pixels would show.
Case facingDiscs(Emitter emitter) {
    return {"C7_FacingDiscs" + nameOf(emitter),
            siUnits,
            "ShadingRate 1e-5\n" + lamp(emitter, 1, disc(2, 1)) +
                "Surface \"matte\" \"float Ka\" [0]\nDisk 0 1 360\n",
            {{"disc", lookDownAt(0, 0, 1), pi * (3 - 2 * std::numbers::sqrt2), 4}},
            Accuracy::Direct,
            256};
}

/// C8: an opaque half-plane whose edge crosses the axis hides half of the disc.
Case halfOcclusion(Emitter emitter) {
    const std::string halfPlane =
        "AttributeBegin\nSurface \"matte\" \"float Ka\" [0] \"float Kd\" [0]\n"
        "Polygon \"P\" [0 -40 .5 40 -40 .5 40 40 .5 0 40 .5]\n"
        "AttributeEnd\n";
    // Off the axis by x, what one side sees more the other sees less.
    return {"C8_HalfOccluded" + nameOf(emitter),
            siUnits,
            halfPlane + lamp(emitter, 1, disc(1, 1)) + receiver,
            {irradianceAt(0, underDisc(1, 1, 0) / 2)},
            Accuracy::Direct,
            512};
}

/// C9: inside its cone I / r^2 cos, outside exactly nothing.
Case spotCone() {
    constexpr double inside = 1.0, outside = 1.2; // the rim is at 2 tan(.5) = 1.0926
    double square = 4 + inside * inside;
    return {"C9_Spot",
            siUnits,
            "LightSource \"hardspot\" 1\n" + receiver,
            {exactlyAt(0, 0.25), exactlyAt(inside, 2 / std::sqrt(square) / square),
             exactlyAt(outside, 0)},
            Accuracy::Exact};
}

/// G5: a small lamp of flux 4 pi is the point light of intensity 1, at (0, 0, 2); a sphere at any
/// size that leaves the plane alone.
Case smallSphere(double radius) {
    const std::string r = number(radius);
    Case test{"G5_Sphere_r" + atDistance(radius).substr(1),
              siUnits,
              lamp(Emitter::AreaLight, 1 / (pi * radius * radius),
                   "Translate 0 0 2\nSphere " + r + " -" + r + " " + r + " 360\n") +
                  receiver,
              {},
              Accuracy::Direct,
              64};
    for (double d : {0.0, 2.0})
        test.probes.push_back(exactlyAt(d, 2 / std::pow(4 + d * d, 1.5)));
    return test;
}

/// G5: a small disc is a point light whose intensity goes with the cosine.
Case smallDisc(double radius) {
    Case test{"G5_Disc_r" + atDistance(radius).substr(1),
              siUnits,
              lamp(Emitter::Surface, 1 / (pi * radius * radius), disc(2, radius)) + receiver,
              {},
              Accuracy::Direct,
              64};
    for (double d : {0.0, 2.0})
        test.probes.push_back(exactlyAt(d, 4 / ((4 + d * d) * (4 + d * d))));
    return test;
}

} // namespace

std::vector<Case> directLightCases() {
    std::vector<Case> cases{pointCase(), distantCase(), spotCone()};
    const auto add = [&](std::vector<Case> more) {
        cases.insert(cases.end(), more.begin(), more.end());
    };
    for (Emitter emitter : {Emitter::AreaLight, Emitter::Surface}) {
        for (double h : {0.5, 1.0, 2.0, 10.0})
            add({discOnAxis(emitter, h)});
        add({discOffAxis(emitter)});
        add(squareCases(emitter));
        add({sphereCase(emitter), facingDiscs(emitter), halfOcclusion(emitter)});
        add(sphereWallCases(emitter));
    }
    add(photometricTrio());
    add({smallSphere(0.1), smallSphere(1e-3), smallDisc(1e-3)});
    return cases;
}

} // namespace candela::test
