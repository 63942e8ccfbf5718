// SPDX-License-Identifier: Apache-2.0
// Attributes that an object sets for its own shapes: an instance looks like the same shapes written
// out, wherever it stands, however often, inside of other objects, and by every integrator.
#include "tests/support/frames.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

const std::string square = "Polygon \"P\" [-.4 -.4 0 -.4 .4 0 .4 .4 0 .4 -.4 0]\n";
const std::string left = "Translate -.5 0 0\n" + square;
const std::string right = "Translate .5 0 0\n" + square;

struct Case {
    const char *name;
    const char *own;      ///< What the object sets before its right square.
    const char *instance; ///< Attributes and transformations around the instance.
};

const Case cases[] = {
    {"color", "Color .2 .4 .8", ""},
    {"opacity", "Opacity .5 .5 .5", ""},
    {"surface", "Surface \"matte\" \"float Kd\" [0]", ""},
    {"both", "Color .2 .4 .8 Opacity .25 .5 1", "Opacity .5 .5 .5"},
    {"one side", "Sides 1", "Scale 1 1 -1"},
    {"one side of a mirror", "Sides 1 Color .2 .4 .8", "Scale -1 1 1"},
    {"scaled", "Color .2 .4 .8", "Scale .5 .5 .5"},
    {"turned", "Color .2 .4 .8", "Rotate 30 0 0 1 ReverseOrientation"},
    {"shadowless", "Attribute \"render\" \"string casts_shadows\" [\"none\"]", ""},
    {"volume", "Interior \"fog\" \"float distance\" [1]", ""},
    {"shining", "Color .2 .4 .8", "AreaLightSource \"arealight\" \"lamp\" \"float intensity\" [1]"},
};

std::vector<Frame> framesOf(const Case &each, const std::string &options) {
    const std::string before =
        "Surface \"constant\"\nColor .9 .5 .1\n" + std::string(each.instance) + "\n";
    const std::string written = "AttributeBegin\n" + left + "AttributeEnd\nAttributeBegin\n" +
                                each.own + "\n" + right + "AttributeEnd\n";
    const std::string plain = "ObjectBegin \"o\"\nAttributeBegin\n" + left +
                              "AttributeEnd\nAttributeBegin\n" + each.own + "\n" + right +
                              "AttributeEnd\nObjectEnd\n";
    const std::string nested = plain + "ObjectBegin \"outer\" ObjectInstance \"o\" ObjectEnd\n";
    const std::string elsewhere = "TransformBegin Translate 1000 0 0 ObjectInstance \"o\" "
                                  "TransformEnd\n";
    const auto frame = [&](const std::string &world) {
        return Frame{each.name, options, "Translate 0 0 2\n" + world};
    };
    return {frame(before + written), frame(plain + before + "ObjectInstance \"o\""),
            frame(plain + before + elsewhere + "ObjectInstance \"o\""),
            frame(nested + before + "ObjectInstance \"outer\""),
            frame(nested + before + elsewhere + "ObjectInstance \"outer\"")};
}

TEST(OwnAttributes, showAsIfTheShapesWereWrittenOut) {
    for (const char *integrator : {"classic", "path"}) {
        const std::string options = "Projection \"orthographic\"\nFormat 16 16 1\n"
                                    "Option \"render\" \"string integrator\" [\"" +
                                    std::string(integrator) + "\"]\n";
        std::vector<Frame> frames;
        for (const Case &each : cases)
            for (Frame &frame : framesOf(each, options))
                frames.push_back(std::move(frame));
        const auto pictures = render(frames, {1, 1, "", true});
        ASSERT_EQ(pictures.size(), frames.size());
        for (std::size_t i = 0; i < frames.size(); i += 5)
            for (std::size_t k = 1; k < 5; ++k) {
                const std::string what =
                    frames[i].name + ", " + integrator + ", form " + std::to_string(k);
                for (std::size_t p = 0; p < pictures[i].red.size(); ++p) {
                    ASSERT_NEAR(pictures[i].red[p], pictures[i + k].red[p], 1e-5f) << what << p;
                    ASSERT_NEAR(pictures[i].green[p], pictures[i + k].green[p], 1e-5f) << what << p;
                    ASSERT_NEAR(pictures[i].alpha[p], pictures[i + k].alpha[p], 1e-5f) << what << p;
                }
            }
    }
}

} // namespace
} // namespace candela::test
