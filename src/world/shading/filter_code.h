// SPDX-License-Identifier: Apache-2.0
// A filter shader with its parameters, as code: a function that runs once, and one for each of its
// pixel loops.
#pragma once

#include "language/ir/core/ir.h"
#include "language/jit/jit.h"
#include "world/shading/shader_answers.h"
#include "world/shading/shader_messages.h"

#include <memory>
#include <string>
#include <vector>

namespace candela {

class FilterCode {
public:
    /// `whole`: the text, its parameters folded in. Null, with an error, if there is no code.
    static std::shared_ptr<const FilterCode> compile(ir::Function whole, std::shared_ptr<Jit>,
                                                     std::shared_ptr<const ShaderMessages>,
                                                     std::shared_ptr<const ShaderAnswers>,
                                                     DiagnosticSink &);

    const std::string &name() const { return name_; }
    /// What runs once: ir::Function::maps, images and pixelLoops say what about.
    const ir::Function &driver() const { return driver_; }
    void run(const ShaderArgs &args) const { code_(&args); }
    /// A pixel loop's code; its lanes are pixels of a row.
    ShaderFunction loop(int number) const { return loops_[std::size_t(number)]; }

    const ShaderCallbacks &callbacks() const { return messages_->callbacks(); }
    const ShaderServices &services() const { return answers_->services(); }

private:
    FilterCode() = default;

    std::string name_;
    ir::Function driver_;
    ShaderFunction code_ = nullptr;
    std::vector<ShaderFunction> loops_;
    std::shared_ptr<Jit> jit_; ///< Whose the code is.
    std::shared_ptr<const ShaderMessages> messages_;
    std::shared_ptr<const ShaderAnswers> answers_;
};

} // namespace candela
