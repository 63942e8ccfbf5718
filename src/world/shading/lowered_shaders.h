// SPDX-License-Identifier: Apache-2.0
// Checked shaders lowered for the strings of instances. Instances whose strings only name pictures
// share a text: it reads them from the parameter block.
#pragma once

#include "language/ir/lower/lower.h"
#include "world/shading/instance_values.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace candela {

class ShaderAnswers;

/// A text for an instance.
struct LoweredText {
    const ir::LoweredShader *shader = nullptr; ///< Null: it has errors, which are told.
    std::vector<ir::StringValue> strings;      ///< Of the instance.

    /// Puts the numbers of strings that are left to run time into the instance's parameter block.
    void placeStrings(ShaderAnswers &, std::vector<float> &block) const;
};

class LoweredShaders {
public:
    /// What texts are told apart by, beside the shader itself.
    struct Wishes {
        const std::set<std::string> *variables = nullptr; ///< Primitive variables; null: none.
        const ToldValues *told = nullptr;                 ///< By other shaders; null: nothing.
        ir::LoweringOptions lowering{};
        /// Strings may be left to run time.
        bool leavesStrings = true;
    };
    /// Adds to `key` what tells the text apart. `words`: of a text that has not been lowered
    /// before.
    LoweredText find(const sl::TypedShader &, const ShaderRecord &, const Options &, const Wishes &,
                     std::string &key, DiagnosticSink &words);

private:
    std::vector<ir::StringValue> stringsFor(const sl::TypedShader &, const ShaderRecord &,
                                            const Wishes &);
    const std::set<std::string> &textsIn(const sl::TypedShader &);

    std::map<std::string, std::optional<ir::LoweredShader>> lowered_; ///< By key.
    /// By the key with all strings that may be left: parameters whose strings are needed.
    std::map<std::string, std::set<std::string>> needed_;
    std::map<const sl::TypedShader *, std::set<std::string>> texts_; ///< As ir::textsOf().
};

} // namespace candela
