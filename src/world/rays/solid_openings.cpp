// SPDX-License-Identifier: Apache-2.0
// Bodies that are none: lines through what bounds a body come out of it as often as they go in.
#include "world/rays/solid_tracer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr int linesOfShape = 32;
/// Some rays slip through bodies that are closed for all that is seen of them.
constexpr double bearable = 0.05;

/// Number k of a sequence that fills [0,1) evenly.
float evenly(int k, double step) {
    const double sum = (k + 0.5) * step;
    return float(sum - std::floor(sum));
}

/// Through a point of the shape, and not along it: where rays graze, rounding decides.
struct Line {
    Vec3 through, direction; ///< In the shape's own space.
};

Vec3 onUnitSphere(int k) {
    const float z = 2 * evenly(k, 0.6180339887) - 1, r = std::sqrt(std::max(0.0f, 1 - z * z));
    const float turn = 2 * std::numbers::pi_v<float> * evenly(k, 0.4142135624);
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// k counts lines.
Line lineOf(const RayShape &shape, int k) {
    const auto number =
        std::size_t(double(evenly(k, 0.7548776662)) * double(shape.triangles.size()));
    const auto &[a, b, c] = shape.triangles[std::min(number, shape.triangles.size() - 1)];
    float u = evenly(k, 0.5698402910), v = evenly(k, 0.3819660113);
    if (u + v > 1)
        u = 1 - u, v = 1 - v;
    const Vec3 corner = shape.positions[a];
    const Vec3 edgeB = shape.positions[b] - corner, edgeC = shape.positions[c] - corner;
    return {corner + edgeB * u + edgeC * v,
            normalize(cross(edgeB, edgeC)) * 1.5f + onUnitSphere(k)};
}

float diagonalOf(RTCScene scene) {
    RTCBounds box;
    rtcGetSceneBounds(scene, &box);
    return length(
        Vec3{box.upper_x - box.lower_x, box.upper_y - box.lower_y, box.upper_z - box.lower_z});
}

} // namespace

std::vector<std::int32_t> SolidTracer::findOpenNodes(std::span<const PlacedShapes> members) const {
    std::vector<int> lines(expression_.size()), odd(expression_.size());
    const float far = 2 * diagonalOf(bodies_);
    std::vector<SolidCrossing> crossings;
    SolidExpression::State state;
    int number = 0;
    std::size_t part = 0;
    for (const PlacedShapes &member : members)
        for (const RayShape &shape : member.shapes) {
            const auto node = std::size_t(parts_[part++].node);
            if (shape.triangles.empty()) // What is round is whole.
                continue;
            for (int k = 0; k < linesOfShape; ++k, ++number) {
                const Line line = lineOf(shape, number);
                const Matrix4 &matrix = member.currentFromObject;
                const Vec3 through = transformPoint(matrix, line.through) * unit_;
                const Vec3 direction = normalize(transformVector(matrix, line.direction));
                crossings.clear();
                findCrossings({through - direction * far, direction, 0, 0}, crossings);
                passAll(expression_, parts_, crossings, state, [](auto &&...) {});
                ++lines[node], odd[node] += state.isInsideOwn(std::int32_t(node));
            }
        }
    std::vector<std::int32_t> open;
    for (std::size_t node = 0; node < lines.size(); ++node)
        if (odd[node] > bearable * lines[node])
            open.push_back(std::int32_t(node));
    return open;
}

} // namespace candela
