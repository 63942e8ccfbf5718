// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/shape.h"

#include "world/shapes/corner_order.h"
#include "world/shapes/cut_triangles.h"
#include "world/shapes/dice_rate.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// Rounding of an intersection, against the extent of the element: eight units of a float.
constexpr float elementRounding = 8 * 0x1p-24f;

/// The shape's elements against the natural normals, by vote of some triangles.
float signByVote(const Shape &shape, const RayShape &mesh) {
    int vote = 0;
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / 15);
    for (std::size_t k = 0; k < mesh.triangles.size(); k += step) {
        auto [a, b, c] = mesh.triangles[k];
        std::uint32_t piece = shape.naming == Naming::Direct ? std::uint32_t(k)
                              : shape.pieces.empty()         ? 0
                                                             : shape.pieces[k];
        float u = 1 / 3.0f, v = 1 / 3.0f, x = 0, y = 0, z = 0;
        if (shape.naming == Naming::Corners) {
            const auto *uv = shape.vertexUv.data();
            u = (uv[a][0] + uv[b][0] + uv[c][0]) / 3, v = (uv[a][1] + uv[b][1] + uv[c][1]) / 3;
        }
        SurfaceAnswer answer;
        answer.Ng = {&x, &y, &z};
        shape.surface->evaluate({1, &piece, &u, &v}, answer);
        Vec3 normal = normalize(transformNormal(shape.shapeFromOuter, normalize(Vec3{x, y, z})));
        Vec3 p0 = mesh.positions[a];
        Vec3 element = cross(mesh.positions[b] - p0, mesh.positions[c] - p0);
        float along = dot(normalize(element), normal);
        vote += along > 0 ? 1 : along < 0 ? -1 : 0;
    }
    return vote < 0 ? -1 : 1;
}

/// How far along its elements rounding leads astray who meets them.
struct Reach {
    float longestEdge = 0;
    /// The longest edge, and more where the edges at an element's first corner are nearly parallel:
    /// its normal is off by rounding over the sine between them. No more than what lifts one off by
    /// its own width.
    float slender = 0;
};

Reach reachOf(const RayShape &mesh) {
    Reach reach;
    for (const auto &t : mesh.triangles) {
        Vec3 edge[3];
        float squared = 0;
        for (int k = 0; k < 3; ++k) {
            edge[k] = mesh.positions[t[(k + 1) % 3]] - mesh.positions[t[k]];
            squared = std::max(squared, dot(edge[k], edge[k]));
        }
        const float longest = std::sqrt(squared), area = length(cross(edge[0], edge[1]));
        const float product = length(edge[0]) * length(edge[2]);
        reach.longestEdge = std::max(reach.longestEdge, longest);
        if (!(area > 0))
            continue;
        const float width = area / longest, astray = longest * (product / area) / 2;
        reach.slender = std::max(reach.slender, std::min(astray, width / elementRounding));
    }
    reach.slender = std::max(reach.slender, reach.longestEdge);
    return reach;
}

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
    if (!radius || !shape.mayBeSphere || !keepsSpheres(shape.outerFromShape))
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
    if (diced.vertexUv.empty())
        shape.pieces = cutTriangles(diced, eye);
    shape.naming = diced.vertexUv.empty() ? Naming::Direct : Naming::Corners;
    if (shape.naming == Naming::Corners) {
        beginAtBluntCorners(diced);
        shape.triangles = diced.triangles;
        shape.vertexUv = std::move(diced.vertexUv);
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
