// SPDX-License-Identifier: Apache-2.0
// Dicing of displaced shapes: triangles are split until their edges are as short as asked, where
// they have been moved to.
//
// Whether an edge is split depends on that edge alone, so both its sides agree. Vertices that
// coincide before they are moved (seams, poles, edges of faces and of neighbouring primitives) are
// one point ever after, and so are the middles of edges between them: each surface says where it
// moves the point to, and it goes to the mean of what they say. So nothing cracks. Shapes that
// share more than rims, as two bodies of one form do, are not joined (joined_points.h).
#pragma once

#include "world/camera/camera.h"
#include "world/shapes/shape.h"

#include <span>
#include <vector>

namespace candela {

/// Shapes that are diced together are of one outer space.
struct DisplacedDicing {
    Shape *shape;
    DicedMesh mesh; ///< Of its surface, to begin with; the shape's own space.
    /// How long edges may be, in pixels of the camera's, or in outer units if there is none.
    float edge = 1;
};

/// An edge of a displaced surface is at most so many pixels long at ShadingRate 1; it grows with
/// its square root. The mean of what splitting leaves is then about a pixel.
inline constexpr float displacedEdgePixels = 1.4f;
/// No frame has more triangles of displaced surfaces than this.
inline constexpr double displacedBudget = 4e6;

/// Splits and moves; gives each shape the displaced surface as its surface, and what follows from
/// that (see dice()). Returns what rays meet. `camera`: sizes are as it sees them, the outer space
/// being current space; null: sizes are as they are.
std::vector<RayShape> diceDisplaced(std::span<DisplacedDicing>, const Camera *camera,
                                    double mostTriangles);

} // namespace candela
