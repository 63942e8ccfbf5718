// SPDX-License-Identifier: Apache-2.0
// Points on sources of light, and the densities of finding them, in batches of mixed forms.
#pragma once

#include "foundation/base/planes.h"
#include "world/points/shading_points.h"
#include "world/scene/light_sources.h"

#include <array>

namespace candela {

/// LightTable::elements, one a lane.
struct ElementRows {
    explicit ElementRows(int capacity);
    /// Takes element[0..count); -1 gives a lane of no form, of source 0.
    void take(const LightTable &, int count, const std::int32_t *element);
    /// Takes an element of each of source[0..count), by area; `u` is uniform in [0,1), and so is
    /// what is left of it.
    void draw(const LightTable &, int count, const std::int32_t *source, const float *u);

    /// Brings elements that move to where they are at the lanes' times.
    void moveTo(const PointTables &, const float *time);

    int count = 0;
    Planes<float> planes;
    Planes<int> row;
    std::int32_t *source, *form;
    std::uint32_t *instance, *shape, *element;
    std::array<float *, 3> corner, edgeA, edgeB;
    float *offset, *area;
    std::int32_t *light; ///< The source's,
    float *handedness;   ///< and this too.
    float *u;            ///< See draw().

private:
    void fill(const LightTable &, int count, std::int32_t element);
    LightElement filled_; ///< What the first filledLanes_ lanes hold.
    int filledLanes_ = 0;
};

/// A point a lane, current space.
struct SourcePoints {
    explicit SourcePoints(int capacity);
    Planes<float> floats;
    /// The element's normal, of any length, as hits have it: not yet turned, and carried along as a
    /// covector by instances.
    std::array<float *, 3> point, normal;
    float *pdf;   ///< Per steradian from where one looks.
    float *u, *v; ///< Barycentric, on triangles.
};

/// Samples elements as seen `from` points at uniform (u,v): those that are all of their source by
/// solid angle, of triangles and of pieces by area. Lanes without a form get a density of 0.
void sampleElements(const ElementRows &, const float *const from[3], const float *u, const float *v,
                    SourcePoints &);
/// The same by area: no one looks, densities are left alone.
void placeOnElements(const ElementRows &, const float *u, const float *v, SourcePoints &);

/// Fills what evaluatePoints wants to know of points on elements, but I.
void placePoints(const ElementRows &, const SourcePoints &, ShadingPoints &);

/// The densities with which draw() and sampleElements(), asked for the elements' sources, find
/// these points on the elements.
void elementDensities(const ElementRows &, const float *const from[3], const float *const point[3],
                      float *pdf);

} // namespace candela
