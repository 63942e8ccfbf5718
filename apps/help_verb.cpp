// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line_facts.h"
#include "apps/manual.h"
#include "apps/shader_text.h"
#include "apps/verbs.h"

#include "foundation/base/suggestion.h"
#include "render/console.h"
#include "render/reference.h"
#include "render/shader_folders.h"
#include "render/shader_library_reference.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <memory>

namespace candela {

namespace {

constexpr const char *topics =
    "candela help WORD tells of a request, an option, an attribute, a function of the Shading\n"
    "Language or a shader: candela help Sphere, candela help integrator, candela help noise\n\n"
    "  requests     all requests of the RenderMan Interface\n"
    "  options      what Option sets\n"
    "  attributes   what Attribute sets\n"
    "  statements   those of the Shading Language that ask for light and give it\n"
    "  functions    all functions of the Shading Language\n"
    "  shaders      those that come with Candela; or one kind of them: surfaces, lights,\n"
    "               displacements, volumes, imagers, filters\n\n"
    "candela info tells more of a shader, candela --help and candela VERB --help of verbs\n";

/// Of a shader of that name or file that scenes here would use, unless it is one of the library.
std::vector<std::string> entriesOfOwnShader(const std::string &name) {
    Console console(Console::Words::Messages);
    const ShaderFolders folders = shaderFolders("", {}, console);
    std::string problem;
    const auto source = readShader(name, folders.all, problem);
    const auto isOf = [&](const std::string &folder) {
        return std::filesystem::path(source->name).parent_path() == folder;
    };
    if (!source || std::ranges::any_of(folders.library, isOf))
        return {};
    return shaderEntries(*source, folders.all, console);
}

int tell(const std::string &word) {
    if (word.empty()) {
        std::fputs(topics, stdout);
        return 0;
    }
    std::vector<std::string> entries = referenceOf(word);
    std::ranges::move(entriesOfOwnShader(word), std::back_inserter(entries));
    for (std::size_t k = 0; k < entries.size(); ++k)
        std::printf("%s%s\n", k > 0 ? "\n" : "", entries[k].c_str());
    if (!entries.empty())
        return 0;
    std::fprintf(stderr, "candela help: there is no entry of \"%s\"%s\n", word.c_str(),
                 suggestion(word, referenceWords()).c_str());
    return 1;
}

int printManual(const CLI::App &program, const std::string &verb) {
    std::vector<const CLI::App *> all = verbsOf(program);
    const auto found = std::ranges::find(all, verb, &CLI::App::get_name);
    if (found == all.end() && verb != "candela") {
        std::fprintf(stderr, "candela help: there is no verb \"%s\"\n", verb.c_str());
        return 1;
    }
    std::fputs(manualPage(found == all.end() ? program : **found).c_str(), stdout);
    return 0;
}

/// `candela help` and what may follow.
struct Asked {
    std::string word, manual, shell;
};

int answer(const CLI::App &program, const Asked &asked) {
    if (!asked.shell.empty()) {
        std::fputs(completionScript(asked.shell, program, referenceWords()).c_str(), stdout);
        return 0;
    }
    return asked.manual.empty() ? tell(asked.word) : printManual(program, asked.manual);
}

} // namespace

void addHelp(CLI::App &app, int &status) {
    auto asked = std::make_shared<Asked>();
    CLI::App *help = app.add_subcommand(
        "help", "The reference entry of a request, option, attribute, function or shader");
    help->footer("Exit status: 0 all went well, 1 there is no such word, 2 the command line cannot "
                 "be understood.");
    help->add_option("word", asked->word, "What to tell of; none: what there is");
    CLI::Option *const manual =
        help->add_option("--man", asked->manual,
                         "The manual page of this verb, or of candela, for man -l -")
            ->type_name("VERB");
    help->add_option("--completion", asked->shell,
                     "A script that makes a shell complete candela's command line: "
                     "source <(candela help --completion bash)")
        ->check(CLI::IsMember(completingShells()))
        ->excludes(manual);
    help->callback([asked, &app, &status] { status = answer(app, *asked); });
}

} // namespace candela
