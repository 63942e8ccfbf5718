// SPDX-License-Identifier: Apache-2.0
#include "tests/solved/solved.h"

#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

std::string solvedScene(const std::string &finalPass, const std::string &more) {
    return "Option \"radiometry\" \"string units\" [\"si\"]\n"
           "Option \"render\" \"string integrator\" [\"radiosity\"]\n"
           "Option \"radiosity\" \"string finalpass\" [\"" +
           finalPass +
           "\"]\nFormat 4 4 1\nPixelSamples 1 1\nDisplay \"solved.exr\" \"openexr\" \"rgb\"\n"
           "Projection \"perspective\"\n" +
           more;
}

double statistic(const std::string &rib, const std::string &name) {
    const ScratchFolder folder;
    folder.write("scene.rib", rib);
    const Outcome outcome =
        runCandela({folder.path("scene.rib"), "--output-dir", folder.path(""), "--quiet", "--stats",
                    folder.path("stats.json"), "--shader-path",
                    std::string(CANDELA_SOURCE_DIR) + "/tests/solved/shaders:&"});
    EXPECT_EQ(outcome.status, 0) << outcome.text();
    const std::string text = folder.read("stats.json");
    const std::size_t at = text.find("\"radiosity." + name + "\"");
    EXPECT_NE(at, std::string::npos) << text;
    return at == std::string::npos ? 0 : std::stod(text.substr(text.find(':', at) + 1));
}

} // namespace candela::test
