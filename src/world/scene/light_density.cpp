// SPDX-License-Identifier: Apache-2.0
// How likely light sampling would have been to find what a ray has met.
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/scene/light_choices.h"
#include "world/scene/source_points.h"

#include <optional>

namespace candela {

namespace {

SourceRows &sourceRows(int count) {
    thread_local std::optional<SourceRows> own;
    if (!own || own->planes.lanes() < count)
        own.emplace(count);
    return *own;
}

} // namespace

void Scene::lightDensity(const LightQuery &query, const ShadingPoints &points,
                         const std::array<const float *, 3> &elementPoint, float *pdf) const {
    thread_local Scratch<std::int32_t> sources;
    thread_local AlignedScratch probabilities;
    const int count = query.count;
    std::int32_t *source = sources.get(count);
    float *probability = probabilities.get(count);
    const PointTables &tables = state_->points;
    for (int i = 0; i < count; ++i) {
        source[i] = -1;
        if (points.light[i] == 0 || query.lightSet[i] < 0)
            continue;
        const Appearance &appearance =
            tables.appearances[tables.appearanceOf(points.instance[i], points.shape[i])];
        const auto &ofElement = tables.shapes[points.shape[i]].sourceOfElement;
        source[i] = appearance.firstSource +
                    std::int32_t(ofElement.empty() ? 0 : ofElement[points.element[i]]);
    }
    sourceProbabilities(*state_, query, source, probability);
    SourceRows &rows = sourceRows(count);
    rows.take(state_->lights, count, source);
    sourceDensities(rows, query.P.data(), elementPoint.data(), pdf);
    lanes::multiply(count, probability, pdf);
}

} // namespace candela
