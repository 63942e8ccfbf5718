// SPDX-License-Identifier: Apache-2.0
#include "light/transport/classic_light.h"

#include <algorithm>
#include <cmath>

namespace candela {

ClassicLight::ClassicLight(int capacity)
    : light_(capacity), shadow_(capacity), position_(2, capacity), lanes_(paddedLanes(capacity)) {}

int ClassicLight::shade(SurfaceVertices &vertices, int rounds, const float *u, const float *v,
                        const float *const *ambient, float *const *Ci, float *const *Oi) {
    const int lights = vertices.scene().lightCount(), rows = lights * rounds;
    if (rows > rowCapacity_) {
        rowCapacity_ = rows;
        rows_ = Planes<float>(3 + colorSamples, rows * lanes_);
        rowLights_ = Planes<std::int32_t>(1, rows * lanes_);
    }
    int traced = 0;
    for (int row = 0; row < rows; ++row) {
        int light = row % lights, round = row / lights;
        // A rank-1 lattice turns one stratified sample into one for each round.
        for (int i = 0; i < vertices.count(); ++i) {
            position_[0][i] = u[i] + float(round) / float(rounds);
            position_[1][i] = v[i] + float(round) * 0.61803399f;
            position_[0][i] -= std::floor(position_[0][i]);
            position_[1][i] -= std::floor(position_[1][i]);
        }
        traced += sampleRow(vertices, row, light, rounds, position_[0], position_[1]);
    }
    std::array<float *, 3> L;
    std::array<float *, colorSamples> Cl;
    for (int c = 0; c < 3; ++c)
        L[c] = rows_.planes() ? rows_[c] : nullptr;
    for (int c = 0; c < colorSamples; ++c)
        Cl[c] = rows_.planes() ? rows_[3 + c] : nullptr;
    vertices.shade(rows, L.data(), Cl.data(), rowLights_.planes() ? rowLights_[0] : nullptr,
                   ambient, Ci, Oi);
    return traced;
}

int ClassicLight::sampleRow(SurfaceVertices &vertices, int row, int light, int rounds,
                            const float *u, const float *v) {
    LightQuery query;
    query.count = vertices.count();
    query.P = vertices.P();
    query.lightSet = vertices.points.lightSet;
    query.time = vertices.points.input(int(ShaderInput::time));
    query.choice = u;
    query.position = {u, v};
    LightSamples &samples = light_.samples;
    vertices.scene().sampleLight(light, query, samples);

    const int at = row * lanes_;
    for (int i = 0; i < query.count; ++i) {
        for (int c = 0; c < 3; ++c)
            rows_[c][at + i] = samples.L[c][i];
        rowLights_[0][at + i] = samples.light[i];
        float pdf = samples.pdfSolidAngle[i];
        float scale = samples.light[i] == 0 ? 0 : pdf > 0 ? 1 / (float(M_PI) * pdf) : 1;
        for (int c = 0; c < colorSamples; ++c)
            rows_[3 + c][at + i] = samples.value[c][i] * (scale / float(rounds));
    }
    return shadowRow(vertices, row);
}

int ClassicLight::shadowRow(SurfaceVertices &vertices, int row) {
    const LightSamples &samples = light_.samples;
    std::array<float *, colorSamples> Cl;
    for (int c = 0; c < colorSamples; ++c)
        Cl[c] = rows_[3 + c] + row * lanes_;
    lane_.clear();
    for (int i = 0; i < vertices.count(); ++i) {
        bool lit = false;
        for (int c = 0; c < colorSamples; ++c)
            lit |= Cl[c][i] != 0;
        if (lit && samples.castsShadow[i])
            lane_.push_back(i);
    }
    return shadow_.attenuate(vertices, samples, int(lane_.size()), lane_.data(), Cl.data());
}

} // namespace candela
