// SPDX-License-Identifier: Apache-2.0
#include "apps/compiler_passes.h"
#include "apps/shader_text.h"
#include "apps/verbs.h"

#include "language/ir/core/regions.h"
#include "language/runtime/services.h"
#include "language/semantics/front.h"
#include "render/console.h"
#include "render/shader_entry.h"
#include "render/shader_folders.h"

#include <CLI/CLI.hpp>
#include <filesystem>
#include <fmt/format.h>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    std::vector<std::string> shaders, shaderPath, defines;
    sl::FrontOptions front;
    std::string integrator = "path";
};

const char *yesNo(bool holds) { return holds ? "yes" : "no"; }

/// With the line that it fails at, if that is known.
std::string yesOrWhereNot(bool holds, int line) {
    return yesNo(holds) + (holds || line <= 0 ? std::string() : fmt::format(" (line {})", line));
}

void printParameters(const CompiledShader &compiled) {
    if (!compiled.parameters.empty())
        fmt::print("  parameters\n");
    for (size_t i = 0; i < compiled.parameters.size(); ++i) {
        const std::string doc = inOneLine(compiled.parameterDocs[i]);
        fmt::print("    {}{}\n", declarationOf(compiled.parameters[i]),
                   doc.empty() ? "" : "  -- " + doc);
    }
}

/// "derived", "given by the shader", "derived; infinite where texture() (line 12) reaches"
std::string boundsText(const ir::BoundFacts &facts) {
    std::string text = facts.givenByShader ? "given by the shader" : "derived";
    for (std::size_t k = 0; k < facts.boundless.size(); ++k) {
        const ir::Boundless &reason = facts.boundless[k];
        text += (k ? ", " : "; infinite where these reach: ") + reason.what +
                (reason.line > 0 ? fmt::format(" (line {})", reason.line) : "");
    }
    return text;
}

void printProofs(const sl::TypedShader &shader, const CompiledShader &compiled) {
    if (shader.kind == sl::ShaderKind::Surface) {
        const ir::SurfaceFacts &facts = compiled.facts;
        fmt::print("  proofs\n    affine in the light: {}\n",
                   yesOrWhereNot(facts.affine, facts.notAffineLine));
        fmt::print("    light requests static: {}\n",
                   yesOrWhereNot(facts.staticRequests, facts.notStaticLine));
        fmt::print("    opaque where Os is 1: {}\n    black without light: {}\n",
                   yesNo(facts.opaqueIfOsIs1), yesNo(!facts.emits));
        fmt::print("    cones of importance: {}\n", facts.cones.size());
        fmt::print("    bounds over a box: {}\n", boundsText(compiled.bounds));
    } else if (shader.kind == sl::ShaderKind::Light) {
        fmt::print("  proofs\n    cones of emission: {}{}\n", compiled.lightFacts.cones.size(),
                   compiled.lightFacts.conesAreTheLights ? "" : ", which differ by what is lit");
        fmt::print("    falls off with the square of the distance: {}\n",
                   yesNo(compiled.inverseSquare));
        fmt::print("    bounds over a box: {}\n", boundsText(compiled.bounds));
    } else if (shader.kind == sl::ShaderKind::Volume) {
        const ir::VolumeFacts &facts = compiled.volumeFacts;
        fmt::print("  proofs\n    affine in what there is at its end: {}\n",
                   yesOrWhereNot(facts.affine, facts.notAffineLine));
        fmt::print("    asks for light: {}\n", yesNo(facts.asksForLight));
    }
    const ir::DisplacementFacts &moves = compiled.displacement;
    if (moves.movesP || moves.setsN)
        fmt::print("{}    moves P: {}\n    derivatives of P known: {}\n",
                   shader.kind == sl::ShaderKind::Surface ? "" : "  proofs\n", yesNo(moves.movesP),
                   yesNo(moves.slopesKnown));
}

/// What a lane costs: instructions as written, services by services.def.
void printEntryPoints(const CompiledShader &compiled) {
    fmt::print("  entry points\n");
    for (const CompiledShader::Answer &answer : compiled.answers) {
        const ir::Function &function = answer.function;
        std::string asks;
        for (const ir::ServiceUse &use : function.services)
            asks += (asks.empty() ? ", asks " : ", ") + std::string(use.info->name);
        fmt::print("    {:<9} {:>6} instructions, {:>3} + {:>3} saved numbers{}\n",
                   ir::nameOf(answer.question), ir::instructionCount(function.body),
                   function.surfaceSlots, function.viewSlots, asks);
    }
}

class InfoRun {
public:
    explicit InfoRun(const Arguments &arguments)
        : arguments_(arguments), console_(Console::Words::Messages),
          folders_(shaderFolders("", arguments.shaderPath, console_)) {}

    int status() {
        for (const std::string &shader : arguments_.shaders)
            describeFile(shader);
        return console_.failed() ? 1 : 0;
    }

private:
    void describeFile(const std::string &name) {
        std::string problem;
        const auto source = readShader(name, folders_.all, problem);
        if (!source)
            return console_.error({}, problem);
        sl::FrontOptions options = arguments_.front;
        options.hints = false;
        options.includeDirectories.insert(options.includeDirectories.end(), folders_.all.begin(),
                                          folders_.all.end());
        const auto front = sl::analyzeSource(*source, options, console_);
        for (size_t k = 0; front && k < front->shaders.size(); ++k)
            describe(*front->shaders[k], source->name);
    }

    void describe(const sl::TypedShader &shader, const std::string &file) {
        const std::string about = inOneLine(shader.doc);
        fmt::print("{} {}  ({}:{})\n", sl::nameOf(shader.kind), shader.name, file,
                   shader.where.line);
        if (!about.empty())
            fmt::print("  {}\n", about);
        const auto rule =
            arguments_.integrator == "path" ? ir::LightRule::Path : ir::LightRule::Classic;
        const auto compiled = compileShader(
            shader, rule, [](const char *, const ir::Function &) {}, console_);
        if (!compiled)
            return;
        printParameters(*compiled);
        printProofs(shader, *compiled);
        printEntryPoints(*compiled);
    }

    const Arguments &arguments_;
    Console console_;
    ShaderFolders folders_;
};

} // namespace

void addInfo(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *info = app.add_subcommand(
        "info", "Tell of shaders: parameters, defaults, what is proved, entry points, cost");
    info->footer("Exit status: 0 all went well, 1 something was wrong and has been reported, 2 the "
                 "command line cannot be understood.");
    info->add_option("shaders", a.shaders,
                     "Files, or names that are looked for on the shader path and in the library")
        ->required();
    info->add_option("-I", a.front.includeDirectories, "Folder that #include searches")
        ->type_name("FOLDER")
        ->allow_extra_args(false);
    info->add_option("-D", a.defines, "Define a macro; without a value as 1")
        ->type_name("NAME[=VALUE]")
        ->check(CLI::Validator(flawOfDefine, ""))
        ->allow_extra_args(false);
    info->add_option("--shader-path", a.shaderPath, "Folders to look for shaders in: a:b:c")
        ->delimiter(':')
        ->allow_extra_args(false);
    info->add_option("--integrator", a.integrator,
                     "path or classic: which light a shader's ambient() stands for; default path")
        ->check(CLI::IsMember({"path", "classic"}));
    info->callback([arguments, &status] {
        for (const std::string &define : arguments->defines)
            arguments->front.defines.push_back(defineOf(define));
        status = InfoRun(*arguments).status();
    });
}

} // namespace candela
