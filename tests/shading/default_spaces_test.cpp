// SPDX-License-Identifier: Apache-2.0
// The spaces that defaults of parameters are given in.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

TEST(DefaultSpaces, MatricesStartAtTheirs) {
    ScratchFolder folder;
    const std::string rib = "Format 1 1 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\nWorldBegin\n"
                            "Translate 1 0 5\nRotate 30 0 1 0\nSurface \"placed\"\n"
                            "Sphere 2 -2 2 360\nWorldEnd\n";
    const Outcome run =
        runCandela({folder.write("scene.rib", rib), "--quiet", "--shader-path",
                    CANDELA_SOURCE_DIR "/tests/shading/shaders", "--output-dir", folder.path()});
    EXPECT_EQ(run.status, 0) << run.text();
    EXPECT_EQ(run.out.substr(0, run.out.find('\n')),
              "2.00 2.00 3.00, 1.00 6.00 3.00, 1.00 2.00 3.00");
}

} // namespace candela::test
