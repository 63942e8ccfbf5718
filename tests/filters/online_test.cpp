// SPDX-License-Identifier: Apache-2.0
// PushFilter and what displays show of it.
#include "tests/filters/filtered.h"

#include <algorithm>
#include <cmath>

namespace candela::test {

using Names = std::vector<std::string>;

TEST_F(Filtered, filtersRunInTheOrderInWhichTheyWerePushed) {
    struct Case {
        const char *requests;
        float expected; ///< Of .25.
    };
    const Case table[] = {
        {"PushFilter \"double\" PushFilter \"plusone\"", 1.5f},
        {"PushFilter \"plusone\" PushFilter \"double\"", 2.5f},
        {"PushFilter \"double\" \"factor\" [8] PushFilter \"double\" \"float factor\" [.5]", 1},
        {"PushFilter \"double\" PushFilter \"plusone\" PopFilter", .5f},
        {"PushFilter \"plusone\" PopFilter PushFilter \"double\"", .5f},
        {"PushFilter \"double.slo\"", .5f},
    };
    for (const Case &test : table) {
        render(
            smallFrame(std::string(test.requests) + "\nDisplay \"a.exr\" \"openexr\" \"rgb\"\n") +
            plainWorld());
        EXPECT_EQ(everywhere("a.exr", "R"), test.expected) << test.requests;
    }
}

TEST_F(Filtered, withoutFiltersNotAByteChanges) {
    for (const char *integrator : {"path", "classic"}) {
        const std::string display = "Display \"a.exr\" \"openexr\" \"rgbaz\"\n"
                                    "Display \"+b.exr\" \"openexr\" \"N,variance,id\"\n";
        const std::string world = ballWorld("LightSource \"pointlight\" 1 Surface \"matte\"");
        render(smallFrame(display) + world, {"--integrator", integrator, "--spp", "4"});
        const std::string a = folder_.read("a.exr"), b = folder_.read("b.exr");
        render(smallFrame("PushFilter \"double\"\nPopFilter\n" + display) + world,
               {"--integrator", integrator, "--spp", "4"});
        EXPECT_EQ(folder_.read("a.exr"), a) << integrator;
        EXPECT_EQ(folder_.read("b.exr"), b) << integrator;
    }
}

/// Filtered colours; all else is as without filters, to the bit.
TEST_F(Filtered, onlyColoursAreFilteredAndRadianceStays) {
    const std::string displays = "Display \"a.exr\" \"openexr\" \"rgbaz,radiance,N,albedo\"\n"
                                 "Display \"+raw.exr\" \"openexr\" \"radiance,variance\"\n"
                                 "Exposure 4 1\n";
    const std::vector<std::string> samples{"--spp", "4"};
    render(smallFrame(displays) + ballWorld("Surface \"glow\""), samples);
    const Picture plain = read("a.exr");
    const std::string raw = folder_.read("raw.exr");
    render(smallFrame("PushFilter \"plusone\"\n" + displays) + ballWorld("Surface \"glow\""),
           samples);
    const Picture filtered = read("a.exr");
    for (const PictureChannel &channel : plain.channels) {
        const PictureChannel *other = filtered.find(channel.name);
        ASSERT_TRUE(other) << channel.name;
        const bool color = channel.name.size() == 1 && std::string("RGB").find(channel.name) < 3;
        for (std::size_t i = 0; i < channel.values.size(); ++i)
            ASSERT_EQ(other->values[i], channel.values[i] + (color ? 4 : 0)) << channel.name;
    }
    EXPECT_EQ(filtered.metadata.at("filters"), "plusone");
    EXPECT_FALSE(plain.metadata.contains("filters"));
    EXPECT_FALSE(read("raw.exr").metadata.contains("filters")); // Nothing in it is filtered.
    const Picture rawFiltered = read("raw.exr");
    folder_.write("before.exr", raw);
    EXPECT_EQ(read("before.exr").find("radiance.R")->values,
              rawFiltered.find("radiance.R")->values);
}

TEST_F(Filtered, filesNameTheFiltersAndTheirParameters) {
    render(smallFrame("PushFilter \"double\" \"factor\" [.125] \"tint\" [1 2 .5]\n"
                      "PushFilter \"show\" \"string what\" \"Oi\"\n"
                      "Display \"a.exr\" \"openexr\" \"rgb\"\n") +
           plainWorld());
    const Picture picture = read("a.exr");
    EXPECT_EQ(picture.metadata.at("filters"), "double factor=0.125 tint=1,2,0.5; show what=Oi");
    EXPECT_EQ(picture.metadata.at("units"), "W m^-2 sr^-1");
    EXPECT_EQ(picture.metadata.at("luminousEfficacy"), "179 lm/W");
}

TEST_F(Filtered, framesHaveStacksOfTheirOwn) {
    const auto frame = [](const std::string &number, const std::string &options) {
        return "FrameBegin " + number + "\nDisplay \"" + number + ".exr\" \"openexr\" \"rgb\"\n" +
               options + "Projection \"orthographic\"\n" + plainWorld() + "FrameEnd\n";
    };
    render("Option \"radiometry\" \"string units\" \"si\"\nFormat 8 8 1\nPixelSamples 1 1\n"
           "PixelFilter \"box\" 1 1\nPushFilter \"plusone\"\n" +
           frame("1", "PushFilter \"double\"\n") + frame("2", "") + frame("3", "PopFilter\n") +
           frame("4", "Format 4 6 1\nPopFilter\nPushFilter \"double\"\n"));
    EXPECT_EQ(everywhere("1.exr", "R"), 2.5f);
    EXPECT_EQ(everywhere("2.exr", "R"), 1.25f);
    EXPECT_EQ(everywhere("3.exr", "R"), .25f);
    EXPECT_EQ(everywhere("4.exr", "R"), .5f);
    EXPECT_EQ(read("4.exr").find("R")->values.size(), 24u);
}

TEST_F(Filtered, aFilterThatIsMissingOrFaultyIsLeftOut) {
    for (const char *name : {"nowhere", "broken", "glow"}) {
        const Outcome outcome =
            run(smallFrame("PushFilter \"double\"\nPushFilter \"" + std::string(name) +
                           "\" \"x\" [1]\nPushFilter \"plusone\"\n"
                           "Display \"a.exr\" \"openexr\" \"rgb\"\n") +
                plainWorld());
        EXPECT_EQ(outcome.status, 1) << outcome.text();
        EXPECT_TRUE(outcome.says(name)) << outcome.text();
        EXPECT_EQ(everywhere("a.exr", "R"), 1.5f) << outcome.text();
        EXPECT_EQ(read("a.exr").metadata.at("filters"), "double; plusone");
    }
}

TEST_F(Filtered, whatIsWrongWithTheStackIsSaidWithItsPlace) {
    Outcome outcome = run("PopFilter\n" + smallFrame() + plainWorld());
    EXPECT_EQ(outcome.status, 1);
    EXPECT_TRUE(outcome.says("scene.rib:1")) << outcome.text();
    EXPECT_TRUE(outcome.says("PopFilter: there is no filter on the stack")) << outcome.text();
    outcome = run(smallFrame() + "WorldBegin\nPushFilter \"double\"\nWorldEnd\n");
    EXPECT_TRUE(outcome.says("PushFilter has no effect between WorldBegin and WorldEnd"))
        << outcome.text();
}

/// Filters see the crop, and no byte depends on threads.
TEST_F(Filtered, cropsAreWhatFiltersSee) {
    const std::string rib = smallFrame("PushFilter \"makes\"\nCropWindow .25 .75 0 .5\n"
                                       "Display \"a.exr\" \"openexr\" \"rgb,mine\"\n") +
                            ballWorld("Surface \"glow\"");
    render(rib, {"--threads", "1"});
    const std::string one = folder_.read("a.exr");
    render(rib, {"--threads", "3"});
    EXPECT_EQ(folder_.read("a.exr"), one);
    EXPECT_EQ(read("a.exr").window, (FrameWindow{16, 12, 4, 12, 0, 6}));
    EXPECT_EQ(at("a.exr", "mine", 0, 0), 0); // Columns of the crop.
    EXPECT_EQ(at("a.exr", "mine", 7, 5), 7);
}

TEST_F(Filtered, displaysShowMapsThatFiltersMake) {
    render(smallFrame("PushFilter \"makes\"\nDisplay \"a.exr\" \"openexr\" \"mine\"\n"
                      "Display \"+b.exr\" \"openexr\" \"varying float mine,a\"\n") +
           plainWorld());
    EXPECT_EQ(channelsOf("a.exr"), (Names{"mine"}));
    EXPECT_EQ(channelsOf("b.exr"), (Names{"A", "mine"}));
    EXPECT_EQ(at("a.exr", "mine", 15, 11), 15);
    const Outcome outcome =
        run(smallFrame("Display \"c.exr\" \"openexr\" \"mine\"\n") + plainWorld());
    EXPECT_TRUE(outcome.says("unknown display mode or channel \"mine\"")) << outcome.text();
}

TEST_F(Filtered, picturesTakeTheSizeThatFiltersGive) {
    const Outcome outcome = run(smallFrame("PushFilter \"smaller\"\n"
                                           "Display \"a.exr\" \"openexr\" \"rgbaz\"\n"
                                           "Display \"+b.exr\" \"openexr\" \"a,radiance\"\n"
                                           "Display \"+c.png\" \"png\" \"rgb\"\n") +
                                plainWorld());
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_TRUE(outcome.says("left out: A, Z")) << outcome.text();
    EXPECT_EQ(read("a.exr").window, (FrameWindow{8, 6, 0, 8, 0, 6}));
    EXPECT_EQ(channelsOf("a.exr"), (Names{"B", "G", "R"}));
    EXPECT_EQ(everywhere("a.exr", "G"), .25f);
    EXPECT_EQ(read("b.exr").window, (FrameWindow{16, 12, 0, 16, 0, 12}));
    EXPECT_EQ(channelsOf("b.exr"), (Names{"A", "radiance.B", "radiance.G", "radiance.R"}));
    EXPECT_EQ(read("c.png").window.columns(), 8);
    // A filter that brings alpha to that size keeps it in the file.
    render(smallFrame("PushFilter \"halves\"\nDisplay \"a.exr\" \"openexr\" \"rgba\"\n") +
           ballWorld());
    EXPECT_EQ(everywhere("a.exr", "A"), 1);
    EXPECT_EQ(read("a.exr").window.rows(), 6);
}

/// The mean of what is kept is what the film has.
TEST_F(Filtered, filtersReadEverySample) {
    const std::string world = ballWorld("LightSource \"pointlight\" 1 \"point from\" [0 3 2]\n"
                                        "Surface \"glow\"");
    render(smallFrame("PushFilter \"spread\" \"samples\" [5]\nCropWindow .25 .75 .25 .75\n"
                      "Display \"a.exr\" \"openexr\" \"rgb,radiance\"\n") +
               world,
           {"--spp", "5"});
    const Picture picture = read("a.exr");
    for (const char *name : {"R", "G", "B"})
        for (std::size_t i = 0; i < picture.window.pixels(); ++i)
            EXPECT_NEAR(picture.find(name)->values[i],
                        picture.find(std::string("radiance.") + name)->values[i], 1e-5);
    // A frame without displays is not rendered, only looked at.
    const Outcome outcome = run(smallFrame("PushFilter \"spread\"\nFormat 2000 2000 1\n"
                                           "Display \"b.exr\" \"openexr\" \"nothing\"\n") +
                                    "WorldBegin\nWorldEnd\n",
                                {"--spp", "100"});
    EXPECT_TRUE(outcome.says("which would take 5.0 GB") && outcome.says("4 GB are the most"))
        << outcome.text();
    EXPECT_EQ(outcome.status, 1);
}

/// A 4 K picture fits, one with all its maps in a machine's memory does not.
TEST_F(Filtered, mapsCountAmongTheMemoryThatAFrameTakes) {
    const auto refused = [&](const std::string &filters) {
        return run(smallFrame(filters + "Format 1000000 1000000 1\n") + plainWorld())
            .says("with its filters");
    };
    EXPECT_FALSE(refused(""));
    EXPECT_TRUE(refused("PushFilter \"double\"\n"));
}

TEST_F(Filtered, framesThatAreNotFiniteReachFiltersAsZero) {
    folder_.write("spike.sl",
                  "surface spike() { Oi = 1; Ci = .25; if (u > .5) Ci = 1 / (u - u); }");
    const Outcome outcome =
        run(smallFrame("PushFilter \"double\"\nDisplay \"a.exr\" \"openexr\" \"rgb\"\n") +
            "WorldBegin\nSurface \"spike\"\n"
            "Patch \"bilinear\" \"P\" [-2 -2 1 2 -2 1 -2 2 1 2 2 1]\nWorldEnd\n");
    EXPECT_TRUE(outcome.says("not finite")) << outcome.text();
    EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.text();
    const Picture picture = read("a.exr");
    for (float value : picture.find("R")->values)
        EXPECT_TRUE(value == 0 || value == .5f) << value;
}

} // namespace candela::test
