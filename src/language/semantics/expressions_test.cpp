// SPDX-License-Identifier: Apache-2.0
// Overloads, promotions and conversions, by the typed tree that comes out.
#include <gtest/gtest.h>

#include "language/semantics/front_test_support.h"

namespace candela::sl {
namespace {

using test::Compiled;
using test::surfaceWith;

// The last statement of a surface shader, printed.
std::string lastOf(const std::string &statement) {
    Compiled compiled(surfaceWith(statement));
    if (!compiled.good())
        return compiled.firstMessage();
    std::string text = compiled.tree();
    size_t end = text.find("function ");
    text = text.substr(0, end == text.npos ? text.size() : end);
    size_t start = text.rfind('\n', text.size() - 2);
    return text.substr(start + 3, text.size() - start - 4);
}

TEST(Expressions, OverloadsAndPromotions) {
    const std::pair<const char *, const char *> table[] = {
        // The context chooses among results.
        {"f = noise(f);", "f = noise:float(f)"},
        {"c = noise(f);", "c = noise:color(f)"},
        {"q = noise(q);", "q = noise:point(q)"},
        {"w = noise(q, f);", "w = noise:vector(q, f)"},
        {"c = noise(q) * 0.5;", "c = color<(noise:float(q) * 0.5)>"},
        {"f = 2 * noise(w) - 1;", "f = ((2 * noise:float(point<w>)) - 1)"},
        {"q = q + noise(q) * w;", "q = (q + (noise:float(q) * w))"},
        {"c = c * noise(q);", "c = (c * noise:color(q))"},
        {"c = float noise(q);", "c = color<noise:float(q)>"},
        {"c = c * color noise(q);", "c = (c * noise:color(q))"},
        {"w = normalize(noise(q));", "w = normalize:vector(noise:vector(q))"},
        {"if (noise(q) > .5) f = 1;", "  f = 1"},
        {"printf(\"%f\", noise(q));", "printf:void(\"%f\", noise:float(q))"},
        {"c = f * f / 2;", "c = color<((f * f) / 2)>"},
        {"c = noise(q) + 0.5;", "c = color<(noise:float(q) + 0.5)>"},
        {"c = f * noise(q) - noise(f) / 2;",
         "c = color<((f * noise:float(q)) - (noise:float(f) / 2))>"},
        {"q = q + f * noise(q);", "q = (q + point<(f * noise:float(q))>)"},
        {"c = c * (2 * noise(q) - 1);", "c = (c * ((2 * noise:float(q)) - 1))"},
        {"w = f * f;", "w = vector<(f * f)>"},
        {"f = f > 0 ? noise(f) : 2;", "f = ((f > 0) ? noise:float(f) : 2)"},
        {"c = f > 0 ? noise(f) : 2;", "c = ((f > 0) ? noise:color(f) : color<2>)"},
        // Arguments choose among overloads.
        {"c = mix(c, 1, f);", "c = mix:color(c, color<1>, f)"},
        {"c = mix(c, c, c);", "c = mix:color(c, c, c)"},
        {"f = mix(1, 2, f);", "f = mix:float(1, 2, f)"},
        {"f = atan(f, 2);", "f = atan:float(f, 2)"},
        {"f = max(f, 1, 2, 3);", "f = max:float(f, 1, 2, 3)"},
        {"c = max(c, 0);", "c = max:color(c, color<0>)"},
        {"f = comp(c, 1);", "f = comp:float(c, 1)"},
        {"f = comp(m, 1, 2);", "f = comp:float(m, 1, 2)"},
        {"q = transform(\"world\", q);", "q = transform:point(\"world\", q)"},
        {"q = transform(m, q);", "q = transform:point(m, q)"},
        {"q = transform(\"a\", \"b\", q);", "q = transform:point(\"a\", \"b\", q)"},
        {"q = rotate(q, f, q, q);", "q = rotate:point(q, f, q, q)"},
        {"m = rotate(m, f, w);", "m = rotate:matrix(m, f, w)"},
        // In a function of the same name the built-in one is meant.
        {"float noise(point p) { return 2 * noise(p * 2); } f = noise(q);", "f = noise(q)"},
        {"f = spline(f, a);", "f = spline:float(f, a)"},
        {"c = spline(\"bezier\", f, c, c, c, c, c);",
         "c = spline:color(\"bezier\", f, c, c, c, c, c)"},
        {"f = arraylength(a);", "f = arraylength:float(a)"},
        {"fresnel(w, n, 1.5, f, a[1]);", "fresnel:void(w, vector<n>, 1.5, f, a[1])"},
        {"setxcomp(q, 1);", "setxcomp:void(q, 1)"},
        {"w = Du(q);", "w = Du:vector(q)"},
        {"f = Du * Du(f);", "f = (Du * Du:float(f))"},
        // Promotions and interchange.
        {"c = 1;", "c = color<1>"},
        {"m = 2;", "m = matrix<2>"},
        {"q = n;", "q = point<n>"},
        {"f = q . n;", "f = (q . n)"},
        {"w = q ^ n;", "w = (q ^ n)"},
        {"w = q - q;", "w = (q - q)"},
        {"w = 2 * n / 3;", "w = ((2 * n) / 3)"},
        {"q += f * w;", "q = (target + (f * w))"},
        {"c *= f;", "c = (target * f)"},
        {"m = m / m;", "m = (m / m)"},
        {"m *= 2;", "m = (target * 2)"},
        {"f = c == 1;", "f = (c == color<1>)"},
        {"f = name == \"x\";", "f = (name == \"x\")"},
        {"f = f > 1 && !f;", "f = ((f > 1) && !f)"},
        {"f = a[1] = 2;", "f = a[1] = 2"},
        {"f = Os[0] + q[2];", "f = (Os[0] + q[2])"},
        {"c[1] = f;", "c[1] = f"},
        // Casts, tuples and spaces.
        {"c = (1, f, 2);", "c = color(1, f, 2)"},
        {"q = (1, 2, 3);", "q = point(1, 2, 3)"},
        {"c = color q;", "c = color<q>"},
        {"q = point(c);", "q = point<c>"},
        {"q = point \"world\" (1, 2, 3);", "q = point<point(1, 2, 3) from \"world\">"},
        {"w = vector \"world\" 1;", "w = vector<vector<1> from \"world\">"},
        {"c = color \"hsv\" (f, 1, 1) * 2;", "c = (color<color(f, 1, 1) from \"hsv\"> * 2)"},
        {"m = matrix \"world\" 1;", "m = matrix<matrix<1> from \"world\">"},
        {"c = color noise(q) * 2;", "c = (noise:color(q) * 2)"},
        {"f = PI;", "f = 3.14159"},
        {"string x = \"a\" \"b\";", "uniform string x = \"ab\""},
        {"m = (1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,0,1);",
         "m = matrix(1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1)"},
    };
    for (auto [statement, expected] : table)
        EXPECT_EQ(lastOf(statement), expected) << statement;
}

TEST(Expressions, DetailOfResults) {
    const std::pair<const char *, bool> table[] = {
        {"p * 2", false},         {"u * 2", true},
        {"noise(p)", false},      {"noise(u)", true},
        {"random()", false},      {"arraylength(a)", false},
        {"p > 0 ? 1 : 2", false}, {"u > 0 ? 1 : 2", true},
        {"time", false},          {"comp(ambient(), 0)", true},
        {"xcomp(E)", false},
    };
    for (auto [text, varying] : table) {
        Compiled compiled(surfaceWith(std::string("uniform float x = ") + text + ";"));
        EXPECT_EQ(compiled.good(), !varying) << text << "\n" << compiled.diagnostics.text();
    }
}

TEST(Expressions, UserFunctionsAreOverloadedByArgumentsAndResult) {
    const char *text = "float g(float x) { return 1; }\n"
                       "float g(point x) { return 2; }\n"
                       "color h(float x) { return 3; }\n"
                       "float h(float x) { return 4; }\n"
                       "float sin(float x) { return 5; }\n"
                       "surface s() { float a = g(u), b = g(P), c = h(u), e = sin(1), k = sin(u);\n"
                       "  color d = h(u); Ci = a + b + c + d + e + k; }";
    Compiled compiled(text);
    ASSERT_TRUE(compiled.good()) << compiled.diagnostics.text();
    auto called = [&](size_t statement) {
        const Expr &call = *compiled.shader().body.at(statement)->values.at(0);
        EXPECT_EQ(call.kind, ExprKind::Call);
        return call.function->body.at(0)->value->operands.empty()
                   ? call.function->body.at(0)->value->number
                   : call.function->body.at(0)->value->operands.at(0)->number;
    };
    EXPECT_EQ(called(0), 1);
    EXPECT_EQ(called(1), 2);
    EXPECT_EQ(called(2), 4);
    EXPECT_EQ(called(3), 5);
    EXPECT_EQ(called(5), 3);
    // One instance for the uniform argument, one for the varying.
    const Expr &uniformCall = *compiled.shader().body.at(3)->values.at(0);
    const Expr &varyingCall = *compiled.shader().body.at(4)->values.at(0);
    EXPECT_NE(uniformCall.function, varyingCall.function);
    EXPECT_FALSE(uniformCall.type.isVarying());
}

TEST(Expressions, EveryNameIsResolved) {
    Compiled compiled(surfaceWith("Ci = c * p * u;"));
    ASSERT_TRUE(compiled.good());
    const Expr &assign = *compiled.shader().body.back()->value;
    const Symbol &ci = *assign.operands[0]->symbol;
    EXPECT_EQ(ci.kind, Symbol::Kind::Predefined);
    EXPECT_EQ(ci.predefined->id, PredefinedId::Ci);
    EXPECT_TRUE(ci.written);
    const Expr &product = *assign.operands[1]->operands[0];
    EXPECT_EQ(product.operands[0]->symbol->kind, Symbol::Kind::Local);
    EXPECT_EQ(product.operands[1]->symbol->kind, Symbol::Kind::Parameter);
}

} // namespace
} // namespace candela::sl
