// SPDX-License-Identifier: Apache-2.0
// What the renderer answers to running shaders: the services of language/runtime/services.def.
#pragma once

#include "interface/ri/options.h"
#include "language/runtime/services.h"
#include "world/shading/instance_values.h"
#include "world/shading/ray_answers.h"
#include "world/texture/textures.h"

#include <atomic>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace candela {

/// Answers all shaders of a scene, from any thread. Must outlive their calls.
class ShaderAnswers {
public:
    /// `textureFolders` as Textures has them.
    ShaderAnswers(std::vector<std::string> textureFolders, DiagnosticSink &);
    ShaderAnswers(const ShaderAnswers &) = delete;
    ShaderAnswers &operator=(const ShaderAnswers &) = delete;

    /// printf() is for points that are shaded; `prints` is false where a shader is only probed.
    const ShaderServices &services(bool prints = true) const {
        return prints ? services_ : silent_;
    }
    /// The number of a string that an instance gives, and the string; not while a shader runs.
    int numberOf(const std::string &);
    std::string stringOf(int number) const { return strings_[std::size_t(number)]; }
    /// The options of the frame; not while a shader runs.
    void bindOptions(const Options &);
    /// As Textures has it, for the options bound last.
    bool hasShadowMap(const std::string &name) const { return textures_.hasShadowMap(name); }
    /// Who follows rays; null: nobody, and they meet nothing. Not while a shader runs.
    void bindRays(const RayAnswers *rays) { rays_ = rays; }
    /// The parameters of the lights, by their index; likewise.
    void bindLights(std::vector<std::vector<ToldParameter>> lights) { lights_ = std::move(lights); }

private:
    void print(const ServiceCall &);
    void transmission(const ServiceCall &) const;
    void option(const ServiceCall &) const;
    void lightsource(const ServiceCall &) const;
    template <auto answer> void letTexturesAnswer(Service);

    DiagnosticSink &diagnostics_;
    std::atomic<std::size_t> printedBytes_{0};
    ShaderServices services_, silent_; ///< silent_ hears print and says nothing.
    std::map<std::string, int> numbers_;
    std::vector<const char *> strings_; ///< Those, by number.
    Options options_;
    const RayAnswers *rays_ = nullptr;
    std::vector<std::vector<ToldParameter>> lights_;
    Textures textures_;
};

/// The numbers of an option as option() names it, "Ri:" before it or not: those of RI 3.2, section
/// 15.8, and "category:name" of RiOption, if it has this type ("float[3]"; whole numbers are
/// floats too). Points stand as they were given. Empty if there is none.
std::vector<float> optionValue(const Options &, std::string_view name, std::string_view type);

} // namespace candela
