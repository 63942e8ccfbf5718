// SPDX-License-Identifier: Apache-2.0
// Derivatives against central differences: each source through each operation, written plainly, in
// branches, loops, functions, arrays and components.
#include "language/ir/lower/patch_points.h"

#include <cmath>

namespace candela::ir {
namespace {

const char *const sources[] = {
    "u",           "v",        "s",         "t",         "xcomp(P)",
    "ycomp(P)",    "zcomp(I)", "xcomp(N)",  "ycomp(Ng)", "comp(Cs, 0)",
    "comp(Os, 2)", "pf",       "zcomp(pq)", "ycomp(pq)", "(u * v - s)",
};

/// Of $, which stays between -4 and 4.
const char *const operations[] = {
    "$ * $ + 3 * $",
    "$ / (3 + $ * $)",
    "-$",
    "abs($ - 9)",
    "min($, 7) + max($, -7)",
    "sqrt(9 + $)",
    "sin($) + cos(2 * $)",
    "tan(0.2 * $)",
    "asin(0.2 * $) - acos(0.1 * $)",
    "atan($)",
    "atan($, 2 + $ * $)",
    "exp(0.5 * $)",
    "log(5 + $)",
    "pow(5 + $, 1.5)",
    "pow(2, $)",
    "pow(5 + $, 1 + 0.1 * $)",
    "noise(2 * $)",
    "noise($, 0.5 * $)",
    "pnoise($, 4)",
    "comp(color noise($), 1)",
    "smoothstep(-5, 5, $)",
    "mix($, 2, 0.25)",
    "mod($ + 6, 50)",
    "clamp($, -50, 50)",
    "length(point($, 2, $ * $))",
    "xcomp(normalize(vector($, 1, 2)))",
    "ycomp(vector($, 1, 2) ^ vector(1, $, $ * $))",
    "$ > 100 ? 0 : $ * $",
    "spline(0.5 + 0.1 * $, 0, 1, 3, 2, 5, 4)",
    "comp(ctransform(\"hsv\", color(0.3 + 0.01 * $, 0.5, 0.4)), 2)",
};

/// How x gets an operation's value E (of the source, S); F is the operation as a function.
struct Form {
    const char *name, *body;
};
const Form forms[] = {
    {"plain", "x = E;"},
    {"if", "if (u > 0.33) x = E; else x = 2 * (E);"},
    {"loop", "x = 0; for (i = 0; i < 3; i += 1) x = 0.5 * x + (E);"},
    {"function", "x = F(S);"},
    {"array", "for (i = 0; i < 3; i += 1) a[i] = (i + 1) * (E); x = a[i - 2];"},
    {"component", "c = color(E, 1, 2); setcomp(c, 1, 3 * (E)); x = comp(c, 0) + comp(c, 1);"},
};

std::string replaced(std::string text, const std::string &what, const std::string &by) {
    for (size_t at = 0; (at = text.find(what, at)) != std::string::npos; at += by.size())
        text.replace(at, what.size(), by);
    return text;
}

/// All operations on one source in one form; the output of each is color(x, y, z) in terms of x.
std::string shaderOf(const std::string &source, const Form &form, const std::string &output) {
    std::string functions, outputs, body;
    for (size_t k = 0; k < std::size(operations); ++k) {
        const std::string number = std::to_string(k), name = "f" + number;
        functions += "float " + name + "(float y) { if (y > 100) return 0; return " +
                     replaced(operations[k], "$", "y") + "; }\n";
        outputs += "output varying color r" + number + " = 0;\n";
        std::string text = replaced(form.body, "F", name);
        text = replaced(text, "E", "(" + replaced(operations[k], "$", source) + ")");
        body += replaced(text, "S", source) + " r" + number + " = " + output + ";\n";
    }
    return functions + "surface test(" + outputs +
           "varying float pf = 0; varying vector pq = 0;) {\n"
           "float x, i; float a[3]; color c;\n" +
           body + "}";
}

constexpr int side = 3, points = side * side;
double uOf(int k) { return 0.09 + 0.31 * (k % side); }
double vOf(int k) { return 0.12 + 0.27 * (k / side); }

class Slopes : public testing::TestWithParam<int> {};

TEST_P(Slopes, AgreeWithCentralDifferences) {
    const Form &form = forms[size_t(GetParam())];
    const double h = 1.0 / 1024;
    for (const char *source : sources) {
        ShaderRun plain(shaderOf(source, form, "x"), 4 * points, {}, {"pf", "pq"});
        ShaderRun slopes(shaderOf(source, form, "color(Du(x), Dv(x), 0)"), points, {},
                         {"pf", "pq"});
        ASSERT_TRUE(plain.lowered && slopes.lowered)
            << source << plain.diagnostics.text() << slopes.diagnostics.text();
        for (int k = 0; k < points; ++k) {
            placeOnPatch(slopes, k, uOf(k), vOf(k));
            for (int n = 0; n < 4; ++n)
                placeOnPatch(plain, 4 * k + n,
                             uOf(k) + (n == 0   ? h
                                       : n == 1 ? -h
                                                : 0),
                             vOf(k) + (n == 2   ? h
                                       : n == 3 ? -h
                                                : 0));
        }
        const auto values = plain.run(), found = slopes.run();
        for (size_t op = 0; op < std::size(operations); ++op) {
            const std::string output = "r" + std::to_string(op);
            const auto &x = values.at(output)[0];
            for (int k = 0; k < points; ++k)
                for (int d = 0; d < 2; ++d) {
                    const double expected =
                        (double(x[4 * k + 2 * d]) - x[4 * k + 2 * d + 1]) / (2 * h);
                    EXPECT_NEAR(found.at(output)[size_t(d)][k], expected,
                                4e-3 * std::max(1.0, std::fabs(expected)))
                        << form.name << ": " << operations[op] << " of " << source << " by "
                        << (d ? "v" : "u") << " at " << uOf(k) << " " << vOf(k);
                }
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Table, Slopes, testing::Range(0, int(std::size(forms))),
                         [](const auto &info) { return std::string(forms[info.param].name); });

} // namespace
} // namespace candela::ir
