// SPDX-License-Identifier: Apache-2.0
// How likely light sampling would have been to find what a ray has met.
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/scene/light_choices.h"
#include "world/scene/source_points.h"

#include <algorithm>
#include <optional>

namespace candela {

namespace {

ElementRows &elementRows(int count) {
    thread_local std::optional<ElementRows> own;
    if (!own || own->planes.lanes() < count)
        own.emplace(count);
    return *own;
}

} // namespace

void Lights::density(const LightQuery &query, const ShadingPoints &points,
                     const std::array<const float *, 3> &elementPoint, float *pdf) const {
    if (state_->lights.elements.empty())
        return void(std::fill_n(pdf, query.count, 0.0f));
    thread_local Scratch<std::int32_t> sources;
    thread_local AlignedScratch probabilities;
    const int count = query.count;
    std::int32_t *source = sources.get(2 * std::size_t(count)), *element = source + count;
    float *probability = probabilities.get(count);
    const PointTables &tables = state_->points;
    for (int i = 0; i < count; ++i) {
        source[i] = element[i] = -1;
        if (points.light[i] == 0 || query.lightSet[i] < 0)
            continue;
        const Appearance &appearance =
            tables.appearances[tables.appearanceOf(points.instance[i], points.shape[i])];
        if (appearance.firstElement < 0)
            continue;
        const bool isSphere = tables.shapes[points.shape[i]].naming == Naming::Round;
        element[i] = appearance.firstElement + (isSphere ? 0 : std::int32_t(points.element[i]));
        source[i] = state_->lights.elements[element[i]].source;
    }
    sourceProbabilities(*state_, query, source, probability);
    ElementRows &rows = elementRows(count);
    rows.take(state_->lights, count, element);
    rows.moveTo(state_->points, query.time);
    elementDensities(rows, query.P.data(), elementPoint.data(), pdf);
    lanes::multiply(count, probability, pdf);
}

void Lights::densityOf(const LightQuery &query, const std::int32_t *source,
                       const std::int32_t *element,
                       const std::array<const float *, 3> &elementPoint, float *pdf) const {
    thread_local AlignedScratch probabilities;
    const int count = query.count;
    float *probability = probabilities.get(count);
    sourceProbabilities(*state_, query, source, probability);
    ElementRows &rows = elementRows(count);
    rows.take(state_->lights, count, element);
    rows.moveTo(state_->points, query.time);
    elementDensities(rows, query.P.data(), elementPoint.data(), pdf);
    for (int i = 0; i < count; ++i)
        pdf[i] = element[i] < 0 ? probability[i] : pdf[i] * probability[i];
}

} // namespace candela
