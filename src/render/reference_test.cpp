// SPDX-License-Identifier: Apache-2.0
#include "render/reference.h"

#include "interface/ri/request_meanings.h"
#include "interface/ri/state_parameters.h"
#include "render/shader_library_reference.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <set>
#include <sstream>

namespace candela {
namespace {

TEST(Reference, HasEveryWordOfTheTables) {
    for (const std::string &word : referenceWords()) {
        const std::vector<std::string> entries = referenceOf(word);
        ASSERT_FALSE(entries.empty()) << word;
        EXPECT_TRUE(std::ranges::any_of(entries, [&](const std::string &entry) {
            return entry.find(word) != entry.npos;
        })) << word;
    }
    EXPECT_GT(referenceWords().size(), 300u);
}

TEST(Reference, ToldOfAKindTellsOfAllOfIt) {
    EXPECT_EQ(referenceOf("requests").size(), requestTable().size());
    EXPECT_EQ(referenceOf("options").size() + referenceOf("attributes").size(),
              stateParameters().size());
    EXPECT_GT(referenceOf("functions").size(), 100u);
    EXPECT_EQ(referenceOf("statements").size(), 4u);
    EXPECT_TRUE(referenceOf("no such word").empty());
}

TEST(Reference, HasTheLibraryOfShadersByKinds) {
    EXPECT_EQ(referenceOf("shaders").size(), libraryShaderNames().size());
    EXPECT_GT(referenceOf("shaders").size(), 45u);
    std::size_t sum = 0;
    for (const char *kinds :
         {"surfaces", "lights", "displacements", "volumes", "imagers", "filters"}) {
        const std::vector<std::string> entries = libraryShaderEntries(kinds);
        EXPECT_FALSE(entries.empty()) << kinds;
        EXPECT_GE(referenceOf(kinds).size(), entries.size()) << "an attribute may be called so";
        sum += entries.size();
    }
    EXPECT_EQ(sum, libraryShaderNames().size());
    EXPECT_EQ(
        referenceOf("matte"),
        std::vector<std::string>{
            "surface matte(Ka, Kd)\n"
            "    An ideal diffuse surface of albedo Kd * Cs, the same from both sides.\n"
            "    float Ka = 1: share of ambient light that is sent on [0 to 1]\n"
            "    float Kd = 1: share of all other light, times the surface's colour: the albedo "
            "[0 to 1]"});
    EXPECT_EQ(referenceOf("null").size(), 2u) << "a surface and an imager";
}

/// Each shader says what it is for, and each parameter what it is, with range and unit in brackets.
TEST(Reference, SaysOfEveryParameterOfTheLibraryWhatItIs) {
    for (const std::string &entry : referenceOf("shaders")) {
        std::istringstream lines(entry);
        std::string title, about;
        std::getline(lines, title);
        std::getline(lines, about);
        EXPECT_TRUE(about.ends_with('.')) << entry;
        const auto commas = std::ranges::count(title, ',');
        std::ptrdiff_t parameters = 0;
        for (std::string line; std::getline(lines, line); ++parameters)
            EXPECT_TRUE(line.find(": ") != line.npos && line.find(" [") != line.npos &&
                        line.ends_with(']'))
                << title << "\n"
                << line;
        EXPECT_EQ(parameters, title.ends_with("()") ? 0 : commas + 1) << entry;
    }
}

TEST(Reference, TellsOfAnyShader) {
    DiagnosticList problems;
    const auto entries =
        shaderEntries({"two.sl", "surface bare() {} surface odd(color c[2] = {1, 2}; string s = "
                                 "\"a\"; output varying float f = 1e-9; float g = ycomp(P);) {}"},
                      {}, problems);
    EXPECT_EQ(problems.text(), "");
    EXPECT_EQ(entries, (std::vector<std::string>{
                           "surface bare()", "surface odd(c, s, f, g)\n"
                                             "    color c[2] = { (1, 1, 1), (2, 2, 2) }\n"
                                             "    string s = \"a\"\n"
                                             "    output varying float f = 1e-09\n"
                                             "    float g = computed where the shader starts"}));
    EXPECT_TRUE(shaderEntries({"bad.sl", "surface bad( {}"}, {}, problems).empty());
    EXPECT_EQ(problems.count(Severity::Error), 1);
}

/// A request without a sentence would be called one of other renderers.
TEST(Reference, HasASentenceForEveryRequestThatIsServed) {
    const std::pair<std::string_view, std::string_view> consequences[] = {
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) {#Name, consequence},
#include "interface/ri/requests.def"
    };
    std::set<std::string_view> foreign;
    for (const auto &[name, consequence] : consequences)
        if (consequence.find("belongs to other renderers") != std::string_view::npos)
            foreign.insert(name);
    for (const RequestDescription &request : requestTable())
        EXPECT_EQ(meaningOf(RequestId(&request - requestTable().data())).empty(),
                  foreign.contains(request.name))
            << request.name;
}

} // namespace
} // namespace candela
