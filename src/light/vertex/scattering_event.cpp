// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/scattering_event.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// Light that less than this share of passes is taken as stopped.
constexpr float leastTransmission = 1e-6f;

CANDELA_HOT void addTransmission(int count, const float *__restrict opacity, float weight,
                                 float *__restrict transmission) {
    for (int i = 0; i < count; ++i) {
        float through = 1 - opacity[i];
        through = through > leastTransmission ? through : 0;
        transmission[i] += weight * (through < 1 ? through : 1);
    }
}

/// Where the finite lobes are all there is.
CANDELA_HOT void followFiniteLobes(int count, const float *__restrict total,
                                   std::int32_t *__restrict event, float *__restrict probability,
                                   float *__restrict finiteProbability) {
    for (int i = 0; i < count; ++i) {
        bool goesOn = total[i] > 0;
        event[i] = goesOn ? finiteRequests : pathEnds;
        probability[i] = goesOn ? 1.0f : 0.0f;
        finiteProbability[i] = goesOn ? 1.0f : 0.0f;
    }
}

/// The weight of a cone's request as a delta request.
float deltaWeight(const ConePlanes &cone, int i) {
    const float r = cone.importance[i];
    return !(cone.kindAngle[i] > 0) && r > 0 && std::isfinite(r) ? r : 0;
}

} // namespace

ScatteringEvents::ScatteringEvents(int capacity)
    : events_(1, capacity), probability_(1, capacity), finiteProbability_(1, capacity),
      direction_(3, capacity), transmission_(1, capacity) {}

void ScatteringEvents::look(const SurfaceVertices &vertices) {
    const int count = vertices.count();
    opaque_ = true;
    for (int c = 0; c < colorSamples; ++c)
        opaque_ &= lanes::allEqual(count, vertices.Oi(c), 1);
    deltas_.clear();
    for (int k = 0; k < int(vertices.cones().size()); ++k) {
        const ConePlanes &cone = vertices.cones()[k];
        if (cone.first && !lanes::allPositive(count, cone.kindAngle))
            deltas_.push_back(k);
    }
    mayBeDelta_ = !deltas_.empty();
    if (opaque_)
        return;
    std::fill_n(transmission_[0], count, 0.0f);
    for (int c = 0; c < colorSamples; ++c)
        addTransmission(count, vertices.Oi(c), luminanceWeights[c], transmission_[0]);
}

void ScatteringEvents::choose(SurfaceVertices &vertices, const float *finiteTotal, const float *u) {
    const int count = vertices.count();
    if (!needsChoice()) {
        followFiniteLobes(count, finiteTotal, events_[0], probability_[0], finiteProbability_[0]);
        return;
    }
    if (opaque_)
        std::fill_n(transmission_[0], count, 0.0f);
    ConstVec3Planes incident = vertices.input(ShaderInput::I);
    for (int i = 0; i < count; ++i) {
        float total = finiteTotal[i] + transmission_[0][i];
        for (int k : deltas_)
            total += deltaWeight(vertices.cones()[k], i);
        events_[0][i] = pathEnds;
        probability_[0][i] = finiteProbability_[0][i] = 0;
        if (!(total > 0))
            continue;
        float scale = 1 / total, left = u[i] * total;
        finiteProbability_[0][i] = finiteTotal[i] * scale;
        auto take = [&](std::int32_t event, float weight) {
            if (weight <= 0 || events_[0][i] != pathEnds)
                return false;
            left -= weight;
            if (left >= 0)
                return false;
            events_[0][i] = event;
            probability_[0][i] = weight * scale;
            return true;
        };
        take(finiteRequests, finiteTotal[i]);
        for (int k : deltas_) {
            const ConePlanes &cone = vertices.cones()[k];
            if (take(cone.request, deltaWeight(cone, i)))
                for (int c = 0; c < 3; ++c)
                    direction_[c][i] = cone.axis[c][i];
        }
        if (take(straightThrough, transmission_[0][i]))
            for (int c = 0; c < 3; ++c)
                direction_[c][i] = incident[c][i];
        // Rounding may leave a sliver above the last weight: the path ends there, unweighted,
        // with a probability below 1e-7.
    }
}

bool ScatteringEvents::takeAll(SurfaceVertices &vertices, int kind, const int *wanted) {
    const bool delta = kind < int(deltas_.size());
    const ConePlanes *cone = delta ? &vertices.cones()[deltas_[kind]] : nullptr;
    const ConstVec3Planes along = delta ? cone->axis : vertices.input(ShaderInput::I);
    bool some = false;
    for (int i = 0; i < vertices.count(); ++i) {
        const float weight = delta ? deltaWeight(*cone, i) : transmission_[0][i];
        const bool taken = wanted[i] != 0 && weight > 0;
        events_[0][i] = taken ? delta ? cone->request : straightThrough : pathEnds;
        probability_[0][i] = taken ? 1 : 0;
        finiteProbability_[0][i] = 0;
        for (int c = 0; c < 3; ++c)
            direction_[c][i] = along[c][i];
        some |= taken;
    }
    return some;
}

void ScatteringEvents::end(int count, const int *marked) {
    for (int i = 0; i < count; ++i)
        events_[0][i] = marked[i] != 0 ? pathEnds : events_[0][i];
}

void ScatteringEvents::endAllBut(std::int32_t event, int count) {
    for (int i = 0; i < count; ++i)
        events_[0][i] = events_[0][i] == event ? event : pathEnds;
}

bool ScatteringEvents::any(std::int32_t event, int count) const {
    return std::find(events_[0], events_[0] + count, event) != events_[0] + count;
}

} // namespace candela
