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

CANDELA_HOT bool followFiniteLobes(int count, const float *__restrict total,
                                   std::int32_t *__restrict event) {
    int some = 0;
    for (int i = 0; i < count; ++i) {
        const int goesOn = total[i] > 0;
        event[i] = goesOn ? finiteRequests : pathEnds;
        some |= goesOn;
    }
    return some != 0;
}

/// The weight of a cone's request as a delta request.
float deltaWeight(const ConePlanes &cone, int i) {
    const float r = cone.importance[i];
    return !(cone.kindAngle[i] > 0) && r > 0 && std::isfinite(r) ? r : 0;
}

} // namespace

ScatteringEvents::ScatteringEvents(int capacity)
    : events_(1, capacity), direction_(3, capacity), transmission_(1, capacity),
      total_(1, capacity), share_(1, capacity) {}

bool transmittedLight(int count, const std::array<const float *, colorSamples> &Oi,
                      float *transmission) {
    bool opaque = true;
    for (int c = 0; c < colorSamples; ++c)
        opaque &= lanes::allEqual(count, Oi[c], 1);
    if (opaque)
        return false;
    std::fill_n(transmission, count, 0.0f);
    for (int c = 0; c < colorSamples; ++c)
        addTransmission(count, Oi[c], luminanceWeights[c], transmission);
    return true;
}

void ScatteringEvents::look(const SurfaceVertices &vertices) {
    const int count = vertices.count();
    const PreparedSurface &prepared = vertices.prepared();
    opaque_ = !transmittedLight(count, prepared.Oi, transmission_[0]);
    deltas_.clear();
    for (int k = 0; k < int(prepared.cones.size()); ++k) {
        const ConePlanes &cone = prepared.cones[k];
        if (cone.first && !lanes::allPositive(count, cone.kindAngle))
            deltas_.push_back(k);
    }
}

float ScatteringEvents::weightOf(const SurfaceVertices &vertices, int kind, int i) const {
    const bool delta = kind < int(deltas_.size());
    return delta ? deltaWeight(vertices.prepared().cones[deltas_[kind]], i) : transmission_[0][i];
}

void ScatteringEvents::weigh(const SurfaceVertices &vertices, const float *finiteTotal) {
    for (int i = 0; i < vertices.count(); ++i) {
        float total = finiteTotal ? finiteTotal[i] : 0;
        for (int kind = 0; kind < kinds(); ++kind)
            total += weightOf(vertices, kind, i);
        total_[0][i] = total;
    }
}

bool ScatteringEvents::takeFinite(int count, const float *total) {
    finite_ = true;
    if (kinds() > 0)
        for (int i = 0; i < count; ++i)
            share_[0][i] = total[i] > 0 ? total[i] / total_[0][i] : 0;
    return followFiniteLobes(count, total, events_[0]);
}

bool ScatteringEvents::takeKind(SurfaceVertices &vertices, int kind) {
    finite_ = false;
    const bool delta = kind < int(deltas_.size());
    const ConePlanes *cone = delta ? &vertices.prepared().cones[deltas_[kind]] : nullptr;
    const ConstVec3Planes along = delta ? cone->axis : vertices.input(ShaderInput::I);
    bool some = false;
    for (int i = 0; i < vertices.count(); ++i) {
        const float weight = weightOf(vertices, kind, i);
        const bool taken = weight > 0;
        events_[0][i] = taken ? delta ? cone->request : straightThrough : pathEnds;
        share_[0][i] = taken ? weight / total_[0][i] : 0;
        for (int c = 0; c < 3; ++c)
            direction_[c][i] = along[c][i];
        some |= taken;
    }
    return some;
}

} // namespace candela
