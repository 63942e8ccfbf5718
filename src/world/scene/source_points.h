// SPDX-License-Identifier: Apache-2.0
// Points on sources of light, and the densities of finding them, in batches of mixed forms.
#pragma once

#include "foundation/base/planes.h"
#include "world/points/shading_points.h"
#include "world/scene/light_sources.h"

#include <array>

namespace candela {

/// LightTable::sources, one a lane.
struct SourceRows {
    explicit SourceRows(int capacity);
    /// Takes source[0..count); -1 gives a lane of no form.
    void take(const LightTable &, int count, const std::int32_t *source);

    int count = 0;
    Planes<float> planes;
    Planes<int> row;
    std::int32_t *light, *form;
    std::uint32_t *instance, *shape, *element;
    std::array<float *, 3> corner, edgeA, edgeB;
    float *offset;
};

/// A point a lane, current space.
struct SourcePoints {
    explicit SourcePoints(int capacity);
    Planes<float> floats;
    std::array<float *, 3> point, normal; ///< The element's normal, of any length, not yet turned.
    float *pdf;                           ///< Per steradian from where one looks.
    float *u, *v;                         ///< Barycentric, on triangles.
};

/// Samples the sources by solid angle as seen `from` points, at uniform (u,v). Lanes without a form
/// get a density of 0.
void sampleSources(const SourceRows &, const float *const from[3], const float *u, const float *v,
                   SourcePoints &);
/// The same by area: no one looks, densities are left alone.
void placeOnSources(const SourceRows &, const float *u, const float *v, SourcePoints &);

/// Fills what evaluatePoints wants to know of points on sources, but I.
void placePoints(const SourceRows &, const SourcePoints &, ShadingPoints &);

/// The densities with which sampleSources finds these points on the sources.
void sourceDensities(const SourceRows &, const float *const from[3], const float *const point[3],
                     float *pdf);

} // namespace candela
