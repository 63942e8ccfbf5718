// SPDX-License-Identifier: Apache-2.0
#include "tests/bad_input/bad_input.h"

#include "image/picture_file.h"

namespace candela::test {

std::string sceneWith(const std::string &wrong) {
    return "##RenderMan RIB-Structure 1.0\n"
           "Format 8 8 1\n"
           "PixelFilter \"box\" 1 1\n"
           "Display \"out.exr\" \"openexr\" \"rgba\"\n"
           "Option \"render\" \"string integrator\" [\"path\"]\n"
           "WorldBegin\n"
           "AttributeBegin\n" +
           wrong +
           "\nAttributeEnd\n"
           "Surface \"constant\"\n"
           "Translate 0 0 5\n"
           "Disk 0 .5 360\n"
           "WorldEnd\n";
}

Outcome BadInput::render(const std::string &rib, const std::vector<std::string> &more,
                         RunSettings settings) {
    std::vector<std::string> arguments{folder_.write("scene.rib", rib), "--output-dir",
                                       folder_.path()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runCandela(arguments, settings);
}

void BadInput::expectDisc(const std::string &name) {
    std::string problem;
    std::optional<Picture> picture = readPicture(folder_.path(name), problem);
    ASSERT_TRUE(picture) << problem;
    const PictureChannel *red = picture->find("R");
    ASSERT_TRUE(red);
    ASSERT_EQ(red->values.size(), 64u);
    EXPECT_FLOAT_EQ(red->values[4 * 8 + 4], 1);
    EXPECT_FLOAT_EQ(red->values[0], 0);
}

void BadInput::expectReportedAndRendered(const std::string &wrong,
                                         const std::vector<std::string> &said) {
    Outcome run = render(sceneWith(wrong));
    EXPECT_EQ(run.status, 1) << run.text();
    EXPECT_TRUE(run.says("error")) << run.text();
    for (const std::string &text : said)
        EXPECT_TRUE(run.says(text)) << "expected it to say: " << text << "\n" << run.text();
    expectDisc();
}

void BadInput::expectErrorAtTheLine(const std::string &wrong, std::vector<std::string> said) {
    said.push_back("scene.rib:" + std::to_string(wrongLine));
    expectReportedAndRendered(wrong, said);
}

} // namespace candela::test
