// SPDX-License-Identifier: Apache-2.0
// One specialisation of a shader (its text with control-relevant parameters folded in, and strings
// unless they only name pictures, and the primitive variables that override parameters) with native
// code for each question, and the parameter blocks of all instances that share it.
#pragma once

#include "interface/ri/attributes.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/light_rule.h"
#include "language/jit/jit.h"
#include "world/shading/light_categories.h"
#include "world/shading/shader_answers.h"
#include "world/shading/shader_messages.h"
#include "world/shading/shader_spaces.h"

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// What a wave must allocate and bind to ask one question.
struct QuestionCode {
    ir::Function function;
    ShaderFunction code = nullptr; ///< Null if LLVM failed (reported).

    /// By the code; without it by interpreting the function, which takes long.
    void ask(const ShaderArgs &args) const { code ? code(&args) : ir::interpret(function, args); }

    /// Index of the output's first plane; -1 if the question doesn't have it.
    int output(ir::OutputKind kind) const { return ir::slotOf(function.outputs, kind); }
    /// Puts the output's planes, as far as the question has them, where ShaderArgs::outputs wants
    /// them.
    void place(ir::OutputKind kind, float *const *planes, std::vector<float *> &outputs) const {
        outputs.resize(function.outputs.size());
        for (std::size_t slot = 0; slot < outputs.size(); ++slot)
            if (function.outputs[slot].name == kind)
                outputs[slot] = planes[function.outputs[slot].component];
    }
    bool reads(ShaderInput input) const { return function.inputsRead[int(input)]; }
};

class ShaderCode {
public:
    ShaderCode(ir::LoweredShader, ir::LightRule, std::shared_ptr<Jit>,
               std::shared_ptr<const ShaderMessages>, std::shared_ptr<const ShaderAnswers>);

    const std::string &name() const { return shader_.name; }
    const ir::LoweredShader &shader() const { return shader_; }
    ir::LightRule lightRule() const { return rule_; }
    /// Surface shaders only.
    const ir::SurfaceFacts &facts() const { return facts_; }
    /// Volume shaders only.
    const ir::VolumeFacts &volumeFacts() const { return volumeFacts_; }
    /// Whether it displaces: displacement shaders, and surface shaders that set P.
    const ir::DisplacementFacts &displacement() const { return displacement_; }
    /// Compiled on first use, once; thread-safe.
    const QuestionCode &question(ir::Question) const;

    /// Compiles, as one module, the questions that rendering asks. Before any is asked, by one
    /// thread a shader; false if there is no code for them.
    bool compileAll(DiagnosticSink &);
    /// Takes the text of another shader of its kind that reads no parameters, and that one's facts.
    void become(ir::LoweredShader);
    /// It has become another shader.
    bool isStandIn() const { return isStandIn_; }

    /// The names by which the instance with that block may ask a service for something.
    std::vector<std::string> namesAsked(Service, std::int32_t offset) const;
    /// True if any question that the facts allow reads the input.
    bool reads(ShaderInput input) const { return shader_.whole.inputsRead[int(input)]; }
    /// Primitive variables that stand in for parameters: planes of ShaderArgs::variables.
    std::span<const ir::ParameterSlot> variables() const { return shader_.whole.variables; }

    /// Adds an instance's parameter block; its offset for ShaderArgs::parameterOffset. Not to be
    /// called once rendering has begun.
    std::int32_t addBlock(const std::vector<float> &values);
    std::span<const float> block(std::int32_t offset) const {
        return std::span(blocks_).subspan(std::size_t(offset), shader_.whole.parameters.size());
    }
    /// The block at `offset` is the first of so many, one after the other, between which parameters
    /// go straight while the shutter is open.
    void setSteps(std::int32_t offset, int steps) { steps_[offset] = steps; }
    bool hasMotion() const { return !steps_.empty(); }
    int stepsOf(std::int32_t offset) const {
        const auto found = steps_.find(offset);
        return found == steps_.end() ? 1 : found->second;
    }
    /// Named coordinate systems; with a warning for those that are not there.
    void bindSpaces(const std::map<std::string, Matrix4> &systems, DiagnosticSink &);
    /// As LightCategories::bind().
    void bindCategories(std::vector<std::uint8_t> accepts, int lightCount);
    /// As LightCategories::leaveLightsToSamples().
    void leaveLightsToSamples(int lightCount) { categories_.leaveLightsToSamples(lightCount); }
    const LightCategories &categories() const { return categories_; }

    /// Fills what belongs to the shader: parameters, spaces, categories, where it speaks and whom
    /// it asks (`prints` as ShaderAnswers::services()).
    void bind(ShaderArgs &, bool prints = true) const;

private:
    struct CompiledQuestion {
        std::once_flag once;
        QuestionCode answer;
    };
    void readText();
    ir::Function answering(ir::Question) const;
    ir::Function slice(ir::Question) const; ///< As the level computes it.
    std::vector<ir::Question> questionsAsked() const;

    ir::LoweredShader shader_;
    ir::LightRule rule_;
    std::shared_ptr<const ir::Plan> plan_; ///< Of surfaces.
    ir::SurfaceFacts facts_;
    ir::VolumeFacts volumeFacts_;
    ir::DisplacementFacts displacement_;
    bool isStandIn_ = false;
    std::shared_ptr<Jit> jit_;
    std::shared_ptr<const ShaderMessages> messages_;
    std::shared_ptr<const ShaderAnswers> answers_;
    std::vector<float> blocks_;
    std::map<std::int32_t, int> steps_; ///< Of the blocks that move.
    ShaderSpaces spaces_;
    LightCategories categories_;
    mutable std::array<CompiledQuestion, ir::questionCount> questions_;
};

/// A shader as bound to primitives or a light.
struct ShaderInstance {
    std::shared_ptr<ShaderCode> code;
    std::int32_t parameterOffset = 0;
};

} // namespace candela
