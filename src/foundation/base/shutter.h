// SPDX-License-Identifier: Apache-2.0
// The interval that rays' times lie in.
#pragma once

namespace candela {

struct Shutter {
    float open = 0, close = 0; ///< Seconds.

    bool hasInterval() const { return close > open; }
    /// How much of the interval has passed, in [0,1]: outside of it, and for no number, its ends.
    float share(float time) const {
        const float passed = (time - open) / (close - open);
        return passed > 0 ? (passed < 1 ? passed : 1.0f) : 0.0f;
    }
};

} // namespace candela
