// SPDX-License-Identifier: Apache-2.0
#include "language/syntax/parser.h"

#include <gtest/gtest.h>

#include "language/syntax/preprocessor.h"

namespace candela::sl {
namespace {

struct Parsed {
    DiagnosticList diagnostics;
    SourceSet sources;
    ast::File file;

    explicit Parsed(const std::string &text) {
        sources.push_back(std::make_unique<SourceFile>("test.sl", text));
        Reporter reporter(diagnostics);
        file = parse(preprocess(sources, {}, reporter).tokens, reporter);
    }
    const ast::Shader &shader() const { return std::get<ast::Shader>(file.items.at(0)); }
};

std::string expression(const std::string &text) {
    Parsed parsed("surface s() { x = " + text + "; }");
    EXPECT_EQ(parsed.diagnostics.text(), "") << text;
    return ast::print(*parsed.shader().body->body.at(0)->value->operands.at(1));
}

TEST(Parser, Precedence) {
    const std::pair<const char *, const char *> table[] = {
        {"a + b * c", "(a + (b * c))"},
        {"a * b ^ c", "((a * b) ^ c)"},
        {"a ^ b * c", "(a ^ (b * c))"},
        {"a + b ^ c", "(a + (b ^ c))"},
        {"a . b * c", "((a . b) * c)"},
        {"-a . b", "((-a) . b)"},
        {"!a && b", "((!a) && b)"},
        {"a - b - c", "((a - b) - c)"},
        {"a / b * c", "((a / b) * c)"},
        {"a < b == c >= d", "((a < b) == (c >= d))"},
        {"a == b && c || d", "(((a == b) && c) || d)"},
        {"a || b && c", "(a || (b && c))"},
        {"a ? b : c ? d : e", "(a ? b : (c ? d : e))"},
        {"a = b += c", "(a = (b += c))"},
        {"a > 0 ? b : c", "((a > 0) ? b : c)"},
        {"color noise(P) * 2", "((color noise(P)) * 2)"},
        {"color \"hsv\" (1, 2, 3) + a", "((color \"hsv\" (1, 2, 3)) + a)"},
        {"point \"world\" -a", "(point \"world\" (-a))"},
        {"float texture(\"a\" \"b\"[2], s)", "(float texture(\"ab\"[2], s))"},
        {"Os[0] * a[i + 1]", "(Os[0] * a[(i + 1)])"},
        {"(a + b) * c", "((a + b) * c)"},
        {"vector (1, 2, 3)", "(vector (1, 2, 3))"},
        {"vector(P - Q)", "(vector (P - Q))"},
        {"- -a", "(-(-a))"},
        {"+a", "a"},
        {"f(a, g(b))", "f(a, g(b))"},
        {"normal * vector + color.x", "((normal * vector) + (color . x))"},
    };
    for (auto [text, expected] : table)
        EXPECT_EQ(expression(text), expected);
}

TEST(Parser, ShaderKindsAndParameters) {
    for (const char *kind :
         {"surface", "light", "volume", "displacement", "imager", "transformation", "filter"}) {
        Parsed parsed(std::string(kind) + " k() {}");
        EXPECT_EQ(parsed.diagnostics.text(), "");
        EXPECT_STREQ(nameOf(parsed.shader().kind), kind);
    }
    Parsed parsed("surface s(float Ka = 1, Kd = .5; uniform color c = 1,\n"
                  "          output varying float a[2] = {1, 2};\n"
                  "          point from = point \"world\" (0, 0, 0);) {}");
    EXPECT_EQ(parsed.diagnostics.text(), "");
    const auto &p = parsed.shader().parameters;
    ASSERT_EQ(p.size(), 5u);
    EXPECT_EQ(p[1].type, BaseType::Float);
    EXPECT_EQ(p[2].detail, Detail::Uniform);
    EXPECT_TRUE(p[3].output && p[3].isArray && p[3].braced);
    EXPECT_EQ(p[3].detail, Detail::Varying);
    EXPECT_EQ(p[4].type, BaseType::Point);
}

TEST(Parser, InitialValuesMayAssignOtherVariables) {
    Parsed parsed("surface s() { float a, b; float c = a = b = 0, d = 1; }");
    EXPECT_EQ(parsed.diagnostics.text(), "");
    const auto &declared = parsed.shader().body->body.at(1)->variables;
    ASSERT_EQ(declared.size(), 2u);
    EXPECT_EQ(ast::print(*declared[0].initial.at(0)), "(a = (b = 0))");
}

TEST(Parser, OldStyleParameters) {
    Parsed parsed("surface s(Ka, tint)\nfloat Ka = 1;\ncolor tint = 2;\n{}\n"
                  "float f(a, b) float a; point b; { return a; }");
    EXPECT_EQ(parsed.diagnostics.text(), "");
    EXPECT_EQ(parsed.shader().parameters.at(1).type, BaseType::Color);
    EXPECT_EQ(std::get<ast::Function>(parsed.file.items.at(1)).formals.at(1).type, BaseType::Point);
}

TEST(Parser, CommentsDocumentParameters) {
    Parsed parsed("// A thing.\nsurface s(float a = 1; /* first */\n"
                  "  // second\n  float b = 2;\n  float c = 3;) {}");
    EXPECT_EQ(parsed.shader().doc, "A thing.");
    EXPECT_EQ(parsed.shader().parameters.at(0).doc, "first");
    EXPECT_EQ(parsed.shader().parameters.at(1).doc, "second");
    EXPECT_EQ(parsed.shader().parameters.at(2).doc, "");
    Parsed oneLine("// A thing.\nsurface s(float a = 1, b = 2) {}");
    EXPECT_EQ(oneLine.shader().doc, "A thing.");
    for (const ast::Variable &parameter : oneLine.shader().parameters)
        EXPECT_EQ(parameter.doc, "") << "that is the shader's";
}

TEST(Parser, Statements) {
    Parsed parsed("surface s() {\n"
                  " ; { } if (a) b = 1; else { }\n"
                  " while (a) { break; continue 2; }\n"
                  " for (i = 0; i < 3; i += 1, j += 1) ;\n"
                  " for (;;) break;\n"
                  " float x = 1, y[3] = {1, 2, 3}; uniform color c; extern point P;\n"
                  " float f(float z) { return z; } void g() { return; } h(float q) { }\n"
                  " illuminance(P) { } illuminate(P) a = 1; solar() { } gather(a) { } else { }\n"
                  " return; }");
    EXPECT_EQ(parsed.diagnostics.text(), "");
    std::vector<ast::StmtKind> kinds;
    for (const ast::StmtPtr &s : parsed.shader().body->body)
        kinds.push_back(s->kind);
    using enum ast::StmtKind;
    std::vector<ast::StmtKind> expected{
        Empty,    Block,    If,       While,       For,        For,   Declare, Declare, Declare,
        Function, Function, Function, Illuminance, Illuminate, Solar, Gather,  Return};
    EXPECT_EQ(kinds, expected);
    const ast::Stmt &loop = *parsed.shader().body->body[3];
    EXPECT_EQ(loop.body[0]->body[1]->levels, 2);
}

TEST(Parser, KeywordLikeNames) {
    Parsed parsed("surface s(float exp = 2; float light = 1; string surface = \"\") {\n"
                  " point incident = P; point normal; normal = incident; vector vector = normal;\n"
                  " float filter = normal . vector; float output = 1; output += exp;\n"
                  " normal N2 = N; if (light < filter) light2 = surface(\"Kd\", exp); }");
    EXPECT_EQ(parsed.diagnostics.text(), "");
}

std::string lastValue(const std::string &statements) {
    Parsed parsed("surface s(point point = 1) { " + statements + " }");
    EXPECT_EQ(parsed.diagnostics.text(), "") << statements;
    return ast::print(*parsed.shader().body->body.back()->value->operands.at(1));
}

TEST(Parser, MinusAfterAVariableThatIsCalledLikeAType) {
    const std::pair<const char *, const char *> table[] = {
        {"normal normal = N; x = normal - a;", "(normal - a)"},
        {"color color = Cs; x = color - .25;", "(color - 0.25)"},
        {"x = point - a;", "(point - a)"},
        {"x = normal - a;", "(normal (-a))"},
        {"{ normal normal = N; } x = normal - a;", "(normal (-a))"},
        {"for (vector vector = 1; ;) ; x = vector - a;", "(vector (-a))"},
        {"float f(normal normal) { return normal - 1; } x = normal - a;", "(normal (-a))"},
        {"normal normal = N; x = a - normal - b;", "((a - normal) - b)"},
    };
    for (auto [statements, expected] : table)
        EXPECT_EQ(lastValue(statements), expected);
}

struct Mistake {
    const char *text;
    const char *expected;
};

TEST(Parser, Reports) {
    const Mistake table[] = {
        {"surface s() {\n  a = 1\n  b = 2; }",
         "test.sl:2:8: error: expected ';' after the expression\n      a = 1\n           ^"},
        {"surface s() { a = ; }", "test.sl:1:19: error: expected an expression, not ';'"},
        {"surface s() { a = (1, 2); }",
         "test.sl:1:19: error: a tuple has 3 components (color, point, vector, normal) or 16 "
         "(matrix), not 2"},
        {"surface s() { if a) ; }", "test.sl:1:18: error: expected '(' after 'if', not 'a'"},
        {"surface s() { f(a b); }",
         "test.sl:1:19: error: expected ')' or ',' in the arguments of f, not 'b'"},
        {"surface s() { flot x = 1; }",
         "test.sl:1:15: error: 'flot' is not a type; expected one, or an operator after it"},
        {"surface s() { a = 1;",
         "test.sl:1:21: error: expected '}' to close the block that line 1 opens, not the end of "
         "the file"},
        {"surface s() { } }", "test.sl:1:17: error: '}' closes nothing; is there one too many "
                              "above?"},
        {"surfac s() ;", "test.sl:1:1: error: expected a shader (such as: surface name(...) "
                         "{...}) or a function, not 'surfac'"},
        {"surface s(float a = 1 float b = 2) { }",
         "test.sl:1:22: error: expected ';', ',' or ')' after parameter a"},
        {"surface s(a) { }", "test.sl:1:11: error: parameter a has no type"},
        {"surface s() { else a = 1; }", "test.sl:1:15: error: 'else' without an 'if' before it"},
        {"surface s() { break 1.5; }",
         "test.sl:1:21: error: expected a positive whole number of loops after 'break'"},
        {"surface s() { float a[]; }",
         "test.sl:1:21: error: array a needs a length or initial values"},
        {"surface s() { void a; }", "test.sl:1:15: error: a variable cannot be of type void"},
        {"surface s() { uniform x = 1; }", "test.sl:1:23: error: expected a type (float, color, "
                                           "point, vector, normal, matrix, string), not 'x'"},
        {"surface s() { float a b; }",
         "test.sl:1:22: error: expected ';' after the declaration of a"},
        {"surface s() { float a[3; }",
         "test.sl:1:24: error: expected ']' after the length of the array, not ';'"},
        {"surface s() { float a[2] = {1, 2; }",
         "test.sl:1:33: error: expected '}' or ',' in the initial values of a, not ';'"},
        {"surface s(float a = 1; { }",
         "test.sl:1:24: error: expected ')' to close the parameters of s, not '{'"},
        {"surface s(a) float b = 1; { }",
         "test.sl:1:20: error: b is not in the list of parameters"},
        {"surface s(a) float a = 1 { }",
         "test.sl:1:25: error: expected ';' after the declaration of a parameter"},
        {"surface s() { a = b ? 1 ; }",
         "test.sl:1:25: error: expected ':' in this ?: expression, not ';'"},
        {"surface s() { a = b[1; }", "test.sl:1:22: error: expected ']' after the index, not ';'"},
        {"surface s() { a = (1; }",
         "test.sl:1:21: error: expected ')' to close the bracket, not ';'"},
        {"surface s() a = 1;",
         "test.sl:1:13: error: expected '{' to open the body of shader s, not 'a'"},
        {"surface s() { if (a { } }",
         "test.sl:1:21: error: expected ')' after the condition of 'if', not '{'"},
        {"surface s() { for (i = 0; i < 3) { } }",
         "test.sl:1:32: error: expected ';' after the condition of 'for', not ')'"},
        {"surface s() { for (i = 0; i < 3; i += 1 { } }",
         "test.sl:1:41: error: expected ')' to close the head of 'for', not '{'"},
        {"float f() { return 1 }", "test.sl:1:21: error: expected ';' after the value of 'return'"},
    };
    for (const Mistake &mistake : table) {
        std::string found = Parsed(mistake.text).diagnostics.text();
        EXPECT_EQ(found.substr(0, std::string(mistake.expected).size()), mistake.expected);
    }
}

TEST(Parser, AllErrorsInOneRun) {
    Parsed parsed("surface s(float a = ; float b = 2) {\n"
                  "  x = ;\n"
                  "  if (y) { z = 1 + ; }\n"
                  "  for (i = 0 i < 3; i += 1) { w = 2; }\n"
                  "  ok = 1;\n"
                  "}\n"
                  "light l() { q = ) ; }\n");
    std::vector<int> lines;
    for (const Diagnostic &d : parsed.diagnostics.all())
        lines.push_back(d.where.line);
    EXPECT_EQ(lines, (std::vector<int>{1, 2, 3, 4, 7}));
    EXPECT_EQ(parsed.file.items.size(), 2u);
}

TEST(Parser, DepthHasLimits) {
    auto errors = [](const std::string &body) {
        return Parsed("surface s() { " + body + " }").diagnostics.count(Severity::Error);
    };
    EXPECT_GE(errors("a = " + std::string(100000, '(') + ";"), 1);
    EXPECT_GE(errors("a = " + std::string(100000, '-') + "1;"), 1);
    EXPECT_GE(errors(std::string(100000, '{')), 1);
    std::string sum = "a = 1";
    for (int i = 0; i < 100000; ++i)
        sum += " + 1";
    EXPECT_GE(errors(sum + ";"), 1);
    std::string ifs;
    for (int i = 0; i < 100000; ++i)
        ifs += "if (a) ";
    EXPECT_GE(errors(ifs + ";"), 1);
}

} // namespace
} // namespace candela::sl
