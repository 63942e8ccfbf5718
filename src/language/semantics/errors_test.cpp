// SPDX-License-Identifier: Apache-2.0
// Every class of error, with its text and its place.
#include <gtest/gtest.h>

#include "language/semantics/front_test_support.h"
#include "language/syntax/reporter.h"

namespace candela::sl {
namespace {

using test::Compiled;
using test::surfaceWith;

struct Mistake {
    const char *text;
    const char *expected; ///< From the column on: "3: error: ..."
};

// The statement stands in line 2, from column 1.
void expectInSurface(const Mistake &mistake) {
    Compiled compiled(surfaceWith(mistake.text));
    std::string message = compiled.firstMessage(), head = "test.sl:2:";
    EXPECT_FALSE(compiled.good() && message.find("warning") == message.npos) << mistake.text;
    EXPECT_EQ(message, head + mistake.expected) << mistake.text;
}

TEST(Errors, NamesAndTypes) {
    const Mistake table[] = {
        {"f = wobble(N);",
         "5: warning: unknown function 'wobble' is taken for an external function "
         "of another renderer: its calls give 0; no header was read"},
        {"c = caustic(P, N);",
         "5: warning: function caustic() is known and gives 0: photon maps are not supported; the "
         "integrators path and bidir bring their light."},
        {"w = normalise(N);", "5: error: unknown function 'normalise'; did you mean 'normalize'?"},
        {"f = zzz;", "5: error: unknown variable 'zzz'"},
        {"f = nmae;", "5: error: unknown variable 'nmae'; did you mean 'name'?"},
        {"zzz = 1;", "1: error: unknown variable 'zzz'"},
        {"f = Ns;", "5: error: unknown variable 'Ns' in a surface shader; light shaders have it"},
        {"f = w;", "5: error: what is assigned here must be a float, not a vector; did you mean "
                   "length(), xcomp() or a dot product?"},
        {"f = name;", "5: error: what is assigned here must be a float, not a string"},
        {"c = q;", "5: error: what is assigned here must be a color, not a point; a cast says "
                   "that it is meant"},
        {"c = c + q;", "7: error: operator '+' cannot be applied to color and point"},
        {"f = c < q;", "7: error: operator '<' cannot be applied to color and point"},
        {"c ^= c;", "4: error: expected an expression, not '='"},
        {"m += c;", "3: error: operator '+=' cannot be applied to matrix and color"},
        {"f = c ? 1 : 2;", "5: error: the condition of '?:' must be a float, not a color; comp() "
                           "takes one component"},
        {"f = f ? 1 : name;", "7: error: the branches of '?:' have no common type: float and "
                              "string"},
        {"f = -name;", "5: error: '-' cannot be applied to a string"},
        {"f = float w;", "5: error: a vector cannot be cast to a float; did you mean length(), "
                         "xcomp() or a dot product?"},
        {"f = float \"world\" 1;", "11: error: a float is in no space; only color, point, vector, "
                                   "normal and matrix are"},
        {"f = spline(\"bezir\", f, a);", "12: error: unknown spline basis \"bezir\"; expected "
                                         "catmull-rom, bezier, bspline, hermite, linear or power"},
        {"f = a;", "5: error: array a needs an index here"},
        {"f = a[3];", "7: error: index is outside of array a; expected 0 to 2"},
        {"f = c[3];", "7: error: index is outside of a color; expected 0 to 2"},
        {"f = a[-3];", "7: error: index is outside of array a; expected 0 to 2"},
        {"f = a[2 + 1];", "9: error: index is outside of array a; expected 0 to 2"},
        {"f = c[-1];", "7: error: index is outside of a color; expected 0 to 2"},
        {"f = comp(c, 7);", "13: error: index is outside of a color; expected 0 to 2"},
        {"f = comp(m, 0, 4);", "16: error: index is outside of a matrix; expected 0 to 3"},
        {"setcomp(c, -1, 1);", "12: error: index is outside of a color; expected 0 to 2"},
        {"f = m[0];", "6: error: only arrays, colors, points, vectors and normals can be indexed, "
                      "not a matrix"},
        {"a = 1;", "3: error: an array cannot be assigned as a whole"},
        {"f + 1 = 2;", "3: error: only variables, array elements and components can be assigned"},
        {"PI = 3;", "1: error: PI is a constant and cannot be assigned"},
        {"p = 2;", "1: warning: parameter p is assigned, but not declared output; only this shader "
                   "sees the change"},
        {"Cs = 1;", "1: warning: Cs is not for a surface shader to assign; only this shader sees "
                    "the change"},
        {"shader x;", "1: error: the type shader is of RSL 2.0 (shader classes, structures, shader "
                      "objects, arrays that grow), which Candela does not support; a shader of "
                      "RenderMan's first Shading Language can say the same"},
        {"float b[];", "7: error: array b needs a length or initial values; an array that grows is "
                       "of RSL 2.0, which Candela does not support"},
        {"float f = 1;", "7: error: f is declared in line 1 already"},
        {"float b[2] = {1, 2, 3};", "21: warning: more initial values than array b has elements "
                                    "(2): those from here on are left out"},
        {"f = ycomp(c);", "5: warning: ycomp() is about vectors: of a color it gives what comp() "
                          "does, component 1"},
        {"float b[2] = 1;", "7: error: the initial values of array b must stand in { }"},
        {"float b = {1};", "7: error: only arrays take initial values in { }"},
        {"float b[f];", "9: error: the length of array b must be a whole number from 1 to 65536, "
                        "known at compile time"},
        {"float b[-----------------------------------------1];", // Its cost once doubled a sign.
         "9: error: the length of array b must be a whole number from 1 to 65536, known at compile "
         "time"},
        {"float b[1000000000];", "9: error: the length of array b must be a whole number from 1 to "
                                 "65536, known at compile time"},
        {"f = sin(1, 2);", "5: error: sin cannot be called with (float, float); expected float "
                           "sin(float angle)"},
        {"f = length(name);", "5: error: length cannot be called with (string); expected float "
                              "length(vector v)"},
        {"setxcomp(P + Q2, 1);", "14: error: unknown variable 'Q2'"},
        {"setxcomp(q + q, 1);", "1: error: setxcomp cannot be called with (point, float); expected "
                                "void setxcomp(output vector v, float x)"},
        {"gather(\"a\", P, N) { }", "1: error: gather needs a category, a position, a direction, "
                                    "an angle and a number of samples"},
        {"gather(\"a\", P, N, 1, 2, f) { }",
         "25: error: behind the number of samples gather takes pairs of a name (a string constant) "
         "and a value"},
        {"f = name[0];", "9: error: a string cannot be indexed; a texture's channel, as in "
                         "name[0], stands only as the first argument of texture(), environment(), "
                         "shadow() or bump()"},
        {"printf(\"%f %f\", f);", "1: warning: the pattern of printf asks for 2 values, but 1 are "
                                  "given; it prints nothing"},
        {"printf(\"%s\", f);",
         "14: warning: '%s' in the pattern of printf cannot print a float; it "
         "prints nothing"},
        {"extern float zz;", "14: error: extern variable zz is not known outside of here"},
        {"extern color P;", "14: error: extern variable P is a point where it is defined"},
        {"c = (1, w, 2);", "9: error: a component of a tuple must be a float, not a vector; did "
                           "you mean length(), xcomp() or a dot product?"},
        {"f = !name;", "6: error: the operand of '!' must be a float, not a string"},
        {"f = f && name;", "7: error: operator '&&' cannot be applied to float and string"},
        {"c = c . name;", "7: error: operator '.' cannot be applied to color and string"},
        {"f = q ? 1 : 2;", "5: error: the condition of '?:' must be a float, not a point; did you "
                           "mean length(), xcomp() or a dot product?"},
        {"f += name;", "3: error: operator '+=' cannot be applied to float and string"},
        {"string t[2] = {\"a\", 1};",
         "21: error: the initial value of t must be a string, not a float"},
    };
    for (const Mistake &mistake : table)
        expectInSurface(mistake);
}

TEST(Errors, UniformAndVarying) {
    const Mistake table[] = {
        {"uniform float x = u;", "19: error: a varying value cannot be assigned to uniform float "
                                 "x; declare it varying"},
        {"uniform float x; x = p; x += u;", "27: error: a varying value cannot be assigned to "
                                            "uniform float x; declare it varying"},
        {"uniform float b[2]; b[0] = u;", "26: error: a varying value cannot be assigned to "
                                          "uniform float b; declare it varying"},
        {"uniform float b[2]; b[u] = 1;", "26: error: a varying value cannot be assigned to "
                                          "uniform float b; declare it varying"},
        {"varying string x = \"a\"; q = transform(x, q);",
         "39: error: argument 'to' of transform must be uniform"},
        {"float g(uniform float x) { return x; } f = g(u);",
         "46: error: argument 'x' of g must be uniform"},
        {"uniform float x; setcomp(c, 0, 1); fresnel(I, N, 1, x, f);",
         "53: error: a varying value cannot be assigned to uniform float x; declare it varying"},
    };
    for (const Mistake &mistake : table)
        expectInSurface(mistake);
}

TEST(Errors, ControlAndFunctions) {
    const Mistake table[] = {
        {"break;", "1: error: 'break' stands in no loop"},
        {"while (f) { continue 2; }", "13: error: 'continue 2' wants more loops than stand around "
                                      "it: 1"},
        {"return 1;", "8: error: a shader returns no value"},
        {"if (w) f = 1;", "5: error: a condition must be a float, not a vector; did you mean "
                          "length(), xcomp() or a dot product?"},
        {"float g(float x) { return g(x - 1); } f = g(2);",
         "27: error: function g calls itself; the Shading Language has no recursion"},
        {"g(float x) { return g(x); } f = g(2);",
         "21: error: function g calls itself; the Shading Language has no recursion"},
        {"float g(float x) { x = 1; return x; }",
         "20: warning: argument x is assigned, but not declared output; the caller's value stays "
         "as it is"},
        {"void g() { return 1; }", "19: error: void function g cannot return a value"},
        {"float g() { return; }", "13: error: function g must return a float"},
        {"float g() { return c; }", "20: error: what g returns must be a float, not a color; "
                                    "comp() takes one component"},
        {"float g(float x) { return 1; } float g(float y) { return 2; }",
         "38: warning: function g with these arguments is defined again: this definition counts, "
         "not that in test.sl, line 2"},
        {"void g(output float x) { x = 1; } g(1);",
         "35: error: g cannot be called with (float); expected void g(output float x)"},
        {"void g(output float x) { x = 1; } g(p);",
         "37: warning: parameter p is assigned, but not declared output; only this shader sees the "
         "change"},
        {"float g(float x[3]) { return x[0]; } float b[2] = {1, 2}; f = g(b);",
         "15: error: array argument x is given an array of another length: 2"},
        {"float g(float x = 1) { return x; } f = g(1);",
         "15: error: arguments of functions have no default values"},
        {"float g(float x[3]) { return x[0]; } f = g(f);",
         "42: error: g cannot be called with (float); expected float g(float x[])"},
        {"float g() { extern float f; float f = 1; return f; } f = g();",
         "35: error: f is declared in line 1 already"},
        {"float g() { float p; extern float p; return p; } f = g();",
         "35: error: p is declared here already"},
        {"float g() { } f = g();", "7: warning: function g returns no value; its result is 0"},
    };
    for (const Mistake &mistake : table)
        expectInSurface(mistake);
}

TEST(Errors, LightStatements) {
    const Mistake table[] = {
        {"illuminance() { }", "1: error: illuminance needs a position"},
        {"illuminance(P, 1) { }", "16: error: behind the number of cones illuminance takes exactly "
                                  "4 arguments a cone (axis, "
                                  "angle in degrees, exponent, importance); 0 are given"},
        {"illuminance(P, 1, N, 180, 0) { }",
         "16: error: behind the number of cones illuminance takes exactly 4 arguments a cone "
         "(axis, "
         "angle in degrees, exponent, importance); 3 are given"},
        {"illuminance(P, 2, N, 180, 0, 1) { }",
         "16: error: illuminance announces more cones than the 1 that follow"},
        {"illuminance(P, N) { }",
         "16: error: the classic form of illuminance takes an axis and an angle, not 1 arguments "
         "here; with a number of cones first it takes 4 arguments a cone"},
        {"illuminance(P, 1, 1, N, 0, 1) { }", "22: error: the angle of a cone must be a float, not "
                                              "a normal; did you mean length(), xcomp() or a dot "
                                              "product?"},
        {"illuminance(c) { }", "13: error: the position of illuminance must be a point, not a "
                               "color; a cast says that it is meant"},
        {"illuminance(P) { illuminance(P) { } }",
         "18: error: illuminance cannot stand inside another light statement"},
        {"color g() { color r = 0; illuminance(P) r += Cl; return r; } illuminance(P) c = g();",
         "81: error: function g has a light statement and cannot be called inside another"},
        {"illuminate(P) { }", "1: error: illuminate stands only in light shaders, not in a surface "
                              "shader"},
        {"solar() { }", "1: error: solar stands only in light shaders, not in a surface shader"},
        {"illuminance(P, 1, N, 3.1416, 0, 1) { }",
         "22: warning: the angle of a cone is its full opening in degrees; this looks like "
         "radians"},
        {"illuminance(P, 1, N, 2*PI, 0, 1) { }",
         "23: warning: the angle of a cone is its full opening in degrees; this looks like "
         "radians"},
        {"f = comp(Cl, 0);",
         "10: warning: Cl has a value only inside an illuminance, illuminate or "
         "solar statement; here it is 0"},
        {"illuminance(P, N, 45) { }",
         "19: warning: the angle of illuminance is half of the cone in "
         "radians; this looks like degrees"},
        {"f = sin(45);", "9: warning: the angle of sin() is in radians; this looks like degrees"},
        {"q = rotate(q, degrees(1), P, P + N);",
         "15: warning: the angle of rotate() is in radians; this looks like degrees"},
        {"f == 1;", "3: warning: this expression has no effect"},
        {"if (f = 1) c = 1;", "7: warning: '=' assigns; did you mean '=='?"},
        {"varying string v = name; illuminance(v, P) { }",
         "38: error: the category of illuminance must be uniform"},
        {"illuminance(P, c, 1) { }", "16: error: the axis of illuminance must be a vector, not a "
                                     "color; a cast says that it is meant"},
        {"illuminance(P, N, c) { }", "19: error: the angle of illuminance must be a float, not a "
                                     "color; comp() takes one component"},
        {"illuminance(P, 1, c, 1, 0, 1) { }", "19: error: the axis of a cone must be a vector, not "
                                              "a color; a cast says that it is meant"},
        {"illuminance(P, 1, N, 1, w, 1) { }",
         "25: error: the exponent of a cone must be a float, not a vector; did you mean length(), "
         "xcomp() or a dot product?"},
        {"illuminance(P, 1, N, 1, 0, name) { }",
         "28: error: behind the cones illuminance takes pairs of a name (a string constant, such "
         "as \"light:NAME\") and a value"},
    };
    for (const Mistake &mistake : table)
        expectInSurface(mistake);
    EXPECT_EQ(Compiled("light l() { illuminance(P) { } }").firstMessage(),
              "test.sl:1:13: error: illuminance stands only in surface and volume shaders, not in "
              "a light shader");
    for (const std::string angle : {"degrees(PI)", ".53", "1", "6"})
        EXPECT_EQ(Compiled(surfaceWith("illuminance(P, 1, N, " + angle + ", 0, 1) { }"))
                      .diagnostics.text()
                      .find("radians"),
                  std::string::npos)
            << angle;
}

TEST(Errors, OfShaders) {
    const std::pair<const char *, const char *> table[] = {
        {"", "test.sl:1:1: error: the file holds no shader"},
        {"float f(float x) { return x; }", "test.sl:1:1: error: the file holds no shader"},
        {"surface s() {} surface s() {}",
         "test.sl:1:24: error: a shader named s stands in this file already"},
        {"surface s(float a = 1; float a = 2) {}",
         "test.sl:1:30: error: a is declared in line 1 already"},
        {"class a() { public void surface(output color Ci, Oi) { } }",
         "test.sl:1:1: error: class a is of RSL 2.0 (shader classes, structures, shader objects, "
         "arrays that grow), which Candela does not support; a shader of RenderMan's first Shading "
         "Language can say the same"},
        {"surface s(float a;) { Ci = a; }",
         "test.sl:1:17: warning: parameter a has no default; it is 0"},
        {"surface s() { float b; Ci = b; }",
         "test.sl:1:21: warning: variable b is read, but never set: it is 0"},
        {"surface s() { float b; }", "test.sl:1:21: warning: variable b is never used"},
        {"surface s(float a = 1;) { }", "test.sl:1:17: warning: parameter a is never used"},
        {"float f() { return zz; } surface s() { }", "test.sl:1:20: error: unknown variable 'zz'"},
    };
    for (auto [text, expected] : table)
        EXPECT_EQ(Compiled(text).firstMessage(), expected) << text;
}

TEST(Errors, AllOfAFileInOneRunWithCarets) {
    Compiled compiled("surface s(float Kd = 1; color tint = P)\n"
                      "{\n"
                      "    color c = difuse(N);\n"
                      "    float x = c;\n"
                      "    y = 2\n"
                      "    Ci = tint * c + Kd * N;\n"
                      "}\n");
    EXPECT_FALSE(compiled.good());
    EXPECT_EQ(compiled.diagnostics.text(),
              "test.sl:5:10: error: expected ';' after the expression\n"
              "        y = 2\n"
              "             ^\n"
              "test.sl:1:38: error: the initial value of tint must be a color, not a point; a cast "
              "says that it is meant\n"
              "    surface s(float Kd = 1; color tint = P)\n"
              "                                         ^\n"
              "test.sl:3:15: error: unknown function 'difuse'; did you mean 'diffuse'?\n"
              "        color c = difuse(N);\n"
              "                  ^~~~~~\n"
              "test.sl:4:15: error: the initial value of x must be a float, not a color; comp() "
              "takes one component\n"
              "        float x = c;\n"
              "                  ^\n"
              "test.sl:5:5: error: unknown variable 'y'\n"
              "        y = 2\n"
              "        ^\n"
              "test.sl:6:19: error: operator '+' cannot be applied to color and normal\n"
              "        Ci = tint * c + Kd * N;\n"
              "                      ^\n");
}

TEST(Errors, AFileDoesNotFloodWithWarnings) {
    std::string text = "surface s() { Ci = 1;";
    for (int i = 0; i < 1000; ++i)
        text += " float x" + std::to_string(i) + " = u;";
    Compiled compiled(text + " }");
    EXPECT_TRUE(compiled.good());
    EXPECT_EQ(compiled.diagnostics.count(Severity::Warning), Reporter::warningLimit + 1);
    EXPECT_EQ(compiled.diagnostics.all().back().message,
              "too many warnings; the rest is not shown");
}

} // namespace
} // namespace candela::sl
