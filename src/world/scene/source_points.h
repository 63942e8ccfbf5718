// SPDX-License-Identifier: Apache-2.0
// Points on sources of light, and the densities of finding them, in batches of mixed forms.
#pragma once

#include "foundation/base/planes.h"
#include "world/scene/light_sources.h"

#include <array>

namespace candela {

/// Sources with geometry, one a lane, as seen from points.
struct SourceQuery {
    int count = 0;
    const std::int32_t *source = nullptr; ///< Index into LightTable::sources.
    std::array<const float *, 3> from{};  ///< The points that look.
};

/// A point a lane, current space.
struct SourcePoints {
    explicit SourcePoints(int capacity);
    Planes<float> floats;
    std::array<float *, 3> point, normal; ///< The element's normal, of any length, not yet turned.
    float *pdf;                           ///< Per steradian at `from`, without the choice.
    float *offset;                        ///< LightSource::offset.
    float *u, *v;                         ///< Barycentric, on triangles.
};

/// Samples the sources by solid angle (by area if `byArea`: then pdf is per unit area, and `from`
/// is not read) at uniform (u,v).
void sampleSources(const LightTable &, const SourceQuery &, const float *u, const float *v,
                   bool byArea, SourcePoints &);

/// The densities with which sampleSources finds these points on them; `point` planes are given.
void sourceDensities(const LightTable &, const SourceQuery &, const float *const point[3],
                     float *pdf);

} // namespace candela
