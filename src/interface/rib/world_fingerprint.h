// SPDX-License-Identifier: Apache-2.0
// Hands all requests on, and makes a fingerprint of each world by itself: equal for worlds that
// hold the same bodies and lights, wherever the camera stands and whatever picture is made of them.
#pragma once

#include "interface/ri/forwarding_sink.h"

#include <memory>
#include <string>

namespace candela {

class WorldFingerprint final : public ForwardingSink {
public:
    /// It must outlive this one.
    explicit WorldFingerprint(RequestSink &sink);
    ~WorldFingerprint() override;

#define TAKEN(Name, handler, scopes, ...)                                                          \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST(...) TAKEN(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) TAKEN(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    TAKEN(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef TAKEN

    /// Of the world that is open, or was last.
    std::string text();

private:
    class Hash;
    /// Where the request is written to; null if it says nothing of the world.
    Hash *hashFor(RequestId);

    /// What stands outside of frames, in the frame and in the world; transformations outside of the
    /// world, which move the camera, apart: they count where they move lights, too.
    std::unique_ptr<Hash> file_, fileCamera_, frame_, frameCamera_, world_;
    bool inFrame_ = false, inWorld_ = false, movesLights_ = false;
};

} // namespace candela
