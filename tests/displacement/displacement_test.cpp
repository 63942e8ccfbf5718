// SPDX-License-Identifier: Apache-2.0
// Displaced surfaces against closed forms, against dense geometry that is displaced here, and
// against themselves in company.
#include "foundation/base/student.h"
#include "tests/bodies/copies.h"
#include "tests/displacement/scenes.h"
#include "tests/support/frames.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {

/// How GoogleTest names what failed.
static void PrintTo(const Body &body, std::ostream *stream) { *stream << body.name; }
static void PrintTo(const DenseScene &scene, std::ostream *stream) { *stream << scene.name; }

namespace {

/// A sphere of radius 1 in current space, to be blown up by .2.
struct Blown {
    const char *name, *before, *world;
    const char *place = ""; ///< Before the surface shader, whose space is the sphere's.
    bool inward = false;    ///< Its normals.
    float rounding = 1e-3f; ///< Of places, by floats or by triangles.
};
const Blown blown[] = {
    {"plain", "", "Displacement \"puff\" Sphere 1 -1 1 360"},
    {"bound", "",
     "Attribute \"displacementbound\" \"float sphere\" [.2] \"string coordinatesystem\" "
     "[\"shader\"] Displacement \"puff\" Sphere 1 -1 1 360"},
    {"scaled", "", "Scale 2 2 2 Displacement \"puff\" Sphere .5 -.5 .5 360"},
    {"mirrored in the world", "", "Scale -1 1 1 Displacement \"puff\" Sphere 1 -1 1 360"},
    {"mirrored before the world", "Scale 1 1 -1 Translate 0 0 -10",
     "Displacement \"puff\" Sphere 1 -1 1 360"},
    {"turned inside out", "",
     "ReverseOrientation Displacement \"puff\" \"float by\" [-.2] Sphere 1 -1 1 360", "", true},
    {"one-sided", "", "Sides 1 Displacement \"puff\" Sphere 1 -1 1 360"},
    {"one of two instances", "",
     "Displacement \"puff\" ObjectBegin 1 Sphere 1 -1 1 360 ObjectEnd ObjectInstance 1 "
     "Translate 9 0 0 ObjectInstance 1"},
    {"one of two instances, mirrored and scaled", "",
     "ObjectBegin 1 Sphere .5 -.5 .5 360 ObjectEnd Displacement \"puff\" AttributeBegin "
     "Translate 9 0 0 ObjectInstance 1 AttributeEnd Scale -2 2 2 ObjectInstance 1"},
    {"far from the origin of its world", "Translate -70000 3000 500",
     "Displacement \"puff\" Sphere 1 -1 1 360", "Translate 70000 -3000 -500\n", false, .02f},
    {"coarse", "ShadingRate 16", "Displacement \"puff\" Sphere 1 -1 1 360", "", false, 4e-3f},
};

std::vector<FramePixels> renderBlown(const std::string &integrator, const std::string &which) {
    std::vector<Frame> frames;
    for (const Blown &sphere : blown)
        frames.push_back({sphere.name,
                          "Option \"render\" \"string integrator\" [\"" + integrator +
                              "\"]\nFormat 128 128 1\nProjection \"orthographic\"\n"
                              "ScreenWindow -2 2 -2 2\nTranslate 0 0 5\n" +
                              sphere.before + "\n",
                          sphere.place + ("Surface \"radial\" \"float which\" [" + which + "]\n") +
                              std::string(sphere.world) + "\n"});
    return render(frames, {4, 1, "displacement/shaders"});
}

TEST(Sphere, BlownUpIsALargerOneInEverySpace) {
    for (const char *integrator : {"classic", "path"})
        for (const char *which : {"0", "1"}) {
            const auto pictures = renderBlown(integrator, which);
            ASSERT_EQ(pictures.size(), std::size(blown));
            for (std::size_t i = 0; i < pictures.size(); ++i) {
                SCOPED_TRACE(std::string(blown[i].name) + ", " + integrator +
                             (which[0] == '0' ? ", N" : ", Ng"));
                const FramePixels &picture = pictures[i];
                double covered = 0;
                float place = 0, normal = 0;
                for (std::size_t k = 0; k < picture.alpha.size(); ++k) {
                    covered += picture.alpha[k];
                    if (picture.alpha[k] < .99f)
                        continue;
                    place = std::max(place, picture.red[k]);
                    const float away = blown[i].inward ? 2 : 0;
                    normal = std::max(normal, std::abs(picture.green[k] - away));
                }
                // Of the outline each of the four samples a pixel may be wrong.
                EXPECT_NEAR(covered / double(picture.alpha.size()), std::numbers::pi * 1.44 / 16,
                            1.5e-3);
                EXPECT_LT(place, blown[i].rounding);
                EXPECT_LT(normal, blown[i].rounding + 1e-3);
            }
        }
}

/// Of two pictures of one thing: at outlines samples may fall to either side.
void expectSamePicture(const FramePixels &a, const FramePixels &b, float tolerance,
                       int oneIn = 50) {
    ASSERT_EQ(a.alpha.size(), b.alpha.size());
    int covered = 0, different = 0, edges = 0;
    for (std::size_t i = 0; i < a.alpha.size(); ++i) {
        covered += a.alpha[i] > 0;
        edges += std::abs(a.alpha[i] - b.alpha[i]) > .01f;
        different +=
            std::abs(a.alpha[i] - b.alpha[i]) <= .01f &&
            std::max(std::abs(a.red[i] - b.red[i]), std::abs(a.green[i] - b.green[i])) > tolerance;
    }
    EXPECT_GT(covered, int(a.alpha.size()) / 20);
    EXPECT_LE(edges, covered / 50);
    EXPECT_LE(different, covered / oneIn);
}

/// What is displaced by "waves", and the same made of points that are displaced here.
class Waves : public testing::TestWithParam<DenseScene> {};

TEST_P(Waves, LookLikeDenseGeometry) {
    const std::string options =
        "Option \"render\" \"string integrator\" [\"classic\"]\nFormat 96 96 1\n"
        "Projection \"perspective\" \"fov\" [35]\nTranslate 0 0 5\n";
    const std::string stands = "Rotate 50 1 0 0 Rotate 30 0 0 1\n";
    std::vector<Frame> frames;
    for (const char *mirror : {"", "Scale -1 1 1\n", "Scale 1 .7 -1.2\n"})
        for (const char *what : {"0", "1", "2"})
            for (const std::string &rib :
                 {"Displacement \"waves\"\n" + GetParam().plain, GetParam().dense})
                frames.push_back({what, options,
                                  stands + mirror + "Surface \"tellplace\" \"float what\" [" +
                                      what + "]\n" + rib});
    const auto pictures = render(frames, {1, 1, "displacement/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        SCOPED_TRACE(std::to_string(i) + ", tells " + frames[i].name);
        // Dense geometry has facets, of which Ng tells.
        expectSamePicture(pictures[i], pictures[i + 1], frames[i].name == "2" ? .03f : .01f);
    }
}

INSTANTIATE_TEST_SUITE_P(Dense, Waves, testing::ValuesIn(denseScenes()),
                         [](const auto &info) { return info.param.name; });

class DisplacedBodies : public testing::TestWithParam<Body> {};

/// From within every ray meets the body, and the light around it, of radiance 1, stays out. Rays
/// that start within rounding of a sharp fold may start beyond it: some in a hundred thousand.
TEST_P(DisplacedBodies, AreClosed) {
    std::vector<Frame> frames;
    for (const char *displacement : {"lumps", "steps"})
        for (const char *look : {"constant", "matte"})
            for (const char *mirror : {"", "Scale 1 -1 1\n"})
                frames.push_back(
                    {displacement, "Format 48 48 1\nProjection \"perspective\" \"fov\" [120]\n",
                     "AttributeBegin\nSurface \"constant\"\nSphere 50 -50 50 360\nAttributeEnd\n" +
                         std::string(mirror) + "Displacement \"" + displacement + "\"\nSurface \"" +
                         look + "\"\nColor [.5 .5 .5]\nRotate 40 1 1 0\n" + GetParam().rib});
    const auto pictures = render(frames, {16, 1, "displacement/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const float right = i / 2 % 2 == 0 ? .5f : 0;
        SCOPED_TRACE(frames[i].name + (right > 0 ? ", shining" : ", dark within"));
        double wrong = 0;
        for (float red : pictures[i].red)
            wrong += std::abs(red - right) / double(pictures[i].red.size());
        EXPECT_LE(wrong, right > 0 ? 0 : 1e-4);
    }
}

/// Instances of what is displaced in its own space, and the primitives repeated.
TEST_P(DisplacedBodies, LookTheSameAsInstances) {
    const std::string options = "Option \"render\" \"string integrator\" [\"classic\"]\n"
                                "Format 64 64 1\nProjection \"perspective\" \"fov\" [40]\n"
                                "ShadingRate .1\nTranslate 0 0 18\n";
    std::vector<Frame> frames;
    for (const char *sides : {"Sides 2\n", "Sides 1\n"})
        for (const char *what : {"0", "1", "2"})
            for (bool instances : {false, true})
                frames.push_back({what, options,
                                  copied(GetParam(), instances,
                                         sides + ("Displacement \"lumps\" Surface \"tellplace\" "
                                                  "\"float what\" [" +
                                                  std::string(what) + "]\n"))});
    const auto pictures = render(frames, {1, 1, "displacement/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        SCOPED_TRACE("tells " + frames[i].name + (i < 6 ? "" : ", one-sided"));
        // Objects and the world are diced apart, so where faces are joined, in lines of a pixel's
        // width, places differ by some of a pixel, and normals by what they turn within one.
        expectSamePicture(pictures[i], pictures[i + 1], .02f, frames[i].name == "0" ? 25 : 10);
    }
}

/// Those whose primitives agree about the points of their rims before they are displaced: where a
/// rim is not the widest place of its quadric they need not (src/world/geometry/README.md).
std::vector<Body> displacedBodies() {
    std::vector<Body> bodies = closedBodies();
    std::erase_if(bodies, [](const Body &body) {
        return body.name == "SphereZone" || body.name == "Hyperboloid" || body.name == "Washer";
    });
    return bodies;
}

INSTANTIATE_TEST_SUITE_P(Bodies, DisplacedBodies, testing::ValuesIn(displacedBodies()),
                         [](const auto &info) { return info.param.name; });

/// A surface shader that moves P does what a displacement shader would.
TEST(MovingSurfaces, LookAsIfDisplaced) {
    std::vector<Frame> frames;
    for (const char *integrator : {"classic", "path"})
        for (const char *what : {"0", "1"})
            for (const char *place : {"", "Scale -1 1 1\n"})
                for (bool itself : {false, true}) {
                    const std::string tells = "\"float what\" [" + std::string(what) + "]\n";
                    frames.push_back(
                        {what,
                         "Option \"render\" \"string integrator\" [\"" + std::string(integrator) +
                             "\"]\nFormat 64 64 1\nProjection \"perspective\" \"fov\" [40]\n"
                             "Translate 0 0 4\n",
                         std::string(place) +
                             (itself ? "Surface \"selflumps\" " + tells
                                     : "Displacement \"lumps\" Surface \"tellplace\" " + tells) +
                             "Sphere 1 -1 1 360\n"});
                }
    const auto pictures = render(frames, {1, 1, "displacement/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2)
        expectSamePicture(pictures[i], pictures[i + 1], .005f);
}

std::vector<FramePixels> renderThings(const std::vector<std::string> &worlds) {
    std::vector<Frame> frames;
    for (const std::string &world : worlds)
        frames.push_back({world,
                          "Option \"render\" \"string integrator\" [\"classic\"]\n"
                          "Format 64 64 1\nProjection \"perspective\" \"fov\" [40]\n"
                          "Translate 0 0 4\n",
                          world});
    return render(frames, {1, 1, "displacement/shaders"});
}

/// N alone is changed: the surface stays the very same one.
TEST(Bumps, TurnNormalsAndMoveNothing) {
    const std::string things[] = {"Sphere 1 -1 1 360\n",
                                  "Polygon \"P\" [-1 -1 0 1 -1 0 1 1 .5 -1 1 .5]\n",
                                  "Patch \"bilinear\" \"P\" [-1 -1 0 1 -1 0 -1 1 1 1 1 0]\n"};
    for (const std::string &thing : things)
        for (const char *place : {"Rotate 30 1 2 0\n", "Scale -1 1 .7\n"}) {
            const std::string plain = std::string(place) + "Surface \"tellbumps\"\n" + thing;
            const std::string bumped = std::string(place) +
                                       "Surface \"tellplace\" \"float what\" [1]\n"
                                       "Displacement \"bumps\"\n" +
                                       thing;
            const auto pictures = renderThings({plain, bumped});
            ASSERT_EQ(pictures.size(), 2u);
            EXPECT_EQ(pictures[0].alpha, pictures[1].alpha);
            for (std::size_t k = 0; k < pictures[0].red.size(); ++k) {
                EXPECT_NEAR(pictures[0].red[k], pictures[1].red[k], 1e-5);
                EXPECT_NEAR(pictures[0].green[k], pictures[1].green[k], 1e-5);
            }
        }
}

/// A transformation shader that shears is a shear; displacement comes after it.
TEST(Deformations, MovePointsBeforeDisplacementDoes) {
    const std::string shear = "ConcatTransform [1 .5 0 0  0 1 0 0  0 0 1 0  0 0 0 1]\n";
    const std::string tells = "Surface \"tellplace\" \"float what\" [2]\n";
    for (const char *thing :
         {"Sphere 1 -1 1 360\n", "Polygon \"P\" [-1 -1 0 1 -1 0 1 1 .5 -1 1 .5]\n"})
        for (const char *also : {"", "Displacement \"bumps\"\n"}) {
            const auto pictures = renderThings(
                {tells + also + shear + thing, tells + also + "Deformation \"bend\"\n" + thing});
            ASSERT_EQ(pictures.size(), 2u);
            expectSamePicture(pictures[0], pictures[1], .01f);
        }
}

/// A displaced lamp gives the light of the lamp that it has become.
TEST(DisplacedLamps, ShineAsDisplaced) {
    std::vector<Frame> frames;
    for (const char *look :
         {"Surface \"constant\"\n",
          "AreaLightSource \"arealight\" 1 \"float onesided\" [1]\nSurface \"matte\"\n"})
        for (const char *lamp :
             {"Sphere 1.2 -1.2 1.2 360\n", "Displacement \"puff\"\nSphere 1 -1 1 360\n"})
            frames.push_back(
                {look,
                 "Format 32 32 1\nProjection \"orthographic\"\nClipping 4 99\n"
                 "ScreenWindow -5 5 -5 5\n",
                 std::string("AttributeBegin\n") + look + lamp + "AttributeEnd\n" +
                     (look[0] == 'A' ? "Illuminate 1 1\n" : "") +
                     "Surface \"matte\"\nPolygon \"P\" [-9 -9 5 -9 9 5 9 9 5 9 -9 5]\n"});
    const auto pictures = render(frames, {64, 1, "displacement/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); i += 2) {
        const auto [mean, difference] = compareRed(pictures[i], pictures[i + 1]);
        EXPECT_GT(mean, .01);
        EXPECT_LE(std::abs(difference.mean),
                  studentQuantile(1e-5, 1023) * difference.standardError + 2e-4 * mean)
            << frames[i].name << mean;
    }
}

/// A convex body sees nothing of itself, whatever moves it: at outlines, too, its normals stay on
/// the side that is seen.
TEST(DisplacedLamps, ThatAreConvexDoNotLightThemselves) {
    const std::string ball = "Sphere 1 -1 1 360\n", egg = "Scale 1 .8 1.1 " + ball;
    std::vector<Frame> frames;
    for (const char *place : {"", "Scale -1 1 1\n", "ReverseOrientation\n"})
        for (const std::string &world :
             {"Surface \"selfshining\"\n" + ball, "Surface \"selfshining\" \"by\" [.1]\n" + egg,
              "Surface \"selfshining\" \"by\" [.1] \"turns\" [1]\n" + egg,
              "Displacement \"swell\"\nSurface \"shining\"\n" + egg,
              "Displacement \"puff\"\nSurface \"shining\"\n" + egg})
            frames.push_back({place + world,
                              "Option \"render\" \"string integrator\" [\"path\"]\n"
                              "Format 48 48 1\nProjection \"perspective\" \"fov\" [40]\n"
                              "Translate 0 0 4\n",
                              place + world});
    const auto pictures = render(frames, {16, 1, "displacement/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        double seen = 0, found = 0;
        float most = 0;
        for (std::size_t k = 0; k < pictures[i].red.size(); ++k)
            if (const float alpha = pictures[i].alpha[k]; alpha > 0) {
                seen += alpha, found += pictures[i].red[k];
                most = std::max(most, std::abs(pictures[i].red[k] / alpha - .3f));
            }
        EXPECT_GT(seen, 200) << frames[i].name;
        EXPECT_NEAR(found / seen, .3, 2e-4) << frames[i].name;
        EXPECT_LT(most, .05f) << frames[i].name; // One sample of 16, where facets show.
    }
}

} // namespace
} // namespace candela::test
