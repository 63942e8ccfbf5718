// SPDX-License-Identifier: Apache-2.0
#include "world/scene/skies.h"

#include "foundation/base/scratch.h"
#include "world/scene/light_choices.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"
#include "world/scene/stated_cones.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace candela {

namespace {

/// Directions that are drawn again to see that they come back.
constexpr int trials = 64;
/// Of a direction that comes back, what may be off, of the sine of the widest angle between two of
/// its cone: the shader computes with floats.
constexpr double tolerance = 4e-3;

/// Asks `light` alone; lanes need P's place and what drives the directions.
void setLanes(const SceneState &state, const SceneLight &light, int count, LightBatch &batch) {
    batch.count = count;
    batch.hasSurface = false;
    batch.Ns = batch.I = {};
    for (int i = 0; i < count; ++i) {
        placePointLight(batch, i, light, state.points.shutter);
        batch.parameterOffset[i] = light.shader.parameterOffset;
        batch.objectIndex[i] = 0;
    }
}

Vec3 directionOf(const LightBatch &batch, int i) {
    return normalize(Vec3{batch.L[0][i], batch.L[1][i], batch.L[2][i]});
}

/// What the shader draws for numbers all over the square is drawn again, for other points, by the
/// numbers that the direction tells.
bool drawsAsStated(const SceneState &state, const SceneLight &light, const SkyCones &cones) {
    LightBatch batch(trials);
    batch.prints = false;
    setLanes(state, light, trials, batch);
    const auto askFrom = [&](Vec3 Ps) {
        for (int i = 0; i < trials; ++i)
            for (int c = 0; c < 3; ++c)
                batch.input(ShaderInput::Ps, c)[i] = Ps[c];
        batch.ask(state, *light.shader.code);
    };
    float *const x = batch.input(ShaderInput::lightSample, 0), *const y = batch.input(
                                                                   ShaderInput::lightSample, 1);
    for (int i = 0; i < trials; ++i)
        x[i] = (float(i) + 0.5f) / trials, y[i] = std::fmod((float(i) + 0.5f) * 0.618034f, 1.0f);
    askFrom(state.centre);
    std::vector<Vec3> drawn;
    std::vector<double> mayBeOff;
    for (int i = 0; i < trials; ++i) {
        const Vec3 direction = directionOf(batch, i);
        const double density = cones.pdfOfDrawn(x[i], direction);
        if (!isFinite(direction) || !std::isfinite(density))
            return false;
        drawn.push_back(direction);
        // Half as wide as what the density says.
        mayBeOff.push_back(density > 0 ? tolerance * std::min(1.0, 1 / std::sqrt(density)) : 0);
        if (density > 0) {
            if (!(cones.pdf(direction) > 0))
                return false;
            const auto [again, turn] = cones.numbersFor(direction);
            x[i] = again, y[i] = turn;
        }
    }
    askFrom(state.centre + Vec3{state.radius, 0, 0});
    for (int i = 0; i < trials; ++i)
        if (mayBeOff[i] > 0 && !(length(directionOf(batch, i) - drawn[i]) < mayBeOff[i]))
            return false;
    return true;
}

std::optional<SkyCones> skyOf(const SceneState &state, const SceneLight &light) {
    if (light.kind != LightKind::Distant || !light.si || !light.steps.empty() ||
        light.parametersChange || readsWhatIsLit(*light.shader.code, false))
        return std::nullopt;
    const std::optional<StatedCones> stated = statedCones(state, light);
    if (!stated)
        return std::nullopt;
    const SkyCones cones(stated->cones);
    if (!cones.isWide() || !drawsAsStated(state, light, cones))
        return std::nullopt;
    return cones;
}

} // namespace

void findSkies(SceneState &state) {
    std::vector<SceneLight> &lights = state.lights.lights;
    for (int k = 0; k < int(lights.size()); ++k)
        if ((lights[k].sky = skyOf(state, lights[k])))
            state.lights.skies.push_back(k + 1);
}

std::span<const std::int32_t> Lights::skies() const { return state_->lights.skies; }

void Lights::sky(std::int32_t number, const LightQuery &query,
                 const std::array<const float *, 3> &direction, const SkyAnswer &out) const {
    const SceneLight &light = state_->lights.lights[number - 1];
    const int count = query.count;
    thread_local Scratch<std::int32_t> sources;
    thread_local std::optional<LightBatch> batch;
    if (!batch)
        batch.emplace(lightBatchSize);
    std::int32_t *source = sources.get(count);
    std::fill_n(source, count, light.firstSource);
    sourceProbabilities(*state_, query, source, out.probability);
    setLanes(*state_, light, count, *batch);
    for (int i = 0; i < count; ++i) {
        const Vec3 L{-direction[0][i], -direction[1][i], -direction[2][i]};
        out.directionPdf[i] = float(light.sky->pdf(L));
        const std::array<float, 2> numbers = light.sky->numbersFor(L);
        for (int c = 0; c < 2; ++c)
            batch->input(ShaderInput::lightSample, c)[i] = numbers[std::size_t(c)];
        for (int c = 0; c < 3; ++c)
            batch->input(ShaderInput::Ps, c)[i] = query.Ps[c][i];
        batch->input(ShaderInput::time)[i] = query.time[i];
    }
    batch->ask(*state_, *light.shader.code);
    for (int i = 0; i < count; ++i) {
        const float density = out.directionPdf[i];
        bool isFinite = true;
        for (int c = 0; c < colorSamples; ++c)
            isFinite &= bool(std::isfinite(batch->Cl[c][i]));
        const bool shines = density > 0 && isFinite && isOn(query.lightSet[i], number);
        for (int c = 0; c < colorSamples; ++c)
            out.radiance[c][i] = shines ? batch->Cl[c][i] * density : 0.0f;
        if (density > 0 && !isFinite)
            ++state_->nonFiniteLight;
    }
}

} // namespace candela
