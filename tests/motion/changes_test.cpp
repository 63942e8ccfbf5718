// SPDX-License-Identifier: Apache-2.0
// What changes its shape, its colour or the parameters of its shader while the shutter is open, is
// the mean of what it is at times.
#include "tests/motion/stills.h"

#include <cmath>
#include <gtest/gtest.h>
#include <ostream>

namespace candela::test {

namespace {

#define SUN "LightSource \"distantlight\" 1 \"intensity\" 2 \"from\" [1 1 -2] \"to\" [0 0 0]\n"

struct Change {
    const char *name;
    std::string world; ///< "@" stands for what changes.
    std::function<std::string(double share)> at;
};

void PrintTo(const Change &change, std::ostream *stream) { *stream << change.name; }

/// A quadrilateral whose corner wanders, with colours and texture coordinates that do.
std::string quadrilateral(double s) {
    return "Polygon \"P\" " +
           array({-.5, -.5, 0, -.5, .5, .3 * s, .2 + .6 * s, .5, 0, .5, -.5, 0}) + " \"Cs\" " +
           array({1, 1, 1, s, s, s, 0, 0, 0, 1 - s, 1, 1}) + "\n";
}

/// Two faces, one with a hole, that share points.
std::string mesh(double s) {
    return "PointsGeneralPolygons [2 1] [4 4 3] [0 1 2 3 4 5 6 7 2 1 8] \"P\" " +
           array({-.6, -.6, 0, -.6, .6,          0, .6 - .3 * s, .6, 0, .6, -.6, 0,     -.3, -.3, 0,
                  .2,  -.3, 0, .2,  .2 + .2 * s, 0, -.3,         .2, 0, 0,  .9,  .2 * s}) +
           "\n";
}

std::string patch(double s) {
    std::string P = "[";
    for (int row = 0; row < 4; ++row)
        for (int column = 0; column < 4; ++column)
            P += array({column / 3. - .5, row / 3. - .5 + .2 * s * column / 3,
                        s * ((row * column) % 3) / 3.})
                     .substr(1) +
                 " ";
    std::erase(P, ']');
    return "Patch \"bicubic\" \"P\" " + P + "]\n";
}

/// Hairs that bend, get wider and change their colour.
std::string hairs(double s) {
    const std::string P =
        array({-.6,          -.8, 0,      -.6,          -.5, 0,      -.6,          -.2, 0,
               -.5 + .2 * s, .1,  0,      -.4 + .4 * s, .4,  .1 * s, -.4 + .6 * s, .6,  .1 * s,
               -.4 + .8 * s, .8,  .2 * s, .2,           -.8, .5 * s, .2,           -.2, 0,
               .2 + .5 * s,  .2,  0,      .3 + .5 * s,  .8,  0});
    return "Curves \"cubic\" [7 4] \"nonperiodic\" \"P\" " + P + " \"width\" " +
           array({.2 + .2 * s, .1, .2, .2, .3 - .2 * s}) + " \"Cs\" " +
           array({1, 1, 1, s, s, s, .5, 0, 0, 1, 0, 0, 1 - s, 1, 1}) + "\n";
}

/// Lines with corners, whose mitres change.
std::string lines(double s) {
    return "Curves \"linear\" [3 3] \"periodic\" \"P\" " +
           array({-.8, -.7, 0, -.1 - .3 * s, -.7, 0, -.4, .2 + .4 * s, 0, .2, .5, 0, .8, .5 - s, 0,
                  .3 + .3 * s, -.4, .3 * s}) +
           " \"constantwidth\" " + array({.15}) + "\n";
}

/// A ribbon that is twisted, and bent.
std::string ribbon(double s) {
    return "Curves \"linear\" [3] \"nonperiodic\" \"P\" " +
           array({-.6, -.5, 0, .1, 0 + .4 * s, 0, .6, .5 - .3 * s, 0}) + " \"vertex normal N\" " +
           array({s, 0, -1, s, .5 * s, -1, 0, .8 * s, -1}) + " \"constantwidth\" " + array({.3}) +
           "\n";
}

/// Grains that part, grow and change their colour.
std::string grains(double s) {
    return "Points \"P\" " + array({-.5, -.5 + .6 * s, 0, .4 - .3 * s, .4, .2 * s, .5, -.5, 0}) +
           " \"width\" " + array({.4, .2 + .3 * s, .5 - .4 * s}) + " \"Cs\" " +
           array({1, 0, 0, s, s, s, 1 - .5 * s, 1, 1}) + "\n";
}

/// Two blobs that go their ways, and a limb that stretches.
std::string blobs(double s) {
    const std::string round = array(
        {.6,     0,  0, 0, 0, .6,          0,   0,  0,  0, .6, 0,  -.4, .3 * s - .3, 0,
         1,      .5, 0, 0, 0, 0,           .5,  0,  0,  0, 0,  .5, 0,   -.1,         -.3 - .1 * s,
         .1 * s, 1,  0, 0, 0, .4 + .3 * s, .4,  0,  .3, 1, 0,  0,  0,   0,           1,
         0,      0,  0, 0, 1, 0,           -.2, .1, 0,  1});
    return "Blobby 3 [1001 0 1001 16 1002 32 0 3 0 1 2] " + round + " [\"\"] \"vertex color Cs\" " +
           array({1, 0, 0, s, s, s, 1 - .5 * s, 1, 1}) + "\n";
}

std::vector<Change> changes() {
    const std::string lit = SUN "Surface \"matte\"\nTranslate 0 0 3\n";
    const auto inObjects = [](const std::string &around) {
        return "ObjectBegin 1\n@\nObjectEnd\n" + around +
               "AttributeBegin\nTranslate -.4 0 0\nScale .5 .5 .5\nObjectInstance 1\nAttributeEnd\n"
               "AttributeBegin\nTranslate .4 .2 0\nScale -.5 .5 .5\nRotate 30 0 0 1\n"
               "ObjectInstance 1\nAttributeEnd\n";
    };
    const auto sphere = [](double s) {
        return request("Sphere", {.3 + .4 * s, -.3 - .4 * s, .3 + .4 * s, 360});
    };
    const auto color = [](double s) { return request("Color", {.2 + .7 * s, .5, 1 - s}); };
    const std::string disk = "Translate 0 0 3\nDisk 0 .8 360\n";
    return {
        {"Polygon", lit + "@\n", quadrilateral},
        {"PolygonOneSided", lit + "Sides 1\n@\n", quadrilateral},
        {"PolygonInAMirror", lit + "Scale 1 -1 1\n@\n", quadrilateral},
        {"PolygonsWithAHole", lit + "@\n", mesh},
        {"PolygonsInObjects", inObjects(lit), mesh},
        {"Patch", lit + "@\n", patch},
        {"PatchInObjects", inObjects(lit), patch},
        {"SphereThatGrows", lit + "@\n", sphere},
        {"SpheresInObjects", inObjects(lit), sphere},
        {"Torus", lit + "@\n",
         [](double s) {
             return request("Torus", {.5, .1 + .1 * s, 0, 360, 200 + 100 * s});
         }},
        {"ShapeThatMovesToo",
         lit + "MotionBegin [0 1]\nTranslate 0 0 0\nTranslate 0 0 0\nMotionEnd\n@\n", sphere},
        {"ShadowOfAShape",
         "Attribute \"light\" \"string shadows\" \"on\"\nLightSource \"pointlight\" 1 "
         "\"intensity\" 9 \"from\" [.5 0 -1]\nSurface \"matte\"\n"
         "Polygon \"P\" [-2 -2 4 -2 2 4 2 2 4 2 -2 4]\nTranslate 0 0 2.5\nScale .4 .4 .4\n@\n",
         mesh},
        {"Hairs", lit + "@\n", hairs},
        {"HairsInAMirror", lit + "Scale -1 1 1\n@\n", hairs},
        {"HairsOneSided", lit + "Sides 1\n@\n", hairs},
        {"HairsAsTriangles", lit + "Scale 1 .7 2\n@\n", hairs},
        {"HairsInObjects", inObjects(lit), hairs},
        {"HairsInWideObjects", inObjects(lit + "Scale 1 1 .5\n"), hairs},
        {"HairsThatMoveToo",
         lit + "MotionBegin [0 1]\nRotate 0 0 0 1\nRotate 0 0 0 1\nMotionEnd\n@\n", hairs},
        {"HairsFarAway", "Translate -1000 300 50\n" + lit + "Translate 1000 -300 -50\n@\n", hairs},
        {"HairsSeeThrough", lit + "Opacity [.3 .3 .3]\n@\n", hairs},
        {"TinyHairs", lit + "Scale 1e3 1e3 1e3\nScale 1e-3 1e-3 1e-3\n@\n", hairs},
        {"Lines", lit + "@\n", lines},
        {"LinesAsTriangles", lit + "Scale 1 1 2\n@\n", lines},
        {"Ribbon", lit + "@\n", ribbon},
        {"RibbonInObjects", inObjects(lit), ribbon},
        {"Points", lit + "@\n", grains},
        {"PointsInAMirror", lit + "Scale 1 -1 1\n@\n", grains},
        {"PointsAsTriangles", lit + "Scale 1 .7 2\n@\n", grains},
        {"PointsInObjects", inObjects(lit), grains},
        {"PointsSeeThrough", lit + "Opacity [.7 .7 .7]\n@\n", grains},
        {"ShadowOfHairs",
         "Attribute \"light\" \"string shadows\" \"on\"\nLightSource \"pointlight\" 1 "
         "\"intensity\" 9 \"from\" [.5 0 -1]\nSurface \"matte\"\n"
         "Polygon \"P\" [-2 -2 4 -2 2 4 2 2 4 2 -2 4]\nTranslate 0 0 2.5\nScale .4 .4 .4\n@\n",
         hairs},
        {"Blobs", lit + "@\n", blobs},
        {"BlobsInObjects", inObjects(lit), blobs},
        {"Color", "Surface \"constant\"\n@\n" + disk, color},
        {"ColorInObjects",
         "ObjectBegin 1\nDisk 0 .8 360\nObjectEnd\nSurface \"constant\"\n"
         "Translate 0 0 3\n@\nObjectInstance 1\nTranslate 0 .5 1\n"
         "ObjectInstance 1\n",
         color},
        {"Opacity",
         "Surface \"constant\"\nAttributeBegin\nTranslate 0 0 5\nColor .5 .5 .5\n"
         "Disk 0 1 360\nAttributeEnd\n@\n" +
             disk,
         [](double s) {
             return request("Opacity", {s, .5, 1});
         }},
        {"SurfaceParameters", SUN "@\n" + disk,
         [](double s) { return "Surface \"matte\" \"Kd\" " + array({.2 + .6 * s}) + "\n"; }},
        {"ShiningParameters", "@\n" + disk,
         [](double s) { return "Surface \"glow\" \"radiance\" " + array({3 * s}) + "\n"; }},
        {"LightParameters", "@\nSurface \"matte\"\nPolygon \"P\" [-2 -2 4 -2 2 4 2 2 4 2 -2 4]\n",
         [](double s) {
             return "LightSource \"pointlight\" 1 \"intensity\" " + array({4 * s}) + " \"from\" " +
                    array({2 * s - 1, 0, 3}) + "\n";
         }},
        {"AreaLightParameters",
         "AttributeBegin\n@\nSurface \"constant\"\nTranslate 0 0 3\nRotate 180 1 0 0\n"
         "Disk 0 .2 360\nAttributeEnd\nIlluminate 1 1\nSurface \"matte\"\n"
         "Polygon \"P\" [-2 -2 4 -2 2 4 2 2 4 2 -2 4]\n",
         [](double s) {
             return "AreaLightSource \"arealight\" 1 \"onesided\" 0 \"radiance\" " +
                    array({9 * s}) + "\n";
         }},
        {"AtmosphereParameters", "Surface \"constant\"\n@\n" + disk,
         [](double s) { return "Atmosphere \"haze\" \"amount\" " + array({s}) + "\n"; }},
    };
}

class Changing : public testing::TestWithParam<Change> {};

TEST_P(Changing, IsTheMeanOfStills) {
    for (const char *integrator : {"classic", "path"}) {
        SCOPED_TRACE(integrator);
        expectMeanOfStills(integrator, GetParam().world, GetParam().at);
    }
}

INSTANTIATE_TEST_SUITE_P(, Changing, testing::ValuesIn(changes()),
                         [](const auto &param) { return std::string(param.param.name); });

} // namespace

} // namespace candela::test
