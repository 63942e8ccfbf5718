// SPDX-License-Identifier: Apache-2.0
#include "light/transport/direct_light.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

CANDELA_HOT void multiplyThree(int count, const float *__restrict g, const float *__restrict value,
                               const float *__restrict weight, const std::int32_t *__restrict light,
                               float *__restrict result) {
    for (int i = 0; i < count; ++i)
        result[i] = (weight[i] > 0) & (light[i] != 0) ? g[i] * value[i] * weight[i] : 0.0f;
}

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

/// A component of the way from the shifted origin to the same end as L from P: the receiver's
/// offset must not carry the ray's end into the light. Distant light is away from everywhere.
CANDELA_HOT void towardsLight(int count, const float *__restrict P, const float *__restrict origin,
                              const float *__restrict L, const float *__restrict distance,
                              float *__restrict direction, float *__restrict end) {
    for (int i = 0; i < count; ++i) {
        bool distant = distance[i] == INFINITY;
        direction[i] = distant ? L[i] : L[i] + (P[i] - origin[i]);
        end[i] = distant ? INFINITY : shadowRayEnd;
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

CANDELA_HOT void lightWeights(int count, const float *__restrict lightPdf,
                              const float *__restrict mixturePdf,
                              const float *__restrict finiteProbability,
                              const float *__restrict wanted, float *__restrict weight) {
    for (int i = 0; i < count; ++i) {
        float pl = lightPdf[i], pm = mixturePdf[i] * finiteProbability[i];
        float heuristic = pl / (pl * pl + pm * pm) * (1 / pi); // (pl^2/(pl^2+pm^2)) / (pi pl)
        weight[i] = wanted[i] > 0 ? (pl > 0 ? heuristic : 1.0f) : 0.0f;
    }
}

ShadowRays::ShadowRays(int capacity)
    : rays_(capacity), planes_(5, capacity), transmittance_(colorSamples, capacity) {}

int ShadowRays::attenuate(SurfaceVertices &vertices, const LightSamples &samples, int count,
                          const int *lanes, float *const *light) {
    const int all = vertices.count();
    ConstVec3Planes L{samples.L[0], samples.L[1], samples.L[2]}, P = vertices.P();
    MutableVec3Planes origin{planes_[0], planes_[1], planes_[2]};
    float *direction = planes_[3], *end = planes_[4];
    vertices.rayOrigins(L, origin);
    rays_.count = count;
    float *origins[3] = {rays_.origin[0], rays_.origin[1], rays_.origin[2]};
    float *directions[3] = {rays_.direction[0], rays_.direction[1], rays_.direction[2]};
    for (int c = 0; c < 3; ++c) {
        towardsLight(all, P[c], origin[c], L[c], samples.distance, direction, end);
        lanes::take(count, lanes, origin[c], origins[c]);
        lanes::take(count, lanes, direction, directions[c]);
    }
    std::fill_n(rays_.tMin, count, 0.0f);
    lanes::take(count, lanes, end, rays_.tMax);
    lanes::take(count, lanes, vertices.points.input(int(ShaderInput::time)), rays_.time);

    std::array<float *, colorSamples> transmittance;
    for (int c = 0; c < colorSamples; ++c)
        transmittance[c] = transmittance_[c];
    const bool colored = vertices.scene().transmittance(rays_, transmittance.data());
    float *factor = planes_[3];
    std::fill_n(factor, all, 1.0f);
    for (int c = 0; c < colorSamples; ++c) {
        if (c == 0 || colored)
            for (int ray = 0; ray < count; ++ray)
                factor[lanes[ray]] = transmittance[c][ray];
        lanes::multiply(all, factor, light[c]);
    }
    return count;
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

DirectLight::DirectLight(int capacity)
    : light_(capacity), shadow_(capacity), unit_(3, capacity), pdf_(2, capacity),
      g_(colorSamples, capacity), answered_(1, capacity), lanes_(2, capacity) {
    std::fill_n(answered_[0], answered_.lanes(), finiteRequests);
}

int DirectLight::gather(SurfaceVertices &vertices, ConeMixture &mixture,
                        const float *finiteProbability, const float *wanted, const float *choice,
                        const float *u, const float *v, float *const *contribution) {
    const int count = vertices.count();
    LightQuery query;
    query.count = count;
    query.P = vertices.P();
    query.lightSet = vertices.points.lightSet;
    query.time = vertices.points.input(int(ShaderInput::time));
    query.choice = choice;
    query.position = {u, v};
    LightSamples &light = light_.samples;
    vertices.scene().sampleLights(query, light);

    ConstVec3Planes L{light.L[0], light.L[1], light.L[2]};
    unitDirections(count, L[0], L[1], L[2], unit_[0], unit_[1], unit_[2]);
    mixture.pdf({unit_[0], unit_[1], unit_[2]}, pdf_[0]);
    std::array<float *, colorSamples> g;
    for (int c = 0; c < colorSamples; ++c)
        g[c] = g_[c];
    vertices.scatter(L, answered_[0], light.light, g.data());

    float *weight = pdf_[1];
    lightWeights(count, light.pdfSolidAngle, pdf_[0], finiteProbability, wanted, weight);
    for (int c = 0; c < colorSamples; ++c)
        multiplyThree(count, g[c], light.value[c], weight, light.light, contribution[c]);

    int *inShadowTest = lanes_[0], *lane = lanes_[1];
    static_assert(colorSamples == 3);
    markShadowTests(count, contribution[0], contribution[1], contribution[2], light.light,
                    light.castsShadow, inShadowTest);
    int rays = lanes::compactUnequal(count, inShadowTest, 0, lane);
    return shadow_.attenuate(vertices, light, rays, lane, contribution);
}

} // namespace candela
