// SPDX-License-Identifier: Apache-2.0
// Clipping planes: what is left of things, of their shadows and of lamps.
#include "tests/presence/views.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

constexpr double pi = std::numbers::pi;

/// Of a disk of radius 1, what lies at x < at.
double leftOfDisk(double at) { return pi - (std::acos(at) - at * std::sqrt(1 - at * at)); }

struct Plane {
    const char *name, *text;
    double left; ///< Of a ball of radius 1, as seen along z.
};
const Plane planes[] = {
    {"to the right", "ClippingPlane .25 0 0 1 0 0\n", leftOfDisk(.25)},
    {"to the left", "ClippingPlane .25 7 3 -2 0 0\n", pi - leftOfDisk(.25)},
    {"where the transformation has brought it",
     "TransformBegin\nTranslate 0 .5 0\nRotate 90 0 0 1\nScale 2 2 2\nClippingPlane 0 0 0 1 0 0\n"
     "TransformEnd\n",
     leftOfDisk(.5)},
    {"in front", "ClippingPlane 0 0 0 0 0 -1\n", pi},
    {"of all", "ClippingPlane 0 0 2 0 0 -1\n", 0},
    {"two", "ClippingPlane .25 0 0 1 0 0\nClippingPlane -.25 0 0 -1 0 0\n",
     2 * leftOfDisk(.25) - pi},
};

TEST(ClippingPlane, CutsWhatLiesWhereItsNormalLeads) {
    const char *bodies[] = {
        "Sphere 1 -1 1 360\n", "Scale -1 1 1\nScale 1 1 1.0001\nSphere 1 -1 1 360\n",
        "ObjectBegin 1\nSphere 1 -1 1 360\nObjectEnd\nObjectInstance 1\nTranslate 9 0 "
        "0\nObjectInstance 1\n",
        "SolidBegin \"intersection\"\nSphere 1 -1 1 360\nSphere 1.1 -1.1 1.1 360\nSolidEnd\n"};
    std::vector<Frame> frames;
    std::vector<double> wanted;
    for (const char *integrator : {"classic", "path"})
        for (const Plane &plane : planes)
            for (const char *body : bodies) {
                frames.push_back({plane.name, view(integrator) + plane.text,
                                  "Surface \"constant\"\n" + std::string(body)});
                wanted.push_back(plane.left / 16);
            }
    const auto pictures = render(frames, {64, 1, ""});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(frames[i].name);
        EXPECT_NEAR(meanOf(pictures[i].alpha), wanted[i], .001);
    }
}

TEST(ClippingPlane, CutsLampsAndWhatCastsShadows) {
    const std::string floor = "Illuminate 1 1\nSurface \"matte\"\nPolygon \"P\" [-2 -2 1 2 -2 1 2 "
                              "2 1 -2 2 1]\n";
    const std::string lamp = "AttributeBegin\nAreaLightSource \"arealight\" 1 \"float onesided\" "
                             "[0]\nSurface \"matte\" \"Kd\" 0\nTranslate 0 0 -1\n";
    const std::string whole = lamp + "Disk 0 1 360\nAttributeEnd\n" + floor;
    const std::string half = lamp + "Rotate 90 0 0 1\nDisk 0 1 180\nAttributeEnd\n" + floor;
    const std::string pinhole = "LightSource \"pointlight\" 1 \"from\" [0 0 -3] \"intensity\" 30\n";
    const std::string shade =
        "AttributeBegin\nSurface \"matte\"\nPolygon \"P\" [-1 -1 0 0 -1 0 0 1 0 "
        "-1 1 0]\nAttributeEnd\n";
    const std::string wide =
        "AttributeBegin\nSurface \"matte\"\nPolygon \"P\" [-1 -1 0 0 -1 0 0 1 0 "
        "-1 1 0]\nPolygon \"P\" [.9 -1 -1.5 1.5 -1 -1.5 1.5 1 -1.5 .9 1 "
        "-1.5]\nAttributeEnd\n";
    const std::string cut = "ClippingPlane 0 0 0 1 0 0\n";
    for (const char *integrator : {"path", "bidir"}) {
        // The floor's right half is cut, too; so is the light's way to it.
        const auto pictures =
            render({{"half", view(integrator) + cut, half}, {"cut", view(integrator) + cut, whole}},
                   {256, 1, ""});
        ASSERT_EQ(pictures.size(), 2u);
        EXPECT_GT(meanOf(pictures[0].red), .01);
        EXPECT_NEAR(meanOf(pictures[1].red) / meanOf(pictures[0].red), 1, .01) << integrator;
    }
    for (const char *integrator : {"classic", "path"}) {
        const auto pictures = render(
            {{"one", view(integrator) + "ClippingPlane .5 0 0 1 0 0\n", pinhole + shade + floor},
             {"both", view(integrator) + "ClippingPlane .5 0 0 1 0 0\n", pinhole + wide + floor}},
            {16, 1, ""});
        ASSERT_EQ(pictures.size(), 2u);
        EXPECT_EQ(pictures[0].red, pictures[1].red) << integrator;
    }
}

TEST(ClippingPlane, IsToldOfWhereItIsWrong) {
    const Outcome bad = run("Sphere 1 -1 1 360\n", "path", "ClippingPlane 0 0 0 0 0 0\n");
    EXPECT_EQ(bad.status, 1);
    EXPECT_TRUE(bad.says("ClippingPlane: expected a normal")) << bad.text();
    EXPECT_TRUE(
        run("Surface \"constant\"\nSphere 1 -1 1 360\n", "radiosity", "ClippingPlane 0 0 0 1 0 0\n")
            .says("rendered as under \"path\""));
}

} // namespace
} // namespace candela::test
