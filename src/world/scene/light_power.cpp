// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_power.h"

#include "world/scene/light_question.h"
#include "world/scene/source_points.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr int samples = 256;
constexpr float pi = std::numbers::pi_v<float>;

/// Additive recurrences on powers of the plastic number: four well spread dimensions.
float quasiRandom(int i, int dimension) {
    constexpr double steps[] = {0.8566748838545029, 0.733891856627126, 0.6287067210378087,
                                0.5385972572236101};
    double value = 0.5 + (i + 1) * steps[dimension];
    return float(value - std::floor(value));
}

Vec3 onSphere(float a, float b) {
    float z = 1 - 2 * a, r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(2 * pi * b), r * std::sin(2 * pi * b), z};
}

void setPs(LightBatch &batch, int i, Vec3 Ps) {
    for (int c = 0; c < 3; ++c)
        batch.input(ShaderInput::Ps, c)[i] = Ps[c];
}

/// Sum of Cl's color samples at point i.
double totalCl(const LightBatch &batch, int i) {
    double total = 0;
    for (int c = 0; c < colorSamples; ++c)
        total += std::max(0.0f, batch.Cl[c][i]);
    return total;
}

void prepare(LightBatch &batch, const SceneLight &light) {
    batch.count = samples;
    for (int i = 0; i < samples; ++i) {
        placePointLight(batch, i, light);
        batch.parameterOffset[i] = light.shader.parameterOffset;
        batch.objectIndex[i] = 0;
        for (int c = 0; c < 2; ++c)
            batch.input(ShaderInput::lightSample, c)[i] = quasiRandom(i, 2 + c);
    }
}

double distantPower(const SceneState &state, const SceneLight &light) {
    LightBatch batch(samples);
    prepare(batch, light);
    for (int i = 0; i < samples; ++i)
        setPs(batch, i,
              state.centre + onSphere(quasiRandom(i, 0), quasiRandom(i, 1)) * state.radius);
    batch.ask(state, *light.shader.code);
    double sum = 0;
    for (int i = 0; i < samples; ++i)
        sum += totalCl(batch, i);
    return sum / samples * pi * state.radius * state.radius;
}

/// Asks from all around the scene; where the light stands then is where L comes from.
void askFromAround(const SceneState &state, const SceneLight &light, LightBatch &batch) {
    for (int i = 0; i < samples; ++i)
        setPs(batch, i,
              state.centre + onSphere(quasiRandom(i, 0), quasiRandom(i, 1)) * state.radius);
    batch.ask(state, *light.shader.code);
}

Vec3 vec3(float *const *planes, int i) { return {planes[0][i], planes[1][i], planes[2][i]}; }

Vec3 Ps(const LightBatch &batch, int i) {
    return {batch.input(ShaderInput::Ps, 0)[i], batch.input(ShaderInput::Ps, 1)[i],
            batch.input(ShaderInput::Ps, 2)[i]};
}

/// Intensities over the sphere around the light.
double pointPower(const SceneState &state, const SceneLight &light, LightBatch &batch) {
    askFromAround(state, light, batch);
    for (int i = 0; i < samples; ++i) {
        const Vec3 L = vec3(batch.L.data(), i);
        const Vec3 at =
            dot(L, L) > 0 ? Ps(batch, i) - L : transformPoint(light.currentFromShader, {0, 0, 0});
        setPs(batch, i, at + onSphere(quasiRandom(i, 0), quasiRandom(i, 1)) * state.radius);
    }
    batch.ask(state, *light.shader.code);
    double sum = 0;
    for (int i = 0; i < samples; ++i) {
        const Vec3 L = vec3(batch.L.data(), i);
        sum += totalCl(batch, i) * (double(L.x) * L.x + double(L.y) * L.y + double(L.z) * L.z);
    }
    return sum / samples * 4 * pi;
}

std::int32_t codeOf(const SceneState &state, std::int32_t source) {
    const LightElement &element = state.lights.firstElementOf(state.lights.sources[source]);
    return state.points.appearances[state.points.appearanceOf(element.instance, element.shape)]
        .code;
}

/// Points on the light, uniform by area, as shading points of `code`. Where the shapes' codes
/// differ, those of the first one stand for all.
void placeSamples(const SceneState &state, const SceneLight &light, const SurfaceCode &code,
                  ShadingPoints &points) {
    const std::int32_t first = codeOf(state, light.firstSource);
    std::int32_t source[samples];
    float u[samples], v[samples];
    for (int i = 0; i < samples; ++i) {
        double choice = (i + 0.5) / samples;
        source[i] = light.firstSource + chooseByCumulative(light.cumulative, choice);
        if (codeOf(state, source[i]) != first)
            source[i] = light.firstSource;
        u[i] = quasiRandom(i, 0), v[i] = quasiRandom(i, 1);
    }
    ElementRows rows(samples);
    SourcePoints drawn(samples);
    rows.draw(state.lights, samples, source, u);
    placeOnElements(rows, rows.u, v, drawn);
    placePoints(rows, drawn, points);
    for (int c = 0; c < 3; ++c)
        std::fill_n(points.input(ShaderInput::I, c), samples, 0.0f);
    evaluatePoints(state.points, state.camera, code, nullptr, points);
}

/// Points and cosine-distributed directions on both sides; I is set.
void placeViewers(ShadingPoints &points) {
    for (int i = 0; i < points.count; ++i) {
        Vec3 Ng{points.input(int(ShaderInput::Ng))[i], points.input(int(ShaderInput::Ng) + 1)[i],
                points.input(int(ShaderInput::Ng) + 2)[i]};
        // A unit vector added to the normal has the cosine distribution about it.
        Vec3 direction = normalize(Ng) + onSphere(quasiRandom(i, 2), quasiRandom(i, 3));
        direction = normalize(i % 2 ? -direction : direction);
        for (int c = 0; c < 3; ++c)
            points.input(int(ShaderInput::I) + c)[i] = -direction[c];
    }
}

/// Radiant exitance of both sides times area.
double finitePower(const SceneState &state, const SceneLight &light) {
    ShadingPoints points(samples);
    Planes<float> planes(colorSamples, samples);
    float *radiance[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(radiance[c] = planes[c], samples, 0.0f);
    const int code = codeOf(state, light.firstSource);
    placeSamples(state, light, state.points.codes[code], points);
    placeViewers(points);
    state.emission(code, points, radiance);
    double sum = 0;
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < samples; ++i)
            sum += std::max(0.0f, radiance[c][i]);
    return sum / samples * 2 * pi * light.area;
}

/// Classic area lights are told by their shader how to fall off: what arrives at the rim of the
/// scene counts.
void placeClassicArea(const SceneState &state, const SceneLight &light, LightBatch &batch) {
    ShadingPoints points(samples);
    placeSamples(state, light, SurfaceCode{}, points);
    for (ShaderInput input : {ShaderInput::P, ShaderInput::N, ShaderInput::Ng})
        for (int c = 0; c < 3; ++c)
            std::copy_n(points.input(input, c), samples, batch.input(input, c));
}

} // namespace

Box3 placeOf(const SceneState &state, const SceneLight &light) {
    LightBatch batch(samples);
    prepare(batch, light);
    askFromAround(state, light, batch);
    Box3 place;
    for (int i = 0; i < samples; ++i)
        if (const Vec3 L = vec3(batch.L.data(), i); dot(L, L) > 0 && isFinite(Ps(batch, i) - L))
            place.add(Ps(batch, i) - L);
    return place;
}

double estimatePower(const SceneState &state, const SceneLight &light) {
    double power = 0;
    switch (light.kind) {
    case LightKind::None:
    case LightKind::Ambient: return 0;
    case LightKind::Area:
    case LightKind::Emitter: power = finitePower(state, light); break;
    case LightKind::Distant: power = distantPower(state, light); break;
    case LightKind::Point:
    case LightKind::ClassicArea: {
        LightBatch batch(samples);
        prepare(batch, light);
        if (light.kind == LightKind::ClassicArea)
            placeClassicArea(state, light, batch);
        power = pointPower(state, light, batch);
    }
    }
    bool delta = !light.finite();
    if (delta && !light.si)
        power *= pi;
    return std::isfinite(power) && power > 0 ? power : 0;
}

} // namespace candela
