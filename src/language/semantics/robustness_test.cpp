// SPDX-License-Identifier: Apache-2.0
// Whatever the text, the front end answers: no crash, no hang, no silent refusal.
#include <random>

#include <gtest/gtest.h>

#include "language/semantics/front_test_support.h"

namespace candela::sl {
namespace {

using test::Compiled;

const std::string specimen =
    "#define SQR(x) ((x)*(x))\n"
    "#if CANDELA > 0\n"
    "float turb(point p; uniform float n) { /* sum */\n"
    "  float sum = 0, i; for (i = 1; i < n; i += 1) sum += abs(.5 - noise(p * i)) / i;\n"
    "  return sum; }\n"
    "#endif\n"
    "untyped(color c; output float r[]) { r[0] = c[1]; return SQR(c); }\n"
    "surface lobes(float Kd = 0.4, exp = 2; color tint = color \"hsv\" (.1, .2, 1);\n"
    "    uniform point from = point \"world\" (0, 0, 0); output varying color aov[2] = {0, 1};) {\n"
    "  vector R = reflect(I, normalize(N)); color C = 0; float k[4] = {1, 2, 3, 4};\n"
    "  illuminance(\"a&-b\", P, 2, N, 180, 0, Kd, R, 180, exp, 1 - Kd) {\n"
    "    if (L.N < 0 || !(Kd >= 1)) continue; else C += Cl * pow(max(0, R.L), exp); }\n"
    "  illuminance(P, N, PI / 2) { C -= Cl; while (1) break 2; }\n"
    "  float inner(float x) { extern color C; return x + comp(C, 0); }\n"
    "  aov[1] = untyped(C, k) + inner(u ? 1 : turb(transform(\"shader\", P), 4));\n"
    "  matrix m = (1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1); C *= determinant(m) + k[2];\n"
    "  printf(\"%c %f\\n\", C, exp(1)); Ci = C * tint ^ from; Oi = spline(u, k); }\n"
    "light l(float i = 1) { illuminate(P, 1, N, 180, 1, i) { Cl = i / (L . L); } solar() Cl = 1; "
    "}\n";

void expectAnswer(const std::string &text) {
    Compiled compiled(text);
    EXPECT_NE(compiled.good(), compiled.diagnostics.count(Severity::Error) > 0) << text;
    if (compiled.good()) {
        EXPECT_FALSE(print(compiled.shader()).empty());
    }
}

TEST(Robustness, EveryPrefix) {
    for (size_t i = 0; i <= specimen.size(); ++i)
        expectAnswer(specimen.substr(0, i));
}

TEST(Robustness, EveryDeletedByte) {
    for (size_t i = 0; i < specimen.size(); ++i)
        expectAnswer(specimen.substr(0, i) + specimen.substr(i + 1));
}

TEST(Robustness, RandomMutations) {
    std::mt19937 random(7);
    auto below = [&](size_t n) { return size_t(random() % n); };
    for (int round = 0; round < 2000; ++round) {
        std::string text = specimen;
        for (size_t n = 1 + below(6); n > 0; --n) {
            size_t at = below(text.size()), length = 1 + below(20);
            switch (below(4)) {
            case 0: text[at] = char(random()); break;
            case 1: text.erase(at, length); break;
            case 2: text.insert(below(text.size()), text.substr(at, length)); break;
            case 3: text[at] = specimen[below(specimen.size())]; break;
            }
        }
        expectAnswer(text);
    }
}

TEST(Robustness, DeepAndLong) {
    std::string calls = "float f0(float x) { return x; }\n";
    for (int i = 1; i < 500; ++i)
        calls += "float f" + std::to_string(i) + "(float x) { return f" + std::to_string(i - 1) +
                 "(x) + f" + std::to_string(i - 1) + "(x); }\n";
    expectAnswer(calls + "surface s() { Ci = f499(u); }");
    std::string nested = "1";
    for (int i = 0; i < 60; ++i)
        nested = "noise(" + nested + " * u)";
    expectAnswer("surface s() { Ci = " + nested + "; }");
    std::string long1 = "u";
    for (int i = 0; i < 400; ++i)
        long1 += " + noise(u) * Cs";
    expectAnswer("surface s() { Ci = " + long1 + "; }");
    std::string many = "surface s() {";
    for (int i = 0; i < 20000; ++i)
        many += " Ci += u;";
    expectAnswer(many + "}");
}

} // namespace
} // namespace candela::sl
