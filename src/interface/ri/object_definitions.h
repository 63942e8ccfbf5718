// SPDX-License-Identifier: Apache-2.0
// Objects (RI 3.2, 5.6) as the graphics state knows them: names and numbers; and as data those that
// are defined outside of worlds and belong to every later one. Private to the room.
#pragma once

#include "interface/ri/scene_builder.h"

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace candela {

/// What SceneBuilder::primitive or SceneBuilder::instance is told.
struct PlacedPart {
    std::shared_ptr<const PrimitiveRecord> primitive; ///< Null: an instance of `object`.
    int object = -1;
    std::shared_ptr<const Attributes> attributes;
    MotionTransform transform;
};
struct SolidEnding {};
/// One call of a SceneBuilder.
using ObjectPart = std::variant<PlacedPart, SolidOperation, SolidEnding>;

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

/// Tells a world that begins of the objects that were defined before it.
void tellKeptObjects(SceneBuilder &, const ObjectNames &);

/// The object that is being defined, if one is, and where parts go meanwhile.
class ObjectDefinition {
public:
    explicit ObjectDefinition(SceneBuilder &builder) : builder_(builder) {}

    bool isOpen() const { return open_.has_value(); }
    void begin(ObjectNames &, const std::string &handle, bool inWorld);
    /// The name means this object from here on. Before, it still means what it meant, so that no
    /// object can contain itself.
    void end(ObjectNames &);
    /// Part of the open object, else of the world.
    void tell(ObjectPart);
    /// Counts an instance of the object where parts go now. Why it can't stand there, if it can't;
    /// empty if it can.
    std::string countInstance(ObjectNames &, const ObjectNames::Entry &);

private:
    struct Open {
        std::string handle;
        ObjectNames::Entry entry;
        std::shared_ptr<ObjectRecord> record; ///< Null in a world, where the builder hears of it.
    };
    SceneBuilder &builder_;
    std::optional<Open> open_;
};

} // namespace candela
