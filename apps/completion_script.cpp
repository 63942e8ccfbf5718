// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line_facts.h"
#include "apps/manual.h"

namespace candela {

namespace {

std::string joined(const std::vector<std::string> &words, const char *between) {
    std::string text;
    for (const std::string &word : words)
        text += (text.empty() ? "" : between) + word;
    return text;
}

std::vector<std::string> optionNames(const CLI::App &verb) {
    std::vector<std::string> names;
    for (const CLI::Option *option : optionsOf(verb))
        for (const std::string &name : dashedNames(*option))
            names.push_back(name);
    return names;
}

std::vector<std::string> verbNames(const CLI::App &program) {
    std::vector<std::string> names;
    for (const CLI::App *verb : verbsOf(program))
        names.push_back(verb->get_name());
    return names;
}

/// The program without a verb, then its verbs.
std::vector<const CLI::App *> allOf(const CLI::App &program) {
    std::vector<const CLI::App *> all{&program};
    for (const CLI::App *verb : verbsOf(program))
        all.push_back(verb);
    return all;
}

/// In single quotes, for any shell.
std::string quoted(const std::string &text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return result + "'";
}

std::string bashScript(const CLI::App &program, const std::vector<std::string> &helpWords) {
    std::string values, options;
    for (const CLI::App *verb : allOf(program)) {
        const std::string name = verb == &program ? "render" : verb->get_name();
        for (const CLI::Option *option : optionsOf(*verb))
            if (const auto choices = choicesOf(*option); !choices.empty())
                for (const std::string &dashed : dashedNames(*option))
                    values += "        " + name + ":" + dashed + ") words='" +
                              joined(choices, " ") + "' ;;\n";
        options += "            " + name + ") words='" + joined(optionNames(*verb), " ") + "' ;;\n";
    }
    const std::string verbs = joined(verbNames(program), " ");
    return "# Completion of candela for bash (and, by bashcompinit, zsh).\n"
           "_candela() {\n"
           "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]}\n"
           "    local verb=render words=''\n"
           "    case ' " +
           verbs +
           " ' in\n"
           "        *\" ${COMP_WORDS[1]} \"*) [ \"$COMP_CWORD\" -gt 1 ] && verb=${COMP_WORDS[1]} "
           ";;\n"
           "    esac\n"
           "    case $verb:$before in\n" +
           values + "        help:help) words='" + joined(helpWords, " ") +
           "' ;;\n"
           "    esac\n"
           "    if [ -z \"$words\" ]; then\n"
           "        case $word in\n"
           "        -*) case $verb in\n" +
           options +
           "            esac ;;\n"
           "        *) [ \"$COMP_CWORD\" -eq 1 ] && words='" +
           verbs +
           "' ;;\n"
           "        esac\n"
           "    fi\n"
           "    COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
           "}\n"
           "complete -o bashdefault -o default -F _candela candela\n";
}

std::string fishScript(const CLI::App &program, const std::vector<std::string> &helpWords) {
    std::string script = "# Completion of candela for fish.\n";
    for (const CLI::App *verb : verbsOf(program))
        script += "complete -c candela -n __fish_use_subcommand -a " + verb->get_name() + " -d " +
                  quoted(verb->get_description()) + "\n";
    for (const CLI::App *verb : allOf(program)) {
        const std::string where = verb == &program
                                      ? "__fish_use_subcommand"
                                      : quoted("__fish_seen_subcommand_from " + verb->get_name());
        for (const CLI::Option *option : optionsOf(*verb)) {
            if (option->get_snames().empty() && option->get_lnames().empty())
                continue;
            script += "complete -c candela -n " + where;
            for (const std::string &name : option->get_snames())
                script += " -s " + name;
            for (const std::string &name : option->get_lnames())
                script += " -l " + name;
            if (const auto choices = choicesOf(*option); !choices.empty())
                script += " -x -a " + quoted(joined(choices, " "));
            else if (option->get_type_size() != 0)
                script += " -r";
            script += " -d " + quoted(option->get_description()) + "\n";
        }
    }
    return script + "complete -c candela -n '__fish_seen_subcommand_from help' -f -a " +
           quoted(joined(helpWords, " ")) + "\n";
}

} // namespace

std::vector<std::string> completingShells() { return {"bash", "zsh", "fish"}; }

std::string completionScript(const std::string &shell, const CLI::App &program,
                             const std::vector<std::string> &helpWords) {
    if (shell == "fish")
        return fishScript(program, helpWords);
    const std::string bash = bashScript(program, helpWords);
    return shell == "bash" ? bash : "autoload -U +X bashcompinit && bashcompinit\n" + bash;
}

} // namespace candela
