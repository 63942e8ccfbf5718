// SPDX-License-Identifier: Apache-2.0
#include "light/path/stages.h"

namespace candela {

/// Of what kind the rays are, where that matters.
static const std::uint8_t *kindsOf(PathWave &wave) {
    if (!wave.frame.scene.hidesShapes())
        return nullptr;
    const ActivePaths &active = wave.active;
    std::vector<std::uint8_t> &kinds = wave.rayKinds;
    kinds.resize(std::size_t(active.count));
    for (int i = 0; i < active.count; ++i)
        kinds[std::size_t(i)] = active.seen[i]           ? ray_kind::camera
                                : active.left.pdf[i] > 0 ? ray_kind::diffuse
                                                         : ray_kind::specular;
    return kinds.data();
}

void trace(PathWave &wave) {
    const bool fromCamera = wave.vertex == 0 && wave.purpose == Purpose::Camera;
    wave.active.rays.kinds = kindsOf(wave);
    wave.active.rays.fromLights = wave.purpose == Purpose::Light;
    wave.frame.scene.intersect(wave.active.rays, wave.hits,
                               fromCamera ? Coherence::Primary : Coherence::Secondary);
}

void bin(PathWave &wave) { wave.bins.sort(wave.active.count, wave.hits); }

} // namespace candela
