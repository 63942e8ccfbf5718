// SPDX-License-Identifier: Apache-2.0
// A solution in a file serves every view of its scene, and no other scene.
#include "image/picture_file.h"
#include "tests/solved/ply.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <cmath>
#include <filesystem>
#include <gtest/gtest.h>

namespace candela::test {
namespace {

/// A room with a lamp, a ball, a mirrored patch, and an instance.
std::string room(const std::string &wall = ".6 .5 .4") {
    return "WorldBegin\nLightSource \"pointlight\" 1 \"intensity\" [.4] \"point from\" [0 .6 0]\n"
           "AttributeBegin\nAreaLightSource \"arealight\" 2 \"intensity\" [3]\n"
           "Translate 0 .99 0 Rotate 90 1 0 0\nDisk 0 .3 360\nAttributeEnd\nIlluminate 2 1\n"
           "Surface \"matte\"\nColor [" +
           wall +
           "]\n"
           "Polygon \"P\" [-1 -1 -1 -1 -1 1 -1 1 1 -1 1 -1]\n"
           "Polygon \"P\" [1 -1 -1 1 1 -1 1 1 1 1 -1 1]\n"
           "Polygon \"P\" [-1 -1 -1 1 -1 -1 1 -1 1 -1 -1 1]\n"
           "Polygon \"P\" [-1 1 -1 -1 1 1 1 1 1 1 1 -1]\n"
           "Polygon \"P\" [-1 -1 1 1 -1 1 1 1 1 -1 1 1]\n"
           "ObjectBegin 1 Sphere .25 -.25 .25 360 ObjectEnd\n"
           "AttributeBegin Translate .3 -.7 .3 ObjectInstance 1 AttributeEnd\n"
           "AttributeBegin Scale -1 1 1 Translate .4 -.5 .2 Color [.2 .7 .3]\n"
           "Patch \"bilinear\" \"P\" [-.2 -.2 0 .2 -.2 0 -.2 .2 .1 .2 .2 .1] ObjectInstance 1 "
           "AttributeEnd\nWorldEnd\n";
}

const char *const first = "Translate 0 0 1.6\n";

std::string scene(const std::string &camera, const std::string &world,
                  const std::string &more = "") {
    return "Format 24 24 1\nPixelSamples 4 1\nPixelFilter \"box\" 1 1\n"
           "Option \"radiometry\" \"string units\" [\"si\"]\n"
           "Option \"render\" \"string integrator\" [\"radiosity\"]\n" +
           more + "Projection \"perspective\" \"fov\" [70]\n" + camera + world;
}

class Room {
public:
    Outcome render(const std::string &rib, const std::string &picture,
                   std::vector<std::string> more = {}) {
        std::vector<std::string> arguments{folder.write("scene.rib", rib), "-o",
                                           folder.path(picture), "--shader-path", folder.path(".")};
        arguments.insert(arguments.end(), more.begin(), more.end());
        RunSettings settings;
        settings.folder = folder.path(".");
        return runCandela(arguments, settings);
    }
    Outcome withSolution(const std::string &rib, const std::string &picture,
                         const std::string &solution = "room.solution") {
        return render(rib, picture, {"--solution", folder.path(solution)});
    }

    Picture read(const std::string &name) {
        std::string problem;
        auto picture = readPicture(folder.path(name), problem);
        EXPECT_TRUE(picture) << problem;
        return picture.value_or(Picture{});
    }

    ScratchFolder folder;
};

/// Of two pictures: the root of the mean square of their differences, in shares of the mean.
double distance(const Picture &a, const Picture &b) {
    double squares = 0, sum = 0;
    std::size_t count = 0;
    for (const char *name : {"R", "G", "B"}) {
        const PictureChannel *x = a.find(name), *y = b.find(name);
        if (!x || !y || x->values.size() != y->values.size())
            return INFINITY;
        for (std::size_t i = 0; i < x->values.size(); ++i, ++count) {
            squares += std::pow(double(x->values[i]) - y->values[i], 2);
            sum += x->values[i];
        }
    }
    return std::sqrt(squares / double(count)) / (sum / double(count));
}

TEST(Radiosity, ASolutionThatIsKeptServesEveryView) {
    Room room_;
    ASSERT_EQ(room_.withSolution(scene(first, room()), "first.exr").status, 0);
    ASSERT_TRUE(room_.folder.has("room.solution"));
    const std::string kept = room_.folder.read("room.solution");
    const struct {
        const char *name, *camera, *more;
    } views[] = {
        {"the same", first, ""},
        {"from the side", "Translate .2 .1 1.2\nRotate 25 0 1 0\n", ""},
        {"mirrored", "Scale -1 1 1\nTranslate 0 0 1.6\n", ""},
        {"right-handed", "Scale 1 1 -1\nTranslate 0 0 -1.6\nRotate 180 0 1 0\n", ""},
        {"by other means", first,
         "Exposure 2 1\nCropWindow 0 .5 0 1\nImager \"background\"\nClipping .01 100\n"},
    };
    for (const auto &[name, camera, more] : views) {
        const std::string rib = scene(camera, room(), more);
        const Outcome with = room_.withSolution(rib, "with.exr");
        EXPECT_EQ(with.status, 0) << name << with.text();
        EXPECT_EQ(with.err, "") << name;
        EXPECT_EQ(room_.render(rib, "without.exr").status, 0);
        EXPECT_LT(distance(room_.read("with.exr"), room_.read("without.exr")), 0.01) << name;
        EXPECT_EQ(room_.folder.read("room.solution"), kept) << "it is written once";
    }
    ASSERT_EQ(room_.withSolution(scene(first, room()), "again.exr").status, 0);
    EXPECT_EQ(room_.folder.read("again.exr"), room_.folder.read("first.exr"));
}

TEST(Radiosity, AWalkIsSolvedOnce) {
    Room room_;
    const auto frame = [](int number, double turn) {
        return "FrameBegin " + std::to_string(number) + "\nTranslate 0 0 1.6\nRotate " +
               std::to_string(turn) + " 0 1 0\n" + room() + "FrameEnd\n";
    };
    const Outcome walk =
        room_.withSolution(scene("", frame(1, 0) + frame(2, 10) + frame(3, 20)), "walk.##.exr");
    EXPECT_EQ(walk.status, 0) << walk.text();
    for (const char *picture : {"walk.01.exr", "walk.02.exr", "walk.03.exr"})
        EXPECT_TRUE(room_.folder.has(picture));
    ASSERT_EQ(
        room_.render(scene("Translate 0 0 1.6\nRotate 20 0 1 0\n", room()), "third.exr").status, 0);
    EXPECT_LT(distance(room_.read("walk.03.exr"), room_.read("third.exr")), 0.01);
}

TEST(Radiosity, ASolutionOfAnotherSceneIsRefused) {
    Room room_;
    const std::string own =
        "surface own(float Kd = .5) { Ci = Kd * Cs * diffuse(normalize(N)); Oi = 1; }";
    room_.folder.write("own.sl", own);
    const std::string lamp = "LightSource \"pointlight\" 9 \"intensity\" [.1]\n";
    const std::string world = "AttributeBegin Surface \"own\" Sphere .1 -.1 .1 360 AttributeEnd\n";
    const auto with = [&](const std::string &text) {
        std::string rib = room();
        return rib.insert(rib.find("Surface \"matte\""), text);
    };
    ASSERT_EQ(room_.withSolution(scene(std::string(first) + lamp, with(world)), "a.exr").status, 0);
    const std::string kept = room_.folder.read("room.solution");
    std::string longer = kept + "x", damaged = kept;
    damaged[kept.size() / 2] ^= 1;
    room_.folder.write("damaged", damaged);
    room_.folder.write("longer", longer);
    room_.folder.write("short", kept.substr(0, kept.size() / 2));
    room_.folder.write("text", "my diary");
    room_.folder.write("empty", "");
    const struct {
        const char *file;
        std::string rib;
        std::vector<std::string> more;
        const char *says;
    } table[] = {
        {"room.solution",
         scene(std::string(first) + lamp, room(".6 .5 .41")),
         {},
         "the scene is not the same"},
        {"room.solution", scene(first, with(world)), {}, "the scene is not the same"},
        // The lamp before the world moves with the camera.
        {"room.solution",
         scene("Translate 0 0 1.5\n" + lamp, with(world)),
         {},
         "the scene is not the same"},
        {"room.solution",
         scene(std::string(first) + lamp, with(world),
               "Option \"radiosity\" \"float epsilon\" [1e-3]\n"),
         {},
         "the scene is not the same"},
        {"room.solution",
         scene(std::string(first) + lamp, with(world)),
         {"--seed", "7"},
         "of seed 0"},
        {"room.solution",
         scene("Scale 1000 1000 1000\n" + std::string(first) + lamp, with(world)),
         {},
         "of scale 1"},
        {"damaged", scene(std::string(first) + lamp, with(world)), {}, "it is damaged"},
        {"longer", scene(std::string(first) + lamp, with(world)), {}, "it is damaged"},
        {"short", scene(std::string(first) + lamp, with(world)), {}, "it is damaged"},
        {"text", scene(std::string(first) + lamp, with(world)), {}, "it is no solution"},
        {"empty", scene(std::string(first) + lamp, with(world)), {}, "it is no solution"},
        {".", scene(std::string(first) + lamp, with(world)), {}, "regular file"},
        {"no/such/folder/s", scene(std::string(first) + lamp, with(world)), {}, "No such file"},
    };
    for (const auto &row : table) {
        std::vector<std::string> more = row.more;
        more.insert(more.end(), {"--solution", room_.folder.path(row.file)});
        const Outcome refused = room_.render(row.rib, "refused.exr", more);
        EXPECT_EQ(refused.status, 1) << row.file << refused.text();
        EXPECT_TRUE(refused.says(row.says)) << row.says << refused.text();
        EXPECT_FALSE(room_.folder.has("refused.exr"));
    }
    EXPECT_EQ(room_.folder.read("room.solution"), kept);
    room_.folder.write("own.sl", own + "/* another text */");
    EXPECT_EQ(room_.withSolution(scene(std::string(first) + lamp, with(world)), "b.exr").status, 0)
        << "comments are no light";
    std::string other = own;
    room_.folder.write("own.sl", other.replace(other.find(".5"), 2, ".6"));
    const Outcome shaders =
        room_.withSolution(scene(std::string(first) + lamp, with(world)), "c.exr");
    EXPECT_EQ(shaders.status, 1);
    EXPECT_TRUE(shaders.says("the shaders are not the same")) << shaders.text();
    const Outcome path =
        room_.render(scene(first, room()), "path.exr",
                     {"--integrator", "path", "--solution", room_.folder.path("p")});
    EXPECT_EQ(path.status, 0);
    EXPECT_TRUE(path.says("only --integrator radiosity has a solution")) << path.text();
    EXPECT_FALSE(room_.folder.has("p"));
}

/// A furnace's elements all send radiance 1, stand where the world has them and face inwards.
TEST(Radiosity, TheMeshOfASolutionHasItsRadianceInWorldSpace) {
    Room room_;
    room_.folder.write(
        "glow.sl",
        "surface glow() { Ci = .5 + .5 * diffuse(faceforward(normalize(N), I)); Oi = 1; }");
    const std::string ball =
        "WorldBegin Translate 3 0 0 Surface \"glow\" Sphere 2 -2 2 360 WorldEnd\n";
    for (const char *camera : {"Translate -3 0 0\n", "Rotate 40 1 2 3 Translate -3.5 0 .2\n"}) {
        const Outcome run = room_.render(scene(camera, ball), "ball.exr",
                                         {"--solution-mesh", room_.folder.path("ball.ply")});
        ASSERT_EQ(run.status, 0) << run.text();
        const Ply ply = readPly(room_.folder.read("ball.ply"));
        ASSERT_GT(ply.faces.size(), 8u);
        int inside = 0;
        for (const std::array<float, 9> &v : ply.vertices) {
            const float x = v[0] - 3, away = x * v[3] + v[1] * v[4] + v[2] * v[5];
            EXPECT_NEAR(std::sqrt(x * x + v[1] * v[1] + v[2] * v[2]), 2, 1e-4);
            inside += away < 0;
            if (away < 0) {
                for (int c = 6; c < 9; ++c)
                    EXPECT_NEAR(v[std::size_t(c)], 1, .01);
            }
        }
        EXPECT_GT(inside, int(ply.vertices.size()) / 4);
        for (const std::vector<int> &face : ply.faces) { // Corners go round the normal.
            const auto at = [&](int k) { return ply.vertices[std::size_t(face[std::size_t(k)])]; };
            const auto a = at(0), b = at(1), c = at(int(face.size()) - 1);
            const float u[] = {b[0] - a[0], b[1] - a[1], b[2] - a[2]};
            const float w[] = {c[0] - a[0], c[1] - a[1], c[2] - a[2]};
            const float turn = (u[1] * w[2] - u[2] * w[1]) * a[3] +
                               (u[2] * w[0] - u[0] * w[2]) * a[4] +
                               (u[0] * w[1] - u[1] * w[0]) * a[5];
            EXPECT_GE(turn, -1e-6f);
        }
    }
}

} // namespace
} // namespace candela::test
