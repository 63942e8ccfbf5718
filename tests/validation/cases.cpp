// SPDX-License-Identifier: Apache-2.0
#include "tests/validation/cases.h"

#include <cstdio>

namespace candela::test {

std::string number(double value) {
    char text[32];
    std::snprintf(text, sizeof text, "%.9g", value);
    return text;
}

namespace {

std::string orthographic(double halfWidth) {
    std::string w = number(halfWidth);
    return "Projection \"orthographic\"\nScreenWindow -" + w + " " + w + " -" + w + " " + w + "\n";
}

} // namespace

std::string lookDownAt(double x, double y, double halfWidth) {
    return orthographic(halfWidth) + "Translate 0 0 0.05\nRotate 180 1 0 0\nTranslate " +
           number(-x) + " " + number(-y) + " 0\n";
}

std::string lookFromOrigin(double degreesAboutY, double halfWidth) {
    return orthographic(halfWidth) + "Rotate " + number(degreesAboutY) + " 0 1 0\n";
}

std::vector<Case> allCases() {
    std::vector<Case> all = furnaceCases();
    for (const auto &more : {directLightCases(), unitCases()})
        all.insert(all.end(), more.begin(), more.end());
    return all;
}

} // namespace candela::test
