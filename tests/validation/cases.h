// SPDX-License-Identifier: Apache-2.0
// The table of closed-form cases: scenes as RIB, numbers as the formulas give them.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

/// A small view of one place, and the number that its mean has to be.
struct Probe {
    std::string name;
    std::string camera; ///< RIB before WorldBegin: Projection, ScreenWindow, transforms.
    double expected = 0;
    double scale = 1; ///< Of the picture's mean before it is compared: pi / rho makes it E.
};

/// How near the mean has to come (the head of VALIDATION).
enum class Accuracy {
    Exact,  ///< No chance and no cancellation in it: 1e-5, and the same from every seed.
    Direct, ///< Direct light in closed form: 0.1 %.
    Global, ///< Light of many bounces: 0.5 %.
};

struct Case {
    std::string name;    ///< Letters and digits, with the number VALIDATION gives it.
    std::string options; ///< RIB of each frame before the camera.
    std::string world;   ///< RIB between WorldBegin and WorldEnd.
    std::vector<Probe> probes;
    Accuracy accuracy = Accuracy::Direct;
    int samples = 16; ///< A pixel; the picture has 8 x 8.
};

/// "L = Le / (1 - rho)" and its kin: enclosures [A].
std::vector<Case> furnaceCases();
/// Lights on a plane [C].
std::vector<Case> directLightCases();
/// What one unit of a light is on a surface [I].
std::vector<Case> unitCases();
std::vector<Case> allCases();

/// Names and numbers in RIB, with all digits that floats have.
std::string number(double value);
/// An orthographic look straight down on (x, y, 0) from just above, over a square of 2 * halfWidth.
/// Light sources above the eye are not in the way.
std::string lookDownAt(double x, double y, double halfWidth = 1e-2);
/// An orthographic look along +z from the origin of the world turned by these degrees about y.
std::string lookFromOrigin(double degreesAboutY, double halfWidth = 1e-2);

inline const std::string siUnits = "Option \"radiometry\" \"string units\" [\"si\"]\n";

} // namespace candela::test
