// SPDX-License-Identifier: Apache-2.0
// Integrators are lists of stages; a wave goes through its integrator's list vertex by vertex.
#include "light/path/stages.h"

#include <algorithm>
#include <utility>

namespace candela {

namespace {

/// Paths through stacks of transparent surfaces end here, whatever the depth allows. Each of them
/// is passed but once, so that paths end without it; it bounds the time of those that don't.
constexpr int mostVertices = 1 << 20;

constexpr Stage pathStages[] = {meet,       cross, emit,    ask,    see, seeOutputParameters,
                                stateLobes, light, scatter, deliver};
constexpr Stage gatheringStages[] = {
    meet,   cross, emit, ask, see, lightGathered, seeOutputParameters, scatterBesidesFiniteLobes,
    deliver};
constexpr Stage classicStages[] = {
    meet, cross, emit, ask, see, lightClassic, seeOutputParameters, branch, deliver};

/// Of scenes that have been solved. Shaders that are not affine gather light by paths, which end on
/// the solution, whatever the final pass.
constexpr Stage elementStages[] = {meet,
                                   cross,
                                   emit,
                                   lookUpSolution,
                                   ask,
                                   see,
                                   seeOutputParameters,
                                   stateLobes,
                                   takeSolution,
                                   scatterBesidesFiniteLobes,
                                   deliver};
constexpr Stage solvedStages[] = {
    meet,       cross, emit,         lookUpSolution, ask,    see, seeOutputParameters,
    stateLobes, light, takeSolution, scatter,        deliver};

void shadeBin(PathWave &wave, int bin) {
    std::span<const int> rays = wave.bins.rays(bin);
    if (rays.empty())
        return;
    const int code = wave.frame.scene.codeOfBin(bin);
    const std::span<const Stage> stages = wave.stages(wave, wave.frame.scene.code(code));
    while (!rays.empty()) {
        const int count = std::min<int>(VertexChunk::capacity, int(rays.size()));
        wave.chunk.code = code, wave.chunk.rays = rays.first(count);
        for (Stage stage : stages)
            stage(wave);
        rays = rays.subspan(count);
    }
}

/// The paths that go on become the active ones; where there are none, some that wait.
void advance(PathWave &wave) {
    std::swap(wave.active, wave.next);
    ++wave.vertex;
    if (wave.active.count == 0 && !wave.waiting.empty()) {
        wave.vertex = wave.waiting.back().vertex;
        std::swap(wave.active, wave.waiting.back().paths);
        wave.spare.push_back(std::move(wave.waiting.back().paths));
        wave.waiting.pop_back();
    }
    wave.next.count = wave.next.rays.count = 0;
    wave.active.rays.shares = wave.next.rays.shares = nullptr;
    wave.frame.statistics.bounceRays += wave.active.count;
}

} // namespace

std::span<const Stage> stagesOfIntegrator(const PathWave &wave, const ShaderCode &code) {
    if (wave.frame.settings.kind == IntegratorKind::Classic)
        return classicStages;
    if (wave.solution && code.facts().affine)
        return wave.frame.settings.finalPass == FinalPass::Elements &&
                       wave.purpose == Purpose::Camera
                   ? std::span<const Stage>(elementStages)
                   : solvedStages;
    return code.facts().affine ? std::span<const Stage>(pathStages) : gatheringStages;
}

void follow(PathWave &wave, int vertex) {
    for (wave.vertex = vertex; wave.active.count > 0; advance(wave)) {
        if (wave.vertex >= mostVertices) {
            wave.active.count = 0;
            continue;
        }
        trace(wave);
        escape(wave);
        bin(wave);
        for (int bin = 0; bin < wave.bins.count(); ++bin)
            shadeBin(wave, bin);
        wave.next.rays.count = wave.next.count;
    }
}

} // namespace candela
