// SPDX-License-Identifier: Apache-2.0
// option(): what it asks, and what becomes of the answers.
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/regions.h"
#include "language/ir/lower/test_support.h"
#include "language/ir/transform/jet.h"

namespace candela::ir {
namespace {

/// Has a name of an even length: as many numbers as are asked for, 10, 11, ...
void haveEvenNames(void *log, const ServiceCall &call) {
    noteService(log, call);
    const bool isThere = std::string_view(call.site->texts[0]).size() % 2 == 0;
    for (int k = 0; k < call.site->resultCount && isThere; ++k)
        for (int lane = 0; lane < call.laneCount; ++lane)
            call.result(k, lane) = k == 0 ? 1 : float(9 + k);
}

struct Told {
    Told(const std::string &type, const std::string &body, const LoweringOptions &options = {})
        : shader(surfaceWith(type, body), 3, {}, {}, options) {
        EXPECT_TRUE(shader.lowered) << shader.diagnostics.text();
        if (!shader.lowered)
            return;
        shader.batch->services = testServices(&log);
        shader.batch->services[Service::option] = haveEvenNames;
        const auto outputs = shader.run();
        for (const auto &plane : outputs.at("result"))
            result.push_back(plane[0]);
    }
    ShaderRun shader;
    ServiceLog log;
    std::vector<float> result;
};

using Numbers = std::vector<float>;

TEST(Information, SetsTheVariableIfThereIsSuchAValue) {
    const auto told = [](const char *type, const char *body) { return Told(type, body).result; };
    EXPECT_EQ(told("float", "float x = 5; float is = option(\"ab\", x); result = x + is;"),
              Numbers{11});
    EXPECT_EQ(told("float", "float x = 5; float is = option(\"abc\", x); result = x + is;"),
              Numbers{5});
    EXPECT_EQ(told("float", "float x[3] = {1, 2, 3}; option(\"ab\", x); result = x[2];"),
              Numbers{12});
    EXPECT_EQ(told("float", "float x[3] = {1, 2, 3}, k = 2 * u / u;\n"
                            "option(\"ab\", x); result = x[k];"),
              Numbers{12});
    EXPECT_EQ(told("color", "color x = 1; option(\"ab\", x); result = x;"), (Numbers{10, 11, 12}));
    EXPECT_EQ(told("color", "color x = 1; option(\"a\", x); result = x;"), (Numbers{1, 1, 1}));
}

TEST(Information, AsksByNameAndType) {
    Told told("float", "matrix m = 1; point p[2] = {0, 0}; float is = option(\"one\", m) +\n"
                       "option(\"two\", p) + option(\"one\", m); result = is;");
    const Function &text = told.shader.lowered->whole;
    ASSERT_EQ(text.services.size(), 2u);
    const auto textOf = [&](std::size_t service, std::size_t k) {
        return text.strings[std::size_t(text.services[service].texts[k])];
    };
    EXPECT_EQ(textOf(0, 0), "one");
    EXPECT_EQ(textOf(0, 1), "matrix");
    EXPECT_EQ(textOf(1, 1), "point[2]");
    EXPECT_EQ(text.services[0].results, 17);
    EXPECT_EQ(text.services[1].results, 7);
    EXPECT_EQ(told.log.count("one", 0), 1) << "equal questions are one";
    EXPECT_EQ(told.log.count("two", 2), 1);
    forEachInstruction(text.body, [&](const Instruction &i) {
        if (i.op == Op::Query) {
            EXPECT_EQ(text.values[i.results[0]].uniformity, Uniformity::Uniform);
        }
    });
}

TEST(Information, OnlyNumbersAreTold) {
    ShaderRun run(surfaceWith("float", "string s = \"\"; option(\"a\", s);"));
    EXPECT_TRUE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("option() tells numbers"), std::string::npos)
        << run.diagnostics.text();
}

TEST(Information, DoesNotChangeOverASurface) {
    Told told("float", "float x = 5; option(\"ab\", x); result = Du(x * u);");
    EXPECT_EQ(told.result, Numbers{10});
    EXPECT_EQ(told.shader.diagnostics.text(), "");
}

/// Nobody says how the answers of such a service change.
TEST(Information, UnknownSlopesCountAsZeroAndAreNamed) {
    Function function;
    Builder b(function);
    const ValueId u = input(b, ShaderInput::u);
    const ValueId asked = query(b, testSample, {"a"}, {u, u}, 1)[0];
    output(b, "slope", 0, b.emit(Op::Slope, {asked}, int(Direction::U))[0]);
    b.finish();
    const SlopeReport report = expandSlopes(function);
    EXPECT_FALSE(report.fault);
    ASSERT_EQ(report.held.size(), 1u);
    EXPECT_EQ(report.held[0].text, "what sample() gives is taken not to change with u and v");
    TestBatch batch(function, 1, 1);
    EXPECT_EQ(batch.run(function, interpret)[0][0], 0);
}

} // namespace
} // namespace candela::ir
