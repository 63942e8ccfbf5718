// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_choices.h"

#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"

#include <algorithm>

namespace candela {

namespace {

/// Calls body(set, query of its lanes, lanes) for each light set among the points; lanes are null
/// where all points share one.
template <class Body>
void forLightSets(const SceneState &state, const LightQuery &query, Body body) {
    const std::int32_t first = query.count > 0 ? query.lightSet[0] : -1;
    if (lanes::allEqual(query.count, query.lightSet, first)) {
        if (first >= 0)
            body(first, query, nullptr);
        return;
    }
    thread_local AlignedScratch floats;
    thread_local Scratch<int> integers;
    const int stride = paddedLanes(query.count);
    float *planes = floats.get(7 * std::size_t(stride));
    int *lane = integers.get(query.count);
    for (int set = 0; set < int(state.lightSets.size()); ++set) {
        LightQuery part = query;
        part.count = 0;
        for (int i = 0; i < query.count; ++i)
            if (query.lightSet[i] == set)
                lane[part.count++] = i;
        if (part.count == 0)
            continue;
        for (int c = 0; c < 3; ++c) {
            float *P = planes + c * stride, *N = planes + (3 + c) * stride;
            lanes::gather(part.count, lane, query.P[c], P);
            lanes::gather(part.count, lane, query.N[c], N);
            part.P[c] = P, part.N[c] = N;
        }
        if (query.scattered) {
            lanes::gather(part.count, lane, query.scattered, planes + 6 * stride);
            part.scattered = planes + 6 * stride;
        }
        body(set, part, lane);
    }
}

} // namespace

void chooseSources(const SceneState &state, LightGroup group, const LightQuery &query, double *u,
                   std::int32_t *source, float *probability) {
    if (query.count > 0 && query.lightSet[0] < 0) { // The lanes of no set are left out.
        lanes::fill(query.count, -1, source);
        lanes::fill(query.count, 0.0f, probability);
    }
    forLightSets(state, query, [&](int set, const LightQuery &part, const int *lane) {
        const LightChoice &choice = state.lights.choices[set][group];
        if (!lane)
            return choice.choose(part.count, part.P.data(), part.N.data(), u, source, probability,
                                 part.scattered);
        thread_local Scratch<double> partU;
        thread_local Scratch<std::int32_t> partSource;
        thread_local Scratch<float> partProbability;
        double *own = partU.get(part.count);
        std::int32_t *chosen = partSource.get(part.count);
        float *chance = partProbability.get(part.count);
        for (int k = 0; k < part.count; ++k)
            own[k] = u[lane[k]];
        choice.choose(part.count, part.P.data(), part.N.data(), own, chosen, chance,
                      part.scattered);
        for (int k = 0; k < part.count; ++k)
            u[lane[k]] = own[k], source[lane[k]] = chosen[k], probability[lane[k]] = chance[k];
    });
}

namespace {

void findProbabilities(const SceneState &state, LightGroup group, const LightQuery &query,
                       const std::int32_t *source, float *probability) {
    forLightSets(state, query, [&](int set, const LightQuery &part, const int *lane) {
        const LightChoice &choice = state.lights.choices[set][group];
        if (!lane)
            return choice.probability(part.count, part.P.data(), part.N.data(), source, probability,
                                      part.scattered);
        thread_local Scratch<std::int32_t> partSource;
        thread_local Scratch<float> partProbability;
        std::int32_t *asked = partSource.get(part.count);
        float *chance = partProbability.get(part.count);
        for (int k = 0; k < part.count; ++k)
            asked[k] = source[lane[k]];
        choice.probability(part.count, part.P.data(), part.N.data(), asked, chance, part.scattered);
        for (int k = 0; k < part.count; ++k)
            probability[lane[k]] = chance[k];
    });
}

} // namespace

void sourceProbabilities(const SceneState &state, const LightQuery &query,
                         const std::int32_t *source, float *probability) {
    thread_local AlignedScratch own;
    float *ofGroup = own.get(query.count);
    std::fill_n(probability, query.count, 0.0f);
    for (LightGroup group : state.lights.groups) {
        std::fill_n(ofGroup, query.count, 0.0f);
        findProbabilities(state, group, query, source, ofGroup);
        lanes::add(query.count, ofGroup, probability); // 0 in all groups but the source's.
    }
}

} // namespace candela
