// SPDX-License-Identifier: Apache-2.0
// Attribute "visibility" and Matte: who sees what, and what is held out.
#include "tests/light/pictures.h"
#include "tests/support/frames.h"

#include <algorithm>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

const std::string view = "Projection \"orthographic\"\nScreenWindow -1 1 -1 1\n";

std::string with(const char *integrator) {
    return "Option \"render\" \"string integrator\" \"" + std::string(integrator) + "\"\n" + view;
}

float meanOf(const std::vector<float> &values) {
    float sum = 0;
    for (float value : values)
        sum += value;
    return sum / float(values.size());
}

/// A shining square before the eye.
std::string before(const std::string &attributes) {
    return "AttributeBegin\n" + attributes + "Surface \"constant\"\n" + squareAt(3, 2) +
           "AttributeEnd\n";
}

/// The same behind the eye, which sees it in a mirror.
std::string mirrored(const std::string &attributes) {
    return "AttributeBegin\n" + attributes + "Surface \"constant\"\n" + squareAt(-3, 9) +
           "AttributeEnd\nSurface \"mirror\"\n" + squareAt(5, 9);
}

/// Something behind the eye stands before a sun.
std::string shadowing(const std::string &attributes) {
    return "Attribute \"light\" \"string shadows\" \"on\"\nLightSource \"distantlight\" 1 "
           "\"intensity\" 3\nAttributeBegin\n" +
           attributes + "Surface \"matte\"\n" + squareAt(-3, 9) +
           "AttributeEnd\nSurface \"matte\"\n" + squareAt(5, 9);
}

/// A panel behind the eye is all that lights what is seen.
std::string bouncing(const std::string &attributes) {
    return "AttributeBegin\nLightSource \"pointlight\" 1 \"intensity\" 60\n" + attributes +
           "Surface \"matte\"\n" + squareAt(-3, 9) + "AttributeEnd\nSurface \"matte\"\n" +
           squareAt(3, 9);
}

struct Row {
    const char *attribute;
    bool seen, inMirrors, shadow, bounces;
};

TEST(Visibility, HidesFromKindsOfRays) {
    const Row rows[] = {
        {"", true, true, true, true},
        {"\"int camera\" 0", false, true, true, true},
        {"\"int diffuse\" 0", true, true, true, false},
        {"\"int indirect\" 0", true, true, true, false},
        {"\"int specular\" 0", true, false, true, true},
        {"\"int reflection\" 0", true, false, true, true},
        {"\"int trace\" 0", true, false, true, false},
        {"\"int shadow\" 0", true, true, false, true},
        {"\"int transmission\" 0", true, true, false, true},
        {"\"string transmission\" \"transparent\"", true, true, false, true},
        {"\"string transmission\" \"opaque\"", true, true, true, true},
        {"\"int camera\" 0 \"int trace\" 0", false, false, true, false},
        {"\"int photon\" 0", true, true, true, true},
    };
    const std::string objects[] = {"", "in an object"};
    for (const char *integrator : {"classic", "path"})
        for (const Row &row : rows)
            for (const std::string &object : objects) {
                SCOPED_TRACE(std::string(integrator) + " " + row.attribute + " " + object);
                const std::string attributes =
                    std::string("Attribute \"visibility\" ") +
                    (*row.attribute ? row.attribute : "\"int camera\" 1") + "\n";
                std::vector<Frame> frames;
                for (auto world : {before, mirrored, shadowing, bouncing}) {
                    std::string text = world(attributes);
                    if (!object.empty()) { // The first square is two instances of an object.
                        const std::size_t at = text.find("Polygon"), end = text.find('\n', at);
                        text = "ObjectBegin 1\n" + text.substr(at, end - at) + "\nObjectEnd\n" +
                               text.substr(0, at) + "ObjectInstance 1\nObjectInstance 1" +
                               text.substr(end);
                    }
                    frames.push_back({"", with(integrator), text});
                }
                const auto pictures = render(frames, {16, 1, "light/shaders"});
                ASSERT_EQ(pictures.size(), 4u);
                EXPECT_EQ(meanOf(pictures[0].red), row.seen ? 1 : 0);
                EXPECT_EQ(meanOf(pictures[0].alpha), row.seen ? 1 : 0);
                EXPECT_EQ(meanOf(pictures[1].red), row.inMirrors ? 1 : 0);
                EXPECT_EQ(meanOf(pictures[2].red) == 0, row.shadow);
                if (std::string(integrator) == "path") {
                    EXPECT_EQ(meanOf(pictures[3].red) > .01f, row.bounces);
                }
            }
}

/// Lamps that nobody sees shine all the same.
TEST(Visibility, HidesLampsAndNotTheirLight) {
    const auto lit = [](const std::string &attribute) {
        return Frame{"", with("path"),
                     "AttributeBegin\n" + attribute +
                         "AreaLightSource \"arealight\" 1 \"radiance\" 9 \"onesided\" 0\n"
                         "Surface \"constant\"\n" +
                         squareAt(2, .2) + "AttributeEnd\nIlluminate 1 1\nSurface \"matte\"\n" +
                         squareAt(3, 9)};
    };
    const std::string begin = "Attribute \"visibility\" ";
    const auto pictures =
        render({lit(""), lit(begin + "\"int camera\" 0\n"),
                lit(begin + "\"int camera\" 0 \"int diffuse\" 0\n"),
                lit(begin + "\"int camera\" 0 \"int trace\" 0 \"int shadow\" 0\n")},
               {256, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), 4u);
    // The corner, which the lamp does not hide.
    for (std::size_t k = 1; k < pictures.size(); ++k)
        EXPECT_NEAR(pictures[k].red[0], pictures[0].red[0], .03 * pictures[0].red[0]) << k;
    // What it hid.
    EXPECT_GT(pictures[0].red[27], 5);
    EXPECT_LT(pictures[1].red[27], 5);
    EXPECT_GT(pictures[1].red[27], pictures[1].red[0]);
}

struct Holding {
    const char *name;
    std::string world; ///< "@" stands for the attributes of what is matte.
    float red, alpha;
};

TEST(Matte, HoldsOutWhatTheEyeSees) {
    const std::string behind =
        "AttributeBegin\nSurface \"constant\"\n" + squareAt(5, 9) + "AttributeEnd\n";
    const std::string square = "Surface \"constant\"\n" + squareAt(3, 9);
    const Holding rows[] = {
        {"opaque", behind + "@\n" + square, 0, 0},
        {"alone", "@\n" + square, 0, 0},
        {"transparent", behind + "@\nOpacity [.25 .25 .25]\n" + square, .75f, .75f},
        {"behind a sheet",
         behind + "AttributeBegin\nOpacity [.5 .5 .5]\nSurface \"constant\"\n" + squareAt(2, 9) +
             "AttributeEnd\n@\n" + square,
         .5f, .5f},
        {"before what is not",
         "AttributeBegin\n@\nOpacity [.5 .5 .5]\n" + square + "AttributeEnd\n" + behind, .5f, .5f},
        {"lit",
         behind + "LightSource \"distantlight\" 1\n@\nSurface \"plastic\"\n" + squareAt(3, 9), 0,
         0},
        {"one-sided in a mirror",
         behind + "@\nSides 1\nScale -1 1 1\nReverseOrientation\nReverseOrientation\n" + square, 0,
         0},
        {"an instance",
         "ObjectBegin 1\n" + squareAt(3, 9) + "ObjectEnd\n" + behind +
             "AttributeBegin\n@\nSurface \"constant\"\nObjectInstance 1\n"
             "ObjectInstance 1\nAttributeEnd\n",
         0, 0},
        {"within an object",
         "ObjectBegin 1\n@\nSurface \"constant\"\n" + squareAt(3, 9) + "ObjectEnd\n" + behind +
             "ObjectInstance 1\nObjectInstance 1\n",
         0, 0},
        {"seen in a mirror",
         "AttributeBegin\n@\nSurface \"constant\"\n" + squareAt(-3, 9) +
             "AttributeEnd\nSurface \"mirror\"\n" + squareAt(5, 9),
         1, 1},
    };
    for (const char *integrator : {"classic", "path"}) {
        std::vector<Frame> frames;
        for (const Holding &row : rows) {
            std::string world = row.world;
            world.replace(world.find("@\n"), 2, "Matte 1\n");
            frames.push_back({row.name, with(integrator), world});
        }
        const auto pictures = render(frames, {64, 1, "light/shaders"});
        ASSERT_EQ(pictures.size(), frames.size());
        for (std::size_t k = 0; k < frames.size(); ++k) {
            SCOPED_TRACE(std::string(integrator) + ", " + frames[k].name);
            EXPECT_NEAR(meanOf(pictures[k].red), rows[k].red, 1e-3);
            EXPECT_NEAR(meanOf(pictures[k].alpha), rows[k].alpha, 1e-3);
        }
    }
}

/// Others are untouched, sample by sample.
TEST(Matte, LeavesTheRestAlone) {
    const std::string things = "LightSource \"pointlight\" 1 \"intensity\" 9 \"from\" [1 1 1]\n"
                               "Surface \"plastic\"\nTranslate 0 0 4\nSphere .8 -.8 .8 360\n";
    const auto pictures =
        render({{"", with("path"), things},
                {"", with("path"), things + "Matte 1\nTranslate 0 0 9\n" + squareAt(0, 9)}},
               {16, 1, "light/shaders"});
    ASSERT_EQ(pictures.size(), 2u);
    for (std::size_t k = 0; k < 64; ++k)
        EXPECT_NEAR(pictures[0].red[k], pictures[1].red[k], .05 * pictures[0].red[k] + .005) << k;
}

} // namespace

} // namespace candela::test
