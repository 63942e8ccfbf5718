// SPDX-License-Identifier: Apache-2.0
// The parameter values of a shader instance: what the RIB gives, else the shader's defaults,
// brought into current space.
#pragma once

#include "interface/ri/attributes.h"
#include "interface/ri/options.h"
#include "language/ir/lower/lower.h"

#include <map>
#include <string>
#include <vector>

namespace candela {

/// What shaders tell others of their parameters (surface(), lightsource()...): numbers in current
/// space, colours as they are, or strings.
struct ToldParameter {
    std::string name;
    std::string shape; ///< "float", "color[3]", "string"...
    std::vector<float> values;
    std::vector<std::string> strings;
};
/// All parameters of the instance; and those that begin with "__" and are given to a shader that
/// has no such parameter.
std::vector<ToldParameter> toldParameters(const ir::LoweredShader &, const ShaderRecord &,
                                          const Options &);

/// What other shaders tell an instance, by ir::toldName().
using ToldValues = std::map<std::string, ToldParameter>;

/// The instance's parameter block: a float for each of shader.whole.parameters. Values of the
/// wrong type and parameters that the shader doesn't have are reported; defaults stand in.
/// `attributes`: of the primitive that the instance shades; null, and attribute() finds none.
std::vector<float> parameterBlock(const ir::LoweredShader &, const ShaderRecord &, const Options &,
                                  const ToldValues &, DiagnosticSink &,
                                  const Attributes *attributes = nullptr);
/// Whether instances for primitives of other attributes have other blocks.
bool asksForAttributes(const ir::LoweredShader &);

} // namespace candela
