// SPDX-License-Identifier: Apache-2.0
// Inside a closed body that shines, everything is as bright as its walls, wherever mirrors, objects
// and orientations put it; what is dark on that side leaves all dark. One sample a pixel, no noise.
#include "foundation/base/student.h"
#include "tests/bodies/bodies.h"
#include "tests/support/frames.h"

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

namespace candela::test {

/// How GoogleTest names a body that failed.
static void PrintTo(const Body &body, std::ostream *stream) { *stream << body.name; }

namespace {

/// Where a mirror stands: before WorldBegin, in the world, in an object, or before its instance.
enum class Where { Camera, World, Object, Instance };
constexpr Where everywhere[] = {Where::Camera, Where::World, Where::Object, Where::Instance};
constexpr const char *whereNames[] = {"camera", "world", "object", "instance"};

/// What is said of the orientation, after the mirror.
constexpr const char *turns[] = {"", "ReverseOrientation", "Orientation \"inside\"",
                                 "Orientation \"lh\"", "Orientation \"rh\""};
enum Turn { Outside, Reversed, Inside, LeftHanded, RightHanded };

/// How the body shines with radiance 1; the last on one side only.
constexpr const char *emitters[] = {
    "Surface \"constant\"",
    "AreaLightSource \"arealight\" 1 \"float onesided\" [0] Surface \"matte\" \"float Kd\" [0]",
    "AreaLightSource \"arealight\" 1 \"float onesided\" [1] Surface \"matte\" \"float Kd\" [0]"};
constexpr int oneSided = 2;

/// Curved lamps shine from their dicing, whose outline is true to 1/5000 of their size.
constexpr double outline = 1e-4;

struct Placement {
    double mirror[3] = {1, 1, 1};
    Where where = Where::World;
    int turn = Outside, emitter = 0, sides = 2;
    double size = 1, away = 0;
    bool insideOut = false; ///< The primitives' outsides are within.

    bool mirrors() const { return mirror[0] * mirror[1] * mirror[2] < 0; }
    /// The body's outside is within.
    bool inward() const {
        if (turn == LeftHanded || turn == RightHanded)
            return insideOut != (mirrors() != (turn == RightHanded));
        return insideOut != (turn != Outside);
    }
    bool visible() const { return sides == 2 || inward(); }
    bool bright() const { return visible() && (emitter != oneSided || inward()); }
    /// A dark body is asked for light samples too, which must be dark.
    bool hasLightSamples() const { return !bright(); }
};

std::string scaling(const Placement &p) {
    std::string text = "Scale";
    for (double mirror : p.mirror)
        text += " " + std::to_string(mirror * p.size);
    return text + "\n";
}

/// What stands in one place alone is no instance to rays. This one is dark and out of sight.
std::string anotherInstance(double x) {
    return "AttributeBegin\nSurface \"matte\" \"float Kd\" [0]\nTranslate " + std::to_string(x) +
           " 0 0\nObjectInstance 1\nAttributeEnd\n";
}

/// The body, its origin in the eye.
std::string placed(const Placement &p, const std::string &primitives) {
    const std::string turn = std::string(turns[p.turn]) + "\n";
    const std::string look =
        std::string(emitters[p.emitter]) + "\nSides " + std::to_string(p.sides) + "\n";
    const std::string there = "Translate " + array({p.away, p.away, p.away}).substr(1);
    const std::string away = p.away != 0 ? there.substr(0, there.size() - 1) + "\n" : "";
    switch (p.where) {
    case Where::Camera: return away + look + turn + primitives;
    case Where::World: return away + scaling(p) + look + turn + primitives;
    case Where::Object: // It takes all but its orientation from its instances.
        return away + "ObjectBegin 1\n" + scaling(p) + turn + primitives + "ObjectEnd\n" +
               anotherInstance(20 * p.size) + look + "ObjectInstance 1\n";
    case Where::Instance:
        return away + "ObjectBegin 1\n" + primitives + "ObjectEnd\n" + scaling(p) +
               anotherInstance(20) + look + turn + "ObjectInstance 1\n";
    }
    return "";
}

/// A ball before the eye, well within the body.
std::string ball(const Placement &p, const std::string &look) {
    double scale[3] = {p.size, p.size, p.size}; // Current space is the camera's, but for its Scale.
    if (p.where == Where::Camera)
        std::copy_n(p.mirror, 3, scale);
    const std::string r = std::to_string(.12 * scale[0] * (scale[0] < 0 ? -1 : 1));
    return look + "\nTranslate " + std::to_string(p.away) + " " + std::to_string(p.away) + " " +
           std::to_string(p.away + .3 * scale[2]) + "\nSphere " + r + " -" + r + " " + r + " 360\n";
}

std::string camera(const Placement &p) {
    std::string text = "Projection \"perspective\" \"fov\" [110]\n";
    if (p.where == Where::Camera)
        text += scaling(p);
    const std::string back = std::to_string(-p.away);
    return text + "Translate " + back + " " + back + " " + back + "\n";
}

std::string nameOf(const Placement &p) {
    std::string name = std::string(whereNames[int(p.where)]) + " ";
    for (double mirror : p.mirror)
        name += mirror < 0 ? '-' : '+';
    return name + " \"" + turns[p.turn] + "\" emitter " + std::to_string(p.emitter) + " sides " +
           std::to_string(p.sides) + " size " + std::to_string(p.size);
}

Frame frameOf(const Placement &p, const Body &body, const std::string &look) {
    return {nameOf(p), camera(p),
            "AttributeBegin\n" + placed(p, "AttributeBegin\n" + body.rib + "AttributeEnd\n") +
                "AttributeEnd\n" + (p.emitter > 0 ? "Illuminate 1 1\n" : "") + ball(p, look)};
}

/// A ball in a dark body is lit by what lies beyond a hole.
std::string lookOfBall(const Placement &p, const Body &body) {
    if (!p.hasLightSamples())
        return "Surface \"scattered\"";
    return body.pierced ? "Surface \"matte\" \"Kd\" [0]" : "Surface \"matte\"";
}

/// Everything is 1, also a ball whose light comes by rays; or everything is 0.
void expectFurnaces(const Body &body, const std::vector<Placement> &placements) {
    std::vector<Frame> frames;
    for (const Placement &p : placements)
        frames.push_back(frameOf(p, body, lookOfBall(p, body)));
    const std::vector<FramePixels> pictures = render(frames, {1, 1, "bodies/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        SCOPED_TRACE(body.name + " " + frames[i].name);
        const auto &[red, alpha, green] = pictures[i];
        const double expected = placements[i].bright() ? 1 : 0;
        for (auto [end, what] : {std::pair{*std::min_element(red.begin(), red.end()), "darkest"},
                                 {*std::max_element(red.begin(), red.end()), "brightest"}})
            EXPECT_NEAR(end, expected, 1e-4) << what;
        const auto covered = std::count(alpha.begin(), alpha.end(), 1.f);
        if (placements[i].visible())
            EXPECT_EQ(covered, 64);
        else
            EXPECT_TRUE(covered > 0 && covered < 32) << covered;
    }
}

std::vector<Placement> mirrorings() {
    std::vector<Placement> all;
    for (double x : {1., -1.})
        for (double y : {1., -1.})
            for (double z : {1., -1.})
                for (Where where : everywhere)
                    all.push_back({{x, y, z}, where});
    return all;
}

/// Every `step`th mirroring with a share of the ways to turn, shine and be seen; `shift` chooses
/// which.
std::vector<Placement> someOfEach(int shift, int step) {
    const std::vector<Placement> all = mirrorings();
    std::vector<Placement> some;
    for (std::size_t i = 0; i < all.size() / step; ++i) {
        some.push_back(all[i * step + (shift + i) % step]);
        const int way = (int(i) * 7 + shift * 11) % 30;
        some[i].turn = way % 5, some[i].emitter = way / 5 % 3, some[i].sides = 1 + way / 15;
    }
    return some;
}

class ClosedBodies : public testing::TestWithParam<Body> {};

TEST_P(ClosedBodies, AreFurnacesInEveryMirror) {
    int shift = 0;
    for (char letter : GetParam().name)
        shift += letter;
    expectFurnaces(GetParam(), someOfEach(shift, GetParam().costly ? 4 : 1));
}

TEST(ClosedBody, OfFewTrianglesIsAFurnaceInEveryWay) {
    for (const Body &body : closedBodies())
        for (int shift = 0; shift < 4; ++shift)
            if (body.name == "PointsPolygons" || body.name == "BilinearPatch")
                expectFurnaces(body, someOfEach(shift, 1));
}

/// Normals that the user gives are points' companions, whatever mirrors them.
TEST(ClosedBody, MayHaveNormalsOfItsOwn) {
    for (bool inward : {false, true})
        for (const Body &body : bodiesWithNormals(inward)) {
            std::vector<Placement> all = mirrorings();
            for (Placement &placement : all)
                placement.insideOut = inward, placement.emitter = oneSided;
            expectFurnaces(body, all);
        }
}

/// Smaller, larger, and where floats leave of the place a thousandth of the body's size.
TEST_P(ClosedBodies, AreFurnacesOfAnySizeAnywhere) {
    std::vector<Placement> all;
    for (auto [size, away] : {std::pair{1e-3, 0.}, {1e3, 0.}, {1., 1e4}, {1e3, 1e4}})
        for (Where where : {Where::World, Where::Instance}) {
            if (GetParam().costly && (where == Where::Instance) != (away > 0))
                continue;
            all.push_back({{1, -1, 1}, where, Reversed, int(all.size() % 3)});
            all.back().size = size, all.back().away = away;
        }
    expectFurnaces(GetParam(), all);
}

TEST(ClosedBody, MayHaveItsPointsFarAway) {
    for (const Body &body : bodiesAway(1e4)) {
        const Body moved{body.name, "Translate -10000 -10000 -10000\n" + body.rib};
        expectFurnaces(moved, {{{1, 1, 1}, Where::World, Reversed, 2}});
    }
}

/// The light of the walls on a white ball within, by light samples and rays together (`path`) and
/// by light samples alone (`classic`, which places them by area). Every pixel has the same mean.
TEST_P(ClosedBodies, LightWhatIsWithin) {
    const std::string classic = "Option \"render\" \"string integrator\" [\"classic\"]\n";
    const std::string view = "Projection \"orthographic\"\nScreenWindow -.05 .05 -.05 .05\n";
    std::vector<Frame> frames;
    for (const std::string &options : {std::string(), classic}) {
        const Placement p{{-1, 1, 1}, Where::World, Reversed, oneSided};
        frames.push_back(frameOf(p, GetParam(), "Surface \"matte\""));
        frames.back().options = options + view;
        frames.back().world =
            "Attribute \"light\" \"string shadows\" [\"on\"]\n" + frames.back().world;
    }
    const std::vector<FramePixels> pictures = render(frames, {1024, 1, "bodies/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const MeanAndError light = meanAndError({pictures[i].red.begin(), pictures[i].red.end()});
        EXPECT_LE(light.standardError, i == 0 ? 1e-3 : 2e-2);
        const double interval = studentQuantile(1e-5, 63) * light.standardError;
        EXPECT_LE(std::abs(light.mean - 1), interval + outline) << light.mean;
    }
}

INSTANTIATE_TEST_SUITE_P(Bodies, ClosedBodies, testing::ValuesIn(closedBodies()),
                         [](const auto &info) { return info.param.name; });

} // namespace
} // namespace candela::test
