// SPDX-License-Identifier: Apache-2.0
// What surfaces send of themselves: the one function behind hits on lights and light sampling.
#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <optional>

namespace candela {

namespace {

void addSurfaceEmission(const SceneState &state, int code, ShadingPoints &points,
                        float *const *radiance) {
    const QuestionCode &question = state.points.codes[code].code->question(ir::Question::Emit);
    int Ce = question.output(ir::OutputKind::Ce);
    if (!question.code || Ce < 0)
        return;
    thread_local Scratch<float> storage;
    int stride = paddedLanes(points.count);
    std::size_t slots = question.function.outputs.size();
    // One plane of slack for alignment: planes start on 64 bytes.
    float *values = storage.get((slots + 1) * stride + laneBlock);
    values += (64 - reinterpret_cast<std::uintptr_t>(values) % 64) % 64 / sizeof(float);
    std::fill_n(values, slots * stride, 0.0f);
    thread_local std::vector<float *> outputs;
    outputs.resize(slots);
    for (std::size_t slot = 0; slot < slots; ++slot)
        outputs[slot] = values + slot * stride;
    ShaderArgs args;
    bindPoints(state.points, code, points, args);
    args.outputs = outputs.data();
    question.code(&args);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < points.count; ++i)
            radiance[c][i] += outputs[Ce + c][i];
}

/// Adds what the light shader `code` of area lights sends from those points that are on them.
void addLightEmission(const SceneState &state, const ShaderCode &code, ShadingPoints &points,
                      LightBatch &batch, int first, float *const *radiance) {
    int count = batch.count;
    std::uint16_t active[lightBatchSize / laneBlock] = {};
    for (int i = 0; i < count; ++i) {
        std::int32_t light = points.light[first + i];
        bool mine = light > 0 && state.lights.lights[light - 1].kind == LightKind::Area &&
                    state.lights.lights[light - 1].shader.code.get() == &code;
        if (mine)
            active[i / laneBlock] |= std::uint16_t(1u << i % laneBlock);
        batch.parameterOffset[i] = mine ? state.lights.lights[light - 1].shader.parameterOffset : 0;
        batch.objectIndex[i] = points.objectIndex[first + i];
    }
    float *planes[int(ShaderInput::Count)];
    for (int plane = 0; plane < int(ShaderInput::Count); ++plane)
        planes[plane] = points.inputTable[plane] + first;
    batch.readFrom(ShaderInput::P, int(ShaderInput::Count), planes);
    float *Ps[3];
    for (int c = 0; c < 3; ++c) {
        Ps[c] = batch.input(ShaderInput::Ps, c);
        subtract(count, planes[int(ShaderInput::P) + c], planes[int(ShaderInput::I) + c], Ps[c]);
    }
    batch.readFrom(ShaderInput::Ps, 3, Ps);
    batch.hasSurface = true;
    batch.ask(state, code, active);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            if (active[i / laneBlock] >> i % laneBlock & 1)
                radiance[c][first + i] += batch.Cl[c][i];
}

} // namespace

void SceneState::emission(int code, ShadingPoints &points, float *const *radiance,
                          bool prints) const {
    if (points.count == 0)
        return;
    if (this->points.codes[code].code->facts().emits)
        addSurfaceEmission(*this, code, points, radiance);
    if (areaLightCodes.empty())
        return;
    thread_local std::optional<LightBatch> batch;
    if (!batch)
        batch.emplace(lightBatchSize);
    batch->prints = prints;
    for (int first = 0; first < points.count; first += lightBatchSize) {
        batch->count = std::min(lightBatchSize, points.count - first);
        const std::int32_t *light = points.light + first;
        if (std::all_of(light, light + batch->count, [](std::int32_t l) { return l == 0; }))
            continue;
        for (const ShaderCode *lightCode : areaLightCodes)
            addLightEmission(*this, *lightCode, points, *batch, first, radiance);
    }
}

std::span<const LightGroup> Lights::groupsInUse() const { return state_->lights.groups; }
bool Lights::hasAmbient() const { return !state_->lights.ambient.empty(); }
bool Lights::readsChoice() const { return !state_->lights.isSingle; }
int Lights::count() const { return int(state_->lights.lights.size()); }
std::uint64_t Lights::nonFiniteSamples() const { return state_->nonFiniteLight; }
bool Lights::isOn(std::int32_t lightSet, std::int32_t light) const {
    return state_->lights.on(lightSet, light);
}
bool Lights::castsShadow(std::int32_t light) const {
    return state_->lights.lights[light - 1].castsShadow;
}
std::int32_t Lights::setOfAll() const { return state_->lights.setOfAll; }
bool Lights::areLeftToSamples() const { return state_->lights.leftToSamples; }

void Lights::emission(int code, ShadingPoints &points, float *const *radiance) const {
    state_->emission(code, points, radiance);
}

void Lights::ambient(const LightQuery &query, float *const *ambient) const {
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(ambient[c], query.count, 0.0f);
    thread_local std::optional<LightBatch> batch;
    if (!batch)
        batch.emplace(lightBatchSize);
    for (int index : state_->lights.ambient)
        for (int first = 0; first < query.count; first += lightBatchSize) {
            const SceneLight &light = state_->lights.lights[index];
            batch->count = std::min(lightBatchSize, query.count - first);
            const auto from = [first](const float *plane) { return plane ? plane + first : plane; };
            for (int c = 0; c < 3; ++c) {
                std::copy_n(from(query.Ps[c]), batch->count, batch->input(ShaderInput::Ps, c));
                batch->Ns[c] = from(query.Ns[c]), batch->I[c] = from(query.I[c]);
            }
            for (int i = 0; i < batch->count; ++i) {
                placePointLight(*batch, i, light, state_->points.shutter);
                batch->parameterOffset[i] = light.shader.parameterOffset;
            }
            batch->ask(*state_, *light.shader.code);
            for (int i = 0; i < batch->count; ++i)
                if (isOn(query.lightSet[first + i], index + 1))
                    for (int c = 0; c < colorSamples; ++c)
                        ambient[c][first + i] += batch->Cl[c][i];
        }
}

} // namespace candela
