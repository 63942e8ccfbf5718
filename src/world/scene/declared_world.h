// SPDX-License-Identifier: Apache-2.0
// What the graphics state has said of a world, kept until worldEnd.
#pragma once

#include "foundation/base/shutter.h"
#include "interface/ri/scene_builder.h"
#include "world/scene/declared_solids.h"

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

struct DeclaredPrimitive {
    std::shared_ptr<const PrimitiveRecord> record;
    std::shared_ptr<const Attributes> attributes;
    Matrix4 outerFromPrimitive;     ///< Outer: current space, or the space of the object around it.
    TransformMotion::Shared motion; ///< Null: it stands still while the shutter is open.
    SolidPlace solid;

    /// Its definition reverses the orientation.
    bool turned() const { return attributes->flipNormal != solid.turned; }
};

struct DeclaredInstance {
    int object; ///< Index in DeclaredWorld::objects.
    std::shared_ptr<const Attributes> attributes;
    bool turns; ///< It reverses the orientation.
    Matrix4 outerFromObject;
    TransformMotion::Shared motion; ///< As of primitives.
    SolidPlace solid;
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
    std::vector<DeclaredGroup> objects;     ///< And their parts with attributes of their own.
    std::map<int, int> objectOfNumber;      ///< SceneBuilder's number to the index in `objects`.
    std::map<std::string, Matrix4> systems; ///< Named coordinate systems: currentFromSpace.
    Shutter shutter;

    DeclaredSolids solids;

    /// The object of that number is being defined, up to endObject.
    void beginObject(int number);
    void endObject();
    /// Where instances belong: the object that is being defined, else the world.
    DeclaredGroup &open() { return openObject_ < 0 ? world : objects[openObject_]; }
    /// Where primitives with these attributes do. What sets attributes of its own in an object, or
    /// is a solid there, is an object in it.
    DeclaredGroup &openFor(const std::shared_ptr<const Attributes> &, const SolidPlace &);

    /// What has become of them is told by placementsOf(), and by surfaces.
    void letGoOfInstances();
    void letGoOfRecords();

private:
    template <class Do> void forGroups(Do);

    int openObject_ = -1;
    /// Of the open object, by their attributes, if they have any of their own, and their solid.
    std::map<std::pair<const Attributes *, int>, int> openParts_;
};

/// An object where it stands, with all objects around it resolved.
struct Placement {
    int object;
    std::shared_ptr<const Attributes> attributes; ///< The outermost instance's, and objects' own.
    bool turned; ///< The instances around it reverse the orientation an odd number of times.
    Matrix4 currentFromObject; ///< When the shutter opens.
    /// The same at even steps over the shutter's interval; empty where it stands still.
    std::vector<Matrix4> steps;
    /// In Placements::nodes, of its first primitive; -1: none belongs to a solid.
    std::int64_t firstNode = -1;
};

struct Placements {
    std::vector<Placement> all;
    PlacedSolids solids;
    /// Of primitives, which body of PlacedSolids they bound, or -1: those of the world, then those
    /// of placements that have some.
    std::vector<std::int32_t> nodes;
};

/// Where objects with primitives of their own stand. Singular instances are left out.
Placements placementsOf(const DeclaredWorld &);

} // namespace candela
