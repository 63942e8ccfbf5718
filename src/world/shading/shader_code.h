// SPDX-License-Identifier: Apache-2.0
// One specialisation of a shader (its text with strings and steering parameters folded in, and
// the primitive variables that override parameters) with native code for each question, and the
// parameter blocks of all instances that share it.
#pragma once

#include "interface/ri/attributes.h"
#include "language/ir/lower.h"
#include "language/ir/questions.h"
#include "language/jit/jit.h"
#include "world/shading/shader_messages.h"

#include <array>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// What a wave must allocate and bind to ask one question.
struct QuestionCode {
    ir::Function function;
    ShaderFunction code = nullptr;

    /// Index of the first output plane of that name; -1 if the question doesn't have it.
    int output(std::string_view name) const;
    bool reads(ShaderInput input) const { return function.inputsRead[int(input)]; }
};

class ShaderCode {
public:
    ShaderCode(ir::LoweredShader, ir::LightRule, std::shared_ptr<Jit>,
               std::shared_ptr<const ShaderMessages>);

    const std::string &name() const { return shader_.name; }
    const ir::LoweredShader &shader() const { return shader_; }
    /// Surface shaders only.
    const ir::SurfaceFacts &facts() const { return facts_; }
    /// Compiled on first use, once; thread-safe. Null code if LLVM failed (reported).
    const QuestionCode &question(ir::Question) const;
    /// True if any question that the facts allow reads the input.
    bool reads(ShaderInput input) const { return shader_.whole.inputsRead[int(input)]; }
    /// Primitive variables that stand in for parameters: planes of ShaderArgs::variables.
    std::span<const ir::ParameterSlot> variables() const { return shader_.whole.variables; }

    /// Adds an instance's parameter block; its offset for ShaderArgs::parameterOffset. Not to be
    /// called once rendering has begun.
    std::int32_t addBlock(const std::vector<float> &values);
    /// Named coordinate systems: one of `systems` each, 32 floats; those unknown are identity.
    void bindSpaces(const std::map<std::string, Matrix4> &systems, DiagnosticSink &);
    /// `accepts[category][light + 1]`, row by row, in the shader's category order.
    void bindCategories(std::vector<std::uint8_t> accepts, int lightCount);
    const std::vector<std::string> &categories() const { return shader_.whole.categories; }
    /// True if all loops treat the light (index + 1, 0 = indirect) as they treat indirect light.
    /// If not, only samples that name the light can bring it.
    bool hearsAsIndirect(std::int32_t light) const {
        return hearsAsIndirect_.empty() || hearsAsIndirect_[light] != 0;
    }
    bool hearsAllAsIndirect() const { return hearsAsIndirect_.empty(); }
    /// False if every loop refuses the light (index + 1) by its category: the shader need not be
    /// asked about it. Known once categories are bound.
    bool hears(std::int32_t light) const;

    /// Fills what belongs to the shader: parameters, spaces, categories, and where it speaks.
    void bind(ShaderArgs &) const;

private:
    ir::LoweredShader shader_;
    ir::SurfaceFacts facts_;
    std::shared_ptr<Jit> jit_;
    std::shared_ptr<const ShaderMessages> messages_;
    std::vector<float> blocks_;
    std::vector<std::array<float, 32>> spaceMatrices_;
    std::vector<const float *> spaces_;
    std::vector<std::uint8_t> categoryAccepts_;
    std::vector<std::uint8_t> hearsAsIndirect_; ///< By light + 1; empty = all of them.
    int lightCount_ = 0;
    mutable std::array<std::once_flag, 8> once_;
    mutable std::array<QuestionCode, 8> questions_;
};

/// A shader as bound to primitives or a light.
struct ShaderInstance {
    std::shared_ptr<ShaderCode> code;
    std::int32_t parameterOffset = 0;
};

} // namespace candela
