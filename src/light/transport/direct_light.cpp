// SPDX-License-Identifier: Apache-2.0
#include "light/transport/direct_light.h"

#include "foundation/base/hot.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

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

/// What Cl is worth a unit of `value`: L_i / (pi pdf), weighted against the chance of finding
/// the same direction through the mixture; delta lights come as they are.
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

CANDELA_HOT void multiplyThree(int count, const float *__restrict g, const float *__restrict value,
                               const float *__restrict weight, float *__restrict result) {
    for (int i = 0; i < count; ++i)
        result[i] = weight[i] > 0 ? g[i] * value[i] * weight[i] : 0.0f;
}

} // namespace

void ShadowRays::add(SurfaceVertices &vertices, int i, Vec3 L, float tMax) {
    int at = rays.count++;
    ConstVec3Planes P = vertices.P();
    Vec3 origin = Scene::offsetOrigin({P[0][i], P[1][i], P[2][i]}, vertices.facing(i), L,
                                      vertices.points.offset[i]);
    // Towards the same end from there: the offset must not carry the ray into the light.
    Vec3 direction = L;
    if (std::isfinite(tMax))
        direction = Vec3{P[0][i], P[1][i], P[2][i]} + L - origin;
    rays.originX[at] = origin.x, rays.originY[at] = origin.y, rays.originZ[at] = origin.z;
    rays.directionX[at] = direction.x, rays.directionY[at] = direction.y;
    rays.directionZ[at] = direction.z;
    rays.tMax[at] = tMax;
    rays.time[at] = vertices.points.input(int(ShaderInput::time))[i];
    lane[0][at] = i;
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
      g_(colorSamples, capacity), answered_(1, capacity) {
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
        multiplyThree(count, g[c], light.value[c], weight, contribution[c]);

    shadow_.rays.count = 0;
    for (int i = 0; i < count; ++i) {
        float brightest = 0;
        for (int c = 0; c < colorSamples; ++c)
            brightest = std::max(brightest, std::fabs(contribution[c][i]));
        if (brightest > 0 && light.light[i] > 0 && light.castsShadow[i])
            shadow_.add(vertices, i, {L[0][i], L[1][i], L[2][i]},
                        std::isinf(light.distance[i]) ? INFINITY : shadowRayEnd);
        else if (light.light[i] == 0)
            for (int c = 0; c < colorSamples; ++c)
                contribution[c][i] = 0;
    }
    vertices.scene().transmittance(shadow_.rays, shadow_.transmittancePlanes.data());
    for (int ray = 0; ray < shadow_.rays.count; ++ray)
        for (int c = 0; c < colorSamples; ++c)
            contribution[c][shadow_.lane[0][ray]] *= shadow_.transmittance[c][ray];
    return shadow_.rays.count;
}

} // namespace candela
