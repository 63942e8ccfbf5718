// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/light_samples.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

#include <cmath>

namespace candela {

namespace {

/// test[i] = 1 where some channel of the light is left to lose.
CANDELA_HOT void markShadowTests(int count, const float *__restrict red,
                                 const float *__restrict green, const float *__restrict blue,
                                 const std::int32_t *__restrict light,
                                 const std::uint8_t *__restrict castsShadow, int *__restrict test) {
    for (int i = 0; i < count; ++i) {
        bool any = (red[i] != 0) | (green[i] != 0) | (blue[i] != 0);
        test[i] = any & (light[i] != 0) & (castsShadow[i] != 0);
    }
}

} // namespace

CANDELA_HOT void unitDirections(int count, const float *__restrict x, const float *__restrict y,
                                const float *__restrict z, float *__restrict ux,
                                float *__restrict uy, float *__restrict uz) {
    for (int i = 0; i < count; ++i) {
        float squared = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
        float scale = 1 / std::sqrt(squared > 0 ? squared : 1.0f);
        ux[i] = x[i] * scale;
        uy[i] = y[i] * scale;
        uz[i] = z[i] * scale;
    }
}

LightSampleStorage::LightSampleStorage(int capacity)
    : floats(5 + colorSamples, capacity), integers(1, capacity), bytes(1, capacity) {
    samples.L = {floats[0], floats[1], floats[2]};
    samples.distance = floats[3];
    samples.pdfSolidAngle = floats[4];
    for (int c = 0; c < colorSamples; ++c)
        samples.value[c] = floats[5 + c];
    samples.light = integers[0];
    samples.castsShadow = bytes[0];
}

void LightSampleStorage::tellPlaces() {
    places = Planes<float>(4, floats.lanes());
    samples.probability = places[0];
    samples.normal = {places[1], places[2], places[3]};
}

LightQuery askingPoints(SurfaceVertices &vertices) {
    LightQuery query;
    query.count = vertices.count();
    query.Ps = vertices.P();
    query.Ns = vertices.input(ShaderInput::N);
    query.I = vertices.input(ShaderInput::I);
    query.lightSet = vertices.points.lightSet;
    query.time = vertices.points.input(int(ShaderInput::time));
    return query;
}

LightQuery lightQuery(SurfaceVertices &vertices, const ConstVec3Planes &N, const float *scattered,
                      const LightNumbers &numbers) {
    LightQuery query = askingPoints(vertices);
    query.P = vertices.litPoints();
    query.N = N;
    // Lights that are heard by samples alone are found by no ray.
    query.scattered = vertices.code().categories().hearsAllAsIndirect() ? scattered : nullptr;
    query.choice = numbers.choice;
    query.position = {numbers.u, numbers.v};
    return query;
}

void LightRows::reserve(int rows, int lanes) {
    if (directions_.lanes() >= rows * lanes && lanes_ == lanes)
        return;
    lanes_ = lanes;
    directions_ = Planes<float>(3, rows * lanes);
    colors_ = Planes<float>(colorSamples, rows * lanes);
    lights_ = Planes<std::int32_t>(1, rows * lanes);
}

MutableVec3Planes LightRows::L(int row) const {
    const int at = row * lanes_;
    return {directions_[0] + at, directions_[1] + at, directions_[2] + at};
}

std::array<float *, colorSamples> LightRows::Cl(int row) const {
    std::array<float *, colorSamples> Cl;
    for (int c = 0; c < colorSamples; ++c)
        Cl[c] = colors_[c] + row * lanes_;
    return Cl;
}

int lanesInNeedOfShadowRays(int count, const LightSamples &samples, float *const *light,
                            int *needed, int *lanes) {
    static_assert(colorSamples == 3);
    markShadowTests(count, light[0], light[1], light[2], samples.light, samples.castsShadow,
                    needed);
    return lanes::compactUnequal(count, needed, 0, lanes);
}

void leaveToLightSampling(const ShaderCode &code, int count, const std::int32_t *light,
                          float *directionPdf) {
    if (code.categories().hearsAllAsIndirect())
        return;
    for (int i = 0; i < count; ++i)
        if (!code.categories().hearsAsIndirect(light[i]))
            directionPdf[i] = 0;
}

} // namespace candela
