// SPDX-License-Identifier: Apache-2.0
// Objects (RI 3.2, 5.6) as the graphics state knows them: names and numbers; and as data those that
// are defined outside of worlds and belong to every later one. Private to the room.
#pragma once

#include "interface/ri/primitive_record.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

/// What SceneBuilder::primitive or SceneBuilder::instance is told.
struct ObjectPart {
    std::shared_ptr<const PrimitiveRecord> primitive; ///< Null: an instance of `object`.
    int object = -1;
    std::shared_ptr<const Attributes> attributes;
    MotionTransform transform;
};

struct ObjectRecord {
    std::vector<ObjectPart> parts;
};

/// FrameBegin and WorldBegin save it: objects end with the block that they are defined in.
struct ObjectNames {
    struct Entry {
        int number = 0;        ///< SceneBuilder's.
        int depth = 1;         ///< Levels of instances below, itself included.
        double placements = 1; ///< How many objects an instance places, itself included.
    };
    std::map<std::string, Entry> byHandle;
    /// Of the objects outside worlds; the index is the number.
    std::vector<std::shared_ptr<const ObjectRecord>> kept;
    int count = 0;         ///< Numbers given so far.
    double placements = 0; ///< Objects that the world's instances have placed so far.
};

} // namespace candela
