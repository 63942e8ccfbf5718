// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/world_fingerprint.h"

#include "foundation/base/hash.h"
#include "interface/rib/rib_writer.h"

namespace candela {

class WorldFingerprint::Hash {
public:
    Hash() : output_(ByteOutput::toHash(hash_)), writer_(*output_, RibEncoding::Binary) {}
    RibWriter &writer() {
        isAsked_ = false;
        return writer_;
    }
    /// The same until something is written.
    std::string text() {
        if (!isAsked_)
            writer_.flush();
        isAsked_ = true;
        return hash_.text();
    }

private:
    bool isAsked_ = false;
    ContentHash hash_;
    std::unique_ptr<ByteOutput> output_;
    RibWriter writer_;
};

WorldFingerprint::WorldFingerprint(RequestSink &sink)
    : ForwardingSink(sink), file_(std::make_unique<Hash>()), fileCamera_(std::make_unique<Hash>()),
      frame_(std::make_unique<Hash>()), frameCamera_(std::make_unique<Hash>()),
      world_(std::make_unique<Hash>()) {}
WorldFingerprint::~WorldFingerprint() = default;

/// Of the picture, not of what it is of.
static bool isOfPicture(RequestId id) {
    switch (id) {
    case RequestId::ErrorHandler:
    case RequestId::FrameBegin:
    case RequestId::FrameEnd:
    case RequestId::WorldBegin:
    case RequestId::WorldEnd:
    case RequestId::Format:
    case RequestId::FrameAspectRatio:
    case RequestId::ScreenWindow:
    case RequestId::CropWindow:
    case RequestId::Projection:
    case RequestId::Clipping:
    case RequestId::DepthOfField:
    case RequestId::PixelVariance:
    case RequestId::PixelSamples:
    case RequestId::PixelFilter:
    case RequestId::Exposure:
    case RequestId::Imager:
    case RequestId::Quantize:
    case RequestId::Display:
    case RequestId::DisplayChannel:
    case RequestId::PushFilter:
    case RequestId::PopFilter:
    case RequestId::Hider:
    case RequestId::MakeTexture:
    case RequestId::MakeBump:
    case RequestId::MakeLatLongEnvironment:
    case RequestId::MakeCubeFaceEnvironment:
    case RequestId::MakeShadow: return true;
    default: return false;
    }
}

static bool isTransformation(RequestId id) {
    switch (id) {
    case RequestId::Identity:
    case RequestId::Transform:
    case RequestId::ConcatTransform:
    case RequestId::Perspective:
    case RequestId::Translate:
    case RequestId::Rotate:
    case RequestId::Scale:
    case RequestId::Skew:
    case RequestId::CoordinateSystem:
    case RequestId::ScopedCoordinateSystem:
    case RequestId::CoordSysTransform:
    case RequestId::TransformBegin:
    case RequestId::TransformEnd: return true;
    default: return false;
    }
}

WorldFingerprint::Hash *WorldFingerprint::hashFor(RequestId id) {
    if (id == RequestId::FrameBegin) {
        inFrame_ = true;
        frame_ = std::make_unique<Hash>(), frameCamera_ = std::make_unique<Hash>();
    } else if (id == RequestId::FrameEnd) {
        inFrame_ = false;
    } else if (id == RequestId::WorldBegin) {
        inWorld_ = true;
        world_ = std::make_unique<Hash>();
    } else if (id == RequestId::WorldEnd) {
        inWorld_ = false;
    }
    if (isOfPicture(id))
        return nullptr;
    if (inWorld_)
        return world_.get();
    movesLights_ = movesLights_ || id == RequestId::LightSource || id == RequestId::AreaLightSource;
    if (isTransformation(id))
        return (inFrame_ ? frameCamera_ : fileCamera_).get();
    return (inFrame_ ? frame_ : file_).get();
}

std::string WorldFingerprint::text() {
    ContentHash all;
    for (const auto *hash : {&file_, &frame_, &world_})
        all.add((*hash)->text());
    for (const auto *hash : {&fileCamera_, &frameCamera_})
        if (movesLights_)
            all.add((*hash)->text());
    return all.text();
}

#define TAKEN(Name, handler, scopes, ...)                                                          \
    void WorldFingerprint::handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) {  \
        if (Hash *const hash = hashFor(RequestId::Name))                                           \
            hash->writer().handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                          \
        ForwardingSink::handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                             \
    }
#define REQUEST(...) TAKEN(__VA_ARGS__)
#define REQUEST_OF_BLOCKS(...) TAKEN(__VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    TAKEN(Name, handler, scopes __VA_OPT__(, ) __VA_ARGS__)
#include "interface/ri/requests.def"
#undef TAKEN

} // namespace candela
