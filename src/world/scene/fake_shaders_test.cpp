// SPDX-License-Identifier: Apache-2.0
// Shaders for tests of the scene alone: what the shader library would compile stands here as C++
// with the same ABI. The test program links these definitions instead of the library's.
#include "language/ir/transform/light_rule.h"
#include "world/shading/shader_library.h"

#include <cmath>

namespace candela {

namespace {

enum Slot { Red, Green, Blue, FromX, FromY, FromZ, ToX, ToY, ToZ, Slots };

struct Lane {
    const ShaderArgs &args;
    int i;

    bool active() const {
        return i < args.count && (!args.active || args.active[i / 16] >> (i % 16) & 1);
    }
    float in(ShaderInput input, int c = 0) const { return args.inputs[int(input) + c][i]; }
    Vec3 vec3(ShaderInput input) const { return {in(input, 0), in(input, 1), in(input, 2)}; }
    float parameter(int slot) const { return args.parameters[args.parameterOffset[i] + slot]; }
    Vec3 parameter3(int slot) const {
        return {parameter(slot), parameter(slot + 1), parameter(slot + 2)};
    }
    void out(int slot, Vec3 value) const {
        for (int c = 0; c < 3; ++c)
            args.outputs[slot + c][i] = value[c];
    }
};

template <class Body> void forLanes(const ShaderArgs *args, Body body) {
    for (int i = 0; i < args->count; ++i)
        if (Lane lane{*args, i}; lane.active())
            body(lane);
}

void pointLight(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) {
        Vec3 L = lane.vec3(ShaderInput::Ps) - lane.parameter3(FromX);
        lane.out(0, L), lane.out(3, lane.parameter3(Red) / dot(L, L));
    });
}

/// Dark beyond half a radian about the axis.
void spotLight(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) {
        Vec3 from = lane.parameter3(FromX), L = lane.vec3(ShaderInput::Ps) - from;
        lane.out(0, L);
        if (dot(normalize(L), normalize(lane.parameter3(ToX) - from)) > std::cos(0.5f))
            lane.out(3, lane.parameter3(Red) / dot(L, L));
    });
}

void distantLight(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) {
        lane.out(0, lane.parameter3(ToX)), lane.out(3, lane.parameter3(Red));
    });
}

void areaLight(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) {
        Vec3 L = lane.vec3(ShaderInput::Ps) - lane.vec3(ShaderInput::P);
        if (dot(L, lane.vec3(ShaderInput::N)) > 0)
            lane.out(0, L), lane.out(3, lane.parameter3(Red));
    });
}

void ambientLight(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) { lane.out(3, lane.parameter3(Red)); });
}

void glowEmits(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) { lane.out(0, lane.parameter3(Red)); });
}

void osOpacity(const ShaderArgs *args) {
    forLanes(args, [](Lane lane) { lane.out(0, lane.vec3(ShaderInput::Os)); });
}

QuestionCode makeQuestion(std::initializer_list<ir::OutputKind> outputs, ShaderFunction code) {
    QuestionCode question;
    question.function.inputsRead.assign(int(ShaderInput::Count), true);
    for (ir::OutputKind name : outputs)
        for (int c = 0; c < 3; ++c)
            question.function.outputs.push_back({name, c});
    question.code = code;
    return question;
}

ir::LoweredShader lowered(const std::string &name, const std::set<std::string> &variables) {
    ir::LoweredShader shader;
    shader.name = name;
    bool all = name == "probe" || name == "glass";
    shader.whole.inputsRead.assign(int(ShaderInput::Count), all);
    for (int c = 0; c < 3; ++c)
        shader.whole.inputsRead[int(ShaderInput::Os) + c] = true;
    shader.whole.categories = {"", "a,-b", "!diffuse"};
    if (name == "probe" && variables.count("Kd"))
        shader.whole.variables.push_back({"Kd", 0});
    if (name == "distantlight")
        shader.lightClass = ir::LightClass::Distant;
    if (name == "pointlight" || name == "spotlight" || name == "arealight")
        shader.lightClass = ir::LightClass::Local;
    return shader;
}

} // namespace

ShaderCode::ShaderCode(ir::LoweredShader shader, ir::LightRule rule, std::shared_ptr<Jit> jit,
                       std::shared_ptr<const ShaderMessages>, std::shared_ptr<const ShaderAnswers>)
    : shader_(std::move(shader)), rule_(rule), jit_(std::move(jit)) {
    facts_.emits = name() == "glow";
    facts_.opaqueIfOsIs1 = name() != "glass";
    auto set = [&](ir::Question question, std::initializer_list<ir::OutputKind> outputs,
                   ShaderFunction code) {
        questions_[int(question)].answer = makeQuestion(outputs, code);
    };
    set(ir::Question::Opacity, {ir::OutputKind::Oi}, osOpacity);
    set(ir::Question::Emit, {ir::OutputKind::Ce}, glowEmits);
    set(ir::Question::Light, {ir::OutputKind::L, ir::OutputKind::Cl},
        name() == "pointlight"     ? pointLight
        : name() == "spotlight"    ? spotLight
        : name() == "distantlight" ? distantLight
        : name() == "arealight"    ? areaLight
                                   : ambientLight);
}

const QuestionCode &ShaderCode::question(ir::Question question) const {
    return questions_[int(question)].answer;
}

std::int32_t ShaderCode::addBlock(const std::vector<float> &values) {
    blocks_.insert(blocks_.end(), values.begin(), values.end());
    return std::int32_t(blocks_.size() - values.size());
}

void ShaderCode::bindSpaces(const std::map<std::string, Matrix4> &, DiagnosticSink &) {}

void ShaderCode::bindCategories(std::vector<std::uint8_t> accepts, int lightCount) {
    categories_.bind(std::move(accepts), lightCount);
}

void ShaderCode::bind(ShaderArgs &args, bool) const {
    args.parameters = blocks_.data();
    categories_.bind(args);
}

struct ShaderLibrary::State {
    std::map<std::string, std::shared_ptr<ShaderCode>> codes;
};

ShaderLibrary::ShaderLibrary(ShaderLibrarySettings, DiagnosticSink &)
    : state_(std::make_unique<State>()) {}
ShaderLibrary::~ShaderLibrary() = default;
void ShaderLibrary::makeReady() {}
void ShaderLibrary::bindOptions(const Options &) {}
bool ShaderLibrary::hasShadowMap(const std::string &) const { return true; }
LightRecord ShaderLibrary::lightWithShader(const LightRecord &light, const Options &) {
    return light;
}
void ShaderLibrary::bindRays(const RayAnswers *) {}
void ShaderLibrary::bindLights(std::vector<std::vector<ToldParameter>>) {}

std::vector<ToldParameter> ShaderLibrary::parametersTold(ShaderKind, const ShaderRecord &,
                                                         const Options &, ir::LightRule) {
    return {};
}

std::optional<std::vector<ShaderLookup::ParameterType>>
ShaderLibrary::parametersOf(ShaderKind, const std::string &, const Options &,
                            const SourceLocation &) {
    return std::nullopt;
}

std::optional<ShaderInstance> ShaderLibrary::instance(ShaderKind, const ShaderRecord &record,
                                                      const Options &, ir::LightRule rule,
                                                      const std::set<std::string> &variables,
                                                      const OtherShaders &, const Attributes *) {
    if (record.name == "missing")
        return std::nullopt;
    std::string key = record.name;
    for (const std::string &name : variables)
        key += " " + name;
    auto &code = state_->codes[key];
    if (!code)
        code = std::make_shared<ShaderCode>(lowered(record.name, variables), rule, nullptr, nullptr,
                                            nullptr);
    std::vector<float> block(Slots, 0);
    auto set = [&](const char *name, int slot) {
        if (const Parameter *given = record.parameters.find(name))
            for (int c = 0; c < 3; ++c)
                block[slot + c] = given->floats[c % given->floats.size()];
    };
    set("intensity", Red), set("from", FromX), set("to", ToX);
    return ShaderInstance{code, code->addBlock(block)};
}

std::vector<std::shared_ptr<ShaderCode>> ShaderLibrary::all() const {
    std::vector<std::shared_ptr<ShaderCode>> codes;
    for (const auto &[name, code] : state_->codes)
        codes.push_back(code);
    return codes;
}

} // namespace candela
