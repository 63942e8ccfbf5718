// SPDX-License-Identifier: Apache-2.0
// Shaders that are compiled together, and what becomes of those for which there is no code.
#include "world/shading/shader_library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace candela {
namespace {

ShaderLibrarySettings settingsFor(const std::string &cpu) {
    const std::string shaders = CANDELA_SOURCE_DIR "/shaders/";
    ShaderLibrarySettings settings;
    settings.folders = settings.libraryFolders = {shaders + "surface", shaders + "light"};
    settings.jit.cpu = cpu;
    settings.jit.useCache = false;
    return settings;
}

struct World {
    explicit World(const std::string &cpu) : library(settingsFor(cpu), diagnostics) {}

    std::shared_ptr<ShaderCode> add(ShaderKind kind, const std::string &name,
                                    ir::LightRule rule = ir::LightRule::Path) {
        ShaderRecord record;
        record.name = name;
        return library.instance(kind, record, Options(), rule, {})->code;
    }

    DiagnosticList diagnostics;
    ShaderLibrary library;
};

TEST(ShaderLibrary, CompilesWhatRenderingAsksAndNothingTwice) {
    World world("");
    const auto plastic = world.add(ShaderKind::Surface, "plastic");
    const auto glow = world.add(ShaderKind::Surface, "constant");
    const auto lamp = world.add(ShaderKind::Light, "pointlight");
    world.library.makeReady();
    const int made = world.library.statistics().compiled;
    for (const auto &surface : {plastic, glow})
        for (const ir::Question question :
             {ir::Question::Prepare, ir::Question::Scatter, ir::Question::Opacity})
            EXPECT_NE(surface->question(question).code, nullptr);
    EXPECT_NE(glow->question(ir::Question::Emit).code, nullptr);
    EXPECT_NE(lamp->question(ir::Question::Light).code, nullptr);
    world.library.makeReady();
    EXPECT_EQ(world.library.statistics().compiled, made);
    // Another question is compiled when it is asked.
    EXPECT_NE(plastic->question(ir::Question::Shade).code, nullptr);
    EXPECT_EQ(world.library.statistics().compiled, made + 1);
    EXPECT_EQ(world.diagnostics.text(), "");
}

/// Pictures are named by strings, which make no code of their own unless the text has them, or
/// needs them for more than a name.
TEST(ShaderLibrary, InstancesThatNameOtherPicturesShareCode) {
    World world("");
    const auto painted = [&](const std::string &picture) {
        ShaderRecord record;
        record.name = "paintedplastic";
        record.parameters.all.push_back(
            {"texturename", {StorageClass::Uniform, ValueType::String, 1}, {}, {picture}});
        return *world.library.instance(ShaderKind::Surface, record, Options(), ir::LightRule::Path,
                                       {});
    };
    const ShaderInstance one = painted("one.tx"), other = painted("other.tx"), none = painted("");
    EXPECT_EQ(one.code, other.code);
    EXPECT_NE(one.code, none.code);
    EXPECT_EQ(painted("one.tx").code, one.code);
    const auto namesOf = [](const ShaderInstance &instance) {
        return instance.code->namesAsked(Service::texture, instance.parameterOffset);
    };
    EXPECT_EQ(namesOf(one), std::vector<std::string>{"one.tx"});
    EXPECT_EQ(namesOf(other), std::vector<std::string>{"other.tx"});
    EXPECT_TRUE(namesOf(none).empty());
    EXPECT_EQ(world.diagnostics.text(), "");
}

/// LLVM knows no such CPU, so that there is code for nothing.
TEST(ShaderLibrary, ShadersWithoutCodeBecomeTheDefaultSurfaceOrNoLight) {
    World world("no-such-cpu");
    const auto plastic = world.add(ShaderKind::Surface, "plastic");
    const auto classic = world.add(ShaderKind::Surface, "metal", ir::LightRule::Classic);
    const auto lamp = world.add(ShaderKind::Light, "pointlight");
    const auto plain = world.add(ShaderKind::Surface, "paintedmatte");
    EXPECT_GT(plastic->facts().cones.size(), 1u);
    world.library.makeReady();

    EXPECT_TRUE(plastic->isStandIn());
    EXPECT_TRUE(classic->isStandIn());
    EXPECT_FALSE(lamp->isStandIn());
    EXPECT_EQ(lamp->question(ir::Question::Light).code, nullptr);
    // The messages name the shaders, in their order.
    const std::string text = world.diagnostics.text();
    std::size_t at = 0;
    for (const char *name : {"\"plastic\"", "\"metal\"", "\"pointlight\"", "\"paintedmatte\""}) {
        EXPECT_NE(text.find(name, at), std::string::npos) << name << " in " << text;
        at = std::min(text.find(name, at), text.size());
    }
    EXPECT_EQ(plastic->facts().cones.size(), plain->facts().cones.size());
    EXPECT_EQ(plastic->name(), "plastic");
    // It reads no parameters, since instances hold those of another shader.
    EXPECT_TRUE(plastic->question(ir::Question::Prepare).function.parameters.empty() ||
                ir::print(plastic->question(ir::Question::Prepare).function).find("Parameter") ==
                    std::string::npos);
}

/// Without code an answer takes long and is the same.
TEST(ShaderLibrary, FunctionsWithoutCodeAreInterpreted) {
    World with(""), without("no-such-cpu");
    std::vector<float> answers[2];
    for (World *world : {&with, &without}) {
        const auto code = world->add(ShaderKind::Surface, "constant");
        const QuestionCode &question = code->question(ir::Question::Opacity);
        std::vector<float> &out = answers[world == &without];
        out.assign(3 * laneBlock, 0);
        std::vector<float> Os(laneBlock, .25f);
        std::vector<const float *> inputs(int(ShaderInput::Count), Os.data());
        std::vector<float *> outputs;
        for (int c = 0; c < int(question.function.outputs.size()); ++c)
            outputs.push_back(out.data() + c * laneBlock);
        ShaderArgs args;
        args.count = laneBlock;
        args.inputs = inputs.data();
        args.outputs = outputs.data();
        code->bind(args);
        question.ask(args);
    }
    EXPECT_EQ(answers[0], answers[1]);
    EXPECT_EQ(answers[1][0], .25f);
}

} // namespace
} // namespace candela
