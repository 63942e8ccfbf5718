// SPDX-License-Identifier: Apache-2.0
// Where things are seen behind panes, balls, shells and sheets, against geometrical optics. Rays
// that are set down anew beside their surface, or whose direction is taken from rounded points,
// show what is behind at another place.
#include "foundation/base/student.h"
#include "tests/bodies/bodies.h"
#include "tests/support/frames.h"

#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

namespace candela::test {
namespace {

constexpr double radians = std::numbers::pi / 180;
constexpr double wallAt = 6; ///< z of the wall; the eye is at z = -6.
/// Rays leave surfaces from so far beside them (docs/ray-offset.md: 24 ulp of the largest
/// coordinate).
constexpr double offset = 24 * 0x1p-24 * 6;

struct Sight {
    Frame frame;
    double expected;  ///< x of the wall's point that is seen.
    double tolerance; ///< m
};

std::string text(double value) { return array({value}).substr(1, array({value}).size() - 3); }

/// A look along +z over (x, 0), before a wall that tells places.
Frame look(const std::string &name, const std::string &integrator, double x,
           const std::string &things) {
    return {name,
            "Option \"render\" \"string integrator\" [\"" + integrator +
                "\"]\nProjection \"orthographic\"\nScreenWindow -1e-7 1e-7 -1e-7 1e-7\nTranslate " +
                text(-x) + " 0 6\n",
            "Surface \"place\"\nPolygon \"P\" [-8 -8 6 -8 8 6 8 8 6 8 -8 6]\n" + things};
}

void expectSights(const std::vector<Sight> &sights, int samples) {
    std::vector<Frame> frames;
    for (const Sight &sight : sights)
        frames.push_back(sight.frame);
    const std::vector<FramePixels> pictures = render(frames, {samples, 1, "bodies/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        // Whatever share of the light comes through has seen the same place.
        const FramePixels &seen = pictures[i];
        int through = 0;
        for (std::size_t pixel = 0; pixel < seen.red.size(); ++pixel) {
            if (seen.green[pixel] < 1e-3f)
                continue;
            ++through;
            ASSERT_NEAR(seen.red[pixel] / seen.green[pixel] - 8, sights[i].expected,
                        sights[i].tolerance)
                << frames[i].name;
        }
        EXPECT_GT(through, 20) << frames[i].name;
    }
}

const char *integrators[] = {"path", "classic"};

/// Refraction alone: what is reflected would add its own sights.
std::string clear(double eta) {
    return "Surface \"glass\" \"float Kr\" [0] \"float eta\" [" + text(eta) + "]\n";
}

/// Two faces of 2 x 2 m at z = 0 and z = thickness, their outsides apart.
std::string faces(double thickness) {
    const std::string d = text(thickness);
    return "Polygon \"P\" [-1 -1 0 -1 1 0 1 1 0 1 -1 0]\nPolygon \"P\" [-1 -1 " + d + " 1 -1 " + d +
           " 1 1 " + d + " -1 1 " + d + "]\n";
}

TEST(Panes, DisplaceWhatIsBehindByTheClosedForm) {
    std::vector<Sight> sights;
    for (const char *integrator : integrators)
        for (double eta : {1.0, 1.33, 1.5, 2.4})
            for (double thickness : {1e-4, 1e-2, .1})
                for (double degrees : {0., 20., 45., 70.})
                    for (const char *mirror : {"1 1 1", "-1 1 1", "1 -1 -1"}) {
                        const double i = degrees * radians, t = std::asin(std::sin(i) / eta);
                        const double across =
                            thickness * std::sin(i) * (1 - std::cos(i) / (eta * std::cos(t)));
                        const std::string pane = clear(eta) + "Rotate " + text(degrees) +
                                                 " 0 1 0\nScale " + mirror + "\n" +
                                                 faces(thickness);
                        // Two offsets, and what the place told is rounded by.
                        sights.push_back({look("pane " + text(eta) + " " + text(thickness) +
                                                   " at " + text(degrees) + " scaled " + mirror,
                                               integrator, .1, pane),
                                          .1 + across, 3 * offset});
                    }
    expectSights(sights, 1);
}

/// Where a ray along +z at the distance b from the centre of balls of glass is at the wall: it
/// leaves at the same distance, turned by all refractions. `radii` from the outside inward, each
/// the border between the media on its two sides.
double behindBalls(double b, double eta, const std::vector<double> &radii) {
    double turn = 0;
    bool intoGlass = true;
    for (double radius : radii) {
        const double inAir = std::asin(b / radius), inGlass = std::asin(b / (eta * radius));
        turn -= 2 * (intoGlass ? inAir - inGlass : inGlass - inAir);
        intoGlass = !intoGlass;
    }
    const double along = (wallAt + b * std::sin(turn)) / std::cos(turn);
    return b * std::cos(turn) + along * std::sin(turn);
}

std::string ball(double radius, const std::string &before = "") {
    const std::string r = text(radius);
    return before + "Sphere " + r + " -" + r + " " + r + " 360\n";
}

/// Down to a little more than the offset of their faces, which goes with their size: both faces are
/// met, each of which reflects (.5 / 2.5)^2 of what comes, again and again.
TEST(Panes, OfMicrometresHaveTwoFaces) {
    const struct {
        double width, thickness; ///< m, one metre away.
    } panes[] = {{.2, 1.6e-6}, {2, 3.2e-6}, {18, 1e-5}, {18, 1e-3}};
    const double reflected = .04, through = (1 - reflected) / (1 + reflected);
    std::vector<Frame> frames;
    for (const auto &pane : panes)
        for (const char *integrator : integrators) {
            const auto face = [&](double z) {
                const std::string a = text(pane.width / 2), b = text(-pane.width / 2);
                const std::string at = " " + text(z) + " ";
                return "Polygon \"P\" [" + b + " " + b + at + b + " " + a + at + a + " " + a + at +
                       a + " " + b + at + "]\n";
            };
            frames.push_back({text(pane.width) + ", " + text(pane.thickness),
                              "Option \"render\" \"string integrator\" [\"" +
                                  std::string(integrator) +
                                  "\"]\nFormat 32 32 1\nProjection \"perspective\" \"fov\" [.5]\n",
                              "Surface \"constant\"\nPolygon \"P\" [-9 -9 3 -9 9 3 9 9 3 9 -9 3]\n"
                              "Surface \"glass\" \"float eta\" [1.5]\n" +
                                  face(1) + "ReverseOrientation\n" + face(1 + pane.thickness)});
        }
    const std::vector<FramePixels> pictures = render(frames, {64, 1, "bodies/shaders"});
    ASSERT_EQ(pictures.size(), frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const MeanAndError mean = meanAndError({pictures[i].red.begin(), pictures[i].red.end()});
        EXPECT_NEAR(mean.mean, through, 5 * mean.standardError + 1e-3) << frames[i].name;
        EXPECT_LT(mean.standardError, 3e-3);
    }
}

TEST(Balls, AndShellsShowWhatIsBehindWhereOpticsSay) {
    std::vector<Sight> sights;
    for (const char *integrator : integrators)
        for (double eta : {1.33, 1.5})
            for (double inner : {0., .5, .9, .99, .9999})
                for (double b : {.1, .3, .6, .8})
                    for (const char *mirror : {"1 1 1", "-1 1 1"}) {
                        std::vector<double> radii{1};
                        if (b < inner)
                            radii.push_back(inner);
                        else if (inner > 0)
                            continue;
                        const double x = behindBalls(b, eta, radii);
                        if (std::abs(x) > 7.5)
                            continue;
                        std::string things = clear(eta) + "Scale " + mirror + "\n" + ball(1);
                        if (inner > 0)
                            things += ball(inner, "ReverseOrientation\n");
                        // Up to four offsets, and the lens carries on what they are.
                        sights.push_back({look("shell " + text(eta) + " " + text(inner) + " at " +
                                                   text(b) + " scaled " + mirror,
                                               integrator, b, things),
                                          x, 16 * offset});
                    }
    expectSights(sights, 1);
}

/// What lets light through by its opacity leaves it as it was.
TEST(Sheets, DisplaceNothing) {
    std::vector<Sight> sights;
    const std::string half = "Surface \"constant\"\nColor [0 0 0]\nOpacity [.5 .5 .5]\n";
    for (const char *integrator : integrators)
        for (double x : {.1, .7, .98}) {
            for (double degrees : {0., 45., 80.})
                sights.push_back({look("sheet at " + text(degrees), integrator, x,
                                       half + "Rotate " + text(degrees) + " 0 1 0\nScale 10 1 1\n" +
                                           faces(1e-3)),
                                  x, 2e-6});
            sights.push_back({look("shell", integrator, x, half + ball(1) + ball(.999)), x, 2e-6});
            sights.push_back({look("instance", integrator, x,
                                   half + "ObjectBegin 1\n" + ball(1) +
                                       "ObjectEnd\nScale -1 1 1\nObjectInstance 1\n"),
                              x, 2e-6});
        }
    expectSights(sights, 64);
}

} // namespace
} // namespace candela::test
