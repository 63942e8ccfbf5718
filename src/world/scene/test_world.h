// SPDX-License-Identifier: Apache-2.0
// For tests: small worlds described in a few lines. Current space is object space.
#pragma once

#include "world/scene/scene.h"

#include <functional>
#include <initializer_list>
#include <string>

namespace candela {

class TestWorld {
public:
    TestWorld() {
        options.format.xResolution = options.format.yResolution = 64;
        options.camera.perspective = true;
        attributes.surface = shader("matte");
    }

    static std::shared_ptr<const ShaderRecord> shader(const std::string &name,
                                                      std::vector<Parameter> parameters = {}) {
        auto record = std::make_shared<ShaderRecord>();
        record->name = name, record->parameters.all = std::move(parameters);
        return record;
    }
    static Parameter numbers(const std::string &name, std::vector<float> values) {
        return {name, {StorageClass::Uniform, ValueType::Float, int(values.size())}, values, {}};
    }
    static Parameter variable(const std::string &name, StorageClass storage, ValueType type,
                              std::vector<float> values) {
        return {name, {storage, type, 1}, std::move(values), {}};
    }

    /// Adds a light and switches it on for what follows; area lights get what follows as geometry.
    int addLight(const std::string &name, std::vector<Parameter> parameters,
                 LightUnits units = LightUnits::Si, bool area = false) {
        auto record = std::make_shared<LightRecord>();
        record->index = int(lights.size());
        record->area = area, record->units = units;
        record->shader = *shader(name, std::move(parameters));
        lights.push_back(record);
        attributes.lightsOn.push_back(record->index);
        if (area)
            attributes.areaLight = record;
        return record->index;
    }
    void add(ShapeRecord shape, std::vector<Parameter> variables = {}) {
        auto record = std::make_shared<PrimitiveRecord>();
        record->shape = std::move(shape), record->variables.all = std::move(variables);
        primitives.push_back({record, std::make_shared<Attributes>(attributes), transform});
    }
    /// An object of this shape, placed.
    void addObject(ShapeRecord shape, std::vector<Matrix4> placements) {
        auto record = std::make_shared<PrimitiveRecord>();
        record->shape = std::move(shape);
        objects.push_back(
            {record, std::make_shared<Attributes>(attributes), std::move(placements)});
    }
    void addPolygon(const std::vector<Vec3> &corners, std::vector<Parameter> variables = {}) {
        PolygonsRecord polygon{{1}, {int(corners.size())}, {}};
        std::vector<float> P;
        for (int i = 0; i < int(corners.size()); ++i) {
            polygon.vertices.push_back(i);
            P.insert(P.end(), {corners[i].x, corners[i].y, corners[i].z});
        }
        variables.push_back(variable("P", StorageClass::Vertex, ValueType::Point, P));
        add(polygon, std::move(variables));
    }
    void addTriangles(const std::vector<Vec3> &corners) {
        PolygonsRecord polygons;
        std::vector<float> P;
        for (int i = 0; i < int(corners.size()); ++i) {
            polygons.vertices.push_back(i);
            P.insert(P.end(), {corners[i].x, corners[i].y, corners[i].z});
        }
        polygons.loopCounts.assign(corners.size() / 3, 1);
        polygons.vertexCounts.assign(corners.size() / 3, 3);
        add(polygons, {variable("P", StorageClass::Vertex, ValueType::Point, P)});
    }

    void render(const std::function<void(const Scene &)> &with) {
        ShaderLibrary library({}, diagnostics);
        SceneCompiler compiler(library, diagnostics, with);
        compiler.worldBegin(options);
        for (auto &light : lights)
            compiler.light(light);
        for (auto &[record, state, matrix] : primitives) {
            MotionTransform motion;
            motion.matrix = matrix;
            compiler.primitive(record, state, motion);
        }
        for (int i = 0; i < int(objects.size()); ++i) {
            compiler.objectBegin(i);
            compiler.primitive(objects[i].record, objects[i].attributes, {});
            compiler.objectEnd();
            for (const Matrix4 &matrix : objects[i].placements) {
                MotionTransform motion;
                motion.matrix = matrix;
                compiler.instance(i, objects[i].attributes, motion);
            }
        }
        compiler.worldEnd();
    }

    Options options;
    Attributes attributes;
    Matrix4 transform;
    DiagnosticList diagnostics;

private:
    struct Added {
        std::shared_ptr<const PrimitiveRecord> record;
        std::shared_ptr<const Attributes> attributes;
        Matrix4 matrix;
    };
    std::vector<std::shared_ptr<const LightRecord>> lights;
    std::vector<Added> primitives;
    struct Object {
        std::shared_ptr<const PrimitiveRecord> record;
        std::shared_ptr<const Attributes> attributes;
        std::vector<Matrix4> placements;
    };
    std::vector<Object> objects;
};

} // namespace candela
