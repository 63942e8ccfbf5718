// SPDX-License-Identifier: Apache-2.0
// Mark, hash of all that follows, then numbers and texts one after the other.
#include "render/checkpoint.h"

#include "foundation/base/hash.h"
#include "foundation/base/raw_bytes.h"

#include <algorithm>

namespace candela {

namespace {

constexpr std::string_view mark = "candela checkpoint 1\n";
constexpr std::size_t hashSize = 32;

std::string hashOf(std::string_view bytes) {
    ContentHash hash;
    hash.add(bytes);
    return hash.text();
}

void put(std::string &bytes, const std::string &text) {
    appendRaw(bytes, std::uint64_t(text.size()));
    bytes += text;
}

bool take(std::string_view &bytes, std::string &text) {
    std::uint64_t size = 0;
    if (!takeRaw(bytes, size) || size > bytes.size())
        return false;
    text = bytes.substr(0, size);
    bytes.remove_prefix(size);
    return true;
}

void put(std::string &bytes, const FramePosition &position) {
    appendRaw(bytes, position.firstSample);
    appendRaw(bytes, position.hasLightPaths);
    appendRaw(bytes, std::uint64_t(position.tilesTaken.size()));
    appendRaw(bytes, std::span(position.tilesTaken));
}

bool take(std::string_view &bytes, FramePosition &position) {
    std::uint64_t tiles = 0;
    if (!takeRaw(bytes, position.firstSample) || !takeRaw(bytes, position.hasLightPaths) ||
        !takeRaw(bytes, tiles) || tiles > bytes.size())
        return false;
    position.tilesTaken.resize(tiles);
    return takeRaw(bytes, std::span(position.tilesTaken));
}

bool take(std::string_view &bytes, Checkpoint &checkpoint) {
    std::uint64_t facts = 0;
    if (!takeRaw(bytes, checkpoint.frame) || !takeRaw(bytes, checkpoint.isDone) ||
        !takeRaw(bytes, facts))
        return false;
    for (; facts > 0; --facts) {
        auto &[name, value] = checkpoint.identity.emplace_back();
        if (!take(bytes, name) || !take(bytes, value))
            return false;
    }
    if (!take(bytes, checkpoint.position))
        return false;
    checkpoint.samples = bytes;
    return true;
}

} // namespace

std::string encodeCheckpoint(const Checkpoint &checkpoint, const ResumableSink *sink) {
    std::string bytes(mark);
    bytes.append(hashSize, ' ');
    appendRaw(bytes, checkpoint.frame);
    appendRaw(bytes, checkpoint.isDone);
    appendRaw(bytes, std::uint64_t(checkpoint.identity.size()));
    for (const auto &[name, value] : checkpoint.identity)
        put(bytes, name), put(bytes, value);
    put(bytes, checkpoint.position);
    if (sink)
        sink->save(bytes);
    const std::size_t start = mark.size() + hashSize;
    bytes.replace(mark.size(), hashSize, hashOf(std::string_view(bytes).substr(start)));
    return bytes;
}

std::optional<Checkpoint> decodeCheckpoint(std::string_view bytes, std::string &problem) {
    if (!bytes.starts_with(mark)) {
        problem = "it is no checkpoint of this version";
        return std::nullopt;
    }
    bytes.remove_prefix(mark.size());
    const std::string_view hash = bytes.substr(0, hashSize);
    bytes.remove_prefix(hash.size());
    Checkpoint checkpoint;
    if (hash != hashOf(bytes) || !take(bytes, checkpoint)) {
        problem = "it is damaged";
        return std::nullopt;
    }
    return checkpoint;
}

std::string differenceOf(const FrameIdentity &saved, const FrameIdentity &now) {
    const auto valueIn = [](const FrameIdentity &identity, const std::string &name) {
        const auto found =
            std::ranges::find(identity, name, &std::pair<std::string, std::string>::first);
        return found == identity.end() ? std::string() : found->second;
    };
    for (const auto &[name, value] : now) {
        const std::string before = valueIn(saved, name);
        if (before == value)
            continue;
        const bool isFingerprint = name == "scene" || name == "shaders";
        return isFingerprint
                   ? "the " + name + (name == "scene" ? " is" : " are") + " not the same"
                   : "it is of " + name + " " + before + ", and this render is of " + value;
    }
    return {};
}

} // namespace candela
