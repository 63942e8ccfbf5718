// SPDX-License-Identifier: Apache-2.0
// What the graphics state says of a world to whoever builds it. The one way from the interface
// to the renderer: implemented in world/scene, and by tests that only listen.
#pragma once

#include "interface/ri/attributes.h"
#include "interface/ri/options.h"
#include "interface/ri/primitive_record.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// What a solid block makes of its parts (RI 3.2, 5.7). Primitive: what is told in it bounds one
/// body, together.
enum class SolidOperation { Primitive, Union, Intersection, Difference };

/// All matrices are currentFromX, and "current" is camera space (left-handed: x right, y up,
/// z forward, metres), as PRMan has it.
class SceneBuilder {
public:
    virtual ~SceneBuilder() = default;

    /// The options are frozen; what follows, up to worldEnd, belongs to this world.
    virtual void worldBegin(const Options &) = 0;
    /// A light source has been declared; its index is one more than the last one's.
    virtual void light(std::shared_ptr<const LightRecord>) = 0;
    virtual void primitive(std::shared_ptr<const PrimitiveRecord>,
                           std::shared_ptr<const Attributes>,
                           const MotionTransform &currentFromObject) = 0;
    /// The primitives (and instances of other objects) up to objectEnd() make up the object of that
    /// number, counted from 0 in each world, and are not drawn themselves. Their matrices lead from
    /// their own space to the object's. Of their attributes those count that shape them (bases,
    /// orientation) or are in ownSet; for all else the instance's do. Definitions do not nest.
    virtual void objectBegin(int object) = 0;
    virtual void objectEnd() = 0;
    /// Draws a finished object with these attributes; also inside the definition of another one.
    /// What a world's instances draw, objects within objects counted, stays within what memory
    /// holds.
    virtual void instance(int object, std::shared_ptr<const Attributes>,
                          const MotionTransform &currentFromObject) = 0;
    /// The primitives, instances and solids up to its solidEnd() are parts of a solid, and this one
    /// is a part of the solid around it. Blocks are properly nested, within objects too.
    virtual void solidBegin(SolidOperation) = 0;
    virtual void solidEnd() = 0;
    /// A coordinate system named inside the world block.
    virtual void coordinateSystem(const std::string &name, const Matrix4 &currentFromSpace) = 0;
    /// An imager given within the world, which counts for its picture; null: none.
    virtual void imager(std::shared_ptr<const ShaderRecord>) = 0;
    /// The world is complete: render it.
    virtual void worldEnd() = 0;
};

enum class ShaderKind { Surface, Light, Displacement, Volume, Imager, Filter, Transformation };

/// How the graphics state learns the types of shader parameters that no one declared.
class ShaderLookup {
public:
    struct ParameterType {
        std::string name;
        Declaration declaration;
    };
    virtual ~ShaderLookup() = default;
    /// The parameters of the shader of that name as seen from the given search path; nothing if
    /// there is no such shader or it does not compile (the lookup has then reported why, once).
    virtual std::optional<std::vector<ParameterType>>
    parametersOf(ShaderKind, const std::string &name, const Options &, const SourceLocation &) = 0;
};

} // namespace candela
