// SPDX-License-Identifier: Apache-2.0
// The lowering at work: what its parts (statements, expressions, built-ins, light, spaces) share.
//
// Break, continue and return set cells of type bool, and what follows them in the text is put
// under the condition that none is set.
#pragma once

#include "language/ir/core/builder.h"
#include "language/ir/lower/inlining.h"
#include "language/ir/lower/lower.h"
#include "language/ir/lower/messages.h"
#include "language/ir/lower/spaces.h"
#include "language/ir/lower/strings_at_run_time.h"
#include "language/ir/lower/variables.h"
#include "language/semantics/typed_ast.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela::ir {

/// A Loop or light statement that is being lowered.
struct OpenLoop {
    const sl::Stmt *statement = nullptr;
    int broken = 0, continued = 0; ///< Cells.
};

/// The shader or a function that is being inlined.
struct Frame {
    const sl::Function *function = nullptr;
    int returned = 0; ///< Cell.
    int result = 0;   ///< First cell of its value.
    std::vector<OpenLoop> loops;
};

/// What a light shader turns out to do.
struct EmittedLight {
    LightClass kind = LightClass::Ambient;
    std::optional<Triple> direction; ///< L of the first illuminate or solar.
};

/// A shader that is being lowered.
struct Lowering {
    /// Predefined variables get what the renderer gives, outputs their starting values.
    Lowering(const sl::TypedShader &, const LoweringOptions &, const std::vector<StringValue> &,
             Function &, DiagnosticSink &);

    const sl::TypedShader &shader;
    /// The strings of the instance, and those that other shaders tell it.
    const std::vector<StringValue> &strings;
    StringsAtRunTime stringsAtRunTime;
    const LoweringOptions options;
    Builder b;
    Messages messages;
    Variables variables;
    Spaces spaces;
    /// Cell: a number that is another in each turn of each loop that draws random numbers.
    const int turn;
    std::vector<Frame> frames; ///< The shader, and the functions that are being inlined in it.
    std::vector<Components> targetValues; ///< Of the assignments that are being evaluated.
    Inlining inlining;
    std::map<int, sl::Place> derivatives; ///< The first on each line.
    bool usesFootprints = false; ///< Slopes stand in the text that it does not ask for itself.
    EmittedLight light;
    /// In the default of a parameter that is computed where the shader starts: points and their
    /// kin without a space are in "shader" there.
    bool inDefault = false;
    /// Of the light that the illuminance loop around is at; nothing outside of such loops.
    std::optional<ValueId> lightNumber;
};

/// A string that has to be known when the shader is compiled; reports that it is not.
std::string requiredText(Lowering &, ValueId, const sl::Place &, const std::string &what);

} // namespace candela::ir
