// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/object_definitions.h"

#include <algorithm>

namespace candela {

static constexpr int maximumInstanceDepth = 64;
/// Objects that instance objects multiply: this is about what memory holds.
static constexpr int maximumPlacements = 16'000'000;

static void tellBuilder(SceneBuilder &builder, const ObjectPart &part) {
    if (const auto *operation = std::get_if<SolidOperation>(&part))
        return builder.solidBegin(*operation);
    const auto *placed = std::get_if<PlacedPart>(&part);
    if (!placed)
        return builder.solidEnd();
    if (placed->primitive)
        builder.primitive(placed->primitive, placed->attributes, placed->transform);
    else
        builder.instance(placed->object, placed->attributes, placed->transform);
}

void tellKeptObjects(SceneBuilder &builder, const ObjectNames &names) {
    for (std::size_t number = 0; number < names.kept.size(); ++number) {
        builder.objectBegin(int(number));
        for (const ObjectPart &part : names.kept[number]->parts)
            tellBuilder(builder, part);
        builder.objectEnd();
    }
}

void ObjectDefinition::begin(ObjectNames &names, const std::string &handle, bool inWorld) {
    open_ = Open{handle, {names.count++, 1, 1}, nullptr};
    if (inWorld)
        builder_.objectBegin(open_->entry.number);
    else
        open_->record = std::make_shared<ObjectRecord>();
}

void ObjectDefinition::end(ObjectNames &names) {
    if (open_->record)
        names.kept.push_back(std::move(open_->record));
    else
        builder_.objectEnd();
    names.byHandle[open_->handle] = open_->entry;
    open_.reset();
}

void ObjectDefinition::tell(ObjectPart part) {
    if (open_ && open_->record)
        open_->record->parts.push_back(std::move(part));
    else
        tellBuilder(builder_, part);
}

std::string ObjectDefinition::countInstance(ObjectNames &names, const ObjectNames::Entry &object) {
    if (open_) {
        if (object.depth >= maximumInstanceDepth)
            return "instances are nested more than " + std::to_string(maximumInstanceDepth) +
                   " deep";
        open_->entry.depth = std::max(open_->entry.depth, object.depth + 1);
        open_->entry.placements += object.placements;
    } else {
        if (names.placements + object.placements > maximumPlacements)
            return "with the objects within objects that this instance places the world would hold "
                   "more than " +
                   std::to_string(maximumPlacements) + "; it is left out";
        names.placements += object.placements;
    }
    return {};
}

} // namespace candela
