// SPDX-License-Identifier: Apache-2.0
#include "shading_cases.h"

#include "language/ir/lower/lower.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"
#include "language/ir/transform/fuse.h"
#include "language/ir/transform/light_rule.h"
#include "language/semantics/front.h"

#include <fstream>
#include <sstream>

namespace candela::bench {

static std::string textOf(const std::string &file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

static std::string namesOf(const std::vector<ir::ParameterSlot> &slots) {
    std::string names;
    for (const ir::ParameterSlot &slot : slots)
        names += (names.empty() ? "" : " ") + slot.name;
    return names;
}

static bool writesColorAndOpacity(const ir::Function &function) {
    const std::vector<ir::OutputSlot> &outputs = function.outputs;
    return outputs.size() == 6 && outputs[0].name == "Ci" && outputs[3].name == "Oi";
}

std::optional<ShadingWork> shadingWork(const ShadingCase &which, int points,
                                       DiagnosticSink &diagnostics) {
    const std::string file = std::string(CANDELA_SOURCE_DIR) + "/" + which.file;
    const auto front = sl::analyzeSource({file, textOf(file)}, {}, diagnostics);
    const auto lowered = front ? ir::lower(*front->shaders[0], {}, {}, diagnostics) : std::nullopt;
    if (!lowered)
        return std::nullopt;
    ir::Function function =
        ir::slice(ir::applyLightRule(ir::fold(lowered->whole, {}), ir::LightRule::Classic),
                  ir::Question::Shade);
    if (runtime::hostIsaLevel() != runtime::IsaLevel::V2)
        ir::fuseProducts(function);
    if (namesOf(function.parameters) != which.parameters || !writesColorAndOpacity(function)) {
        diagnostics.error({}, file + ": by hand it has other parameters or outputs");
        return std::nullopt;
    }
    ir::TestBatch batch(function, points, 1);
    batch.setSamples(4, 1);
    batch.parameterOffset.assign(batch.padded(), 0);
    for (const ir::ShaderParameter &parameter : lowered->parameters)
        if (parameter.firstSlot >= 0)
            std::copy(parameter.defaults.begin(), parameter.defaults.end(),
                      batch.parameters.begin() + parameter.firstSlot);
    return ShadingWork{std::move(function), std::move(batch)};
}

} // namespace candela::bench
