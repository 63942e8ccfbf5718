// SPDX-License-Identifier: Apache-2.0
// Every case is rendered by the program itself with seeds that are fixed here, and judged by
// Student's t over them; those in si units once more from both ends. All intervals of the suite
// together have the chance 1e-3 to miss.
#include "foundation/base/student.h"
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"
#include "tests/validation/cases.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

/// How GoogleTest names a case that failed.
static void PrintTo(const Case &test, std::ostream *stream) { *stream << test.name; }

namespace {

constexpr int seeds = 16;
constexpr double familyWiseLevel = 1e-3;
constexpr double largestStandardError = 0.75e-3; ///< Of the mean, relative.
/// Arithmetic in floats, on both sides of the ray's offset: no interval can be narrower.
constexpr double rounding = 2e-5;

double tolerance(Accuracy accuracy) {
    switch (accuracy) {
    case Accuracy::Exact: return rounding;
    case Accuracy::Direct: return 1e-3;
    case Accuracy::Global: return 5e-3;
    }
    return 0;
}

/// Those that mean the same to `bidir`, but for lamps that are surfaces: to paths from lights they
/// are what area lights are.
std::vector<Case> casesFromBothEnds() {
    std::vector<Case> cases = allCases();
    std::erase_if(cases, [](const Case &each) {
        return each.options.find(siUnits) == std::string::npos ||
               each.name.find("Surface") != std::string::npos;
    });
    return cases;
}

std::size_t comparisons() {
    std::size_t count = 0;
    for (const std::vector<Case> &cases : {allCases(), casesFromBothEnds()})
        for (const Case &each : cases)
            count += each.probes.size();
    return count;
}

/// One frame a probe.
std::string ribOf(const Case &test) {
    std::string rib = "##RenderMan RIB-Structure 1.0\n";
    int frame = 0;
    for (const Probe &probe : test.probes)
        rib += "FrameBegin " + std::to_string(++frame) +
               "\nFormat 8 8 1\nPixelFilter \"box\" 1 1\nPixelSamples " +
               std::to_string(test.samples) + " 1\nDisplay \"" + probe.name +
               ".exr\" \"openexr\" \"rgb\"\n" + test.options + probe.camera + "WorldBegin\n" +
               test.world + "WorldEnd\nFrameEnd\n";
    return rib;
}

double meanOf(const PictureChannel &channel) {
    double sum = 0;
    for (float value : channel.values)
        sum += value;
    return sum / double(channel.values.size());
}

/// The mean of a grey picture; its channels have to be one.
double meanOfGrey(const std::string &path) {
    std::string problem;
    std::optional<Picture> picture = readPicture(path, problem);
    EXPECT_TRUE(picture) << problem;
    if (!picture)
        return NAN;
    const PictureChannel *red = picture->find("R");
    const PictureChannel *green = picture->find("G"), *blue = picture->find("B");
    if (!red || !green || !blue) {
        ADD_FAILURE() << path << " lacks a channel";
        return NAN;
    }
    EXPECT_EQ(red->values, green->values) << path;
    EXPECT_EQ(red->values, blue->values) << path;
    return meanOf(*red);
}

/// results[probe][seed]
using Results = std::vector<std::vector<double>>;

/// By the integrator that the case has, or another one.
Results render(const Case &test, const std::vector<std::string> &integrator = {}) {
    ScratchFolder folder;
    std::string rib = folder.write(test.name + ".rib", ribOf(test));
    Results results(test.probes.size());
    for (int seed = 1; seed <= seeds; ++seed) {
        std::vector<std::string> words{rib,
                                       "--quiet",
                                       "--threads",
                                       "1",
                                       "--seed",
                                       std::to_string(seed),
                                       "--output-dir",
                                       folder.path(),
                                       "--shader-path",
                                       CANDELA_SOURCE_DIR "/tests/validation/shaders"};
        words.insert(words.end(), integrator.begin(), integrator.end());
        Outcome run = runCandela(words);
        EXPECT_EQ(run.status, 0) << run.text();
        if (run.status != 0)
            return {};
        for (std::size_t i = 0; i < test.probes.size(); ++i)
            results[i].push_back(meanOfGrey(folder.path(test.probes[i].name + ".exr")) *
                                 test.probes[i].scale);
    }
    return results;
}

void judge(const Probe &probe, Accuracy accuracy, const std::vector<double> &values) {
    SCOPED_TRACE(probe.name);
    MeanAndError result = meanAndError(values);
    // What is expected to be dark has to be dark: there is nothing to be relative to.
    double unit = probe.expected == 0 ? 1 : std::abs(probe.expected);
    double difference = std::abs(result.mean - probe.expected) / unit;
    double error = result.standardError / unit;
    double interval = studentQuantile(familyWiseLevel / double(comparisons()), seeds - 1) * error;
    std::printf("    %-22s expected %.7g, mean %.7g (%+.4f %%), standard error %.4f %%\n",
                probe.name.c_str(), probe.expected, result.mean,
                100 * (result.mean - probe.expected) / unit, 100 * error);
    EXPECT_LE(error, accuracy == Accuracy::Exact ? rounding : largestStandardError);
    EXPECT_LE(difference, tolerance(accuracy));
    EXPECT_LE(difference, interval + rounding) << "outside its confidence interval";
}

class Validation : public testing::TestWithParam<Case> {};

void judgeAll(const Case &test, const Results &results) {
    ASSERT_EQ(results.size(), test.probes.size());
    for (std::size_t i = 0; i < results.size(); ++i)
        judge(test.probes[i], test.accuracy, results[i]);
}

TEST_P(Validation, AgreesWithTheClosedForm) { judgeAll(GetParam(), render(GetParam())); }

class FromBothEnds : public Validation {};

TEST_P(FromBothEnds, AgreesWithTheClosedForm) {
    judgeAll(GetParam(), render(GetParam(), {"--integrator", "bidir"}));
}

std::string nameOf(const testing::TestParamInfo<Case> &info) { return info.param.name; }

INSTANTIATE_TEST_SUITE_P(Furnace, Validation, testing::ValuesIn(furnaceCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(DirectLight, Validation, testing::ValuesIn(directLightCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(Units, Validation, testing::ValuesIn(unitCases()), nameOf);
INSTANTIATE_TEST_SUITE_P(BothEnds, FromBothEnds, testing::ValuesIn(casesFromBothEnds()), nameOf);

} // namespace

} // namespace candela::test
