// SPDX-License-Identifier: Apache-2.0
// Object definitions and instances.
#include "interface/ri/state_handlers.h"

namespace candela {

void StateHandlers::objectBegin(const SourceLocation &, const Handle &handle) {
    object_.begin(state_.objects, handle.text, state_.inWorld);
    saveBlock(true);
    state_.transform = {};
    // The instance's orientation comes on top of the definition's own.
    Attributes &attributes = state_.edit();
    attributes.flipNormal = false;
    attributes.ownSet = 0;
    attributes.ownNames.clear();
}

void StateHandlers::objectEnd(const SourceLocation &) {
    restoreBlock();
    object_.end(state_.objects);
}

void StateHandlers::objectInstance(const SourceLocation &where, const Handle &handle) {
    auto found = state_.objects.byHandle.find(handle.text);
    if (found == state_.objects.byHandle.end())
        return diagnostics_.error(where, "ObjectInstance",
                                  "no object '" + handle.text + "' has been defined");
    if (isFlat(where, "ObjectInstance", "the instance"))
        return;
    const ObjectNames::Entry &object = found->second;
    if (std::string refusal = object_.countInstance(state_.objects, object); !refusal.empty())
        return diagnostics_.error(where, "ObjectInstance", refusal);
    object_.tell(PlacedPart{nullptr, object.number, state_.attributes, state_.currentFromObject()});
}

} // namespace candela
