// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/world_fingerprint.h"

namespace candela {

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

RequestHash *WorldFingerprint::hashFor(RequestId id) {
    if (id == RequestId::FrameBegin) {
        inFrame_ = true;
        frame_.emplace(), frameCamera_.emplace();
    } else if (id == RequestId::FrameEnd) {
        inFrame_ = false;
    } else if (id == RequestId::WorldBegin) {
        inWorld_ = true;
        world_.emplace();
    } else if (id == RequestId::WorldEnd) {
        inWorld_ = false;
    }
    if (isOfPicture(id))
        return nullptr;
    if (inWorld_)
        return &*world_;
    movesLights_ = movesLights_ || id == RequestId::LightSource || id == RequestId::AreaLightSource;
    if (isTransformation(id))
        return inFrame_ ? &*frameCamera_ : &fileCamera_;
    return inFrame_ ? &*frame_ : &file_;
}

std::string WorldFingerprint::text() {
    ContentHash all;
    for (RequestHash *const hash : {&file_, &*frame_, &*world_})
        all.add(hash->text());
    for (RequestHash *const hash : {&fileCamera_, &*frameCamera_})
        if (movesLights_)
            all.add(hash->text());
    return all.text();
}

} // namespace candela
