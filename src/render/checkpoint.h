// SPDX-License-Identifier: Apache-2.0
// A render on its way, as a file: after any end of the program it goes on from there and gives the
// bytes that it would have given.
#pragma once

#include "image/resumable_sink.h"
#include "light/frame/frame_progress.h"
#include "render/frame_identity.h"

#include <optional>
#include <string>
#include <string_view>

namespace candela {

struct Checkpoint {
    int frame = 0;       ///< The worlds before it have been rendered.
    bool isDone = false; ///< This one has, too: there is neither position nor samples.
    FrameIdentity identity;
    FramePosition position;
    std::string samples; ///< What the sink has saved.
};

/// The bytes of the file, with what the sink holds (null = nothing) in place of `samples`. They are
/// of use to machines of the same byte order.
std::string encodeCheckpoint(const Checkpoint &, const ResumableSink *);

/// Nothing, and `problem`, if the bytes are not those of a whole checkpoint.
std::optional<Checkpoint> decodeCheckpoint(std::string_view bytes, std::string &problem);

} // namespace candela
