// SPDX-License-Identifier: Apache-2.0
// What a surface looks like whose shader is missing, faulty or not given: what the shipped library
// says, whatever lies beside the RIB, in the current folder or on the search path.
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {
namespace {

const std::string own[] = {"defaultsurface", "paintedmatte", "matte"};

/// The user's shaders are of a colour that nothing else has, and are named after the library's.
void writeOwnShaders(const ScratchFolder &folder, const std::string &where) {
    for (const std::string &name : own)
        folder.write(where + name + ".sl",
                     "surface " + name + "() { Oi = 1; Ci = color(0, .125, 0); }\n");
}

std::string pictureOf(const std::string &surface, const std::string &integrator, bool withOwn) {
    ScratchFolder folder;
    folder.write("faulty.sl", "surface faulty() { Ci = nothing; }\n");
    if (withOwn)
        for (const std::string where : {"", "path/", "current/"})
            writeOwnShaders(folder, where);
    folder.write("current/empty", "");
    const std::string scene =
        folder.write("scene.rib", "Format 8 8 1\nDisplay \"out.exr\" \"openexr\" \"rgb\"\n"
                                  "Option \"searchpath\" \"string shader\" [\"" +
                                      folder.path("path") +
                                      ":&\"]\nProjection \"orthographic\"\nWorldBegin\n"
                                      "LightSource \"distantlight\" 1\n" +
                                      surface + "\nSphere 1 -1 1 360\nWorldEnd\n");
    RunSettings settings;
    settings.folder = folder.path("current");
    runCandela({scene, "--quiet", "--integrator", integrator, "--shader-path", folder.path("path"),
                "--output-dir", folder.path()},
               settings);
    EXPECT_TRUE(folder.has("out.exr"));
    return folder.read("out.exr");
}

TEST(Fallback, ComesFromTheShippedLibraryAlone) {
    for (const char *integrator : {"path", "classic"})
        for (const char *surface : {"", "Surface \"nosuchshader\"", "Surface \"faulty\""})
            EXPECT_TRUE(pictureOf(surface, integrator, true) ==
                        pictureOf(surface, integrator, false))
                << integrator << ": " << surface;
}

TEST(Fallback, ANameThatIsGivenFollowsTheSearchPath) {
    for (const char *integrator : {"path", "classic"})
        for (const char *surface : {"Surface \"defaultsurface\"", "Surface \"matte\""})
            EXPECT_FALSE(pictureOf(surface, integrator, true) ==
                         pictureOf(surface, integrator, false))
                << integrator << ": " << surface;
}

TEST(Fallback, ItsNameMeansTheSameAsNoneWhereTheUserHasNoOwn) {
    for (const char *integrator : {"path", "classic"})
        EXPECT_TRUE(pictureOf("Surface \"defaultsurface\"", integrator, false) ==
                    pictureOf("", integrator, false))
            << integrator;
}

} // namespace
} // namespace candela::test
