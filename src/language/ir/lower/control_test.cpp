// SPDX-License-Identifier: Apache-2.0
// Control flow against the same text in C++.
#include "language/ir/lower/test_support.h"

#include <cmath>

namespace candela::ir {
namespace {

struct Case {
    const char *name;
    const char *body;
    float (*expected)(float u, float v);
    const char *before = "";
};

const Case cases[] = {
    {"assignment", "float x = u; x += v; x *= 2; result = x - 1;",
     [](float u, float v) { return (u + v) * 2 - 1; }},
    {"localsStartAtZero", "float x; color c[3]; result = x + comp(c[2], 1);",
     [](float, float) { return 0.0f; }},
    {"ifElse", "if (u > 0) result = u; else if (v > 0) result = 2; else result = 3;",
     [](float u, float v) { return u > 0   ? u
                                   : v > 0 ? 2.0f
                                           : 3.0f; }},
    {"nestedIf", "float a = 1; if (u > 0) { if (v > 0) a = 5; else a += u; a += 1; } result = a;",
     [](float u, float v) {
         float a = 1;
         if (u > 0) {
             if (v > 0)
                 a = 5;
             else
                 a += u;
             a += 1;
         }
         return a;
     }},
    {"whileLoop", "float x = abs(u); while (x < 4) x = x * 2 + 1; result = x;",
     [](float u, float) {
         float x = std::fabs(u);
         while (x < 4)
             x = x * 2 + 1;
         return x;
     }},
    {"forLoop", "float i; for (i = 0; i < 5; i += 1) result += i * u;",
     [](float u, float) {
         float r = 0;
         for (float i = 0; i < 5; i += 1)
             r += i * u;
         return r;
     }},
    {"varyingTripCount", "float i; for (i = 0; i < 10 * abs(u); i += 1) result += i;",
     [](float u, float) {
         float r = 0;
         for (float i = 0; i < 10 * std::fabs(u); i += 1)
             r += i;
         return r;
     }},
    {"breakAndContinue",
     "float i; for (i = 0; i < 10; i += 1) { if (mod(i, 2) == 1) continue; "
     "if (i > 10 * u) break; result += i; }",
     [](float u, float) {
         float r = 0;
         for (float i = 0; i < 10; i += 1) {
             if (std::fmod(i, 2.0f) == 1)
                 continue;
             if (i > 10 * u)
                 break;
             r += i;
         }
         return r;
     }},
    {"breakTwo",
     "float i, j; for (i = 0; i < 4; i += 1) { for (j = 0; j < 4; j += 1) { "
     "if (i * j > 4 * u) break 2; if (j > 4 * v) break; result += 1; } result += 10; }",
     [](float u, float v) {
         float r = 0;
         bool done = false;
         for (float i = 0; i < 4 && !done; i += 1) {
             for (float j = 0; j < 4; j += 1) {
                 if (i * j > 4 * u) {
                     done = true;
                     break;
                 }
                 if (j > 4 * v)
                     break;
                 r += 1;
             }
             if (!done)
                 r += 10;
         }
         return r;
     }},
    {"continueTwo",
     "float i, j; for (i = 0; i < 4; i += 1) { for (j = 0; j < 4; j += 1) { "
     "if (j > 4 * v) continue 2; result += 1; } result += 10; }",
     [](float, float v) {
         float r = 0;
         for (float i = 0; i < 4; i += 1) {
             bool next = false;
             for (float j = 0; j < 4 && !next; j += 1) {
                 if (j > 4 * v)
                     next = true;
                 else
                     r += 1;
             }
             if (!next)
                 r += 10;
         }
         return r;
     }},
    {"returnFromShader", "result = 1; if (u > 0) { result = 2; return; } result += v;",
     [](float u, float v) { return u > 0 ? 2.0f : 1 + v; }},
    {"returnFromLoop",
     "float i; for (i = 0; i < 5; i += 1) { if (i > 5 * u) return; result += 1; } result += 100;",
     [](float u, float) {
         float r = 0;
         for (float i = 0; i < 5; i += 1) {
             if (i > 5 * u)
                 return r;
             r += 1;
         }
         return r + 100;
     }},
    {"shortCircuit",
     "float x = 0; if (u > 0 && (x += 1) > 0) result = 10; "
     "if (v > 0 || (x += 2) > 0) result += 20; result += x;",
     [](float u, float v) {
         float x = 0, r = 0;
         if (u > 0 && (x += 1) > 0)
             r = 10;
         if (v > 0 || (x += 2) > 0)
             r += 20;
         return r + x;
     }},
    {"conditional", "result = u > v ? u : v > 0.5 ? 2 : -v;",
     [](float u, float v) { return u > v      ? u
                                   : v > 0.5f ? 2
                                              : -v; }},
    {"conditionalEffects", "float x = 1; result = u > 0 ? (x = 5) : (x = v); result += x;",
     [](float u, float v) { return u > 0 ? 10.0f : v + v; }},
    {"truthAsNumber", "result = (u > 0) + 2 * (v <= 0) + 4 * (!(u > 0));",
     [](float u, float v) { return float(u > 0) + 2 * float(v <= 0) + 4 * float(!(u > 0)); }},
    {"condition", "if (floor(2 * u)) result = 1;",
     [](float u, float) { return std::floor(2 * u) != 0 ? 1.0f : 0.0f; }},
    {"arrayOfValues", "float a[3] = {1, u, v}; a[0] += a[1]; result = a[0] * a[2];",
     [](float u, float v) { return (1 + u) * v; }},
    {"arrayInMemory",
     "float a[5]; float i; for (i = 0; i < 5; i += 1) a[i] = i * u; "
     "a[2] = 7; for (i = 0; i < 5; i += 1) result += (i + 1) * a[4 - i];",
     [](float u, float) {
         float a[5], r = 0;
         for (int i = 0; i < 5; ++i)
             a[i] = float(i) * u;
         a[2] = 7;
         for (int i = 0; i < 5; ++i)
             r += float(i + 1) * a[4 - i];
         return r;
     }},
    {"arrayIndexClamped", "float a[3] = {1, 2, 3}; result = a[100 * u];",
     [](float u, float) {
         return std::array<float, 3>{1, 2, 3}[size_t(std::clamp(int(100 * u), 0, 2))];
     }},
    {"componentOfPoint",
     "point p = point(1, u, v); setycomp(p, 3); result = p[0] + ycomp(p) * p[2];",
     [](float, float v) { return 1 + 3 * v; }},
    {"computedComponent",
     "color c = color(1, 2, 4); setcomp(c, 3 * abs(u), v); "
     "result = comp(c, 0) + 10 * comp(c, 1) + 100 * comp(c, 3 * abs(v));",
     [](float u, float v) {
         float c[3] = {1, 2, 4};
         c[std::clamp(int(3 * std::fabs(u)), 0, 2)] = v;
         return c[0] + 10 * c[1] + 100 * c[std::clamp(int(3 * std::fabs(v)), 0, 2)];
     }},
    {"function", "result = twice(u) + twice(twice(v));",
     [](float u, float v) { return 2 * u + 4 * v; }, "float twice(float x) { return 2 * x; } "},
    {"earlyReturn", "result = pick(u, v);",
     [](float u, float v) {
         if (u > 0)
             return 1.0f;
         for (float i = 0; i < 3; i += 1)
             if (v < i / 3)
                 return i;
         return -1.0f;
     },
     "float pick(float x; float y) { if (x > 0) return 1; float i; "
     "for (i = 0; i < 3; i += 1) { if (y < i / 3) return i; } return -1; } "},
    {"outputArguments", "float a = u, b = v; order(a, b); result = a - 3 * b;",
     [](float u, float v) { return std::min(u, v) - 3 * std::max(u, v); },
     "void order(output float x; output float y) { if (x > y) { float z = x; x = y; y = z; } } "},
    {"outputElement",
     "float a[2] = {1, 2}; bump(a[1]); point p = 0; bump(p[2]); "
     "result = a[1] + 10 * p[2];",
     [](float, float) { return 3.0f + 10; }, "void bump(output float x) { x += 1; } "},
    {"arrayArgument", "float a[4] = {1, 2, u, v}; result = total(a);",
     [](float u, float v) { return 1 + 2 + u + v; },
     "float total(float a[4]) { float i, sum = 0; for (i = 0; i < 4; i += 1) sum += a[i]; "
     "return sum; } "},
    {"compoundOnce",
     "float i = 0; float a[3] = {1, 2, 3}; a[(i += 1)] += 5; "
     "result = a[0] + 10 * a[1] + 100 * i;",
     [](float, float) { return 1.0f + 70 + 100; }},
    {"whileWithEffects", "float x = 0; while ((x += 1) < 5) result += x;",
     [](float, float) { return 10.0f; }},
    {"loopInBranch", "float i; if (u > 0) for (i = 0; i < 3; i += 1) result += v; else result = 9;",
     [](float u, float v) {
         float r = 0;
         if (u <= 0)
             return 9.0f;
         for (int i = 0; i < 3; ++i)
             r += v;
         return r;
     }},
    {"constantsInLoops",
     "string space = \"current\"; float i; "
     "for (i = 0; i < 2; i += 1) result += xcomp(transform(space, point(u, 0, 0)));",
     [](float u, float) { return 0 + u + u; }},
};

TEST(LowerControl, AgreesWithCpp) {
    for (const Case &c : cases) {
        SCOPED_TRACE(c.name);
        ShaderRun run(surfaceWith("float", c.body, c.before));
        ASSERT_TRUE(run.lowered) << run.diagnostics.text();
        const auto result = run.run().at("result")[0];
        for (int lane = 0; lane < run.batch->count; ++lane) {
            const float u = float(run.input(ShaderInput::u, lane));
            const float v = float(run.input(ShaderInput::v, lane));
            EXPECT_FLOAT_EQ(result[size_t(lane)], c.expected(u, v)) << "lane " << lane;
        }
    }
}

TEST(LowerControl, ConstantLoopsStayUniform) {
    ShaderRun run(surfaceWith("float", "float i; for (i = 0; i < 3; i += 1) result += u;"));
    ASSERT_TRUE(run.lowered);
    for (const Instruction &i : run.lowered->whole.body.body)
        if (i.op == Op::Loop) {
            EXPECT_EQ(int(run.lowered->whole.values[i.regions[0].arguments[0]].uniformity),
                      int(Uniformity::Uniform));
        }
}

TEST(LowerControl, IndicesSurelyOutsideAreErrors) {
    ShaderRun run(surfaceWith("float", "float a[3] = {1, 2, 3}; result = a[3];"));
    EXPECT_FALSE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("outside"), std::string::npos) << run.diagnostics.text();
}

} // namespace
} // namespace candela::ir
