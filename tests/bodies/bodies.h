// SPDX-License-Identifier: Apache-2.0
// Closed bodies of every kind of primitive, and the ways to place them in a scene.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

/// The primitives' outsides are the body's. The origin is inside, no face is nearer to it than .45.
struct Body {
    std::string name;
    std::string rib;
    bool costly = false;  ///< Many triangles: curved lamps are diced to 1/5000 of their size.
    bool pierced = false; ///< From within, a line may leave it and meet its outside beyond a hole.
};
std::vector<Body> closedBodies();
/// Those of them that are given by points, with all coordinates moved by that much: what floats
/// leave of a body far from its origin.
std::vector<Body> bodiesAway(double away);

/// Polygons and patches with the primitive variable "N": the outside, and N, are the body's or, if
/// `inward`, look inward.
std::vector<Body> bodiesWithNormals(bool inward);

/// Text of a RIB array.
std::string array(const std::vector<double> &values);

} // namespace candela::test
