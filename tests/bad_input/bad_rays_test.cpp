// SPDX-License-Identifier: Apache-2.0
// Scenes and shaders that ask for rays without meaning: no instruction set may end over them.
#include "tests/bad_input/bad_input.h"

namespace candela::test {

namespace {

/// A surface that traces towards `direction` from `origin`; the numbers are computed, or the
/// compiler would see what comes of them.
std::string tracer(const std::string &origin, const std::string &direction) {
    return "surface tracer(float zero = 0;) {\n"
           "    Ci = color(.5, .5, .5) + trace(" +
           origin + ", " + direction + ");\n}\n";
}

using BadRays = BadInput;

} // namespace

TEST_F(BadRays, OfACamera) {
    for (const char *camera :
         {"Format 16 12 1e38", "Format 16 12 1e-38", "ScreenWindow -1e38 1e38 -1e38 1e38",
          "Projection \"perspective\" \"fov\" [179.9999]", "Translate 1e38 1e38 0",
          "Scale 1e-38 1e-38 1e-38", "Scale 1e30 1 1e-30",
          "ConcatTransform [1e38 0 0 0 0 1e-38 0 "
          "0 0 0 1 0 0 0 0 1]"}) {
        Outcome run = render("Format 16 12 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n" +
                             std::string(camera) +
                             "\nWorldBegin\nLightSource \"pointlight\" 1\nSurface \"matte\"\n"
                             "Translate 0 0 5\nSphere 1 -1 1 360\nDisk 0 1e15 360\nWorldEnd\n");
        EXPECT_TRUE(run.status == 0 || run.status == 1) << camera << "\n" << run.text();
    }
}

TEST_F(BadRays, OfAShader) {
    for (const char *origin : {"P", "P + vector(0 / zero, 0, 0)", "P + vector(1e38 + zero)"})
        for (const char *direction :
             {"vector(0 / zero, 1, 1)", "vector(0 / zero)", "vector(zero)", "vector(1 / zero)",
              "vector(-1 / zero, 0, 0)", "vector(zero + 1e38)", "vector(zero + 1e-44, 0, 0)"}) {
            folder_.write("tracer.sl", tracer(origin, direction));
            Outcome run = render("Format 8 8 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n"
                                 "WorldBegin\nSurface \"tracer\"\nTranslate 0 0 5\n"
                                 "Sphere 1 -1 1 360\nWorldEnd\n",
                                 {"--shader-path", folder_.path()});
            EXPECT_EQ(run.status, 0) << origin << ", " << direction << "\n" << run.text();
        }
}

} // namespace candela::test
