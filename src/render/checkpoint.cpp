// SPDX-License-Identifier: Apache-2.0
#include "render/checkpoint.h"

#include "foundation/base/raw_bytes.h"
#include "foundation/base/sealed_bytes.h"

#include <utility>

namespace candela {

namespace {

constexpr std::string_view mark = "candela checkpoint 2\n";

void put(std::string &bytes, const FramePosition &position) {
    appendRaw(bytes, position.firstSample);
    appendRaw(bytes, position.hasLightPaths);
    appendList(bytes, position.tilesTaken);
    appendList(bytes, position.wishes);
}

bool take(std::string_view &bytes, FramePosition &position) {
    return takeRaw(bytes, position.firstSample) && takeRaw(bytes, position.hasLightPaths) &&
           takeList(bytes, position.tilesTaken) && takeList(bytes, position.wishes);
}

bool take(std::string_view &bytes, Checkpoint &checkpoint) {
    if (!takeRaw(bytes, checkpoint.frame) || !takeRaw(bytes, checkpoint.isDone) ||
        !takeIdentity(bytes, checkpoint.identity) || !take(bytes, checkpoint.position))
        return false;
    checkpoint.samples = bytes;
    return true;
}

} // namespace

std::string encodeCheckpoint(const Checkpoint &checkpoint, const ResumableSink *sink) {
    std::string body;
    appendRaw(body, checkpoint.frame);
    appendRaw(body, checkpoint.isDone);
    appendIdentity(body, checkpoint.identity);
    put(body, checkpoint.position);
    if (sink)
        sink->save(body);
    return sealed(mark, std::move(body));
}

std::optional<Checkpoint> decodeCheckpoint(std::string_view bytes, std::string &problem) {
    auto body = unsealed(mark, "checkpoint", bytes, problem);
    Checkpoint checkpoint;
    if (body && take(*body, checkpoint))
        return checkpoint;
    if (body)
        problem = "it is damaged";
    return std::nullopt;
}

} // namespace candela
