// SPDX-License-Identifier: Apache-2.0
// Object definitions and instances.
#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

static constexpr int maximumInstanceDepth = 64;
/// Objects that instance objects multiply: this is about what memory holds.
static constexpr int maximumPlacements = 16'000'000;

static void tellBuilder(SceneBuilder &builder, const ObjectPart &part) {
    if (part.primitive)
        builder.primitive(part.primitive, part.attributes, part.transform);
    else
        builder.instance(part.object, part.attributes, part.transform);
}

void StateHandlers::tell(ObjectPart part) {
    if (openObject_ && openObject_->record)
        openObject_->record->parts.push_back(std::move(part));
    else
        tellBuilder(builder_, part);
}

void StateHandlers::tellKeptObjects() {
    for (std::size_t number = 0; number < objects_.kept.size(); ++number) {
        builder_.objectBegin(int(number));
        for (const ObjectPart &part : objects_.kept[number]->parts)
            tellBuilder(builder_, part);
        builder_.objectEnd();
    }
}

void StateHandlers::objectBegin(const SourceLocation &where, const Handle &handle) {
    openObject_ = OpenObject{handle.text, {objects_.count++, 1, 1}, nullptr};
    if (inWorld_)
        builder_.objectBegin(openObject_->entry.number);
    else
        openObject_->record = std::make_shared<ObjectRecord>();
    attributeBegin(where);
    savedBases_.push_back(base_);
    ctm_ = base_ = {};
    // The instance's orientation comes on top of the definition's own.
    edit().flipNormal = false;
}

void StateHandlers::objectEnd(const SourceLocation &where) {
    base_ = savedBases_.back();
    savedBases_.pop_back();
    attributeEnd(where);
    if (openObject_->record)
        objects_.kept.push_back(std::move(openObject_->record));
    else
        builder_.objectEnd();
    objects_.byHandle[openObject_->handle] = openObject_->entry;
    openObject_.reset();
}

void StateHandlers::objectInstance(const SourceLocation &where, const Handle &handle) {
    auto found = objects_.byHandle.find(handle.text);
    if (found == objects_.byHandle.end())
        return error(where, "ObjectInstance", "no object '" + handle.text + "' has been defined");
    const auto [number, depth, placements] = found->second;
    if (isFlat(where, "ObjectInstance", "the instance"))
        return;
    // The name of an object that is being defined still means what it meant before, so that none
    // can contain itself.
    if (openObject_) {
        if (depth >= maximumInstanceDepth)
            return error(where, "ObjectInstance",
                         "instances are nested more than " + std::to_string(maximumInstanceDepth) +
                             " deep");
        openObject_->entry.depth = std::max(openObject_->entry.depth, depth + 1);
        openObject_->entry.placements += placements;
    } else {
        if (objects_.placements + placements > maximumPlacements)
            return error(where, "ObjectInstance",
                         "with the objects within objects that this instance places the world "
                         "would hold more than " +
                             std::to_string(maximumPlacements) + "; it is left out");
        objects_.placements += placements;
    }
    tell({nullptr, number, currentAttributes(), currentTransform()});
}

} // namespace candela
