// SPDX-License-Identifier: Apache-2.0
// Volumes that are no straight lines, give no numbers, or are not there.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/volumes/worlds.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

struct Rendered {
    Outcome run;
    std::vector<float> red, alpha;
};

Rendered renderOne(const std::string &world, const std::string &integrator,
                   const std::string &shader = "") {
    ScratchFolder folder;
    if (!shader.empty())
        folder.write("own.sl", shader);
    const std::string rib = folder.write(
        "scene.rib", "Format 4 4 1\nPixelFilter \"box\" 1 1\nDisplay \"out.exr\" \"openexr\" "
                     "\"rgba\"\nProjection \"orthographic\"\nScreenWindow -.1 .1 -.1 .1\n"
                     "WorldBegin\n" +
                         world + "WorldEnd\n");
    Rendered result{runCandela({rib, "--quiet", "--integrator", integrator, "--spp", "1",
                                "--threads", "1", "--output-dir", folder.path(), "--shader-path",
                                CANDELA_SOURCE_DIR "/tests/volumes/shaders"}),
                    {},
                    {}};
    std::string problem;
    if (const auto picture = readPicture(folder.path("out.exr"), problem))
        result.red = picture->find("R")->values, result.alpha = picture->find("A")->values;
    return result;
}

int occurrences(const std::string &text, const std::string &what) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += what.size())
        ++count;
    return count;
}

const std::string integrators[] = {"classic", "path"};

TEST(StrangeVolumes, ThatAreNotAffineAreTakenForStraightLines) {
    for (const std::string &integrator : integrators) {
        const Rendered seen =
            renderOne("Atmosphere \"squared\"\n" + sheet(2, .25) + sheet(3, .5), integrator);
        EXPECT_EQ(seen.run.status, 0) << seen.run.text();
        EXPECT_EQ(occurrences(seen.run.text(), "\"squared\", line 3"), 1) << seen.run.text();
        ASSERT_EQ(seen.red.size(), 16u);
        for (const float red : seen.red) // From 1/8 for black to 5/8 for 1.
            EXPECT_NEAR(red, .125 + .5 * .25, 1e-6) << integrator;
    }
}

TEST(StrangeVolumes, WithoutNumbersAreReportedAndBlack) {
    for (const std::string &integrator : integrators) {
        const Rendered seen = renderOne("Atmosphere \"broken\"\n" + sheet(2, .25), integrator);
        EXPECT_EQ(seen.run.status, 0) << seen.run.text();
        EXPECT_EQ(occurrences(seen.run.text(), "shader \"broken\" gave a value that is not finite"),
                  1)
            << seen.run.text();
        ASSERT_EQ(seen.red.size(), 16u);
        for (int pixel = 0; pixel < 16; ++pixel) {
            EXPECT_EQ(seen.red[std::size_t(pixel)], 0) << integrator;
            EXPECT_EQ(seen.alpha[std::size_t(pixel)], 1) << integrator;
        }
    }
}

TEST(StrangeVolumes, ThatAreMissingOrFaultyAreNone) {
    for (const std::string &integrator : integrators)
        for (const auto &[request, shader] :
             {std::pair<std::string, std::string>{"Atmosphere \"nosuchvolume\"", ""},
              {"Interior \"nosuchvolume\"", ""},
              {"Exterior \"nosuchvolume\"", ""},
              {"Atmosphere \"matte\"", ""},
              {"Atmosphere \"own\"", "volume own() { Ci = nothing; }\n"}}) {
            const Rendered seen = renderOne(request + "\n" + sheet(2, .25), integrator, shader);
            EXPECT_EQ(seen.run.status, 1) << request;
            EXPECT_NE(seen.run.text().find("scene.rib:"), std::string::npos) << seen.run.text();
            ASSERT_EQ(seen.red.size(), 16u);
            EXPECT_EQ(seen.red[5], .25f) << request;
        }
}

TEST(StrangeVolumes, AskForLightAtSoManyPoints) {
    const std::string sun = "LightSource \"distantlight\" 1 \"intensity\" [1]\n";
    const std::string everywhere =
        "volume own() { color c = 0; float k; for (k = 0; k < 3000; k += 1)\n"
        "illuminance (P - I * k / 3000) c += Cl / 1024; Ci = c; }\n";
    const Rendered seen =
        renderOne(sun + "Atmosphere \"own\"\n" + sheet(2, .25), "classic", everywhere);
    EXPECT_EQ(seen.run.status, 0) << seen.run.text();
    EXPECT_EQ(occurrences(seen.run.text(), "more than 1024 points"), 1) << seen.run.text();
    ASSERT_EQ(seen.red.size(), 16u);
    EXPECT_NEAR(seen.red[5], 1, 1e-3);
}

TEST(StrangeVolumes, SpeakOnceAPointHoweverOftenTheyRun) {
    const std::string sun = "LightSource \"distantlight\" 1 \"intensity\" [.5]\n";
    const auto said = [&](const std::string &text, const std::string &words) {
        const Rendered seen =
            renderOne(sun + "Atmosphere \"own\"\n" + sheet(2, .25), "classic", text);
        return occurrences(seen.run.text(), words);
    };
    const std::string lit = "volume own() { color c = 0; illuminance (P) c += Cl;\n"
                            "printf(\"it is %f\\n\", comp(c, 0)); Ci += c; }\n";
    const std::string plain = "volume own() { printf(\"it is %f\\n\", .5); }\n";
    EXPECT_GE(said(plain, "it is 0.5"), 16);
    EXPECT_EQ(said(lit, "it is 0.5"), said(plain, "it is 0.5"));
    EXPECT_EQ(said(lit, "it is 0.0"), 0);
}

} // namespace
} // namespace candela::test
