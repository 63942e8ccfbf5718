// SPDX-License-Identifier: Apache-2.0
// Shaders as the command line names them: "ward94 L_dmax=80".
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/options.h"
#include "interface/ri/scene_builder.h"

#include <string>
#include <vector>

namespace candela {

/// The filters of the words behind -f: a name each, and NAME=VALUE behind it. Values are numbers
/// ("80"), several of them ("1,0,0" or "[1 0 0]"; one is enough for a color), or text, as the
/// shader's parameter is declared. False if anything is wrong, which is reported.
bool readFilters(const std::vector<std::string> &words, ShaderLookup &, const Options &,
                 std::vector<ShaderRecord> &filters, DiagnosticSink &);

/// Adds the parameter that a word NAME=VALUE gives, as above. What is wrong with the word, to stand
/// behind the shader's name; empty if nothing is.
std::string takeValue(const std::string &word, const std::vector<ShaderLookup::ParameterType> &,
                      ShaderRecord &);

} // namespace candela
