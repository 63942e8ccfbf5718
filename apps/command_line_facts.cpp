// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line_facts.h"

#include <sstream>

namespace candela {

std::vector<const CLI::App *> verbsOf(const CLI::App &program) {
    return program.get_subcommands([](const CLI::App *verb) {
        return !verb->get_name().empty() && !verb->get_group().empty();
    });
}

std::vector<const CLI::Option *> optionsOf(const CLI::App &verb) {
    std::vector<const CLI::Option *> options =
        verb.get_options([](const CLI::Option *option) { return !option->get_group().empty(); });
    // Groups are verbs without a name.
    for (const CLI::App *group : verb.get_subcommands([](const CLI::App *) { return true; }))
        if (group->get_name().empty())
            for (const CLI::Option *option : optionsOf(*group))
                options.push_back(option);
    return options;
}

std::vector<std::string> dashedNames(const CLI::Option &option) {
    std::vector<std::string> names;
    for (const std::string &name : option.get_snames())
        names.push_back("-" + name);
    for (const std::string &name : option.get_lnames())
        names.push_back("--" + name);
    return names;
}

std::vector<std::string> choicesOf(const CLI::Option &option) {
    const std::string type = option.get_type_name(); // "TEXT:{a,b}"
    const std::size_t open = type.find('{'), close = type.rfind('}');
    std::vector<std::string> choices;
    if (open == std::string::npos || close == std::string::npos)
        return choices;
    std::istringstream list(type.substr(open + 1, close - open - 1));
    for (std::string choice; std::getline(list, choice, ',');)
        choices.push_back(choice);
    return choices;
}

} // namespace candela
