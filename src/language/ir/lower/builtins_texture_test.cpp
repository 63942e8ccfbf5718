// SPDX-License-Identifier: Apache-2.0
// What lookups of textures ask of the renderer, and how their answers change with u and v.
#include "language/ir/lower/patch_points.h"

namespace candela::ir {
namespace {

constexpr double u = 0.3, v = 0.6, s = 3 * u + v, t = v * v;

/// Gives the operand whose number is the texture's name; of "ramp" 2 s + 3 t.
void tellOperand(void *, const ServiceCall &call) {
    const std::string name = call.site->texts[0];
    for (int lane = 0; lane < call.laneCount; ++lane) {
        const float value =
            name == "ramp" ? 2 * call.operand(0, lane).number + 3 * call.operand(1, lane).number
                           : call.operand(std::stoi(name), lane).number;
        for (int k = 0; k < call.site->resultCount; ++k)
            call.result(k, lane) = value;
    }
}

/// "ramp" as above, with its slopes.
void tellRamp(void *context, const ServiceCall &call) {
    tellOperand(context, call);
    const int values = call.site->resultCount / 3;
    for (int lane = 0; lane < call.laneCount; ++lane)
        for (int k = 0; k < values; ++k)
            call.result(values + k, lane) = 2, call.result(2 * values + k, lane) = 3;
}

struct Asked {
    explicit Asked(const std::string &body, const std::string &type = "float",
                   const LoweringOptions &options = {})
        : run(surfaceWith(type, body), 1, {}, {}, options) {
        EXPECT_TRUE(run.lowered) << body << run.diagnostics.text();
        if (!run.lowered)
            return;
        placeOnPatch(run, 0, u, v);
        run.setInput(ShaderInput::orientation, {1.0f});
        run.setInput(ShaderInput::dudx, {0.1f}), run.setInput(ShaderInput::dvdx, {0.2f});
        run.setInput(ShaderInput::dudy, {0.3f}), run.setInput(ShaderInput::dvdy, {-0.4f});
        run.setInput(ShaderInput::uShift, {0.05f}), run.setInput(ShaderInput::vShift, {-0.01f});
        for (const Service service : {Service::texture, Service::environment, Service::shadow})
            run.batch->services[service] = tellOperand;
        run.batch->services[Service::textureSlopes] = tellRamp;
        const auto outputs = run.run();
        for (const auto &plane : outputs.at("result"))
            result.push_back(plane[0]);
    }
    ShaderRun run;
    std::vector<float> result;
};

TEST(LowerTextures, HandOverPlaceExtentAndOptions) {
    const struct {
        const char *expression;
        double expected;
    } rows[] = {
        // s, t; ds and dt along either axis of the footprint.
        {"texture(\"0\")", s},
        {"texture(\"1\")", t},
        {"texture(\"0\", 2 * s, t)", 2 * s},
        {"texture(\"2\", 2 * s, t)", 2 * (3 * 0.1 + 0.2)},
        {"texture(\"3\", 2 * s, t)", 2 * v * 0.2},
        {"texture(\"4\", s * s, t)", 2 * s * (3 * 0.3 - 0.4)},
        {"texture(\"5\")", 2 * v * -0.4},
        {"texture(\"2\", .5, t)", 0},
        {"texture(\"2\", s, t, \"width\", .5)", 0.5 * (3 * 0.1 + 0.2)},
        {"texture(\"3\", s, t, \"swidth\", .5)", 2 * v * 0.2},
        {"texture(\"3\", s, t, \"twidth\", .5)", v * 0.2},
        {"texture(\"2\", .1, 0, .3, 0, .1, 1, .4, 1)", 0.25},
        {"texture(\"4\", .1, 0, .3, 0, .1, 1, .4, 1)", 0.05},
        {"texture(\"5\", .1, 0, .3, 0, .1, 1, .4, 1)", 1},
        {"texture(\"0\", .1, 0, .3, 0, .1, 1, .4, 1)", 0.225},
        {"texture(\"6\", s, t)", 0},
        {"texture(\"6\", s, t, \"blur\", .25)", 0.25},
        {"texture(\"7\", s, t, \"blur\", .25, \"sblur\", .5)", 0.25},
        {"texture(\"8\"[2], s, t)", 2},
        {"texture(\"8\"[u], s, t)", u},
        {"texture(\"9\", s, t, \"fill\", .75, \"filter\", \"box\", \"lerp\", 1)", 0.75},
        {"texture(\"10\")", 3 * 0.05 - 0.01},
        {"texture(\"11\", s, t, \"width\", 2)", 2 * v * -0.01},
        {"texture(\"10\", s, t, \"width\", 0)", 0},
        {"comp(color texture(\"0\"), 2)", s},
        // Directions and points: three numbers, then how they change along x, along y.
        {"environment(\"1\", P)", patchP(u, v).y},
        {"environment(\"3\", P)", patchDu(u, v).x * 0.1 + patchDv(u, v).x * 0.2},
        {"environment(\"8\", P)", patchDu(u, v).z * 0.3 - patchDv(u, v).z * 0.4},
        {"environment(\"9\", P, \"blur\", .5)", 0.5},
        {"environment(\"11\"[1], P)", 1},
        {"shadow(\"2\", P)", patchP(u, v).z},
        {"shadow(\"11\", P)", -1},
        {"shadow(\"11\", P, \"bias\", .125)", 0.125},
        {"shadow(\"12\", P)", 16},
        {"shadow(\"12\", P, \"samples\", 4)", 4},
    };
    for (const auto &row : rows)
        EXPECT_NEAR(Asked("result = float " + std::string(row.expression) + ";").result.at(0),
                    row.expected, 1e-5)
            << row.expression;
}

TEST(LowerTextures, ChangeAsTheirCoordinatesDo) {
    EXPECT_NEAR(Asked("result = Du(float texture(\"ramp\", s * s, t));").result.at(0),
                2 * 2 * s * 3, 1e-4);
    EXPECT_NEAR(Asked("result = Dv(float texture(\"ramp\", s, t));").result.at(0), 2 + 3 * 2 * v,
                1e-4);
    EXPECT_NEAR(Asked("result = Dv(color texture(\"ramp\", s, t));", "color").result.at(2),
                2 + 3 * 2 * v, 1e-4);
    // A surface that is moved by a texture has the normals of its bumps.
    const auto n =
        Asked("result = calculatenormal(P + normal \"current\" (0, 0, 1) * texture(\"ramp\"));",
              "normal")
            .result;
    const Vec3 up = vec(0, 0, 1);
    const Vec3 expected = cross(patchDu(u, v) + up * 6.0f, patchDv(u, v) + up * float(2 + 6 * v));
    for (int c = 0; c < 3; ++c) // On either side.
        EXPECT_NEAR(std::abs(n[std::size_t(c)]), std::abs(expected[c]), 1e-4) << c;
}

TEST(LowerTextures, BumpTiltsTheNormalAgainstTheSlope) {
    // h = 2 s + 3 t over a plane of unit tangents: N becomes (-2, -3, 1), of N's length and side.
    for (const float side : {1.0f, -1.0f}) {
        const auto n = Asked("result = bump(\"ramp\", normal (0, 0, " + std::to_string(7 * side) +
                                 "), vector (1, 0, 0), vector (0, 1, 0), s, t);",
                             "normal")
                           .result;
        const double size = 7 / std::sqrt(14.0);
        EXPECT_NEAR(n[0], -2 * size, 1e-4);
        EXPECT_NEAR(n[1], -3 * size, 1e-4);
        EXPECT_NEAR(n[2], side * size, 1e-4);
    }
}

TEST(LowerTextures, FootprintsAreLeftOutWhereTheyMakeATextTooLarge) {
    // Noise of noise has no third derivatives, and nobody has asked for any.
    const std::string body = "result = texture(\"2\", Du(Du(noise(P))), t);";
    Asked asked(body);
    EXPECT_EQ(asked.run.diagnostics.count(Severity::Error), 0);
    EXPECT_EQ(asked.result.at(0), 0);
}

TEST(LowerLookups, SayWhatIsWrong) {
    const std::pair<const char *, const char *> faults[] = {
        {"result = texture(\"a\", s);", "texture() takes a name, then s and t or four pairs"},
        {"result = texture(\"a\", P);", "texture() takes a name, then s and t or four pairs"},
        {"result = environment(\"a\", s);", "environment() takes a name, then a direction"},
        {"result = shadow(\"a\");", "shadow() takes a name, then a point or four of them"},
        {"result = texture(\"a\", s, t, \"blur\");", "each with its value"},
        {"result = texture(\"a\", s, t, \"blur\", \"much\");", "\"blur\" takes a float"},
        {"result = filterstep(1, s, \"width\", \"wide\");", "\"width\" takes a float"},
    };
    for (const auto &[body, words] : faults) {
        ShaderRun run(surfaceWith("float", body));
        EXPECT_FALSE(run.lowered) << body;
        EXPECT_NE(run.diagnostics.text().find(words), std::string::npos) << body << "\n"
                                                                         << run.diagnostics.text();
    }
    ShaderRun run(surfaceWith("float", "result = texture(\"a\", s, t, \"soft\", 1);"));
    EXPECT_TRUE(run.lowered);
    EXPECT_NE(run.diagnostics.text().find("texture() has no parameter \"soft\""),
              std::string::npos);
}

} // namespace
} // namespace candela::ir
