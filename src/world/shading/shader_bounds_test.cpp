// SPDX-License-Identifier: Apache-2.0
// Bounds and projections of shaders, asked as renderers ask them.
#include "world/shading/shader_projection.h"

#include "world/shading/shader_library.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace candela {
namespace {

/// Shaders of the library, and others by their text.
class Shaders {
public:
    explicit Shaders(int width = laneBlock) : library_(settings(width), diagnostics) {}
    ~Shaders() { std::filesystem::remove_all(folder()); }

    ShaderInstance named(const std::string &name, ShaderKind kind = ShaderKind::Surface) {
        ShaderRecord record;
        record.name = name;
        auto instance = library_.instance(kind, record, Options(), ir::LightRule::Path, {});
        EXPECT_EQ(diagnostics.text(), "");
        return *instance;
    }
    ShaderInstance written(const std::string &name, const std::string &text,
                           ShaderKind kind = ShaderKind::Surface) {
        std::ofstream(folder() / (name + ".sl")) << text;
        return named(name, kind);
    }

    DiagnosticList diagnostics;

private:
    std::filesystem::path folder() const {
        const auto path = std::filesystem::path(testing::TempDir()) /
                          ("candela_bounds_" + std::to_string(std::uintptr_t(this)));
        std::filesystem::create_directories(path);
        return path;
    }
    ShaderLibrarySettings settings(int width) const {
        ShaderLibrarySettings settings;
        settings.libraryFolders = {CANDELA_SOURCE_DIR "/shaders/surface"};
        settings.folders = {folder().string(), settings.libraryFolders[0]};
        settings.jit.useCache = false;
        settings.jit.width = width;
        return settings;
    }

    ShaderLibrary library_;
};

/// The unit square across z, seen along it.
void place(BoxBounds &boxes, int lane, const ParameterBox &box) {
    const auto u = float(box.u), v = float(box.v);
    boxes.set(ShaderInput::P, lane, {u, v, 0});
    for (ShaderInput normal : {ShaderInput::N, ShaderInput::Ng, ShaderInput::fieldAxis})
        boxes.set(normal, lane, {0, 0, -1});
    boxes.set(ShaderInput::I, lane, {0, .6f, .8f});
    boxes.set(ShaderInput::dPdu, lane, {1, 0, 0});
    boxes.set(ShaderInput::dPdv, lane, {0, 1, 0});
    boxes.set(ShaderInput::u, lane, {u}), boxes.set(ShaderInput::s, lane, {u});
    boxes.set(ShaderInput::v, lane, {v}), boxes.set(ShaderInput::t, lane, {v});
    boxes.set(ShaderInput::dsdu, lane, {1}), boxes.set(ShaderInput::dtdv, lane, {1});
    boxes.set(ShaderInput::Cs, lane, {.8f, .5f, .25f});
    boxes.set(ShaderInput::Os, lane, {1, 1, 1});
    boxes.set(ShaderInput::Du, lane, {float(box.Du)});
    boxes.set(ShaderInput::Dv, lane, {float(box.Dv)});
}

TEST(BoxBounds, AMatteSurfaceReflectsItsColourEverywhere) {
    Shaders shaders;
    BoxBounds boxes(shaders.named("matte"), 3);
    for (int i = 0; i < 3; ++i)
        place(boxes, i, {.2 * i, .5, .5, .5});
    boxes.ask(3);
    for (int i = 0; i < 3; ++i) {
        EXPECT_FLOAT_EQ(boxes.reflectance().value[1][i], .5f);
        EXPECT_EQ(boxes.reflectance().tolerance[1][i], 0);
        EXPECT_EQ(boxes.reflectance().byU[1][i], 0);
        EXPECT_EQ(boxes.emission().value[1][i], 0);
        EXPECT_EQ(boxes.opacity().value[1][i], 1);
    }
}

TEST(BoxBounds, LightsAreAskedOverTheirSurface) {
    Shaders shaders;
    const ShaderInstance lamp = shaders.written(
        "lamp", "light lamp() { illuminate(P) Cl = 2 + s * s; }", ShaderKind::Light);
    BoxBounds boxes(lamp, 1);
    place(boxes, 0, {.5, .5, .5, .5});
    boxes.set(ShaderInput::Ps, 0, {.5f, .5f, -3});
    boxes.ask(1);
    EXPECT_FLOAT_EQ(boxes.emission().value[0][0], 2.25f);
    EXPECT_FLOAT_EQ(boxes.emission().byU[0][0], 1);
    EXPECT_NEAR(boxes.emission().tolerance[0][0], .0625, 1e-5);
    boxes.set(ShaderInput::s, 0, {1});
    boxes.askValues(1);
    EXPECT_FLOAT_EQ(boxes.emission().value[0][0], 3);
}

/// Curved, with everything in it.
TEST(BoxBounds, InterpreterAndBothWidthsAgreeBitByBitAndValuesAreTheFurnaces) {
    Shaders wide, narrow(1);
    const char *const text =
        "surface mixed() { normal n = normalize(N); float k, x = noise(6 * P);"
        " float list[3] = { .2, s, .9 }; for (k = 0; k < 3; k += 1) x += .1 * list[k];"
        " if (s > .4) x = mix(x, cellnoise(9 * s, 5 * t), smoothstep(.2, .9, t));"
        " Ci = x * diffuse(n) + .2 * specular(n, -normalize(I), .3) + pow(abs(s - .5), 1.5);"
        " Oi = clamp(2 * t, .1, 1); }";
    const ShaderInstance one = wide.written("mixed", text), other = narrow.written("mixed", text);
    BoxBounds boxes(one, 37), singly(other, 37), values(one, 37);
    for (int i = 0; i < 37; ++i)
        for (BoxBounds *b : {&boxes, &singly, &values}) {
            place(*b, i, {.1 + .02 * i, .9 - .02 * i, .2 / (1 + i), .1});
            b->set(ShaderInput::dNdu, i, {.3f, 0, 0});
            b->set(ShaderInput::NRest, i, {.001f});
        }
    boxes.ask(37), singly.ask(37), values.askValues(37);
    const auto bits = [](float x) { return std::bit_cast<std::uint32_t>(x); };
    const QuestionCode &question = one.code->question(ir::Question::Bounds);
    EXPECT_NE(question.code, nullptr);
    EXPECT_EQ(ir::verify(question.function), "");
    for (auto quantity : {&BoxBounds::reflectance, &BoxBounds::emission, &BoxBounds::opacity}) {
        const BoundPlanes a = (boxes.*quantity)(), b = (singly.*quantity)();
        for (std::size_t c = 0; c < std::size_t(colorSamples); ++c)
            for (int i = 0; i < 37; ++i) {
                ASSERT_EQ(bits(a.value[c][i]), bits(b.value[c][i]));
                ASSERT_EQ(bits(a.byU[c][i]), bits(b.byU[c][i]));
                ASSERT_EQ(bits(a.byV[c][i]), bits(b.byV[c][i]));
                ASSERT_EQ(bits(a.tolerance[c][i]), bits(b.tolerance[c][i]));
                ASSERT_EQ(bits(a.value[c][i]), bits((values.*quantity)().value[c][i]));
                ASSERT_LT(a.tolerance[c][i], 100);
            }
    }
    // Without code the function is interpreted.
    std::vector<float> planes(question.function.outputs.size() * 48);
    std::vector<float *> outputs;
    for (std::size_t k = 0; k < question.function.outputs.size(); ++k)
        outputs.push_back(planes.data() + 48 * k);
    std::vector<const float *> inputs;
    for (int k = 0; k < int(ShaderInput::Count); ++k)
        inputs.push_back(boxes.plane(ShaderInput(k)));
    const std::vector<std::int32_t> zeros(48);
    ShaderArgs args;
    args.count = 37;
    args.inputs = inputs.data();
    args.outputs = outputs.data();
    args.parameterOffset = zeros.data();
    one.code->bind(args, false);
    ir::interpret(question.function, args);
    const int slot = question.output(ir::OutputKind::ReflectanceTolerance);
    for (int i = 0; i < 37; ++i)
        EXPECT_EQ(bits(outputs[std::size_t(slot)][i]), bits(boxes.reflectance().tolerance[0][i]));
}

TEST(Projection, OfACheckerboardIsExactWithinItsTolerance) {
    Shaders shaders;
    const ShaderInstance checker = shaders.written(
        "checker", "surface checker() { float c = mod(floor(5 * s) + floor(3 * t), 2);"
                   " Ci = mix(.2, .8, c) * diffuse(normalize(N)); }");
    ProjectionSettings settings;
    settings.tolerance = 2e-3f;
    settings.degree = 1;
    const Projection found = project(checker, place, {}, settings);
    EXPECT_LE(found.error, 2e-3);
    // Of 15 fields seven are light.
    const double mean = .2 + .6 * 7 / 15;
    EXPECT_NEAR(found.reflectance[0][0], mean, 2e-3);
    EXPECT_NEAR(found.reflectance[1][0], 0, 2e-3); // Even along u and along v.
    EXPECT_NEAR(found.reflectance[2][0], 0, 2e-3);
    EXPECT_NEAR(found.opacity[0][0], 1, 1e-6);
    EXPECT_EQ(found.emission[0][0], 0);
    // Edges are cut across alone.
    EXPECT_LT(double(found.boundCalls) * 100, found.plainCalls);
}

TEST(Projection, ANarrowStripeIsNotMissed) {
    Shaders shaders;
    const ShaderInstance stripe =
        shaders.written("stripe", "surface stripe() { if (s > .31831 && s < .31931) Ci = 900; }");
    ProjectionSettings settings;
    settings.tolerance = 2e-2f;
    const Projection found = project(stripe, place, {}, settings);
    EXPECT_LE(found.error, 2e-2);
    EXPECT_NEAR(found.emission[0][0], .9, 2e-2);
}

TEST(Projection, OfWhatIsSmoothNeedsFewBoxesAndPolynomialsAreThemselves) {
    Shaders shaders;
    const ShaderInstance ramp =
        shaders.written("ramp", "surface ramp() { Ci = 1 + s + 3 * s * t; Oi = .5; }");
    ProjectionSettings settings;
    settings.degree = 2;
    const Projection found = project(ramp, place, {}, settings);
    EXPECT_LE(found.error, 1e-3);
    // 1 + s + 3 s t, of s = (1 + x) / 2 and t = (1 + y) / 2.
    EXPECT_NEAR(found.emission[0][2], 2.25, 1e-3);
    EXPECT_NEAR(found.emission[1][2], 2.5 / std::sqrt(12.0), 1e-3);
    EXPECT_NEAR(found.emission[3][2], 1.5 / std::sqrt(12.0), 1e-3);
    EXPECT_NEAR(found.emission[4][2], 3 / 12.0, 1e-3);
    EXPECT_NEAR(found.emission[8][2], 0, 1e-3);
    EXPECT_NEAR(found.opacity[0][2], .5, 1e-6);
    // A part of the square.
    const Projection part = project(ramp, place, {.75, .25, .5, .5}, settings);
    EXPECT_NEAR(part.emission[0][0], 1 + .75 + 3 * .75 * .25, 1e-3);
}

TEST(Projection, ViewsAreAveraged) {
    Shaders shaders;
    const ShaderInstance rim =
        shaders.written("rim", "surface rim() { Ci = -normalize(I) . normalize(N); }");
    ProjectionSettings settings;
    EXPECT_NEAR(project(rim, place, {}, settings).emission[0][0], 1, 1e-5);
    settings.views = 64; // The cosine's mean under the cosine.
    EXPECT_NEAR(project(rim, place, {}, settings).emission[0][0], 2 / 3.0, 2e-3);
}

TEST(Projection, WithoutBoundsSaysSoAndEnds) {
    Shaders shaders;
    const ShaderInstance pole =
        shaders.written("pole", "surface pole() { Ci = .001 / (s - .5); Oi = s; }");
    const Projection found = project(pole, place, {}, {});
    EXPECT_TRUE(std::isinf(found.error));
    EXPECT_NEAR(found.opacity[0][0], .5, 1e-3);
    EXPECT_LT(found.boundCalls, 100000);
}

} // namespace
} // namespace candela
