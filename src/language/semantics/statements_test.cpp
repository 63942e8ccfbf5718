// SPDX-License-Identifier: Apache-2.0
// Whole shaders: statements, functions, light statements, and what real files do.
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "language/semantics/front_test_support.h"

namespace candela::sl {
namespace {

using test::Compiled;
using test::surfaceWith;

void expectBody(const std::string &text, const std::string &expected) {
    Compiled compiled(text);
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    std::string tree = compiled.tree();
    EXPECT_NE(tree.find(expected), std::string::npos) << tree << "\nshould hold\n" << expected;
}

TEST(Statements, Loops) {
    expectBody("surface s() { float i; for (i = 0; i < 3; i += 1) { if (i == 1) continue;"
               " while (1) break 2; } }",
               "  block\n"
               "    i = 0\n"
               "    loop (i < 3)\n"
               "      if (i == 1)\n"
               "        continue\n"
               "      loop 1\n"
               "        break\n"
               "    step i = (target + 1)\n");
    expectBody("surface s() { for (float i = 0; ; ) { Ci = i; break; } }",
               "  block\n    varying float i = 0\n    loop\n");
}

TEST(Statements, JumpsKnowTheirLoops) {
    Compiled compiled("surface s() { while (1) illuminance(P) { for (;;) { break 3; } continue; } "
                      "}");
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    const Stmt &outer = *compiled.shader().body.at(0);
    const Stmt &lights = *outer.body.at(0);
    const Stmt &inner = *lights.body.at(0);
    ASSERT_EQ(lights.kind, StmtKind::Illuminance);
    EXPECT_EQ(inner.body.at(0)->target, &outer);
    EXPECT_EQ(lights.body.at(1)->target, &lights);
}

TEST(Statements, LightForms) {
    const std::tuple<const char *, const char *, ConeForm> table[] = {
        {"illuminance(P) {}", "illuminance P\n", ConeForm::Everywhere},
        {"illuminance(\"a,-b\", P) {}", "illuminance \"a,-b\" P\n", ConeForm::Everywhere},
        {"illuminance(P, N, PI/2) {}", "illuminance P vector<N> (3.14159 / 2)\n",
         ConeForm::Classic},
        {"illuminance(P, vector (0,0,1), 1) {}", "illuminance P vector(0, 0, 1) 1\n",
         ConeForm::Classic},
        {"illuminance(P, (0,0,1), 1) {}", "illuminance P vector(0, 0, 1) 1\n", ConeForm::Classic},
        {"illuminance(P, 1, N, 180, 0, .5) {}", "illuminance P 1 [vector<N> 180 0 0.5]\n",
         ConeForm::Extended},
        {"illuminance(\"a\", P, p + 1, N, 180, 0, c, w, f, f, f) {}",
         "illuminance \"a\" P (p + 1) [vector<N> 180 0 c] [w f f f]\n", ConeForm::Extended},
        {"illuminance(P, 1, noise(P), noise(f), 0, noise(f)) {}",
         "illuminance P 1 [noise:vector(P) noise:float(f) 0 noise:float(f)]\n", ConeForm::Extended},
    };
    for (auto [text, expected, form] : table) {
        Compiled compiled(surfaceWith(text));
        ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
        EXPECT_NE(compiled.tree().find(expected), std::string::npos) << compiled.tree();
        EXPECT_EQ(compiled.shader().body.back()->light->form, form);
    }
}

TEST(Statements, LightShaders) {
    expectBody("light l(float i = 1; point from = point \"shader\" (0,0,0)) {\n"
               " illuminate(from) Cl = i / (L . L); }",
               "  illuminate from\n    Cl = color<(i / (L . L))>\n");
    expectBody("light l(float i = 1; vector d = (0,0,1)) { illuminate(P, N, PI/2) Cl = i;"
               " solar(d, 0) Cl = i; }",
               "  solar d 0\n    Cl = color<i>\n");
    expectBody("light l(float i = 1) { illuminate(P, 1, N, 180, 1, 1) { Cl = i; } }",
               "  illuminate P 1 [vector<N> 180 1 1]\n");
    expectBody("light l(float i = 1) { solar(1, N, 180, 1, 1) { Cl = i; } solar() { Cl = i; } }",
               "  solar 1 [vector<N> 180 1 1]\n");
    expectBody("light ambientlight(float i = 1; color lightcolor = 1) { Cl = i * lightcolor; }",
               "  Cl = (i * lightcolor)\n");
}

TEST(Statements, NestedFunctionsAndExtern) {
    expectBody("surface s(float Kd = 1) { float x = 0;\n"
               " void bump1(float by) { extern float x; x += by * Kd; }\n"
               " bump1(2); Ci = x; }",
               "  bump1(2)\n");
    expectBody("float scaled(float a) { extern float Kd; return a * Kd; }\n"
               "surface s(float Kd = 1) { Ci = scaled(u); }",
               "Ci = color<scaled(u)>\n");
    EXPECT_FALSE(Compiled("float scaled(float a) { return a * Kd; }\n"
                          "surface s(float Kd = 1) { Ci = scaled(u); }")
                     .good());
}

TEST(Statements, FunctionsTakeReferencesAndArrays) {
    expectBody("void split(color c; output float r; output float g) { r = c[0]; g = comp(c, 1); }\n"
               "float total(float a[]) { float i, s = 0;\n"
               "  for (i = 0; i < arraylength(a); i += 1) s += a[i]; return s; }\n"
               "surface s() { float x, k[2] = {1, 2}, m[3]; split(Cs, x, k[1]); m[0] = total(m);\n"
               "  Ci = x * total(k); }",
               "split(Cs, x, k[1])");
}

TEST(Statements, UntypedFunctions) {
    expectBody("half(point a) { return a / 2; }\nsurface s() { point h = half(P); Ci = h[0]; }",
               "point h = half(P)");
    expectBody("setup() { }\nsurface s() { setup(); }", "  setup()\n");
}

TEST(Statements, OneInstanceForEachDetail) {
    Compiled compiled("float f(float x) { return x * 2; }\n"
                      "surface s() { uniform float a = f(1); float b = f(u), c = f(v);"
                      " Ci = a + b + c; }");
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    EXPECT_EQ(compiled.shader().functions.size(), 2u);
    Compiled condition("float f(float x) { if (x > 0) return 1; return 0; }\n"
                       "surface s() { uniform float a = f(u); Ci = a; }");
    EXPECT_FALSE(condition.good()) << "what returns under varying control varies";
}

TEST(Statements, CalleesComeFirst) {
    Compiled compiled("float a(float x) { return b(x); } float b(float x) { return x; }\n"
                      "surface s() { Ci = a(1); }");
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    EXPECT_EQ(compiled.shader().functions.at(0)->name, "b");
}

// The constructs of the paper's figure 2: numeric cones, a parameter that hides exp(), continue in
// the loop, points that serve as vectors.
TEST(Shaders, PaperStyleCones) {
    Compiled compiled("surface lobes(float diff = 0.3; /* broad */ float spec = 0.7; /* narrow */\n"
                      "              float exp = 4) /* lobe */\n"
                      "{\n"
                      "  point normal1 = normalize(N); point toEye = normalize(-I);\n"
                      "  point mirror = reflect(toEye, normal1); point toLight; color sum = 0;\n"
                      "  illuminance(P, 2, /* two cones */ N, 180, 0, diff,\n"
                      "              mirror, 180, exp, spec)\n"
                      "  {\n"
                      "    toLight = normalize(L);\n"
                      "    if ((toLight.normal1) < 0) continue;\n"
                      "    sum += spec*Cl*pow(mirror.toLight, exp);\n"
                      "    sum += diff*Cl*(toLight.normal1);\n"
                      "  }\n"
                      "  Ci = Cs*sum; Oi = Os;\n"
                      "}\n");
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    EXPECT_EQ(compiled.diagnostics.text(), "");
    EXPECT_EQ(compiled.shader().parameters.at(2).doc, "lobe");
    const Stmt &loop = *compiled.shader().body.at(5);
    ASSERT_EQ(loop.kind, StmtKind::Illuminance);
    EXPECT_EQ(loop.light->cones.size(), 2u);
    EXPECT_EQ(loop.light->cones[1].exponent->symbol->name, "exp");
}

TEST(Shaders, OddFiles) {
    const char *table[] = {
        "surface null() { }",
        "surface x() { Ci = Os[0] * N[2]; }",
        "surface x(float exp = 1; float light = 2; string incident = \"\")\r\n{\r\n"
        "\tpoint normal = exp * light * N;\r\n\tnormal = normalize(normal);\r\n"
        "\tCi = exp(normal.normal) + (incident == \"a\");\r\n}",
        "/* \xe4 */ surface x() { Ci = 1; } // \xff",
        "surface x(float a = 1, float b = 2;) { Ci = a * b; }",
        "surface x() { uniform string s = concat(\"a\", \"b\"); printf(\"%s\\n\", s); }",
        "displacement d(float Km = 1) { P += Km * noise(P) * normalize(N); N = calculatenormal(P); "
        "}",
        "volume v(float k = 1) { Ci = mix(Ci, color(1,1,1), k * length(I)); Oi = Oi; }",
        "imager i(color bg = 0) { Ci += (1 - Oi) * bg; Oi = 1; alpha = 1; }",
        "transformation t(float k = 1) { P = k * P; N = N; }",
        "filter f(float k = 1) { float x; for (x = 0; x < xsize; x += 1) printf(\"%f\", k); }",
        "surface bounded() { Ci = 1; DCiDu = 0; TCiDu = .1 * Du; TCiDw = Dw; }",
        "surface e() { Ci = irradiance(P, -I) / PI + radiometric(photometric(Cs)); }",
        "light area(float e = 1) { illuminate(P, 1, N, 180, 1, 1) Cl = e; }",
        "#define SQR(x) ((x)*(x))\nsurface x() { float a; Ci = SQR(a = u); }",
        "surface x() { uniform float n; for (n = 0; n < 3; n += 1) { if (u > n) break; } Ci = n; }",
    };
    for (const char *text : table) {
        Compiled compiled(text);
        EXPECT_TRUE(compiled.good()) << text << "\n" << compiled.diagnostics.text();
        EXPECT_EQ(compiled.diagnostics.count(Severity::Error), 0);
    }
}

TEST(Shaders, ParametersKeepWhatWasSaid) {
    Compiled compiled("surface s(float a[3] = {1, 2}; // some numbers\n"
                      "          output varying color aov = 0; string map = \"x\" \"y\";\n"
                      "          point from = point \"world\" (0, 0, 1) + (1, 0, 0)) {\n"
                      "  aov = a[0] * from[0]; if (map == \"\") aov = 1; }");
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    const auto &p = compiled.shader().parameters;
    ASSERT_EQ(p.size(), 4u);
    EXPECT_EQ(nameOf(p[0].symbol->type), "uniform float[3]");
    EXPECT_EQ(p[0].defaults.size(), 2u);
    EXPECT_EQ(p[0].doc, "some numbers");
    EXPECT_TRUE(p[1].symbol->output && p[1].symbol->type.isVarying());
    EXPECT_EQ(print(*p[1].defaults[0]), "color<0>");
    EXPECT_EQ(p[2].defaults[0]->text, "xy");
    EXPECT_EQ(print(*p[3].defaults[0]), "(point<point(0, 0, 1) from \"world\"> + point(1, 0, 0))");
}

TEST(Shaders, ShadowingOfPredefinedNamesAndOuterOnes) {
    expectBody("surface s() { float x = 1; { float x = x + 1; Ci = x; } Oi = x; }",
               "    varying float x = (x + 1)\n");
    Compiled compiled("surface s(float s = 3) { float u = s; Ci = u; }");
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    EXPECT_EQ(compiled.shader().body.at(1)->value->operands[1]->operands[0]->symbol->kind,
              Symbol::Kind::Local);
}

TEST(Shaders, IncludesAreNamed) {
    auto folder = std::filesystem::path(testing::TempDir()) / "candela_front_include";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "lib.h") << "float twice(float x) { return 2 * x; }\n"
                                       "float onlyForLights() { return length(Ps); }\n";
    FrontOptions options{{folder.string()}, {{"GAIN", "3"}}};
    Compiled compiled("#include \"lib.h\"\nsurface s() { Ci = twice(GAIN); }", options);
    EXPECT_TRUE(compiled.good()) << compiled.diagnostics.text();
    ASSERT_EQ(compiled.front->includedFiles.size(), 1u);
    EXPECT_EQ(compiled.front->includedFiles[0], (folder / "lib.h").string());
    std::filesystem::remove_all(folder);
}

} // namespace
} // namespace candela::sl
