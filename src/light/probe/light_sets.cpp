// SPDX-License-Identifier: Apache-2.0
#include "light/probe/light_sets.h"

#include "foundation/base/parallel.h"
#include "light/bidir/light_wave.h"
#include "light/bidir/no_picture.h"
#include "light/bidir/plan.h"
#include "light/path/stages.h"

#include <algorithm>
#include <atomic>
#include <memory>

namespace candela {

namespace {

/// Of a set: waves, and half of what each holds, so that branches find room.
constexpr int wavesOfSet = 2, pathsOfWave = PathWave::capacity / 2;

/// The vertices of waves [first, first + waves), which depend on their numbers alone.
std::vector<std::vector<LightVertex>>
followWaves(FrameContext &frame, const TechniqueCounts &counts, int first, int waves) {
    std::vector<std::vector<LightVertex>> kept(static_cast<std::size_t>(waves));
    std::atomic<int> next{0};
    parallelFor(std::size_t(std::clamp(threadCount(), 1, waves)), [&](std::size_t) {
        NoPicture nothing;
        LightWave wave(frame, counts, nothing);
        for (int at; (at = next++) < waves;) {
            startLight(wave, std::int64_t(first + at) * pathsOfWave, pathsOfWave);
            follow(wave);
            kept[std::size_t(at)] = std::move(wave.kept);
        }
    });
    return kept;
}

} // namespace

LightSets::LightSets(FrameContext &frame, int sets) {
    if (!lightsMayBeginPaths(frame))
        return;
    const int waves = sets * wavesOfSet;
    // A pilot, for how many vertices a path has.
    const std::size_t found = followWaves(frame, {0, 1}, waves, 1).front().size();
    if (found == 0)
        return;
    counts_.connections = connections * double(pathsOfWave) / double(found);
    const auto kept = followWaves(frame, counts_, 0, waves);
    sets_.resize(std::size_t(sets));
    for (int wave = 0; wave < waves; ++wave) {
        LightVertices &set = sets_[std::size_t(wave / wavesOfSet)];
        const std::vector<LightVertex> &rows = kept[std::size_t(wave)];
        set.rows.insert(set.rows.end(), rows.begin(), rows.end());
        set.paths += pathsOfWave;
    }
}

} // namespace candela
