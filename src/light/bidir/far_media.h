// SPDX-License-Identifier: Apache-2.0
// What rays between two surfaces lie in (ShadowMedia), as the eye's end has it.
#pragma once

#include "world/scene/scene.h"

namespace candela {

class FarMedia {
public:
    explicit FarMedia(int capacity) : around_(2, capacity), atmosphere_(1, capacity) {}

    /// Ray k begins in these and ends at that surface.
    void set(int k, const MediaAround &around, const SurfaceMedia &end) {
        around_[0][k] = around.inner(), around_[1][k] = around.outer();
        atmosphere_[0][k] = end.atmosphere;
    }
    ShadowMedia media(bool fromOrigins) const {
        return {around_[0], around_[1], atmosphere_[0], fromOrigins};
    }

private:
    Planes<std::uint32_t> around_;
    Planes<std::int32_t> atmosphere_;
};

} // namespace candela
