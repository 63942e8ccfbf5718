// SPDX-License-Identifier: Apache-2.0
// That runs are told apart by whatever differs between them.
#include "code_trial.h"
#include "runs.h"
#include "trial.h"

#include "language/semantics/front.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela::fuzz {
namespace {

class NoMonitor : public Monitor {
public:
    void show(const std::string &) override {}
    void enter(Stage, const std::string &) override {}
    Tally &tally() override { return tally_; }

private:
    Tally tally_{};
};

ir::LoweredShader lowered(const std::string &text) {
    DiagnosticList diagnostics;
    const auto front = sl::analyzeSource({"test.sl", text}, {}, diagnostics);
    EXPECT_TRUE(front) << diagnostics.text();
    return *ir::lower(*front->shaders[0], {}, {}, diagnostics);
}

const char *const talking = "surface s() { float a[2] = {u, v}; Oi = Os;"
                            "  printf(\"%f\", u); Ci = diffuse(N) + ambient() + a[floor(3 * s)]; }";

class Runs : public testing::Test {
protected:
    ir::LoweredShader shader = lowered(talking);
    Chance chance{5};
    Batch batch{shader, chance};
    RunResult run(Light light) {
        batch.fit(shader.whole);
        return batch.run(shader.whole, ir::interpret, light);
    }
};

TEST_F(Runs, AreTheSameAgain) {
    EXPECT_EQ(differenceOf(run(Light::Given), run(Light::Given)), "");
    EXPECT_NE(differenceOf(run(Light::Given), run(Light::None)), "");
}

TEST_F(Runs, DifferInAnyPart) {
    const RunResult expected = run(Light::Given);
    RunResult found = expected;
    found.outputs[1][0] = std::nextafter(found.outputs[1][0], 9.0f);
    EXPECT_EQ(differenceOf(expected, found).find("output 1, lane 0"), 0u);
    found = expected;
    for (const auto frame : {&ir::TestFrames::surface, &ir::TestFrames::view}) {
        (found.frames.*frame).assign(1, 2);
        RunResult other = found;
        (other.frames.*frame)[0] = 3;
        EXPECT_EQ(differenceOf(found, other).find("frame"), 0u);
    }
    found = expected;
    ++found.digest;
    EXPECT_NE(differenceOf(expected, found).find("printed"), std::string::npos);
    found = expected;
    found.outside.emplace("test.sl", 99);
    EXPECT_NE(differenceOf(expected, found).find("outside"), std::string::npos);
    EXPECT_GT(expected.lines, 0u);
    EXPECT_FALSE(expected.outside.empty());
}

TEST_F(Runs, CompareOutputsByNameWhereTheyAreFinite) {
    const RunResult expected = run(Light::Given);
    RunResult found = expected;
    const auto difference = [&] {
        return differenceOfOutputs(shader.whole, expected, "Ci", shader.whole, found, "Ci");
    };
    EXPECT_EQ(difference(), "");
    found.outputs[2].back() += 1;
    EXPECT_EQ(difference().find("Ci 2"), 0u);
    EXPECT_EQ(differenceOfOutputs(shader.whole, expected, "Ci", shader.whole, found, "Ce"),
              "no output Ce");
}

TEST_F(Runs, OfCodeAreTheInterpreters) {
    NoMonitor monitor;
    batch.fit(shader.whole);
    EXPECT_EQ(compareCode(shader.whole, batch, "whole", monitor), "");
    EXPECT_EQ(monitor.tally().compared, 1u);
}

TEST(Trial, JudgesMessages) {
    NoMonitor monitor;
    EXPECT_EQ(tryText("surface s() { Ci = nothing; }", {}, monitor), "");
    EXPECT_EQ(tryText(talking, {}, monitor), "");
    EXPECT_EQ(monitor.tally().compiled, 1u);
}

} // namespace
} // namespace candela::fuzz
