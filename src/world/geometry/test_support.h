// SPDX-License-Identifier: Apache-2.0
// What the tests of this room share: records by hand, and questions to surfaces one at a time.
#pragma once

#include "world/geometry/surface.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace candela::geometrytest {

inline Parameter parameter(std::string name, StorageClass storage, ValueType type,
                           std::vector<float> floats, int arraySize = 1) {
    return {std::move(name), {storage, type, arraySize}, std::move(floats), {}};
}

inline std::shared_ptr<PrimitiveRecord> record(ShapeRecord shape,
                                               std::vector<Parameter> variables = {}) {
    auto result = std::make_shared<PrimitiveRecord>();
    result->shape = std::move(shape);
    result->variables.all = std::move(variables);
    result->where = {std::make_shared<const std::string>("test.rib"), 17, 0};
    return result;
}

/// The one surface of a record; fails the test if there is not exactly one or something was said.
inline std::shared_ptr<const Surface> surfaceOf(ShapeRecord shape,
                                                std::vector<Parameter> variables = {},
                                                const Attributes &attributes = {}) {
    DiagnosticList diagnostics;
    auto surfaces =
        makeSurfaces(record(std::move(shape), std::move(variables)), attributes, diagnostics);
    EXPECT_EQ(diagnostics.text(), "");
    EXPECT_EQ(surfaces.size(), 1u);
    return surfaces.empty() ? nullptr : surfaces[0];
}

struct Point {
    Vec3 P, Ng, N, dPdu, dPdv;
    float u = 0, v = 0;
};

inline Point at(const Surface &surface, float u, float v, std::uint32_t piece = 0) {
    Point p;
    SurfaceAnswer answer;
    auto planes = [](Vec3 &to) { return Vec3Planes{&to.x, &to.y, &to.z}; };
    answer.P = planes(p.P), answer.Ng = planes(p.Ng), answer.N = planes(p.N);
    answer.dPdu = planes(p.dPdu), answer.dPdv = planes(p.dPdv);
    answer.u = &p.u, answer.v = &p.v;
    surface.evaluate({1, &piece, &u, &v}, answer);
    return p;
}

/// Of a variable by its name, -1 = none.
inline int numberOf(const Surface &surface, const std::string &name) {
    const auto infos = surface.variables();
    const auto found = std::ranges::find(infos, name, &VariableInfo::name);
    return found == infos.end() ? -1 : int(found - infos.begin());
}

struct Value {
    std::vector<float> value, du, dv;
};

/// The variable of that name; fails the test and is empty if there is none.
inline Value variable(const Surface &surface, const std::string &name, float u, float v,
                      std::uint32_t piece = 0) {
    auto infos = surface.variables();
    for (std::size_t i = 0; i < infos.size(); ++i) {
        if (infos[i].name != name)
            continue;
        Value result;
        std::array<float *, 16> value, du, dv;
        for (auto *plane : {&result.value, &result.du, &result.dv})
            plane->resize(16);
        for (int c = 0; c < 16; ++c)
            value[c] = &result.value[c], du[c] = &result.du[c], dv[c] = &result.dv[c];
        surface.evaluateVariable(int(i), {1, &piece, &u, &v}, value.data(), du.data(), dv.data());
        return result;
    }
    ADD_FAILURE() << "no variable " << name;
    return {std::vector<float>(16), std::vector<float>(16), std::vector<float>(16)};
}

/// Within -1 and 1.
inline std::vector<float> randomFloats(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> uniform(-1, 1);
    std::vector<float> floats(count);
    for (float &x : floats)
        x = uniform(random);
    return floats;
}

inline double areaOf(const DicedMesh &mesh) {
    double area = 0;
    for (const auto &t : mesh.triangles) {
        Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]], c = mesh.positions[t[2]];
        area += 0.5 * length(cross(b - a, c - a));
    }
    return area;
}

/// Every edge of the triangles, by its positions: 2 triangles on it inside, 1 on the border.
/// Fails the test on an edge with more than two or with two that turn the same way.
/// Returns the number of border edges.
int borderEdges(const DicedMesh &);

/// Largest distance between points of the same name on triangles and surface, by sampling.
double sampledChordError(const Surface &, const DicedMesh &, int samplesPerTriangle = 6);

} // namespace candela::geometrytest
