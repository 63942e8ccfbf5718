// SPDX-License-Identifier: Apache-2.0
// Which strings of instances may be left to run time, and what code makes of them.
#include "language/ir/core/regions.h"
#include "language/ir/lower/test_support.h"

namespace candela::ir {
namespace {

struct LeftRow {
    const char *text; ///< With the parameters "name" and "other", which are left if may be.
    const char *left; ///< The parameters that are, in alphabetical order.
};

const LeftRow rows[] = {
    {"x = texture(name);", "name"},
    {"x = texture(name) + texture(other);", "name other"},
    {"x = texture(other[1], s, t, \"width\", 0);", "other"},
    {"x = environment(name, P) + shadow(other, P);", "name other"},
    {"x = xcomp(bump(name, N, dPdu, dPdv));", "name"},
    {"textureinfo(name, \"channels\", x);", "name"},
    {"printf(\"%s %f\\n\", name, x);", "name"},
    // By way of variables, functions, branches and arrays.
    {"string y = name; x = texture(y);", "name"},
    {"float f(string a;) { return texture(a); } x = f(name) + f(\"a\");", "name"},
    {"string y = name; if (x > 0) y = other; x = texture(y);", "name other"},
    {"string y[2] = {name, \"b\"}; uniform float i; for (i = 0; i < 2; i += 1) x += texture(y[i]);",
     "name"},
    {"string y[2] = {name, other}; uniform float i = 0; while (x > i) { x -= texture(y[i]); i += "
     "1; }",
     "name other"},
    {"illuminance(P, N, 1) { x += texture(name); }", "name"},
    // Compared with strings of the text, which they are not.
    {"if (name != \"\") x = texture(name);", "name"},
    {"if (\"a\" == name) x = 1; else x = texture(name);", "name"},
    {"string y = name; if (x > 0) y = \"b\"; if (y == \"b\") x = 2;", "name"},
    {"string y = \"a\"; if (name != \"\") y = name; x = texture(y);", "name"},
    // What has to be known: here nothing is left of "name".
    {"x = name == other;", ""},
    {"x = name == concat(\"a\", \"b\") ; x += texture(other);", "other"},
    {"string y = name; if (x > 0) y = other; if (y == shadername()) x = 2;", ""},
    {"x = texture(concat(name, \".tx\")) + texture(other);", "other"},
    {"x = texture(format(\"%s.tx\", name));", ""},
    {"printf(name);", ""},
    {"x = match(name, other);", ""},
    {"x = match(\"a\", name);", ""},
    {"x = xcomp(transform(name, P));", ""},
    {"option(name, x);", ""},
    {"x = texture(\"a\", s, t, name, 1) + texture(other);", "other"},
    {"textureinfo(other, name, x);", "other"},
    {"x = comp(ctransform(name, Cs), 0);", ""},
    // Both have the same string here, so that it is one that is known.
    {"string y = name; if (x > 0) y = name; x = xcomp(transform(y, P));", ""},
};

TEST(StringsAtRunTime, AreThoseThatTheTextNeedNotKnow) {
    for (const LeftRow &row : rows) {
        const std::string body = row.text;
        const std::size_t function = body.find("float f(") == 0 ? body.find('}') + 1 : 0;
        const std::string source =
            body.substr(0, function) +
            "surface test(string name = \"\"; string other = \"\"; output varying float x = 0;) {" +
            body.substr(function) + "}";
        DiagnosticList diagnostics;
        const auto front = sl::analyzeSource({"test.sl", source}, {}, diagnostics);
        ASSERT_TRUE(front) << diagnostics.text();
        std::vector<StringValue> strings{{"name", {"world"}, {true}}, {"other", {"hsv"}, {true}}};
        const auto lowered = lower(*front->shaders[0], strings, {}, diagnostics);
        ASSERT_TRUE(lowered) << row.text << "\n" << diagnostics.text();
        EXPECT_EQ(verify(lowered->whole), "") << row.text;
        std::string left;
        for (const ShaderParameter &parameter : lowered->parameters)
            if (parameter.type == "string" && parameter.firstSlot >= 0)
                left += (left.empty() ? "" : " ") + parameter.name;
        EXPECT_EQ(left, row.left) << row.text << "\n" << print(lowered->whole);
        // Whoever fills parameter blocks is told. One that nothing reads may seem to be left.
        for (const StringValue &given : strings)
            EXPECT_TRUE(given.isLeft() || left.find(given.name) == std::string::npos) << row.text;
    }
}

TEST(StringsAtRunTime, OfADefaultAreNeededWhereItNamesThem) {
    const std::string source = "surface test(string name = \"\"; float a = match(\"x\", name);"
                               "string b = concat(name, \".tx\");) { Ci = a * texture(b); }";
    DiagnosticList diagnostics;
    const auto front = sl::analyzeSource({"test.sl", source}, {}, diagnostics);
    ASSERT_TRUE(front) << diagnostics.text();
    std::vector<StringValue> strings{{"name", {"xyz"}, {true}}};
    const auto lowered = lower(*front->shaders[0], strings, {}, diagnostics);
    ASSERT_TRUE(lowered) << diagnostics.text();
    EXPECT_FALSE(strings[0].isLeft());
    EXPECT_EQ(lowered->parameters[1].defaults, std::vector<float>{1});
    EXPECT_EQ(lowered->parameters[2].stringDefaults, std::vector<std::string>{"xyz.tx"});
}

/// Errors are what they would be without, and told once.
TEST(StringsAtRunTime, DoNotHideErrors) {
    const std::string source = "surface test(string name = \"\";) { string y = name;"
                               "if (u > 0) y = \"world\"; P = transform(y, P); }";
    std::string texts[2];
    for (const bool left : {false, true}) {
        DiagnosticList diagnostics;
        const auto front = sl::analyzeSource({"test.sl", source}, {}, diagnostics);
        ASSERT_TRUE(front) << diagnostics.text();
        std::vector<StringValue> strings{{"name", {"raster"}, {left}}};
        EXPECT_FALSE(lower(*front->shaders[0], strings, {}, diagnostics));
        texts[left] = diagnostics.text();
    }
    EXPECT_EQ(texts[0], texts[1]);
    EXPECT_NE(texts[0].find("must be known when the shader is compiled"), std::string::npos);
}

void tellLength(void *, const ServiceCall &call) {
    for (int lane = 0; lane < call.laneCount; ++lane)
        if (call.asks(lane))
            call.result(0, lane) = float(std::string(call.text(lane)).size());
}

TEST(StringsAtRunTime, AreReadFromEachLanesBlock) {
    ShaderRun run("surface test(string name = \"\"; output varying float x = 0;)"
                  "{ x = name == \"\" ? 100 : texture(name); }",
                  3, {{"name", {"anything"}, {true}}});
    ASSERT_TRUE(run.lowered) << run.diagnostics.text();
    const char *const strings[] = {"a", "four"};
    run.batch->services.strings = {strings, 2};
    run.batch->services[Service::texture] = tellLength;
    const float numbers[] = {1, 0, 7}; // Of the last there is no string.
    for (int lane = 0; lane < 3; ++lane)
        run.setParameter("name", lane, {numbers[lane]});
    auto plane = run.run().at("x")[0];
    plane.resize(3);
    EXPECT_EQ(plane, (ShaderRun::Plane{4, 1, 0}));
}

} // namespace
} // namespace candela::ir
