// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_library.h"
#include "language/ir/analyse/control_relevance.h"
#include "language/ir/transform/fold.h"
#include "language/ir/transform/light_rule.h"

#include "foundation/base/motion_steps.h"
#include "foundation/base/parallel.h"
#include "interface/ri/search_path.h"
#include "language/jit/function_hash.h"
#include "world/shading/instance_values.h"
#include "world/shading/light_stand_in.h"
#include "world/shading/lowered_shaders.h"
#include "world/shading/shader_source.h"

#include <algorithm>
#include <cstring>
#include <utility>

namespace candela {

struct ShaderLibrary::State {
    State(ShaderLibrarySettings settings, DiagnosticSink &diagnostics)
        : diagnostics(diagnostics), sources(settings.folders, diagnostics),
          libraryFolders(settings.libraryFolders),
          jit(std::make_shared<Jit>(settings.jit, diagnostics)),
          messages(std::make_shared<const ShaderMessages>(diagnostics)),
          answers(
              std::make_shared<ShaderAnswers>(std::move(settings.textureFolders), diagnostics)) {}

    DiagnosticSink &diagnostics;
    ShaderSources sources;
    std::vector<std::string> libraryFolders;
    std::shared_ptr<Jit> jit;
    std::shared_ptr<const ShaderMessages> messages;
    std::shared_ptr<ShaderAnswers> answers;
    LoweredShaders lowered;
    std::map<const ir::LoweredShader *, std::vector<int>> controlRelevant; ///< Of those.
    std::map<std::string, std::shared_ptr<ShaderCode>> codes; ///< By text and folded values.
    std::vector<std::shared_ptr<ShaderCode>> inOrder;
    std::size_t ready = 0; ///< How many of these have been compiled.
    std::set<std::string> said;
    std::set<std::string> standIns; ///< Names of lights that have one.

    /// Passes on what has not been said before: a text is compiled once for each choice of strings,
    /// and its author reads the same each time.
    void sayOnce(const DiagnosticList &);
    const sl::TypedShader *find(ShaderKind, const ShaderRecord &, const Options &, ir::LightRule);
    const sl::TypedShader *fromLibrary(ShaderKind, const std::string &name);
    /// The default surface with all its parameters at their defaults; none without a library.
    std::optional<ir::LoweredShader> standIn(ir::LightRule);
    void replace(ShaderCode &);
    LoweredText lowerOnce(const sl::TypedShader &, const ShaderRecord &, const Options &,
                          std::string &key, const LoweredShaders::Wishes & = {});
    ToldValues askOthers(const OtherShaders &, const Options &, ir::LightRule);
};

ShaderLibrary::ShaderLibrary(ShaderLibrarySettings settings, DiagnosticSink &diagnostics)
    : state_(std::make_unique<State>(std::move(settings), diagnostics)) {}

ShaderLibrary::~ShaderLibrary() = default;

namespace {

std::optional<ValueType> valueTypeOf(sl::BaseType type) {
    switch (type) {
    case sl::BaseType::Float: return ValueType::Float;
    case sl::BaseType::Color: return ValueType::Color;
    case sl::BaseType::Point: return ValueType::Point;
    case sl::BaseType::Vector: return ValueType::Vector;
    case sl::BaseType::Normal: return ValueType::Normal;
    case sl::BaseType::Matrix: return ValueType::Matrix;
    case sl::BaseType::String: return ValueType::String;
    case sl::BaseType::Void: return std::nullopt;
    }
    return std::nullopt;
}

/// "defaultsurface" is lit from the eye under the classic integrator alone: it would be a lamp
/// else.
const char *defaultSurface(ir::LightRule rule) {
    return rule == ir::LightRule::Path ? "paintedmatte" : "defaultsurface";
}

} // namespace

std::optional<std::vector<ShaderLookup::ParameterType>>
ShaderLibrary::parametersOf(ShaderKind kind, const std::string &name, const Options &options,
                            const SourceLocation &where) {
    const sl::TypedShader *shader =
        state_->sources.find(kind, name, searchFolders(options, "shader"), where);
    if (!shader)
        return std::nullopt;
    std::vector<ParameterType> types;
    for (const sl::Parameter &parameter : shader->parameters)
        if (auto type = valueTypeOf(parameter.symbol->type.base)) {
            bool varying = parameter.symbol->type.detail == sl::Detail::Varying;
            Declaration declaration{varying ? StorageClass::Varying : StorageClass::Uniform, *type,
                                    std::max(1, parameter.symbol->type.length)};
            types.push_back({parameter.symbol->name, declaration});
        }
    return types;
}

void ShaderLibrary::State::sayOnce(const DiagnosticList &words) {
    for (const Diagnostic &diagnostic : words.all())
        if (said.insert(format(diagnostic)).second)
            diagnostics.report(diagnostic);
}

/// Null without a word if there is no library: whoever looked for it has said so.
const sl::TypedShader *ShaderLibrary::State::fromLibrary(ShaderKind kind, const std::string &name) {
    return libraryFolders.empty() ? nullptr
                                  : sources.findIn(libraryFolders, kind, name, SourceLocation());
}

const sl::TypedShader *ShaderLibrary::State::find(ShaderKind kind, const ShaderRecord &record,
                                                  const Options &options, ir::LightRule rule) {
    if (record.name.empty())
        return fromLibrary(ShaderKind::Surface, defaultSurface(rule));
    const sl::TypedShader *shader =
        sources.find(kind, record.name, searchFolders(options, "shader"), record.parameters.where);
    // A user's own surface of that name is what it is; the library's has a form for each rule.
    const bool isDefault = kind == ShaderKind::Surface && record.name == "defaultsurface" &&
                           shader == fromLibrary(kind, record.name);
    return isDefault && shader ? fromLibrary(kind, defaultSurface(rule)) : shader;
}

LoweredText ShaderLibrary::State::lowerOnce(const sl::TypedShader &shader,
                                            const ShaderRecord &record, const Options &options,
                                            std::string &key,
                                            const LoweredShaders::Wishes &wishes) {
    DiagnosticList words;
    LoweredText text = lowered.find(shader, record, options, wishes, key, words);
    sayOnce(words);
    return text;
}

/// What the other shaders have for parameters, by the names that texts ask by.
ToldValues ShaderLibrary::State::askOthers(const OtherShaders &others, const Options &options,
                                           ir::LightRule rule) {
    struct Asked {
        const char *whose;
        ShaderKind kind;
        const ShaderRecord *record;
    };
    ToldValues told;
    for (const Asked &asked : {Asked{"surface", ShaderKind::Surface, others.surface},
                               Asked{"displacement", ShaderKind::Displacement, others.displacement},
                               Asked{"atmosphere", ShaderKind::Volume, others.atmosphere},
                               Asked{"interior", ShaderKind::Volume, others.interior},
                               Asked{"exterior", ShaderKind::Volume, others.exterior}}) {
        const sl::TypedShader *shader =
            asked.record ? find(asked.kind, *asked.record, options, rule) : nullptr;
        std::string key;
        const ir::LoweredShader *lowered =
            shader ? lowerOnce(*shader, *asked.record, options, key).shader : nullptr;
        if (!lowered)
            continue;
        for (ToldParameter &parameter : toldParameters(*lowered, *asked.record, options))
            told.emplace(ir::toldName(asked.whose,
                                      parameter.strings.empty() ? parameter.shape : "string",
                                      parameter.name),
                         std::move(parameter));
    }
    return told;
}

/// The record at the steps of its motion, the first as it is when the shutter opens; none if it
/// stands still.
static std::vector<ShaderRecord> recordsInTime(const ShaderRecord &record, const Options &options) {
    const TransformMotion::Shared &motion = record.currentFromShader.motion;
    const Shutter shutter{options.camera.shutterOpen, options.camera.shutterClose};
    if ((!motion && !record.motion) || !shutter.hasInterval())
        return {};
    std::size_t steps = 1;
    if (motion) {
        std::vector<double> times;
        motion->addTimes(times);
        const auto at = [&](double time) { return motion->at(time); };
        steps = std::max<std::size_t>(1, motionSteps(at, times, shutter).size() - 1);
    }
    if (record.motion)
        steps *= std::size_t(stepsThrough(record.motion->times, shutter.open, shutter.close));
    steps = std::min<std::size_t>(steps, 128);
    std::vector<ShaderRecord> records;
    for (std::size_t step = 0; step <= steps; ++step) {
        const double time =
            shutter.open + double(step) / double(steps) * (double(shutter.close) - shutter.open);
        ShaderRecord &moved = records.emplace_back(record);
        if (motion)
            moved.currentFromShader = {motion->at(time).rounded(), nullptr};
        if (!record.motion)
            continue;
        const auto &lists = record.motion->values;
        const KnotPlace place = placeAmong(record.motion->times, time);
        moved.parameters = between(lists[place.knot], lists[place.next], place.share);
        moved.parameters.where = record.parameters.where;
    }
    return records;
}

std::optional<ShaderInstance> ShaderLibrary::instance(ShaderKind kind, const ShaderRecord &record,
                                                      const Options &options, ir::LightRule rule,
                                                      const std::set<std::string> &variables,
                                                      const OtherShaders &others,
                                                      const Attributes *attributes) {
    const sl::TypedShader *shader = state_->find(kind, record, options, rule);
    const ToldValues told = shader && ir::asksOtherShaders(*shader)
                                ? state_->askOthers(others, options, rule)
                                : ToldValues{};
    std::string key = rule == ir::LightRule::Path ? "path " : "classic ";
    LoweredShaders::Wishes wishes{&variables, &told};
    wishes.lowering.indirectByRays = kind == ShaderKind::Surface && rule == ir::LightRule::Classic;
    const LoweredText text =
        shader ? state_->lowerOnce(*shader, record, options, key, wishes) : LoweredText();
    const ir::LoweredShader *lowered = text.shader;
    if (!lowered) {
        if (kind != ShaderKind::Surface || record.name.empty())
            return std::nullopt;
        return instance(kind, {{}, {}, record.currentFromShader, {}}, options, rule, {}, {},
                        attributes);
    }

    const auto blockOf = [&](const ShaderRecord &at, DiagnosticSink &words) {
        auto values = parameterBlock(*lowered, at, options, told, words, attributes);
        text.placeStrings(*state_->answers, values);
        return values;
    };
    std::vector<float> block = blockOf(record, state_->diagnostics);
    std::vector<ir::FoldedValue> folded;
    auto [controlRelevant, isNew] = state_->controlRelevant.try_emplace(lowered);
    if (isNew)
        controlRelevant->second = ir::controlRelevantParameters(lowered->whole);
    std::vector<std::vector<float>> blocks;
    DiagnosticList heard; // It is said of the first block.
    for (const ShaderRecord &moved : recordsInTime(record, options))
        blocks.push_back(blockOf(moved, heard));
    if (!blocks.empty())
        block = blocks.front();
    const auto isSteady = [&](const std::vector<float> &later) {
        return std::ranges::all_of(controlRelevant->second,
                                   [&](int slot) { return later[slot] == block[slot]; });
    };
    if (!std::ranges::all_of(blocks, isSteady)) {
        state_->diagnostics.warning(
            record.parameters.where,
            "shader \"" + record.name +
                "\": parameters that change with time decide what it does; they stay as they are "
                "when the shutter opens");
        blocks.clear();
    }
    for (int slot : controlRelevant->second) {
        folded.push_back({slot, block[slot]});
        key += " " + std::to_string(slot) + "=" +
               std::string(reinterpret_cast<const char *>(&block[slot]), sizeof(float));
    }
    std::shared_ptr<ShaderCode> &code = state_->codes[key];
    if (!code) {
        ir::LoweredShader specialised = *lowered;
        specialised.whole = ir::fold(lowered->whole, folded);
        code = std::make_shared<ShaderCode>(std::move(specialised), rule, state_->jit,
                                            state_->messages, state_->answers);
        state_->inOrder.push_back(code);
    }
    const ShaderInstance made{code, code->addBlock(block)};
    if (!blocks.empty()) {
        for (std::size_t step = 1; step < blocks.size(); ++step)
            code->addBlock(blocks[step]);
        code->setSteps(made.parameterOffset, int(blocks.size()));
    }
    return made;
}

LightRecord ShaderLibrary::lightWithShader(const LightRecord &light, const Options &options) {
    State &state = *state_;
    const std::string &name = light.shader.name;
    const SourceLocation &where = light.shader.parameters.where;
    if (state.libraryFolders.empty() ||
        state.sources.find(ShaderKind::Light, name, searchFolders(options, "shader"), where))
        return light;
    LightRecord other = lightStandIn(light);
    if (state.standIns.insert(name).second)
        state.diagnostics.warning(where, "light \"" + name + "\": the library's \"" +
                                             other.shader.name + "\" stands in for it");
    return other;
}

std::vector<ToldParameter> ShaderLibrary::parametersTold(ShaderKind kind,
                                                         const ShaderRecord &record,
                                                         const Options &options,
                                                         ir::LightRule rule) {
    const sl::TypedShader *shader = state_->find(kind, record, options, rule);
    std::string key;
    const ir::LoweredShader *lowered =
        shader ? state_->lowerOnce(*shader, record, options, key).shader : nullptr;
    return lowered ? toldParameters(*lowered, record, options) : std::vector<ToldParameter>{};
}

std::shared_ptr<const FilterCode> ShaderLibrary::filter(const ShaderRecord &record,
                                                        const Options &options) {
    State &state = *state_;
    const sl::TypedShader *shader = state.sources.find(
        ShaderKind::Filter, record.name, searchFolders(options, "shader"), record.parameters.where);
    std::string key = "filter ";
    const ir::LoweredShader *lowered =
        shader ? state.lowerOnce(*shader, record, options, key, {.leavesStrings = false}).shader
               : nullptr;
    if (!lowered)
        return nullptr;
    const std::vector<float> block =
        parameterBlock(*lowered, record, options, {}, state.diagnostics);
    return FilterCode::compile(ir::foldAll(lowered->whole, block), state.jit, state.messages,
                               state.answers, state.diagnostics);
}

std::optional<ir::LoweredShader> ShaderLibrary::State::standIn(ir::LightRule rule) {
    const sl::TypedShader *shader = fromLibrary(ShaderKind::Surface, defaultSurface(rule));
    auto lowered = shader ? ir::lower(*shader, {}, {}, diagnostics) : std::nullopt;
    if (!lowered)
        return std::nullopt;
    const std::vector<float> block = parameterBlock(*lowered, {}, {}, {}, diagnostics);
    lowered->whole = ir::foldAll(lowered->whole, block);
    return lowered;
}

void ShaderLibrary::State::replace(ShaderCode &code) {
    const bool isSurface = code.shader().kind == sl::ShaderKind::Surface;
    const bool isLight = code.shader().kind == sl::ShaderKind::Light;
    diagnostics.error({}, "shader \"" + code.name() + "\" has no code, so " +
                              (isSurface ? "its surfaces get the default surface"
                               : isLight ? "its lights give no light"
                                         : "it is left out"));
    auto other = isSurface ? standIn(code.lightRule()) : std::nullopt;
    if (!other)
        return;
    code.become(std::move(*other));
    code.compileAll(diagnostics);
}

void ShaderLibrary::makeReady() {
    const std::size_t first = std::exchange(state_->ready, state_->inOrder.size());
    const std::size_t count = state_->ready - first;
    // What is said is passed on in the shaders' order, whichever is compiled first.
    std::vector<DiagnosticList> words(count);
    std::vector<char> compiled(count);
    parallelFor(count, [&](std::size_t k) {
        compiled[k] = state_->inOrder[first + k]->compileAll(words[k]);
    });
    for (std::size_t k = 0; k < count; ++k) {
        state_->sayOnce(words[k]);
        if (!compiled[k])
            state_->replace(*state_->inOrder[first + k]);
    }
}

void ShaderLibrary::bindLights(std::vector<std::vector<ToldParameter>> lights) {
    state_->answers->bindLights(std::move(lights));
}

void ShaderLibrary::bindOptions(const Options &options) { state_->answers->bindOptions(options); }

bool ShaderLibrary::hasShadowMap(const std::string &name) const {
    return state_->answers->hasShadowMap(name);
}

void ShaderLibrary::bindRays(const RayAnswers *rays) { state_->answers->bindRays(rays); }

std::vector<std::shared_ptr<ShaderCode>> ShaderLibrary::all() const { return state_->inOrder; }

/// What instances have that scenes do not say.
static void addDefaults(ContentHash &hash, const ir::ShaderParameter &parameter) {
    hash.add(parameter.name);
    hash.add(parameter.defaultSpace);
    hash.add({reinterpret_cast<const char *>(parameter.defaults.data()),
              parameter.defaults.size() * sizeof(float)});
    for (const std::string &text : parameter.stringDefaults)
        hash.add(text);
}

std::string ShaderLibrary::fingerprint() const {
    std::vector<std::string> texts;
    for (const std::shared_ptr<ShaderCode> &code : state_->inOrder) {
        ContentHash hash;
        hash.add(code->name());
        addFunction(hash, code->shader().whole);
        for (const ir::ShaderParameter &parameter : code->shader().parameters)
            addDefaults(hash, parameter);
        texts.push_back(hash.text());
    }
    std::ranges::sort(texts);
    ContentHash hash;
    for (const std::string &text : texts)
        hash.add(text);
    return hash.text();
}

Jit::Statistics ShaderLibrary::statistics() const { return state_->jit->statistics(); }

} // namespace candela
