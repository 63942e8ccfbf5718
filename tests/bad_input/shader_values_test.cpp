// SPDX-License-Identifier: Apache-2.0
// Values that do not fit a shader's parameters: said with the place, and the default is used.
#include "tests/bad_input/bad_input.h"

namespace candela::test {

class ShaderValues : public BadInput {
protected:
    /// What a surface says with printf() whose parameters are given so; each point says the same.
    std::string said;

    void run(const std::string &values) {
        folder_.write("odd.sl",
                      "surface odd(float weights[3] = {1, 2, 3}; string name = \"none\";\n"
                      "  string names[2] = {\"one\", \"two\"}; color tint = .5;)\n"
                      "{ printf(\"%s %s %s %.1f %.1f\", name, names[0], names[1],\n"
                      "         weights[2], comp(tint, 0)); Ci = 1; }\n");
        outcome = render(sceneWith("Surface \"odd\" " + values + " Disk 5 .5 360"),
                         {"--shader-path", folder_.path() + ":&"});
        const std::string &out = outcome.out;
        said = out.substr(0, std::min(out.size(), std::string("none one two 3.0 0.5").size()));
    }

    Outcome outcome;
};

TEST_F(ShaderValues, ThatFitAreUsed) {
    run("\"uniform float[3] weights\" [4 5 6] \"uniform string name\" [\"some\"] "
        "\"uniform string[2] names\" [\"uno\" \"duo\"] \"uniform color tint\" [1 1 1]");
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    EXPECT_EQ(said, "some uno duo 6.0 1.0");
}

TEST_F(ShaderValues, OfTheWrongTypeOrLength) {
    const std::pair<const char *, const char *> table[] = {
        {"\"uniform float[2] weights\" [4 5]", "is a float[3], but a float[2] is given"},
        {"\"uniform float[4] weights\" [4 5 6 7]", "is a float[3], but a float[4] is given"},
        {"\"uniform float weights\" [4]", "is a float[3], but a float is given"},
        {"\"uniform float name\" [4]", "is a string, but a float is given"},
        {"\"uniform string tint\" [\"red\"]", "is a color, but a string is given"},
        {"\"uniform string[3] names\" [\"a\" \"b\" \"c\"]",
         "is a string[2], but a string[3] is given"},
        {"\"uniform string names\" [\"a\"]", "is a string[2], but a string is given"},
    };
    for (auto [values, message] : table) {
        run(values);
        EXPECT_EQ(outcome.status, 1) << outcome.text();
        EXPECT_TRUE(outcome.says(message)) << values << outcome.text();
        EXPECT_TRUE(outcome.says("scene.rib:8")) << outcome.text();
        EXPECT_EQ(said, "none one two 3.0 0.5") << values;
    }
}

} // namespace candela::test
