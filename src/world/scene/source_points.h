// SPDX-License-Identifier: Apache-2.0
// Points on sources of light, and the densities of finding them, in batches of mixed forms.
#pragma once

#include "foundation/base/planes.h"
#include "world/scene/light_sources.h"

#include <array>

namespace candela {

/// Sources or elements, one a lane, as seen from points. -1 = none.
struct SourceQuery {
    int count = 0;
    const std::int32_t *index = nullptr; ///< Into LightTable::sources, or ::elements.
    std::array<const float *, 3> from{}; ///< The points that look.
};

/// A point a lane, current space.
struct SourcePoints {
    explicit SourcePoints(int capacity);
    Planes<float> floats;
    Planes<std::int32_t> integers;
    std::int32_t *element;                ///< That it lies on: index into LightTable::elements.
    std::array<float *, 3> point, normal; ///< The element's normal, of any length, not yet turned.
    float *pdf;                           ///< Per steradian at `from`, without the choice.
    float *offset;                        ///< LightElement::offset.
    float *u, *v;                         ///< Barycentric, on triangles.
};

/// Draws an element of each source, and a point on it at uniform (u,v): elements that are alone by
/// solid angle, those of pieces by area (all by area if `byArea`: then pdf is not told, and `from`
/// is not read). Sources without geometry get element -1.
void sampleSources(const LightTable &, const SourceQuery &, const float *u, const float *v,
                   bool byArea, SourcePoints &);

/// The densities with which sampleSources, asked for the elements' sources, finds these points on
/// them; `point` planes are given.
void elementDensities(const LightTable &, const SourceQuery &elements, const float *const point[3],
                      float *pdf);

} // namespace candela
