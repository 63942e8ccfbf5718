// SPDX-License-Identifier: Apache-2.0
// What the graphics state has said of a world, kept until worldEnd.
#pragma once

#include "interface/ri/scene_builder.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

struct DeclaredPrimitive {
    std::shared_ptr<const PrimitiveRecord> record;
    std::shared_ptr<const Attributes> attributes;
    Matrix4 outerFromPrimitive; ///< Outer: current space, or the space of the object around it.
};

struct DeclaredInstance {
    int object;
    std::shared_ptr<const Attributes> attributes;
    Matrix4 outerFromObject;
};

/// The world itself, or an object.
struct DeclaredGroup {
    std::vector<DeclaredPrimitive> primitives;
    std::vector<DeclaredInstance> instances;
};

struct DeclaredWorld {
    Options options;
    std::vector<std::shared_ptr<const LightRecord>> lights;
    DeclaredGroup world;
    std::vector<DeclaredGroup> objects;
    std::map<std::string, Matrix4> systems; ///< Named coordinate systems: currentFromSpace.
    int openObject = -1;                    ///< Which one is being defined; -1 = none.

    DeclaredGroup &open() { return openObject < 0 ? world : objects[openObject]; }
};

/// An object where it stands, with all objects around it resolved.
struct Placement {
    int object;
    std::shared_ptr<const Attributes> attributes; ///< Of the outermost instance.
    bool turned; ///< The instances around it reverse the orientation an odd number of times.
    Matrix4 currentFromObject;
};

/// Where objects with primitives of their own stand. Singular instances are left out.
std::vector<Placement> placementsOf(const DeclaredWorld &);

} // namespace candela
