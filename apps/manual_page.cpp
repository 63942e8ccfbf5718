// SPDX-License-Identifier: Apache-2.0
#include "apps/command_line_facts.h"
#include "apps/manual.h"

#include <algorithm>
#include <cctype>

namespace candela {

namespace {

/// Text that means itself: backslashes, dashes that are dashes, lines that begin with a dot.
std::string plain(const std::string &text) {
    std::string result;
    for (const char c : text) {
        if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n'))
            result += "\\&";
        if (c == '\\' || c == '-')
            result += '\\';
        result += c == '\\' ? 'e' : c;
    }
    return result;
}

std::string inCapitals(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return char(std::toupper(c)); });
    return text;
}

std::string fullName(const CLI::App &verb) {
    return verb.get_parent() ? "candela-" + verb.get_name() : "candela";
}

/// "FILE", "TEXT in {path,bidir}": what --help shows of a value.
std::string valueOf(const CLI::Option &option) {
    const std::vector<std::string> choices = choicesOf(option);
    if (choices.empty())
        return option.get_type_size() == 0 ? "" : option.get_type_name();
    std::string text;
    for (const std::string &choice : choices)
        text += (text.empty() ? "" : "|") + choice;
    return text;
}

std::string synopsis(const CLI::App &verb) {
    std::string text = "\\fB" +
                       plain(verb.get_parent() ? "candela " + verb.get_name() : "candela") +
                       "\\fR [\\fIoptions\\fR]";
    for (const CLI::Option *option : optionsOf(verb))
        if (option->get_positional())
            text += " \\fI" + plain(option->get_name(true)) + "\\fR" +
                    (option->get_expected_max() > 1 ? " ..." : "");
    return text;
}

std::string entry(const std::string &head, const std::string &text) {
    return ".TP\n" + head + "\n" + plain(text) + "\n";
}

std::string optionEntries(const CLI::App &verb) {
    std::string text;
    for (const CLI::Option *option : optionsOf(verb)) {
        std::string head;
        for (const std::string &name : dashedNames(*option))
            head += (head.empty() ? "" : ", ") + ("\\fB" + plain(name) + "\\fR");
        if (head.empty())
            head = "\\fI" + plain(option->get_name(true)) + "\\fR";
        else if (const std::string value = valueOf(*option); !value.empty())
            head += " \\fI" + plain(value) + "\\fR";
        text += entry(head, option->get_description());
    }
    return text;
}

} // namespace

std::string manualPage(const CLI::App &verb) {
    const std::string name = fullName(verb);
    std::string page = ".TH " + inCapitals(name) + " 1 \"\" \"candela " CANDELA_VERSION "\"\n";
    page += ".SH NAME\n" + plain(name) + " \\- " + plain(verb.get_description()) + "\n";
    page += ".SH SYNOPSIS\n" + synopsis(verb) + "\n";
    page += ".SH OPTIONS\n" + optionEntries(verb);
    if (const auto verbs = verbsOf(verb); !verbs.empty()) {
        page += ".SH VERBS\n";
        for (const CLI::App *each : verbs)
            page += entry("\\fBcandela\\-" + plain(each->get_name()) + "\\fR(1)",
                          each->get_description());
    }
    if (!verb.get_footer().empty())
        page += ".SH NOTES\n" + plain(verb.get_footer()) + "\n";
    if (verb.get_parent())
        page += ".SH SEE ALSO\n\\fBcandela\\fR(1)\n";
    return page;
}

} // namespace candela
