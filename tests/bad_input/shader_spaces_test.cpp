// SPDX-License-Identifier: Apache-2.0
// Coordinate systems that a shader asks for and the scene does not have: said, with the place.
#include "tests/bad_input/bad_input.h"

namespace candela::test {

class ShaderSpaces : public BadInput {
protected:
    /// Renders with a surface "lost" of this text before the disc.
    Outcome renderWith(const std::string &text, const std::string &parameters = "") {
        folder_.write("lost.sl", text);
        return render(sceneWith("Surface \"lost\" " + parameters + "\nDisk 5 .5 360"),
                      {"--shader-path", folder_.path() + ":&"});
    }
};

TEST_F(ShaderSpaces, InTheBody) {
    const Outcome run = renderWith("surface lost()\n{\n  point p = P;\n"
                                   "  Ci = xcomp(transform(\"nowhere\", p));\n}\n");
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("shader \"lost\", line 4: asks for the coordinate system \"nowhere\""))
        << run.text();
}

TEST_F(ShaderSpaces, InADefault) {
    const std::string text = "surface lost(point from = point \"nowhere\" (0, 0, 0);)\n"
                             "{ Ci = xcomp(from); }\n";
    const Outcome run = renderWith(text);
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_TRUE(run.says("scene.rib:8")) << run.text();
    EXPECT_TRUE(run.says("\"from\" of shader \"lost\" is in the coordinate system \"nowhere\""))
        << run.text();
    EXPECT_EQ(renderWith(text, "\"uniform point from\" [0 0 0]").err, "");
}

TEST_F(ShaderSpaces, ThatAreKnown) {
    const Outcome run = renderWith("surface lost(point from = point \"world\" (0, 0, 0);)\n"
                                   "{ Ci = xcomp(transform(\"world\", from)); }\n");
    EXPECT_EQ(run.err, "");
}

} // namespace candela::test
