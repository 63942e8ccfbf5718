// SPDX-License-Identifier: Apache-2.0
// Du() and Dv() of all that a surface gives its shader, against how it changes from pixel to pixel:
// on a sphere and patches, in mirrored, stretched and turned spaces, placed and as
// instances.
#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace candela::test {
namespace {

const std::string variables =
    "\"varying color Cs\" [1 0 0  0 1 0  0 0 1  1 1 .2] \"varying color Os\" "
    "[1 1 1  .5 1 .2  .1 .6 1  .9 .2 .3] \"varying float pf\" [1 3 2 .5] "
    "\"varying point pp\" [0 0 0  1 0 .2  0 1 .3  1 1 1] "
    "\"varying vector pv\" [1 0 0  0 1 0  0 0 1  1 1 1] "
    "\"varying normal pn\" [1 0 0  0 1 0  0 0 1  1 1 1] ";
const std::string corners = "\"P\" [-1 -1 0  1 -1 .3  -1 1 .2  1 1 -.4] ";

struct Shape {
    const char *name;
    std::string request;
};
const Shape shapes[] = {
    {"sphere", "Rotate 90 1 0 0 Sphere 1 -1 1 360 " + variables},
    {"patch", "Patch \"bilinear\" " + corners + variables},
    {"patch with normals", "Patch \"bilinear\" " + corners + variables +
                               "\"varying normal N\" [0 0 -1  .4 0 -1  0 .5 -1  -.3 -.3 -1]"},
};

/// Three quantities at a time.
const char *const quantities[] = {
    "P",
    "N",
    "normalize(Ng)",
    "color(s, t, u * v)",
    "Cs",
    "Os",
    "color(pf, comp(Cs, 0) * s, noise(P))",
    "pp",
    "pv",
    "pn",
    "transform(\"object\", P)",
    "faceforward(normalize(N), I) * pf",
};

std::string shader(const std::string &name, const std::string &quantity,
                   const std::string &function) {
    return "surface " + name +
           "(varying float pf = 0; varying point pp = 0; varying vector pv = 0;"
           " varying normal pn = 0;) { vector q = vector(" +
           quantity + ");\n Oi = 1; Ci = color(" + function + "(xcomp(q)), " + function +
           "(ycomp(q)), " + function + "(zcomp(q))); }\n";
}

constexpr int side = 12;

class Scenes {
public:
    Scenes() {
        folder_.write("at.sl", "surface at() { Oi = 1; Ci = color(u, v, 1); }");
        for (size_t k = 0; k < std::size(quantities); ++k) {
            const std::string quantity = quantities[k], number = std::to_string(k);
            folder_.write("x" + number + ".sl", shader("x" + number, quantity, "0 + "));
            folder_.write("du" + number + ".sl", shader("du" + number, quantity, "Du"));
            folder_.write("dv" + number + ".sl", shader("dv" + number, quantity, "Dv"));
        }
    }
    /// The channels of a picture of the middle of the shape.
    std::array<std::vector<float>, 3> picture(const std::string &surface, const Shape &shape,
                                              bool instance, const std::string &lanes) {
        const std::string object =
                              instance ? "ObjectBegin 1\n" + shape.request + "\nObjectEnd\n" : "",
                          use = instance ? "ObjectInstance 1" : shape.request;
        const std::string rib = folder_.write(
            "scene.rib",
            "Format 12 12 1\nPixelSamples 1 1\nPixelFilter \"box\" 1 1\n"
            "Display \"out.exr\" \"openexr\" \"rgb\"\nProjection \"perspective\" \"fov\" 90\n"
            "ScreenWindow -.02 .02 -.02 .02\nWorldBegin\nSurface \"" +
                surface + "\"\n" + object +
                "Translate .21 -.17 4\nRotate 25 1 .4 .2\nScale -1.1 .8 1.3\n" + use +
                "\nWorldEnd\n");
        const Outcome run =
            runCandela({rib, "--quiet", "--lanes", lanes, "--output-dir", folder_.path()});
        EXPECT_EQ(run.status, 0) << run.text();
        std::string problem;
        const auto picture = readPicture(folder_.path("out.exr"), problem);
        EXPECT_TRUE(picture) << problem;
        std::array<std::vector<float>, 3> result;
        for (size_t c = 0; picture && c < 3; ++c)
            result[c] = picture->find(std::string(1, "RGB"[c]))->values;
        return result;
    }

private:
    ScratchFolder folder_;
};

TEST(Slopes, OfAllThatASurfaceGives) {
    Scenes scenes;
    for (const Shape &shape : shapes)
        for (bool instance : {false, true}) {
            const auto at = scenes.picture("at", shape, instance, "16");
            ASSERT_EQ(at[0].size(), size_t(side * side));
            for (size_t k = 0; k < std::size(quantities); ++k) {
                SCOPED_TRACE(std::string(shape.name) + (instance ? ", instance: " : ": ") +
                             quantities[k]);
                const std::string number = std::to_string(k);
                const auto x = scenes.picture("x" + number, shape, instance, "16");
                const auto du = scenes.picture("du" + number, shape, instance, "16");
                const auto dv = scenes.picture("dv" + number, shape, instance, "16");
                for (size_t c = 0; c < 3; ++c)
                    for (int i = 1; i < side * side - 1; ++i) {
                        if (i % side == 0 || i % side == side - 1)
                            continue;
                        const size_t left = size_t(i - 1), right = size_t(i + 1), here = size_t(i);
                        ASSERT_EQ(at[2][here], 1);
                        const double byU = at[0][right] - at[0][left];
                        const double byV = at[1][right] - at[1][left];
                        // Samples stand anywhere in their pixels: the rule of the trapezium.
                        const double slopeU = (du[c][left] + du[c][right]) / 2;
                        const double slopeV = (dv[c][left] + dv[c][right]) / 2;
                        const double found = slopeU * byU + slopeV * byV;
                        const double size = std::abs(slopeU * byU) + std::abs(slopeV * byV);
                        EXPECT_NEAR(found, x[c][right] - x[c][left], 0.01 * size + 3e-6)
                            << "component " << c << " pixel " << i;
                    }
            }
        }
}

TEST(Slopes, AreTheSameAtAllWidths) {
    Scenes scenes;
    for (const char *surface : {"du1", "dv2", "du4", "dv6", "du8"})
        EXPECT_EQ(scenes.picture(surface, shapes[2], true, "1"),
                  scenes.picture(surface, shapes[2], true, "16"))
            << surface;
}

} // namespace
} // namespace candela::test
