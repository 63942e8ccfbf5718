// SPDX-License-Identifier: Apache-2.0
// Solids as text and, beside it, as the points inside them.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace candela::test {

/// Whether a point is inside; `share` of the shutter's interval has passed.
using Inside = std::function<bool(double x, double y, double z, double share)>;

/// Within [-1.5,1.5]^3.
struct SolidCase {
    std::string name, rib;
    Inside inside;
    std::string before = ""; ///< Objects that it has instances of.
};

/// Of every operation and primitive, nested, and with faces that lie upon each other.
std::vector<SolidCase> solidCases();

/// Bodies: SolidBegin "primitive" ... SolidEnd.
std::string ball(double x, double y, double z, double radius);
std::string box(double x0, double x1, double y0, double y1, double z0, double z1);
/// Along z.
std::string rod(double x, double y, double radius, double z0, double z1);
std::string combined(const std::string &operation, const std::string &parts);

/// What is drawn of a solid along +z, over the square of half-width 1.6, by so many rays a side.
struct Seen {
    double covered = 0;     ///< Share of the square.
    double halvedOften = 0; ///< Mean of 2 to the power of minus the way through it.
};
Seen lookThrough(const Inside &, int rays = 160);

} // namespace candela::test
