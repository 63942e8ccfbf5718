// SPDX-License-Identifier: Apache-2.0
// Sums and chains of "else if" as programs write them: thousands of links, each with its value.
#include "language/ir/lower/test_support.h"

#include <functional>

namespace candela::ir {
namespace {

std::string each(int count, const std::function<std::string(std::string)> &link) {
    std::string text;
    for (int k = 0; k < count; ++k)
        text += link(std::to_string(k));
    return text;
}

/// x is 100 u, of either sign; gives the results and what is expected of each lane.
void expect(const std::string &body, const std::function<double(double x)> &expected,
            double within = 0) {
    ShaderRun run("surface test(output varying float result = 0;) { float x = 100 * u;\n" + body +
                  "\n}");
    ASSERT_TRUE(run.lowered) << run.diagnostics.text().substr(0, 2000);
    const auto &u = run.batch->inputs[std::size_t(ShaderInput::u)];
    const auto result = run.run().at("result")[0];
    for (int lane = 0; lane < 21; ++lane) {
        const float x = 100 * u[std::size_t(lane)];
        EXPECT_NEAR(result[std::size_t(lane)], expected(double(x)), within)
            << body.substr(0, 200) << ", x " << x;
    }
}

TEST(LongTexts, SumsHaveThousandsOfTerms) {
    expect(
        "result = 0" + each(4900, [](const std::string &n) { return "+ min(x, " + n + ")"; }) +
            " - 12002550;",
        [](double x) {
            double sum = -12002550;
            for (int k = 0; k < 4900; ++k)
                sum += std::min(x, double(k));
            return sum;
        },
        200);
    expect("result = x > 1e6" +
               each(2000, [](const std::string &n) { return " || x == " + n + " + .5"; }) +
               " || (x > 10 && x < 20);",
           [](double x) { return x > 10 && x < 20; });
}

/// Which of the unit intervals from 0 on x lies in, as chains find it.
double place(double x, int links) { return x < 0 ? 0 : std::min(std::floor(x) + 1, links + 1.0); }

TEST(LongTexts, ChainsTakeTheFirstLinkThatHolds) {
    for (const int links : {3, 63, 64, 65, 80, 4000}) {
        const auto chain = [&](const std::string &last) {
            return "if (x < 0) result = 0;\n" +
                   each(links,
                        [](const std::string &n) {
                            return "else if (x < " + n + " + 1) result = " + n + " + 1;\n";
                        }) +
                   last;
        };
        expect(chain("else result = " + std::to_string(links) + " + 1;"),
               [&](double x) { return place(x, links); });
        expect("result = -7; " + chain(""),
               [&](double x) { return x >= links ? -7 : place(x, links); });
    }
}

TEST(LongTexts, ConditionsOfChainsRunAsFarAsTheyAreReached) {
    expect("float asked = 0; if ((asked += 1) > 1e6) ;\n" +
               each(200,
                    [](const std::string &n) {
                        return "else if ((asked += 1) > 0 && x < " + n + ") ;\n";
                    }) +
               "result = asked;",
           [](double x) { return x < 0 ? 2 : std::min(std::floor(x) + 3, 201.0); });
}

TEST(LongTexts, LinksOfChainsMayLeaveWhatIsAround) {
    const auto chain = [](const std::string &leave) {
        return "if (x < 0) result = 0;\n" +
               each(150,
                    [&](const std::string &n) {
                        return "else if (x < " + n + " + 1) { result = " + n + "; " + leave +
                               "; }\n";
                    }) +
               "result += 1000;\n";
    };
    const auto expected = [](double x) { return x < 0 ? 1000 : std::floor(x); };
    expect(chain("return"), expected);
    expect("float i; for (i = 0; i < 3; i += 1) { " + chain("break") + " break; }", expected);
    expect("float i; for (i = 0; i < 2; i += 1) { " + chain("continue") + " x += 1; }",
           [](double x) { return x < -1  ? 1000
                                 : x < 0 ? 0
                                         : std::floor(x); });
}

TEST(LongTexts, BeyondTheLimitsAreErrors) {
    const std::pair<std::string, const char *> texts[] = {
        {"Ci = s" + each(6000, [](const std::string &n) { return " + " + n; }) + ";",
         "expression is too long; split it (the limit is 5000"},
        {"if (s < 0) Ci = 1;" +
             each(6000, [](const std::string &n) { return "else if (s < " + n + ") Ci = 1;\n"; }),
         "too many 'else if' in a row; the limit is 5000"},
        {"Ci = " + std::string(300, '(') + "s" + std::string(300, ')') + ";",
         "nested too deeply; the limit is 200"}};
    for (const auto &[body, words] : texts) {
        ShaderRun run("surface test() { " + body + " }");
        EXPECT_FALSE(run.lowered);
        EXPECT_NE(run.diagnostics.text().find(words), std::string::npos)
            << run.diagnostics.text().substr(0, 2000);
        EXPECT_EQ(run.diagnostics.count(Severity::Error), 1);
    }
}

/// An error in a link is told, and only that.
TEST(LongTexts, ErrorsInLinksEndTheChain) {
    ShaderRun run("surface test() { if (s < 0) Ci = 1; else if (s < ) Ci = 2;\n"
                  "Ci = nosuch;\n}");
    EXPECT_FALSE(run.lowered);
    EXPECT_EQ(run.diagnostics.count(Severity::Error), 2) << run.diagnostics.text();
}

} // namespace
} // namespace candela::ir
