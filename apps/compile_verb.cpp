// SPDX-License-Identifier: Apache-2.0
#include "apps/asked_instruction_set.h"
#include "apps/compiler_passes.h"
#include "apps/shader_text.h"
#include "apps/verbs.h"

#include "foundation/base/whole_file.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/fuse.h"
#include "language/jit/jit.h"
#include "language/semantics/front.h"
#include "render/console.h"
#include "render/shader_folders.h"

#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <memory>

namespace candela {

namespace {

struct Arguments {
    std::vector<std::string> files;
    std::vector<std::string> defines;
    sl::FrontOptions front;
    std::string emit, question, integrator = "path", output, depfile;
    JitOptions jit;
    bool quiet = false;
};

/// "1 cone", "2 cones"
std::string countOf(size_t count, const std::string &what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

/// What was found, in a line.
std::string summaryOf(const sl::TypedShader &shader, const CompiledShader &compiled,
                      double seconds) {
    size_t instructions = 0;
    size_t pixelLoops = 0;
    for (const CompiledShader::Answer &answer : compiled.answers) {
        instructions += ir::instructionCount(answer.function.body);
        pixelLoops += answer.function.pixelLoops.size();
    }
    std::string line = std::string(sl::nameOf(shader.kind)) + " " + shader.name + ": ";
    if (shader.kind == sl::ShaderKind::Surface) {
        const ir::SurfaceFacts &facts = compiled.facts;
        line +=
            std::to_string(facts.cones.size()) + (facts.cones.size() == 1 ? " cone, " : " cones, ");
        line += facts.affine ? "affine in the light, "
                             : "not affine in the light (line " +
                                   std::to_string(facts.notAffineLine) + "), ";
        line += facts.emits ? "may emit, " : "";
    } else if (shader.kind == sl::ShaderKind::Light) {
        line += countOf(compiled.lightFacts.cones.size(), "cone") + " of emission, ";
        line += compiled.lightFacts.conesAreTheLights ? "" : "which differ by what is lit, ";
    } else if (shader.kind == sl::ShaderKind::Volume) {
        const ir::VolumeFacts &facts = compiled.volumeFacts;
        line += facts.affine ? "affine in what it is given, "
                             : "not affine in what it is given (line " +
                                   std::to_string(facts.notAffineLine) + "), ";
        line += facts.asksForLight ? "asks for light, " : "";
    } else if (shader.kind == sl::ShaderKind::Filter) {
        line += countOf(pixelLoops, "pixel loop") + ", ";
    }
    line += compiled.displacement.movesP ? "moves points, " : "";
    char figures[64];
    std::snprintf(figures, sizeof figures, ", %zu instructions, %.0f ms", instructions,
                  seconds * 1000);
    return line + countOf(compiled.answers.size(), "entry point") + figures;
}

/// One run of the verb.
class CompileRun {
public:
    explicit CompileRun(const Arguments &arguments)
        : arguments_(arguments), console_(Console::Words::Messages), jit_(arguments.jit, console_) {
    }

    int status() {
        for (const std::string &file : arguments_.files)
            compileFile(file);
        writeOutput();
        writeDepfile();
        return console_.failed() ? 1 : 0;
    }

private:
    void compileFile(const std::string &name) {
        std::string problem;
        const auto text = readSource(name, problem);
        if (!text) {
            console_.error({}, "cannot read the shader file \"" + name + "\": " + problem);
            return;
        }
        const std::string shown = name == "-" ? "standard input" : name;
        sl::FrontOptions options = arguments_.front;
        const auto library = shaderFolders(name, {}, console_).library;
        options.includeDirectories.insert(options.includeDirectories.end(), library.begin(),
                                          library.end());
        const auto front = sl::analyzeSource({shown, *text}, options, console_);
        if (!front)
            return;
        read_.push_back(name);
        read_.insert(read_.end(), front->includedFiles.begin(), front->includedFiles.end());
        for (const auto &shader : front->shaders)
            compile(*shader);
    }

    void compile(const sl::TypedShader &shader) {
        const auto start = std::chrono::steady_clock::now();
        const bool showsPasses = arguments_.emit == "passes";
        if (showsPasses)
            show(shader.name + ": check", sl::print(shader));
        const auto rule =
            arguments_.integrator == "path" ? ir::LightRule::Path : ir::LightRule::Classic;
        const auto listener = [&](const char *pass, const ir::Function &function) {
            if (showsPasses && wanted(pass))
                show(shader.name + ": " + pass, ir::print(function));
        };
        const auto compiled = compileShader(shader, rule, listener, console_);
        if (!compiled)
            return;
        bool isAsked = false;
        for (const CompiledShader::Answer &answer : compiled->answers)
            if (arguments_.question.empty() || arguments_.question == ir::nameOf(answer.question)) {
                isAsked = true;
                ir::Function function = answer.function;
                if (jit_.fusesProducts() && ir::mayFuse(answer.question) && arguments_.emit != "ir")
                    ir::fuseProducts(function);
                generate(function);
            }
        if (!isAsked)
            console_.error(shader.where.location(), std::string(sl::nameOf(shader.kind)) +
                                                        " shaders have no entry point \"" +
                                                        arguments_.question + "\"");
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - start;
        if (arguments_.emit.empty() && !arguments_.quiet)
            std::printf("%s\n", summaryOf(shader, *compiled, taken.count()).c_str());
    }

    /// Passes that are not of a question are always shown, questions only if they are asked for.
    bool wanted(const std::string &pass) const {
        bool isQuestion = false;
        for (int q = 0; q < ir::questionCount; ++q)
            isQuestion |= pass == ir::nameOf(ir::Question(q));
        return !isQuestion || arguments_.question.empty() || arguments_.question == pass;
    }

    void generate(const ir::Function &function) {
        if (arguments_.emit == "ir")
            show(function.name, ir::print(function));
        else if (arguments_.emit == "llvm" || arguments_.emit == "asm")
            show(function.name, jit_.emit(function, arguments_.emit == "asm"));
        else if (arguments_.emit.empty() && !jit_.compile(function))
            console_.error({}, "no code could be made of " + function.name);
        for (const ir::PixelLoop &loop : function.pixelLoops)
            generate(*loop.body);
    }

    void show(const std::string &title, std::string text) {
        while (!text.empty() && text.back() == '\n')
            text.pop_back();
        const std::string comment = arguments_.emit == "asm" ? "# " : "; ";
        const std::string section = comment + title + "\n" + text + "\n\n";
        if (arguments_.output.empty())
            std::fputs(section.c_str(), stdout);
        else
            written_ += section;
    }

    void writeOutput() {
        if (arguments_.output.empty() || arguments_.emit.empty() || console_.failed())
            return;
        std::string problem;
        if (!writeWholeFile(arguments_.output, written_, problem))
            console_.error({}, problem);
    }

    /// A rule for make: what --output (or the depfile itself) has to be made anew after.
    void writeDepfile() {
        if (arguments_.depfile.empty() || console_.failed())
            return;
        const auto escaped = [](const std::string &name) {
            std::string text;
            for (char c : name)
                text += (c == ' ' || c == '#' || c == '\\' ? "\\"
                         : c == '$'                        ? "$"
                                                           : "") +
                        std::string(1, c);
            return text;
        };
        const bool hasOutput = !arguments_.output.empty();
        std::string rule = escaped(hasOutput ? arguments_.output : arguments_.depfile) + ":";
        for (const std::string &name : read_)
            rule += " \\\n  " + escaped(name);
        std::string problem;
        if (!writeWholeFile(arguments_.depfile, rule + "\n", problem))
            console_.error({}, problem);
    }

    const Arguments &arguments_;
    Console console_;
    Jit jit_;
    std::string written_;
    std::vector<std::string> read_; ///< The files, and those that they include.
};

} // namespace

void addCompile(CLI::App &app, int &status) {
    auto arguments = std::make_shared<Arguments>();
    Arguments &a = *arguments;
    CLI::App *compile = app.add_subcommand(
        "compile", "Check shaders and compile them into the cache, with the defaults of their "
                   "parameters; or print what the compiler makes of them");
    compile->footer("Exit status: 0 all went well, 1 something was wrong and has been reported, 2 "
                    "the command line cannot be understood.\nThe passes: docs/compiler.md");
    compile->add_option("files", a.files, "Shader sources (.sl); - reads standard input")
        ->required();
    compile->add_option("-I", a.front.includeDirectories, "Folder that #include searches")
        ->type_name("FOLDER")
        ->allow_extra_args(false);
    compile->add_option("-D", a.defines, "Define a macro; without a value as 1")
        ->type_name("NAME[=VALUE]")
        ->check(CLI::Validator(flawOfDefine, ""))
        ->allow_extra_args(false);
    compile
        ->add_option("--emit", a.emit,
                     "Print instead of filling the cache: passes (the text after each pass), ir "
                     "(what answers each question), llvm or asm")
        ->check(CLI::IsMember({"passes", "ir", "llvm", "asm"}));
    std::vector<std::string> questions;
    for (int q = 0; q < ir::questionCount; ++q)
        questions.push_back(ir::nameOf(ir::Question(q)));
    compile->add_option("--question", a.question, "Only the entry point that answers this")
        ->check(CLI::IsMember(questions));
    compile
        ->add_option("--integrator", a.integrator,
                     "path or classic: which light a shader's ambient() stands for; default path")
        ->check(CLI::IsMember({"path", "classic"}));
    compile->add_option("--lanes", a.jit.width, "Lane width of the code; default 16")
        ->check(CLI::IsMember({1, 16}));
    compile
        ->add_option("--cpu", "x86-64 level of the code: v2, v3 or v4; default: $CANDELA_CPU, "
                              "else the best")
        ->type_name("TEXT")
        ->check(CLI::IsMember({"v2", "v3", "v4"}));
    compile->add_option("-o,--output", a.output, "Write what is printed into this file");
    compile
        ->add_option("--depfile", a.depfile,
                     "Write a rule for make: which files were read, for --output")
        ->type_name("FILE");
    compile->add_flag("--quiet", a.quiet, "Only messages");
    compile->callback([arguments, compile, &status] {
        Arguments &a = *arguments;
        const auto *cpu = compile->get_option("--cpu");
        if (!instructionSetIsAsAsked(cpu->count() ? cpu->as<std::string>() : "")) {
            status = 2;
            return;
        }
        for (const std::string &define : a.defines)
            a.front.defines.push_back(defineOf(define));
        status = CompileRun(a).status();
    });
}

} // namespace candela
