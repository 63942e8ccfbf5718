// SPDX-License-Identifier: Apache-2.0
// A fingerprint of each world by itself: equal for worlds that hold the same bodies and lights,
// wherever the camera stands and whatever picture is made of them.
#pragma once

#include "interface/rib/fingerprint_sink.h"

#include <optional>
#include <string>

namespace candela {

class WorldFingerprint final : public FingerprintSink {
public:
    using FingerprintSink::FingerprintSink;

    /// Of the world that is open, or was last.
    std::string text();

private:
    /// None for a request that says nothing of the world.
    RequestHash *hashFor(RequestId) override;

    /// What stands outside of frames, in the frame and in the world; transformations outside of the
    /// world, which move the camera, apart: they count where they move lights, too.
    RequestHash file_, fileCamera_;
    std::optional<RequestHash> frame_{std::in_place}, frameCamera_{std::in_place},
        world_{std::in_place};
    bool inFrame_ = false, inWorld_ = false, movesLights_ = false;
};

} // namespace candela
