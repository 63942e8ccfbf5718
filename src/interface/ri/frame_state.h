// SPDX-License-Identifier: Apache-2.0
// The graphics state as a value: all that FrameBegin and WorldBegin save. Private to the room.
#pragma once

#include "interface/ri/object_definitions.h"
#include "interface/ri/transformations.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

struct LightList {
    std::vector<std::shared_ptr<const LightRecord>> all;
    std::map<std::string, int> byHandle; ///< Handle to index.
};

struct FrameState {
    Options options;
    std::shared_ptr<Attributes> attributes = std::make_shared<Attributes>();
    TransformState transform;
    std::map<std::string, CurrentTransform> coordinateSystems;
    /// ScopedCoordinateSystem's, which end with the attribute block; null if there are none.
    std::shared_ptr<const std::map<std::string, CurrentTransform>> scopedSystems;
    LightList lights;
    ObjectNames objects;
    bool inWorld = false;

    /// The attributes for a change: what has been handed on stays as it is.
    Attributes &edit() {
        if (attributes.use_count() > 1)
            attributes = std::make_shared<Attributes>(*attributes);
        return *attributes;
    }
    /// The same for an attribute that objects may have of their own.
    Attributes &edit(std::uint32_t ofOwn) {
        edit().ownSet |= ofOwn;
        return *attributes;
    }
    /// The current transformation as it is handed on.
    MotionTransform currentFromObject() const {
        return {transform.current.matrix.rounded(), transform.current.motion};
    }
};

} // namespace candela
