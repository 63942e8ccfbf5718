// SPDX-License-Identifier: Apache-2.0
// Shapes: surfaces, diced once, wherever they stand. A shape of the world stands in current space;
// one of an object stands in the object's space and is placed by any number of instances. That
// space is called the outer one here, the surface's own the shape's.
#pragma once

#include "foundation/base/matrix4.h"
#include "world/geometry/displacement.h"
#include "world/rays/ray_world.h"

#include <limits>
#include <memory>
#include <vector>

namespace candela {

/// How the elements that rays hit name points of the surface, as (piece, u, v).
enum class Naming : std::uint8_t {
    Direct,  ///< The element is the piece, barycentric coordinates are (u,v).
    Corners, ///< (u,v) is interpolated from the element's corners.
    Round,   ///< A round element: (u,v) follows from where the point lies.
};

struct Shape {
    std::shared_ptr<const Surface> surface;
    /// What moves its points; null = nothing. Once it is diced the surface is the displaced one.
    std::shared_ptr<const Displacement> displacement;
    Matrix4 outerFromShape, shapeFromOuter;
    Naming naming = Naming::Direct;
    /// Rays may meet it as it is, if it is round: unless it shines otherwise than as a sphere.
    bool mayBeRound = true;
    /// Every normal that shaders see is that of the element.
    bool flat = false;
    /// Normals are the surface's to tell, not the elements'.
    bool curved = false;
    /// Elements only come near the surface: positions are the surface's to tell too.
    bool away = false;
    /// Times (p1 - p0) x (p2 - p0) of an element's corners in the outer space (of a sphere, times
    /// the outward normal): along the natural normal, carried along as a covector.
    float elementSign = 1;
    float handedness = 1; ///< -1: the matrix mirrors.
    /// Outer units: no element is farther than this from the true surface, and rays that start
    /// within as much of an element may meet it by rounding.
    float offset = 0;
    /// The same near the eye, where elements were cut small: the offset is no larger than so many
    /// times the point's distance from it.
    float offsetShare = std::numeric_limits<float>::infinity();

    /// Naming::Corners: of each element, and (u,v) of each vertex. `pieces` is empty where all of
    /// the surface is one piece.
    std::vector<std::array<std::uint32_t, 3>> triangles;
    std::vector<std::array<float, 2>> vertexUv;
    std::vector<std::uint32_t> pieces;
    std::uint32_t elements = 0;

    /// Index into Surface::variables(), -1 = none.
    int s = -1, t = -1, Cs = -1, Os = -1;
};

/// A shape of the surface; not diced yet. Nothing if the matrix is singular.
std::optional<Shape> makeShape(std::shared_ptr<const Surface>, const Matrix4 &outerFromShape);

/// Index of a numeric variable of the surface by its name, -1 = none.
int numericVariable(const Surface &, const std::string &name);

/// The matrix leaves spheres spheres.
bool keepsSpheres(const Matrix4 &);
/// Rays meet the shape's round elements: the matrix leaves them round, and nothing moves them.
bool isMetRound(const Shape &);

/// Dices: fills in naming, signs and offset; what rays will meet. Triangles that are large against
/// their distance from `eye` (outer space; null = nowhere) are cut, so that rounding goes with the
/// distance.
RayShape dice(Shape &, const DiceRate &, const Vec3 *eye);

} // namespace candela
