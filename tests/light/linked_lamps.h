// SPDX-License-Identifier: Apache-2.0
// Lamps that a surface hears, and how others are kept from it.
#pragma once

#include <string>

namespace candela::test {

/// How lamps are kept from a surface.
struct Linking {
    const char *name;
    const char *surface;  ///< Its shader.
    const char *heardTag; ///< Parameters of the lamps that it hears,
    const char *otherTag; ///< and of the others.
    bool switchedOff;     ///< The others are off for the surface.
};

inline constexpr Linking linkings[] = {
    {"OffForADiffuseSurface", "matte", "", "", true},
    {"OffForAGlossySurface", "glossy", "", "", true},
    {"Nondiffuse", "matte", "", "\"float __nondiffuse\" [1]", false},
    {"Nonspecular", "glossy", "", "\"float __nonspecular\" [1]", false},
    {"Category", "choosy", "\"string __category\" [\"wanted\"]",
     "\"string __category\" [\"unwanted\"]", false},
};

/// A square lamp about (x, y, 1.5), switched on.
std::string taggedLamp(int number, double x, double y, double size, double radiance,
                       const std::string &tags);

} // namespace candela::test
