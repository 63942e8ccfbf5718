// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/shape.h"

#include "world/shapes/corner_order.h"
#include "world/shapes/cut_triangles.h"
#include "world/shapes/dice_rate.h"
#include "world/shapes/elements.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

void beginAtBluntCorners(DicedMesh &mesh) {
    const std::vector<Vec3> &p = mesh.positions;
    for (auto &triangle : mesh.triangles)
        beginAt(bluntCorner(p[triangle[0]], p[triangle[1]], p[triangle[2]]), triangle);
}

bool hasFlatNormals(const Surface &surface, const DicedMesh &diced) {
    if (!diced.vertexUv.empty() || diced.chordError > 0)
        return false;
    return !surface.hasOwnNormals();
}

} // namespace

int numericVariable(const Surface &surface, const std::string &name) {
    auto variables = surface.variables();
    for (std::size_t i = 0; i < variables.size(); ++i)
        if (variables[i].name == name && variables[i].declaration.type != ValueType::String)
            return int(i);
    return -1;
}

std::optional<Shape> makeShape(std::shared_ptr<const Surface> surface,
                               const Matrix4 &outerFromShape) {
    auto shapeFromOuter = inverse(outerFromShape);
    if (!shapeFromOuter)
        return std::nullopt;
    Shape shape;
    shape.s = numericVariable(*surface, "s"), shape.t = numericVariable(*surface, "t");
    shape.Cs = numericVariable(*surface, "Cs"), shape.Os = numericVariable(*surface, "Os");
    shape.surface = std::move(surface);
    shape.handedness = flipsHandedness(outerFromShape) ? -1 : 1;
    shape.outerFromShape = outerFromShape, shape.shapeFromOuter = *shapeFromOuter;
    return shape;
}

bool keepsSpheres(const Matrix4 &matrix) {
    // The rows must be at right angles and of one length, as far as files of five digits say.
    constexpr float tolerance = 1e-4f;
    Vec3 rows[3];
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            rows[row][column] = matrix.at(row, column);
    const float squared = dot(rows[0], rows[0]);
    for (int row = 0; row < 3; ++row)
        if (!(std::fabs(dot(rows[row], rows[row]) - squared) <= tolerance * squared) ||
            !(std::fabs(dot(rows[row], rows[(row + 1) % 3])) <= tolerance * squared))
            return false;
    return true;
}

std::optional<OuterSphere> outerSphere(const Shape &shape) {
    std::optional<float> radius = shape.surface->wholeSphere();
    if (!radius || shape.displacement || !shape.mayBeSphere || !keepsSpheres(shape.outerFromShape))
        return std::nullopt;
    Vec3 row;
    for (int column = 0; column < 3; ++column)
        row[column] = shape.outerFromShape.at(0, column);
    return OuterSphere{transformPoint(shape.outerFromShape, {0, 0, 0}), *radius * length(row)};
}

RayShape dice(Shape &shape, const DiceRate &rate, const Vec3 *eye) {
    RayShape result;
    if (std::optional<OuterSphere> sphere = outerSphere(shape)) {
        shape.naming = Naming::Sphere;
        shape.elements = 1;
        result.centre = sphere->centre, result.radius = sphere->radius;
        // The natural normal of a sphere turned inside out in parameters points inwards.
        float x, y, z, px, py, pz, u = 0.3f, v = 0.4f;
        SurfaceAnswer answer;
        answer.Ng = {&x, &y, &z}, answer.P = {&px, &py, &pz};
        const std::uint32_t piece = 0;
        shape.surface->evaluate({1, &piece, &u, &v}, answer);
        shape.elementSign = dot(Vec3{x, y, z}, Vec3{px, py, pz}) < 0 ? -1 : 1;
        shape.offset = elementRounding * sphere->radius;
        return result;
    }
    DicedMesh diced = shape.surface->dice(rate);
    for (Vec3 &position : diced.positions)
        position = transformPoint(shape.outerFromShape, position);
    shape.flat = hasFlatNormals(*shape.surface, diced);
    shape.curved = shape.away = !diced.vertexUv.empty();
    if (!shape.curved)
        diced.pieces = cutTriangles(diced, eye);
    shape.naming = diced.vertexUv.empty() ? Naming::Direct : Naming::Corners;
    if (shape.naming == Naming::Corners) {
        beginAtBluntCorners(diced);
        shape.triangles = diced.triangles;
        shape.vertexUv = std::move(diced.vertexUv);
        shape.pieces = std::move(diced.pieces);
    }
    shape.elements = std::uint32_t(diced.triangles.size());
    result.positions = std::move(diced.positions);
    result.triangles = std::move(diced.triangles);
    shape.elementSign = signByVote(shape, result);
    const Reach reach = reachOf(result);
    shape.offset =
        diced.chordError * largestStretch(shape.outerFromShape) + elementRounding * reach.slender;
    if (eye && !shape.pieces.empty() && diced.chordError == 0)
        shape.offsetShare = elementRounding * longestEdgeShare * reach.slender / reach.longestEdge;
    return result;
}

} // namespace candela
