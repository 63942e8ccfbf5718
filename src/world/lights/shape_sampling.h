// SPDX-License-Identifier: Apache-2.0
// Points on shapes as they are seen from points P, with densities per steradian of the direction
// from P. One shape a lane, in planes; all of a call in one space, lengths in one unit.
//
// u and v are uniform in [0,1). Strata of (u,v) stay strata of the shape, and neighbours stay
// neighbours. Planes of results overlap no other plane.
//
// Sampled and hit points get their densities from the same functions of the same floats. A density
// of 0 says that nothing is to be had: P sees the shape edge on, the shape is empty, or a number
// isn't finite or is too great for a float.
#pragma once

namespace candela {

/// Uniform over the cone of directions that a sphere subtends; `point` is where they meet it first
/// or, with the probability `far`, where they leave it. From inside a sphere and from its surface:
/// uniform over all directions, and `point` is where they leave it.
void sampleSpheres(int count, const float *const P[3], const float *const centre[3],
                   const float *radius, const float *far, const float *u, const float *v,
                   float *const point[3], float *pdf);
/// The density of all directions that meet the sphere, with that of the wall which they meet: if
/// `far` is 0 or 1 the one that is drawn, else (1/2) either.
void sphereDensities(int count, const float *const P[3], const float *const centre[3],
                     const float *radius, const float *far, float *pdf);

/// Rectangles corner + s edgeA + t edgeB, s and t in [0,1], the edges at right angles: nearly
/// uniform by solid angle (rectangle_sampling.cpp). Sizes and distances of 1e-15 to 1e15.
void sampleRectangles(int count, const float *const P[3], const float *const corner[3],
                      const float *const edgeA[3], const float *const edgeB[3], const float *u,
                      const float *v, float *const point[3], float *pdf);
/// `point` lies on the rectangle.
void rectangleDensities(int count, const float *const P[3], const float *const corner[3],
                        const float *const edgeA[3], const float *const edgeB[3],
                        const float *const point[3], float *pdf);

/// Triangles corner + s edgeA + t edgeB, s + t <= 1, each drawn by its area from what has `area`
/// in all. Uniform by area.
void sampleTriangles(int count, const float *const P[3], const float *const corner[3],
                     const float *const edgeA[3], const float *const edgeB[3], const float *area,
                     const float *u, const float *v, float *const point[3], float *pdf);
/// `point` lies on the triangle. The draw of the triangle is part of the density.
void triangleDensities(int count, const float *const P[3], const float *const corner[3],
                       const float *const edgeA[3], const float *const edgeB[3], const float *area,
                       const float *const point[3], float *pdf);

} // namespace candela
