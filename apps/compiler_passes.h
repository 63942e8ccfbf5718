// SPDX-License-Identifier: Apache-2.0
// One shader through all passes of the compiler, as `candela compile` shows them.
#pragma once

#include "language/ir/core/pass_listener.h"
#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/light_rule.h"
#include "language/semantics/typed_ast.h"

#include <optional>
#include <vector>

namespace candela {

/// A shader with the default values of its parameters, and the function that answers each question
/// that may be asked of its kind.
struct CompiledShader {
    struct Answer {
        ir::Question question;
        ir::Function function;
    };
    ir::SurfaceFacts facts;      ///< Of surfaces.
    ir::LightFacts lightFacts;   ///< Of lights.
    ir::BoundFacts bounds;       ///< Of surfaces and lights.
    ir::VolumeFacts volumeFacts; ///< Of volumes.
    ir::DisplacementFacts displacement;
    std::vector<Answer> answers;
    std::vector<ir::ShaderParameter> parameters;
    std::vector<std::string> parameterDocs; ///< The comment beside each.
    bool inverseSquare = false;             ///< Of lights, as LoweredShader has it.
};

/// Everything up to code generation; nothing if the shader has errors. The listener is told of
/// "lower", "derivatives", "clean up", "fold", "light rule", "plan", and of each answer by the
/// name of its question.
std::optional<CompiledShader> compileShader(const sl::TypedShader &, ir::LightRule,
                                            const ir::PassListener &, DiagnosticSink &);

} // namespace candela
