// SPDX-License-Identifier: Apache-2.0
#include "light/path/stages.h"

namespace candela {

void trace(PathWave &wave) {
    const bool fromCamera = wave.vertex == 0 && wave.purpose == Purpose::Camera;
    wave.active.rays.fromLights = wave.purpose == Purpose::Light;
    wave.frame.scene.intersect(wave.active.rays, wave.hits,
                               fromCamera ? Coherence::Primary : Coherence::Secondary);
}

void bin(PathWave &wave) { wave.bins.sort(wave.active.count, wave.hits); }

} // namespace candela
