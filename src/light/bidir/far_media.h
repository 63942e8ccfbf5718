// SPDX-License-Identifier: Apache-2.0
// What rays between two surfaces lie in (ShadowMedia), as the eye's end has it.
#pragma once

#include "world/scene/scene.h"

namespace candela {

class FarMedia {
public:
    explicit FarMedia(int capacity) : around_(2, capacity), end_(2, capacity) {}

    /// Ray k begins in these and ends at a surface that it meets from the inside or not.
    void set(int k, const MediaAround &around, const SurfaceMedia &end, bool fromInside) {
        around_[0][k] = around.inner(), around_[1][k] = around.outer();
        end_[0][k] = end.atmosphere, end_[1][k] = fromInside ? end.interior : 0;
    }
    ShadowMedia media(bool fromOrigins) const {
        return {around_[0], around_[1], end_[0], end_[1], fromOrigins};
    }

private:
    Planes<std::uint32_t> around_;
    Planes<std::int32_t> end_;
};

} // namespace candela
