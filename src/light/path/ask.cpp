// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/lanes.h"
#include "light/path/stages.h"
#include "light/path/steps.h"
#include "light/vertex/light_samples.h"

#include <algorithm>
#include <optional>

namespace candela {

namespace {

void seeOpacity(PathWave &wave) {
    const PathsAtVertices &paths = wave.chunk.paths;
    const Scene &scene = wave.frame.scene;
    const int count = wave.chunk.count();
    for (int c = 0; c < colorSamples; ++c) {
        float *opacity = wave.results.opacity[c];
        const float *through = scene.hasVolumes() ? paths.cover[c] : paths.throughput[c];
        const float *Oi = wave.chunk.vertices.prepared().Oi[c];
        if (!scene.hasMatte() && slotsAreConsecutive(wave)) { // All of them are seen.
            lanes::multiplyAdd(count, through, Oi, opacity + paths.slot[0]);
            continue;
        }
        for (int i = 0; i < count; ++i)
            if (paths.seen[i] && !(scene.hasMatte() && paths.heldOut[i]))
                opacity[paths.slot[i]] += through[i] * Oi[i];
    }
}

bool wantsAlbedo(const PathWave &wave) {
    return wave.results.channels.planes() > 0 &&
           std::ranges::any_of(wave.frame.firstHit,
                               [](const FirstHitPlane &plane) { return plane.albedo >= 0; });
}

/// Planes of ShaderInput at the points in hand, those too that their shader does not read.
class ToldInputs {
public:
    explicit ToldInputs(PathWave &wave) : wave_(wave) {}

    const float *plane(int input) {
        VertexChunk &chunk = wave_.chunk;
        const Scene &scene = wave_.frame.scene;
        if (scene.tells(chunk.code, input))
            return chunk.vertices.points.input(input);
        thread_local std::optional<ShadingPoints> own;
        if (!own)
            own.emplace(VertexChunk::capacity);
        if (!described_)
            scene.describedPoints(wave_.active.rays, wave_.hits, chunk.rays.data(), chunk.count(),
                                  *own);
        described_ = true;
        return own->input(input);
    }

private:
    PathWave &wave_;
    bool described_ = false;
};

void seeFirstSurface(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const Camera &camera = wave.frame.scene.camera();
    ToldInputs told(wave);
    std::array<const float *, colorSamples> albedo{};
    if (wantsAlbedo(wave))
        albedo = seeAlbedo(wave);
    for (int plane = 0; plane < wave.results.channels.planes(); ++plane) {
        const FirstHitPlane &from = wave.frame.firstHit[plane];
        float *values = wave.results.channels[plane];
        const float *input = from.input >= 0 ? told.plane(from.input) : nullptr;
        for (int i = 0; i < chunk.count(); ++i) {
            if (from.id)
                values[chunk.paths.slot[i]] = float(chunk.vertices.points.id[i]);
            else if (from.depth && camera.moves())
                values[chunk.paths.slot[i]] = camera.depth(
                    {chunk.vertices.P()[0][i], chunk.vertices.P()[1][i], chunk.vertices.P()[2][i]},
                    chunk.vertices.points.input(int(ShaderInput::time))[i]);
            else if (from.albedo >= 0)
                values[chunk.paths.slot[i]] = albedo[from.albedo][i];
            else if (input)
                values[chunk.paths.slot[i]] = input[i];
        }
    }
}

/// Nothing comes back from where a loop was ended, also through what does not need the loop.
void blacken(const float *completed, PathsAtVertices &paths, int count) {
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < count; ++i)
            paths.throughput[c][i] *= completed[i];
}

} // namespace

void ask(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    const Scene &scene = wave.frame.scene;
    chunk.ambient = nullptr;
    if (scene.lights().hasAmbient() && chunk.vertices.code().facts().readsAmbient) {
        std::array<float *, colorSamples> ambient;
        for (int c = 0; c < colorSamples; ++c)
            std::fill_n(ambient[c] = chunk.ambientLight[c], chunk.count(), 0.0f);
        scene.lights().ambient(askingPoints(chunk.vertices), ambient.data());
        chunk.ambient = chunk.ambientTable.data();
    }
    chunk.vertices.prepare(chunk.ambient, chunk.irradiance);
}

static void holdOut(VertexChunk &chunk, const Scene &scene) {
    const ShadingPoints &points = chunk.vertices.points;
    for (int i = 0; i < chunk.count(); ++i)
        chunk.paths.heldOut[i] =
            chunk.paths.seen[i] && scene.isMatte(points.instance[i], points.shape[i]);
}

void see(PathWave &wave) {
    VertexChunk &chunk = wave.chunk;
    if (wave.frame.scene.hasMatte())
        holdOut(chunk, wave.frame.scene);
    if (wave.frame.scene.hasVolumes())
        for (int c = 0; c < colorSamples; ++c)
            lanes::multiplyAdd(chunk.count(), chunk.paths.veil[c], chunk.vertices.prepared().Oi[c],
                               chunk.paths.light[c]);
    if (!lanes::allEqual(chunk.count(), chunk.paths.seen, 0)) {
        seeOpacity(wave);
        if (wave.vertex == 0)
            seeFirstSurface(wave);
    }
    if (const float *completed = chunk.vertices.prepared().completed)
        blacken(completed, chunk.paths, chunk.count());
}

/// As long as no path has ended or been binned apart: at most first vertices.
bool slotsAreConsecutive(const PathWave &wave) {
    const int count = wave.chunk.count(), *slot = wave.chunk.paths.slot;
    return wave.vertex == 0 && slot[count - 1] - slot[0] == count - 1;
}

} // namespace candela
