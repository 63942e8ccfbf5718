// SPDX-License-Identifier: Apache-2.0
#include "tests/solids/solids.h"

#include <cmath>

namespace candela::test {

namespace {

std::string numbers(const std::vector<double> &values) {
    std::string text;
    for (double value : values)
        text += std::to_string(value) + " ";
    return text;
}

std::string body(const std::string &rib) {
    return "SolidBegin \"primitive\"\n" + rib + "SolidEnd\n";
}

Inside insideBall(double x, double y, double z, double radius) {
    return [=](double px, double py, double pz, double) {
        return std::hypot(px - x, py - y, pz - z) < radius;
    };
}

Inside insideBox(double x0, double x1, double y0, double y1, double z0, double z1) {
    return [=](double x, double y, double z, double) {
        return x > x0 && x < x1 && y > y0 && y < y1 && z > z0 && z < z1;
    };
}

Inside insideRod(double x, double y, double radius, double z0, double z1) {
    return [=](double px, double py, double pz, double) {
        return std::hypot(px - x, py - y) < radius && pz > z0 && pz < z1;
    };
}

Inside both(const Inside &a, const Inside &b) {
    return [=](double x, double y, double z, double s) { return a(x, y, z, s) && b(x, y, z, s); };
}
Inside either(const Inside &a, const Inside &b) {
    return [=](double x, double y, double z, double s) { return a(x, y, z, s) || b(x, y, z, s); };
}
Inside without(const Inside &a, const Inside &b) {
    return [=](double x, double y, double z, double s) { return a(x, y, z, s) && !b(x, y, z, s); };
}

/// Shells in shells: each ball less all that is in it.
SolidCase onion(int depth) {
    SolidCase onion{"an onion", "", {}};
    for (int k = depth; k-- > 0;) {
        const double radius = 1.4 - 1.2 * k / depth;
        const Inside here = insideBall(0, 0, 0, radius);
        onion.rib = onion.rib.empty() ? ball(0, 0, 0, radius)
                                      : combined("difference", ball(0, 0, 0, radius) + onion.rib);
        onion.inside = onion.inside ? without(here, onion.inside) : here;
    }
    return onion;
}

} // namespace

std::string ball(double x, double y, double z, double radius) {
    return "AttributeBegin\nTranslate " + numbers({x, y, z}) + "\n" +
           body("Sphere " + numbers({radius, -radius, radius, 360}) + "\n") + "AttributeEnd\n";
}

std::string box(double x0, double x1, double y0, double y1, double z0, double z1) {
    std::vector<double> points;
    for (double z : {z0, z1})
        for (double y : {y0, y1})
            for (double x : {x0, x1})
                points.insert(points.end(), {x, y, z});
    return body("PointsPolygons [4 4 4 4 4 4] [0 2 3 1 4 5 7 6 0 1 5 4 2 6 7 3 0 4 6 2 1 3 7 5] "
                "\"P\" [" +
                numbers(points) + "]\n");
}

std::string rod(double x, double y, double radius, double z0, double z1) {
    return "AttributeBegin\nTranslate " + numbers({x, y, 0}) + "\n" +
           body("Cylinder " + numbers({radius, z0, z1, 360}) + "\nDisk " +
                numbers({z1, radius, 360}) + "\nReverseOrientation\nDisk " +
                numbers({z0, radius, 360}) + "\n") +
           "AttributeEnd\n";
}

std::string combined(const std::string &operation, const std::string &parts) {
    return "SolidBegin \"" + operation + "\"\n" + parts + "SolidEnd\n";
}

std::vector<SolidCase> solidCases() {
    const std::string cube = box(-1, 1, -1, 1, -1, 1);
    const Inside inCube = insideBox(-1, 1, -1, 1, -1, 1);
    const Inside inDie = both(inCube, insideBall(0, 0, 0, 1.3));
    const Inside drilled = insideRod(.3, 0, .5, -2, 2);
    std::vector<SolidCase> cases{
        {"a union", combined("union", ball(-.4, 0, 0, .9) + ball(.5, .1, .2, .8)),
         either(insideBall(-.4, 0, 0, .9), insideBall(.5, .1, .2, .8))},
        {"an intersection", combined("intersection", cube + ball(0, 0, 0, 1.3)), inDie},
        {"a difference", combined("difference", cube + ball(.3, .2, -1, .8)),
         without(inCube, insideBall(.3, .2, -1, .8))},
        {"a hole through", combined("difference", cube + rod(.3, 0, .5, -2, 2)),
         without(inCube, drilled)},
        {"a hole as long as what it is in", combined("difference", cube + rod(.3, 0, .5, -1, 1)),
         without(inCube, drilled)},
        {"a difference of three",
         combined("difference", cube + rod(.3, 0, .5, -2, 2) + ball(-.8, -.8, 0, .7)),
         without(without(inCube, drilled), insideBall(-.8, -.8, 0, .7))},
        {"neighbours", combined("union", box(-1, 0, -1, 1, -1, 1) + box(0, 1, -1, 1, -1, 1)),
         inCube},
        {"neighbours in depth",
         combined("union", box(-1, 1, -1, 1, -1, 0) + box(-1, 1, -1, 1, 0, 1)), inCube},
        {"a notch that ends with the block",
         combined("difference", cube + box(-.5, 1, -1, .25, -1, .5)),
         without(inCube, insideBox(-.5, 1, -1, .25, -1, .5))},
        {"the same twice", combined("union", cube + cube), inCube},
        {"all of it", combined("difference", cube + cube),
         [](double, double, double, double) { return false; }},
        {"a die",
         combined("difference", combined("intersection", cube + ball(0, 0, 0, 1.3)) +
                                    combined("union", rod(.3, 0, .5, -2, 2) + ball(-1, 0, 0, .6))),
         without(inDie, either(drilled, insideBall(-1, 0, 0, .6)))},
        {"bodies of their own",
         "SolidBegin \"intersection\"\nSphere 1.2 -1.2 1.2 360\n"
         "Torus 1 .4 0 360 360\nSolidEnd\n",
         both(insideBall(0, 0, 0, 1.2),
              [](double x, double y, double z, double) {
                  return std::hypot(std::hypot(x, y) - 1, z) < .4;
              })},
        {"of nothing", combined("difference", combined("union", "") + cube),
         [](double, double, double, double) { return false; }},
        {"an instance within",
         combined("intersection", box(-1.5, .5, -1.5, 1.5, -1.5, 1.5) + "ObjectInstance 7\n"),
         both(insideBox(-1.5, .5, -1.5, 1.5, -1.5, 1.5),
              without(insideBall(0, 0, 0, 1), insideRod(0, 0, .5, -2, 2))),
         "ObjectBegin 7\n" + combined("difference", ball(0, 0, 0, 1) + rod(0, 0, .5, -2, 2)) +
             "ObjectEnd\n"},
        onion(12),
    };
    return cases;
}

Seen lookThrough(const Inside &inside, int rays) {
    constexpr double half = 1.6;
    constexpr int steps = 200;
    Seen seen;
    for (int i = 0; i < rays; ++i)
        for (int j = 0; j < rays; ++j) {
            int within = 0;
            for (int k = 0; k < steps; ++k) {
                const auto at = [](double share) { return half * (2 * share - 1); };
                // Each in its part of time and of the step, so that neither shows.
                const double share = std::fmod((i * 31 + j * 17) * .618034, 1.0);
                const double jitter = std::fmod((i * 7 + j * 13) * .7548777, 1.0);
                within += inside(at((i + .5) / rays), at((j + .5) / rays), at((k + jitter) / steps),
                                 share);
            }
            seen.covered += within > 0;
            seen.halvedOften += std::exp2(-2 * half * within / steps);
        }
    seen.covered /= rays * rays, seen.halvedOften /= rays * rays;
    return seen;
}

} // namespace candela::test
