// SPDX-License-Identifier: Apache-2.0
// For tests: a SceneBuilder that only listens, and a ShaderLookup that knows a few shaders.
#pragma once

#include "interface/ri/scene_builder.h"

#include <map>
#include <string>
#include <vector>

namespace candela::testing {

class ListeningSceneBuilder : public SceneBuilder {
public:
    struct Primitive {
        std::shared_ptr<const PrimitiveRecord> record;
        std::shared_ptr<const Attributes> attributes;
        MotionTransform currentFromObject;

        /// Where the object's point (x, y, z) is in camera space.
        Vec3 place(float x, float y, float z) const {
            return transformPoint(currentFromObject.atOpen(), {x, y, z});
        }
    };
    struct Instance {
        int object;
        std::shared_ptr<const Attributes> attributes;
        MotionTransform currentFromObject;
    };
    struct Object {
        std::vector<Primitive> primitives;
        std::vector<Instance> instances;
    };
    struct World {
        Options options;
        std::vector<std::shared_ptr<const LightRecord>> lights;
        std::vector<Primitive> primitives;
        std::vector<Instance> instances;
        std::map<int, Object> objects;
        int openObject = -1;
        std::vector<SolidOperation> solids; ///< In the order in which they begin.
        int solidsEnded = 0;
        std::map<std::string, Matrix4> coordinateSystems;
        bool ended = false;
    };
    std::vector<World> worlds;

    void worldBegin(const Options &options) override {
        worlds.emplace_back();
        worlds.back().options = options;
    }
    void light(std::shared_ptr<const LightRecord> light) override {
        worlds.back().lights.push_back(std::move(light));
    }
    void primitive(std::shared_ptr<const PrimitiveRecord> record,
                   std::shared_ptr<const Attributes> attributes,
                   const MotionTransform &currentFromObject) override {
        World &world = worlds.back();
        auto &list =
            world.openObject < 0 ? world.primitives : world.objects[world.openObject].primitives;
        list.push_back({std::move(record), std::move(attributes), currentFromObject});
    }
    void objectBegin(int object) override {
        worlds.back().openObject = object;
        worlds.back().objects[object] = {};
    }
    void objectEnd() override { worlds.back().openObject = -1; }
    void instance(int object, std::shared_ptr<const Attributes> attributes,
                  const MotionTransform &currentFromObject) override {
        World &world = worlds.back();
        auto &list =
            world.openObject < 0 ? world.instances : world.objects[world.openObject].instances;
        list.push_back({object, std::move(attributes), currentFromObject});
    }
    void solidBegin(SolidOperation operation) override {
        worlds.back().solids.push_back(operation);
    }
    void solidEnd() override { ++worlds.back().solidsEnded; }
    void coordinateSystem(const std::string &name, const Matrix4 &currentFromSpace) override {
        worlds.back().coordinateSystems[name] = currentFromSpace;
    }
    void imager(std::shared_ptr<const ShaderRecord> shader) override {
        worlds.back().options.imager = shader ? std::optional(*shader) : std::nullopt;
    }
    void worldEnd() override { worlds.back().ended = true; }
};

/// Knows "marble" (float scale, color vein, string grain); no other shader exists.
class SmallShaderLookup : public ShaderLookup {
public:
    std::optional<std::vector<ParameterType>> parametersOf(ShaderKind, const std::string &name,
                                                           const Options &,
                                                           const SourceLocation &) override {
        if (name != "marble")
            return std::nullopt;
        auto uniform = [](ValueType type) { return Declaration{StorageClass::Uniform, type, 1}; };
        return std::vector<ParameterType>{{"scale", uniform(ValueType::Float)},
                                          {"vein", uniform(ValueType::Color)},
                                          {"grain", uniform(ValueType::String)}};
    }
};

} // namespace candela::testing
