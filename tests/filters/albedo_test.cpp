// SPDX-License-Identifier: Apache-2.0
// The channels of the first hit that filters ask for, and "albedo" above all.
#include "tests/filters/filtered.h"

#include <cmath>

namespace candela::test {

namespace {

/// A plate over all of the picture.
std::string plate(const std::string &surface) {
    return "WorldBegin\n" + surface +
           "\nPolygon \"P\" [-5 -5 1  -5 5 1  5 5 1  5 -5 1]\nWorldEnd\n";
}

const std::string albedoFile = "Display \"a.exr\" \"openexr\" \"albedo\"\n";

struct Known {
    const char *surface;
    float albedo[3];
};

} // namespace

/// Without noise where the shader says where light matters and no more: one sample is enough.
TEST_F(Filtered, albedoOfOneSampleIsExactWhereItIsKnown) {
    const Known table[] = {
        {"Color .6 .6 .6 Surface \"matte\" \"Kd\" [1]", {.6f, .6f, .6f}},
        {"Color .2 .4 .8 Surface \"matte\" \"Kd\" [.5]", {.1f, .2f, .4f}},
        {"Color .6 .3 .1 Surface \"glow\"", {.6f, .3f, .1f}}, // Emission is no answer to light.
        {"Color .6 .6 .6 Surface \"constant\"", {0, 0, 0}},   // Nor is it an answer at all.
        {"Color 3 .5 1 Surface \"matte\" \"Kd\" [1]", {1, .5f, 1}}, // Clamped.
        {"Surface \"mirror\"", {1, 1, 1}},
        {"Surface \"glass\"", {1, 1, 1}},
        {"Color .7 .5 .3 Surface \"toon\"", {.7f, .5f, .3f}}, // Not affine in the light.
    };
    for (const char *integrator : {"path", "classic"})
        for (const Known &known : table) {
            const Outcome outcome =
                run(smallFrame(albedoFile) + plate(known.surface), {"--integrator", integrator});
            ASSERT_EQ(outcome.status, 0) << outcome.text(); // Of toon shaders there is a warning.
            const Picture picture = read("a.exr");
            for (int c = 0; c < 3; ++c) {
                const std::string name = std::string("albedo.") + "RGB"[c];
                for (float value : picture.find(name)->values)
                    ASSERT_NEAR(value, known.albedo[c], 1e-3)
                        << known.surface << " " << integrator << " " << name;
            }
        }
}

/// Lights are no part of it, instances answer as what they are of, and nothing has none.
TEST_F(Filtered, albedoBelongsToTheFirstSurfaceAlone) {
    const std::string surface = "Color .6 .6 .6 Surface \"matte\" \"Kd\" [1]\n";
    const std::string worlds[] = {
        ballWorld(surface),
        ballWorld("LightSource \"pointlight\" 1 \"intensity\" [90]\n" + surface),
        "WorldBegin\nObjectBegin 1\nSphere .9 -.9 .9 360\nObjectEnd\n" + surface +
            "Translate 0 0 5\nRotate 30 1 2 3\nObjectInstance 1\nWorldEnd\n",
        "WorldBegin\nTranslate 0 0 5\n" + surface +
            "Sphere .9 -.9 .9 360\nColor 1 1 1\nTranslate 0 0 3\nSphere .9 -.9 .9 360\nWorldEnd\n",
    };
    for (const std::string &world : worlds) {
        render(smallFrame(albedoFile) + world);
        EXPECT_NEAR(at("a.exr", "albedo.G", 8, 6), .6f, 1e-3) << world;
        EXPECT_EQ(at("a.exr", "albedo.G", 0, 0), 0) << world;
    }
}

/// In a furnace a convex body sends what it makes of uniform light: the two ways to know it agree.
TEST_F(Filtered, albedoIsWhatAFurnaceShows) {
    struct Case {
        const char *surface;
        float through; ///< What of the furnace is seen through it.
    };
    const Case table[] = {
        {"Surface \"plastic\" \"Kd\" [.5] \"Ks\" [.3] \"roughness\" [.2]", 0},
        {"Surface \"phong\"", 0},
        {"Surface \"roughmetal\"", 0},
        {"Opacity .5 .5 .5 Surface \"matte\" \"Kd\" [1]", .5f},
    };
    for (const Case &test : table) {
        const std::string world =
            "WorldBegin\nAttributeBegin\nSurface \"constant\" Color 1 1 1\nSphere 20 -20 20 360\n"
            "AttributeEnd\nTranslate 0 0 5\nColor .4 .6 .8\n" +
            std::string(test.surface) + "\nDisk 0 .5 360\nWorldEnd\n";
        render(smallFrame("Display \"a.exr\" \"openexr\" \"albedo,radiance\"\n"
                          "ScreenWindow -.3 .3 -.3 .3\nFormat 4 4 1\n") +
                   world,
               {"--integrator", "path", "--spp", "1024"});
        const Picture picture = read("a.exr");
        for (int c = 0; c < 3; ++c) {
            const char letter = "RGB"[c];
            const auto mean = [&](const std::string &channel) {
                double sum = 0;
                for (float value : picture.find(channel + "." + letter)->values)
                    sum += value;
                return sum / 16;
            };
            EXPECT_NEAR(mean("albedo"), mean("radiance") - test.through, 1e-3)
                << test.surface << " " << letter;
        }
    }
}

/// Asking for it changes no other bit, and what it says depends on no crop and no threads.
TEST_F(Filtered, askingForAlbedoChangesNothingElse) {
    for (const char *surface : {"Surface \"plastic\"", "Surface \"toon\"", "Surface \"glass\""})
        for (const char *integrator : {"path", "classic"}) {
            const std::string world = ballWorld(
                "LightSource \"pointlight\" 1 \"point from\" [0 3 2]\n" + std::string(surface));
            const std::vector<std::string> settings{"--integrator", integrator, "--spp", "3"};
            const auto with = [&](std::vector<std::string> more) {
                more.insert(more.end(), settings.begin(), settings.end());
                run(smallFrame("Display \"a.exr\" \"openexr\" \"rgba,albedo\"\n") + world, more);
                return read("a.exr");
            };
            run(smallFrame("Display \"a.exr\" \"openexr\" \"rgba\"\n") + world, settings);
            const Picture plain = read("a.exr");
            const Picture one = with({"--threads", "1"}), many = with({"--threads", "3"});
            for (const PictureChannel &channel : plain.channels)
                EXPECT_EQ(one.find(channel.name)->values, channel.values)
                    << surface << " " << integrator << " " << channel.name;
            for (const PictureChannel &channel : one.channels)
                EXPECT_EQ(many.find(channel.name)->values, channel.values) << surface;
            const Picture crop = with({"--crop", "0.5,1,0.5,1"});
            for (int y = 0; y < 6; ++y)
                for (int x = 0; x < 8; ++x)
                    ASSERT_EQ(crop.find("albedo.G")->values[std::size_t(y * 8 + x)],
                              one.find("albedo.G")->values[std::size_t((y + 6) * 16 + x + 8)])
                        << surface << " " << integrator;
        }
}

/// A printf() in a shader that is asked for its albedo speaks no more often.
TEST_F(Filtered, probingForAlbedoIsSilent) {
    folder_.write("says.sl", "surface says() { color d = diffuse(N); printf(\"here\\n\"); Oi = 1; "
                             "Ci = comp(d, 0) > .5 ? 1 : 0; }");
    const auto lines = [&](const std::string &mode, const std::string &integrator) {
        const Outcome outcome = run(smallFrame("Display \"a.exr\" \"openexr\" \"" + mode + "\"\n") +
                                        plate("Surface \"says\""),
                                    {"--integrator", integrator});
        return outcome.out + outcome.err;
    };
    for (const char *integrator : {"path", "classic"})
        EXPECT_EQ(lines("rgb,albedo", integrator), lines("rgb", integrator)) << integrator;
}

/// What a filter reads is what displays show of the same film.
TEST_F(Filtered, filtersReadWhatDisplaysShow) {
    struct Case {
        const char *map, *mode, *channels[3];
        const char *more = "";
    };
    const char *halves = " \"int halfbuffers\" [1]";
    const Case table[] = {
        {"N", "N", {"N.X", "N.Y", "N.Z"}},
        {"Z", "z", {"Z", "Z", "Z"}},
        {"albedo", "albedo", {"albedo.R", "albedo.G", "albedo.B"}},
        {"id", "id", {"id", "id", "id"}},
        {"P", "P", {"P.X", "P.Y", "P.Z"}},
        {"Oi", "Oi", {"Oi.R", "Oi.G", "Oi.B"}},
        {"variance", "variance", {"variance.R", "variance.G", "variance.B"}},
        {"half0", "radiance", {"half0.radiance.R", "half0.radiance.G", "half0.radiance.B"}, halves},
        {"half1", "radiance", {"half1.radiance.R", "half1.radiance.G", "half1.radiance.B"}, halves},
        {"radiance", "radiance", {"radiance.R", "radiance.G", "radiance.B"}},
    };
    for (const char *integrator : {"path", "classic"})
        for (const Case &test : table) {
            const std::string world =
                ballWorld("LightSource \"pointlight\" 1 \"point from\" [0 3 2]\n"
                          "Color .2 .4 .8 Surface \"plastic\"");
            render(smallFrame("PushFilter \"show\" \"string what\" \"" + std::string(test.map) +
                              "\"\nDisplay \"a.exr\" \"openexr\" \"rgb\"\n") +
                       world,
                   {"--integrator", integrator, "--spp", "4"});
            render(smallFrame("Display \"b.exr\" \"openexr\" \"" + std::string(test.mode) + "\"" +
                              test.more + "\n") +
                       world,
                   {"--integrator", integrator, "--spp", "4"});
            const Picture a = read("a.exr"), b = read("b.exr");
            for (int c = 0; c < 3; ++c) {
                ASSERT_TRUE(b.find(test.channels[c])) << test.map;
                EXPECT_EQ(a.find(std::string(1, "RGB"[c]))->values,
                          b.find(test.channels[c])->values)
                    << test.map << " " << integrator;
            }
        }
}

TEST_F(Filtered, theVarianceOfOneSampleIsFiniteToFilters) {
    render(smallFrame("PushFilter \"show\" \"string what\" \"variance\"\n"
                      "Display \"a.exr\" \"openexr\" \"rgb\"\n") +
           ballWorld());
    EXPECT_EQ(everywhere("a.exr", "R"), 0);
}

} // namespace candela::test
