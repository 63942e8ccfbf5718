// SPDX-License-Identifier: Apache-2.0
// Shaders that are not affine in the light: what they are given, and what the user is told.
#include "foundation/base/student.h"
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {

namespace {

const std::string shaders =
    CANDELA_SOURCE_DIR "/tests/shading/shaders:" CANDELA_SOURCE_DIR "/tests/validation/shaders";

/// A square of half-width 1/2 that fills the view.
const std::string square = "Translate 0 0 1\n"
                           "Polygon \"P\" [-.5 -.5 0 .5 -.5 0 .5 .5 0 -.5 .5 0]\n";

/// Walls all around, from which radiance / (1 - albedo) comes.
std::string furnace(double emission, double albedo) {
    return "Surface \"glow\" \"float emission\" [" + std::to_string(emission) + "] \"float Kd\" [" +
           std::to_string(albedo) + "]\nSphere 10 -10 10 360\n";
}

/// A distant light that shines down on the square at 60 degrees to its normal.
const std::string slantingLight = "LightSource \"distantlight\" 1 \"float intensity\" [1] "
                                  "\"point from\" [0 0 0] \"point to\" [0 .8660254 .5]\n";

std::string surface(const std::string &shader, const std::string &parameters) {
    return "Surface \"" + shader + "\" " + parameters + "\n" + square;
}

std::string frame(const std::string &options, const std::string &world) {
    return "FrameBegin 1\n" + options +
           "Format 8 8 1\nPixelFilter \"box\" 1 1\nPixelSamples 4 4\n"
           "Display \"out.exr\" \"openexr\" \"rgb\"\nProjection \"orthographic\"\n"
           "ScreenWindow -.2 .2 -.2 .2\nWorldBegin\n" +
           world + "WorldEnd\nFrameEnd\n";
}

const std::string si = "Option \"radiometry\" \"string units\" [\"si\"]\n";
const std::string path = "Option \"render\" \"string integrator\" [\"path\"]\n";
const std::string classic = "Option \"render\" \"string integrator\" [\"classic\"]\n";

struct Result {
    Outcome run;
    std::vector<float> values; ///< Red; the other channels are the same.

    double mean() const {
        double sum = 0;
        for (float value : values)
            sum += value;
        return sum / double(values.size());
    }
};

Result render(const std::string &rib, const std::vector<std::string> &options = {}) {
    ScratchFolder folder;
    std::vector<std::string> arguments{folder.write("scene.rib", rib),
                                       "--quiet",
                                       "--shader-path",
                                       shaders,
                                       "--output-dir",
                                       folder.path()};
    arguments.insert(arguments.end(), options.begin(), options.end());
    Result result{runCandela(arguments), {}};
    EXPECT_EQ(result.run.status, 0) << result.run.text();
    std::string problem;
    std::optional<Picture> picture = readPicture(folder.path("out.exr"), problem);
    EXPECT_TRUE(picture) << problem;
    if (!picture)
        return result;
    result.values = picture->find("R")->values;
    EXPECT_EQ(result.values, picture->find("G")->values);
    EXPECT_EQ(result.values, picture->find("B")->values);
    return result;
}

void expectAll(const Result &result, float expected) {
    ASSERT_EQ(result.values.size(), 64u);
    for (float value : result.values)
        ASSERT_NEAR(value, expected, 1e-5f);
}

int occurrences(const std::string &text, const std::string &what) {
    int count = 0;
    for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + 1))
        ++count;
    return count;
}

/// Means of eight seeds.
MeanAndError meanOf(const std::string &rib) {
    std::vector<double> means;
    for (int seed = 1; seed <= 8; ++seed)
        means.push_back(render(rib, {"--seed", std::to_string(seed)}).mean());
    return meanAndError(means);
}

void expectSameMean(const std::string &one, const std::string &other) {
    MeanAndError a = meanOf(one), b = meanOf(other);
    double error = std::hypot(a.standardError, b.standardError);
    EXPECT_GT(b.mean, 0.1);
    EXPECT_LT(error, 0.01 * b.mean) << "this shows nothing";
    EXPECT_LE(std::abs(a.mean - b.mean), studentQuantile(1e-3, 7) * error + 1e-5 * b.mean)
        << a.mean << " and " << b.mean << " +- " << error;
}

} // namespace

// Radiance 1 from all sides makes diffuse() 1 and the tone that is judged Kd = 1/2, far from both
// thresholds.
TEST(GatheredLight, ThresholdsSeeAllOfAFurnacesLight) {
    for (double albedo : {0.0, 0.5}) {
        const std::string walls = furnace(1 - albedo, albedo);
        expectAll(render(frame(si, walls + surface("toon", "\"float threshold\" [.3]"))), .75f);
        expectAll(render(frame(si, walls + surface("toon", "\"float threshold\" [.75]"))), .25f);
    }
}

TEST(GatheredLight, WithoutConesToo) {
    const std::string world = furnace(1, 0) + surface("toon", "\"float threshold\" [.3]");
    expectAll(render(frame(si, world), {"--sampling", "hemisphere"}), .75f);
}

// Under a distant light at 60 degrees diffuse() is 1/2. As far as can be proved, toon sends light
// in darkness too, so under path a few of the rounds go to the square as a light: hence the margin.
TEST(GatheredLight, ClassicAndPathAgreeWithTheClosedForm) {
    for (const std::string &integrator : {classic, path}) {
        auto tone = [&](const std::string &threshold) {
            return render(
                frame(integrator, slantingLight + surface("toon", "\"color dark\" [0 0 0] "
                                                                  "\"float Kd\" [1] " +
                                                                      threshold)));
        };
        expectAll(tone("\"float threshold\" [.4]"), .75f);
        expectAll(tone("\"float threshold\" [.6]"), 0);
        expectAll(
            render(frame(integrator, slantingLight + surface("rootmatte", "\"float Kd\" [.8]"))),
            .4f);
    }
}

// What is linear in truth has the mean that matte has.
TEST(GatheredLight, LinearInTruthIsMatte) {
    const std::string matte = "\"float Ka\" [0] \"float Kd\" [.5]";
    const std::string white = furnace(1, 0), grey = furnace(.5, .5);
    const std::string kd = "\"float Kd\" [.5]";
    expectSameMean(frame(si, white + surface("rootmatte", kd)),
                   frame(si, white + surface("matte", matte)));
    expectSameMean(frame(si, grey + surface("rootmatte", kd)),
                   frame(si, grey + surface("matte", matte)));
}

// A small emitter is found by light samples and by directions: each must count its share.
TEST(GatheredLight, SmallEmittersCountOnce) {
    const std::string lamp = "AttributeBegin\nTranslate .4 0 .6\nSurface \"glow\" \"float "
                             "emission\" [4] \"float Kd\" [0]\nSphere .2 -.2 .2 360\n"
                             "AttributeEnd\n";
    expectSameMean(frame(si, lamp + surface("rootmatte", "\"float Kd\" [.5]")),
                   frame(si, lamp + surface("matte", "\"float Ka\" [0] \"float Kd\" [.5]")));
}

// A mirror request goes its own way beside the gathered light: a quarter of radiance 1.
TEST(GatheredLight, TracedAnswersComeBesides) {
    expectSameMean(frame(si, furnace(1, 0) + surface("rootmatte", "\"float Kr\" [.25]")),
                   frame(si, furnace(1, 0) + surface("matte", "\"float Ka\" [0] \"float Kd\" "
                                                              "[.75]")));
}

// What shines through joins the tone that the surface itself has.
TEST(GatheredLight, OpacityLetsTheRestThrough) {
    const std::string veil = "Opacity [.5 .5 .5]\n" + surface("toon", "\"float threshold\" [.3]");
    const std::string rib = frame(si, furnace(1, 0) + veil);
    MeanAndError result = meanOf(rib);
    EXPECT_NEAR(result.mean, .5 * .75 + .5, 4 * result.standardError + 1e-5);
}

TEST(GatheredLight, DepthZeroHasNoLight) {
    Result result = render(frame(si + "Option \"trace\" \"integer maxdepth\" [0]\n",
                                 furnace(1, 0) + surface("toon", "\"float threshold\" [.001]")));
    expectAll(result, .25f);
}

// Walls of the kind light each other through lights alone, and it ends there.
TEST(GatheredLight, RoomsOfItEnd) {
    const std::string room = "Surface \"rootmatte\" \"float Kd\" [.8]\nSphere 10 -10 10 360\n";
    Result result = render(frame(si, "LightSource \"pointlight\" 1 \"float intensity\" [100] "
                                     "\"point from\" [0 0 0]\n" +
                                         room));
    const double direct = .8 / std::numbers::pi; // 100 W/sr from ten metres away: E = 1
    EXPECT_NEAR(result.mean(), direct * 1.8, 1e-3 * direct);
}

TEST(GatheredLight, SaysSoOnceWithShaderAndLine) {
    const std::string two = furnace(1, 0) + "AttributeBegin\n" +
                            surface("toon", "\"float threshold\" [.3]") +
                            "AttributeEnd\nAttributeBegin\n" +
                            surface("toon", "\"float threshold\" [.4]") + "AttributeEnd\n";
    const std::string said = "shader \"toon\", line 12:";
    const std::string rib = frame(si, two) + frame(si, two);
    Result result = render(rib);
    EXPECT_EQ(occurrences(result.run.err, said), 1) << result.run.err;
    EXPECT_EQ(occurrences(result.run.err, "16 samples"), 1) << result.run.err;
    EXPECT_EQ(occurrences(result.run.err, "glow"), 0) << result.run.err;
    EXPECT_FALSE(render(frame(classic, two)).run.says(said));
}

TEST(GatheredLight, SlowRequestsAreNamed) {
    const std::string world = slantingLight + surface("wandering", "\"float turns\" [2]");
    Result result = render(frame(path, world));
    EXPECT_EQ(occurrences(result.run.err, "shader \"wandering\", line 11:"), 1) << result.run.err;
}

TEST(GatheredLight, DoesNotDependOnHowTheWorkIsDivided) {
    const std::string lamp = "AttributeBegin\nTranslate .4 0 .6\nSurface \"glow\"\nSphere .2 -.2 "
                             ".2 360\nAttributeEnd\n";
    const std::string rib =
        frame(si, lamp + furnace(.1, .2) + surface("rootmatte", "\"float Kr\" [.25]"));
    const std::vector<std::string> wide{"--format", "40x40", "--spp", "1"};
    auto with = [&](const std::vector<std::string> &options) {
        std::vector<std::string> all = wide;
        all.insert(all.end(), options.begin(), options.end());
        return render(rib, all).values;
    };
    const std::vector<float> reference = with({"--threads", "2", "--lanes", "16"});
    ASSERT_EQ(reference.size(), 40u * 40u);
    EXPECT_EQ(with({"--threads", "1"}), reference);
    EXPECT_EQ(with({"--lanes", "1"}), reference);
    EXPECT_NE(with({"--seed", "7"}), reference);
    const std::vector<float> half = with({"--crop", "0,1,0.5,1"});
    ASSERT_EQ(half.size(), 40u * 20u);
    EXPECT_EQ(half, std::vector<float>(reference.begin() + 40 * 20, reference.end()));
}

} // namespace candela::test
