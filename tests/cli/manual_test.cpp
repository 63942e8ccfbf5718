// SPDX-License-Identifier: Apache-2.0
// Manual pages and completion: what they say is what the verbs take.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cstdio>
#include <gtest/gtest.h>

namespace candela::test {

namespace {

const char *const verbs[] = {"diff", "merge", "filter", "compile", "info",
                             "run",  "tex",   "probe",  "cat",     "help"};

/// "--spp", "--format": the long names in the text, dashes as they are.
std::vector<std::string> longOptionsIn(const std::string &text) {
    std::vector<std::string> names;
    for (std::size_t at = text.find("--"); at != std::string::npos; at = text.find("--", at + 2)) {
        const std::size_t end = text.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at + 2);
        if (end > at + 3)
            names.push_back(text.substr(at, end - at));
    }
    return names;
}

/// What bash offers for the last of these words.
std::string offered(const std::string &script, const std::vector<std::string> &words) {
    std::string list, command = "bash --norc -c 'source " + script + "; COMP_WORDS=(";
    for (const std::string &word : words)
        command += "\"" + word + "\" ";
    command += "); COMP_CWORD=" + std::to_string(words.size() - 1) +
               "; _candela; echo \"${COMPREPLY[@]}\"'";
    FILE *const bash = popen(command.c_str(), "r");
    if (!bash)
        return "no bash";
    char buffer[4096];
    while (const std::size_t got = std::fread(buffer, 1, sizeof buffer, bash))
        list.append(buffer, got);
    pclose(bash);
    return list.substr(0, list.find('\n'));
}

} // namespace

TEST(Manual, PagesNameAllThatHelpNames) {
    std::string all = runCandela({"help", "--man", "candela"}).out;
    for (const char *verb : verbs) {
        const Outcome page = runCandela({"help", "--man", verb});
        EXPECT_EQ(page.status, 0) << page.text();
        EXPECT_TRUE(page.out.starts_with(".TH CANDELA-")) << page.out;
        EXPECT_NE(all.find("\\fBcandela\\-" + std::string(verb)), std::string::npos) << verb;
        std::string plain;
        for (const char c : page.out)
            if (c != '\\')
                plain += c;
        for (const std::string &option : longOptionsIn(runCandela({verb, "--help"}).out))
            EXPECT_NE(plain.find(option), std::string::npos) << verb << " " << option;
        for (std::size_t line = page.out.find("\n."); line != std::string::npos;
             line = page.out.find("\n.", line + 1)) // Requests of ours alone.
            EXPECT_TRUE(page.out.compare(line, 4, "\n.TP") == 0 ||
                        page.out.compare(line, 4, "\n.SH") == 0)
                << page.out.substr(line, 40);
    }
    EXPECT_EQ(runCandela({"help", "--man", "fly"}).status, 1);
    EXPECT_EQ(runCandela({"help", "diff"}).out, runCandela({"diff", "--help"}).out);
}

TEST(Manual, BashCompletesVerbsOptionsValuesAndWords) {
    ScratchFolder folder;
    const Outcome script = runCandela({"help", "--completion", "bash"});
    ASSERT_EQ(script.status, 0) << script.text();
    const std::string file = folder.write("candela.bash", script.out);
    const struct {
        std::vector<std::string> words;
        std::string expected;
    } table[] = {
        {{"candela", "di"}, "diff"},
        {{"candela", "--integ"}, "--integrator"},
        {{"candela", "a.rib", "--integrator", "p"}, "path"},
        {{"candela", "a.rib", "--spp", ""}, ""},
        {{"candela", "diff", "--toler"}, "--tolerance"},
        {{"candela", "diff", "--spp"}, ""},
        {{"candela", "cat", "--bin"}, "--binary"},
        {{"candela", "help", "Paraboloi"}, "Paraboloid"},
        {{"candela", "help", "--completion", "fi"}, "fish"},
        {{"candela", "dif", "x"}, ""},
    };
    for (const auto &[words, expected] : table)
        EXPECT_EQ(offered(file, words), expected) << words.back();
}

TEST(Manual, EveryShellHasAScript) {
    for (const char *shell : {"bash", "zsh", "fish"}) {
        const Outcome script = runCandela({"help", "--completion", shell});
        EXPECT_EQ(script.status, 0);
        for (const char *verb : verbs)
            EXPECT_NE(script.out.find(verb), std::string::npos) << shell << " " << verb;
        EXPECT_NE(script.out.find("radiosity"), std::string::npos);
    }
    EXPECT_EQ(runCandela({"help", "--completion", "tcsh"}).status, 2);
}

} // namespace candela::test
