// SPDX-License-Identifier: Apache-2.0
// What the renderer answers to running shaders: the services of language/runtime/services.def.
#pragma once

#include "interface/ri/options.h"
#include "language/runtime/services.h"

namespace candela {

/// Answers all shaders of a scene, from any thread. Must outlive their calls.
class ShaderAnswers {
public:
    ShaderAnswers();
    ShaderAnswers(const ShaderAnswers &) = delete;
    ShaderAnswers &operator=(const ShaderAnswers &) = delete;

    const ShaderServices &services() const { return services_; }
    /// The options of the frame; not while a shader runs.
    void bindOptions(const Options &options) { options_ = options; }

private:
    void option(const ServiceCall &) const;

    ShaderServices services_;
    Options options_;
};

/// The numbers of an option as option() names it, "Ri:" before it or not: those of RI 3.2, section
/// 15.8, and "category:name" of RiOption, if it has this type ("float[3]"; whole numbers are
/// floats too). Points stand as they were given. Empty if there is none.
std::vector<float> optionValue(const Options &, std::string_view name, std::string_view type);

} // namespace candela
