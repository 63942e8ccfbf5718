// SPDX-License-Identifier: Apache-2.0
// PRMan's resources: attributes kept under a name. They are not bound to the blocks of attributes;
// ResourceBegin and ResourceEnd are blocks of their own. Private to the room.
#pragma once

#include "interface/ri/attributes.h"
#include "interface/ri/transformations.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

struct Resource {
    std::shared_ptr<const Attributes> attributes;
    TransformState transform;
    int lights = 0; ///< Which list of lights its lights are of.
};

class Resources {
public:
    void begin() { blocks_.emplace_back(); }
    /// False if there is no block.
    bool end();
    void save(const std::string &name, Resource);
    /// The resource of that name, of the innermost block; null if there is none.
    const Resource *find(const std::string &name) const;

private:
    std::vector<std::map<std::string, Resource>> blocks_{1};
};

/// Sets those attributes that belong to a subset ("shading", "geometry", "geometrymodification",
/// "geometrydefinition", "hiding", "all") as `from` has them, lights left out. False if there is no
/// such subset.
bool restoreSubset(Attributes &, const Attributes &from, const std::string &subset);

} // namespace candela
