// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/shape.h"

#include "world/geometry/moving_surface.h"
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

bool isMetRound(const Shape &shape) {
    return shape.surface->isRound() && !shape.displacement && shape.mayBeRound &&
           keepsSpheres(shape.outerFromShape);
}

/// The surface's round elements in the outer space.
static RoundElements outerElements(const Shape &shape) {
    Vec3 row;
    for (int column = 0; column < 3; ++column)
        row[column] = shape.outerFromShape.at(0, column);
    const float stretch = length(row);
    RoundElements round = shape.surface->roundElements();
    round.forSteps([&](auto &knots) {
        for (auto &[x, y, z, radius] : knots) {
            const Vec3 place = transformPoint(shape.outerFromShape, {x, y, z});
            x = place.x, y = place.y, z = place.z, radius *= stretch;
        }
    });
    return round;
}

/// How far from a round element rays may find it. Of a tube it goes with its length: that is what
/// the ray tracer computes with.
static float roundRounding(const RoundElements &round) {
    constexpr float tubeRounding = 4e-6f;
    float radius = 0, longest = 0;
    round.forSteps([&](const auto &knots) {
        for (const auto &knot : knots)
            radius = std::max(radius, knot[3]);
        for (std::uint32_t first : round.tubes) {
            const auto &a = knots[first], &b = knots[first + 3];
            longest = std::max(longest, length(Vec3{b[0] - a[0], b[1] - a[1], b[2] - a[2]}));
        }
    });
    return elementRounding * radius + tubeRounding * longest;
}

/// +1 where the natural normal of a round surface points outwards, as its elements' do: not on a
/// sphere that is turned inside out in its parameters.
static float outwardSign(const Surface &surface) {
    const std::uint32_t piece[] = {0, 0};
    const float u[] = {0.3f, 0.8f}, v[] = {0.4f, 0.4f}; // On either side.
    float x[2], y[2], z[2], nx[2], ny[2], nz[2];
    SurfaceAnswer answer;
    answer.P = {x, y, z}, answer.Ng = {nx, ny, nz};
    surface.evaluate({2, piece, u, v}, answer);
    return dot(answer.Ng.get(0), answer.P.get(0) - answer.P.get(1)) < 0 ? -1.0f : 1.0f;
}

RayShape dice(Shape &shape, const DiceRate &rate, const Vec3 *eye) {
    RayShape result;
    if (isMetRound(shape)) {
        result.round = outerElements(shape);
        shape.naming = Naming::Round;
        shape.elements = std::uint32_t(result.round.size());
        shape.curved = !result.round.tubes.empty();
        shape.elementSign = outwardSign(*shape.surface);
        shape.offset = roundRounding(result.round);
        return result;
    }
    DicedMesh diced = shape.surface->dice(rate);
    for (Vec3 &position : diced.positions)
        position = transformPoint(shape.outerFromShape, position);
    shape.flat = hasFlatNormals(*shape.surface, diced);
    shape.curved = shape.away = !diced.vertexUv.empty();
    if (shape.surface->steps() > 1) // It goes anywhere.
        eye = nullptr;
    if (!shape.curved)
        diced.pieces = cutTriangles(diced, eye);
    std::vector<LaterMesh> later;
    for (int step = 1; step < shape.surface->steps(); ++step)
        later.push_back(meshAtStep(*shape.surface->step(step), diced));
    for (const LaterMesh &mesh : later)
        diced.chordError = std::max(diced.chordError, mesh.chordError);
    shape.naming = diced.vertexUv.empty() ? Naming::Direct : Naming::Corners;
    if (shape.naming == Naming::Corners) {
        beginAtBluntCorners(diced);
        shape.triangles = diced.triangles;
        shape.vertexUv = std::move(diced.vertexUv);
        shape.pieces = std::move(diced.pieces);
    }
    shape.elements = std::uint32_t(diced.triangles.size());
    for (LaterMesh &mesh : later) {
        for (Vec3 &position : mesh.positions)
            position = transformPoint(shape.outerFromShape, position);
        result.later.push_back(std::move(mesh.positions));
    }
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
