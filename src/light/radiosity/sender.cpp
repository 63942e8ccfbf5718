// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/sender.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

/// An angle over its sine, within 1e-6 of it. The polynomial is the Chebyshev interpolant on
/// cosines of [0,1].
float angleOverSine(float cosine, float sineSquared) {
    constexpr float coefficients[] = {-0.0266371514f, 0.135951283f, -0.323932017f, 0.509054596f,
                                      -0.648626993f,  0.78329788f,  -0.999903565f, 1.57079558f};
    const float c = std::fabs(cosine);
    float sum = 0;
    for (float coefficient : coefficients)
        sum = sum * c + coefficient;
    return cosine >= 0 ? sum : pi / std::sqrt(std::max(sineSquared, 1e-14f)) - sum;
}

/// Of the Gauss rule: what a node of the sender gives to a point.
float pointFactor(const Vec3 &P, const Vec3 &N, const Node &sender) {
    const Vec3 way = sender.P - P;
    const float squared = dot(way, way);
    const float here = dot(N, way), there = -dot(sender.N, way);
    if (!(here > 0) || !(there > 0) || !(squared > 0))
        return 0;
    return here * there / (pi * squared * squared) * sender.area;
}

} // namespace

std::span<const Vec3> cornersOf(const Mesh &mesh, int e) {
    return {mesh.element(e).corners.data(), std::size_t(mesh.domainOf(e).domain.triangles ? 3 : 4)};
}

float contourFactor(Vec3 P, Vec3 N, std::span<const Vec3> corners, float turned) {
    std::array<Vec3, 9> line;
    std::size_t count = 0;
    Vec3 from = corners.back() - P;
    float above = dot(from, N);
    for (Vec3 corner : corners) {
        const Vec3 to = corner - P;
        const float next = dot(to, N);
        if ((above < 0) != (next < 0))
            line[count++] = normalize(from + (to - from) * (above / (above - next)));
        if (next >= 0)
            line[count++] = normalize(to);
        from = to, above = next;
    }
    if (count == 0)
        return 0;
    float sum = 0;
    Vec3 a = line[count - 1];
    for (std::size_t k = 0; k < count; ++k) {
        const Vec3 b = line[k];
        const Vec3 normal = cross(a, b);
        sum += dot(normal, N) * angleOverSine(dot(a, b), dot(normal, normal));
        a = b;
    }
    return std::max(0.0f, -turned * sum / (2 * pi));
}

Node between(const Basis &shape, const Node *nodes, Place at) {
    std::array<float, mostNodes> value;
    shape.values(at, value.data());
    Node result;
    for (int i = 0; i < shape.nodes(); ++i) {
        result.P += nodes[i].P * value[std::size_t(i)];
        result.N += nodes[i].N * value[std::size_t(i)];
        result.area += nodes[i].area / shape.weight(i) * value[std::size_t(i)];
    }
    result.N = normalize(result.N);
    return result;
}

const Basis &shapeOf(const Mesh &mesh, int e) {
    return Basis::of(mesh.basis(e).isTriangle(), std::max(2, mesh.order()));
}

Place inParent(const Basis::ChildPlace &child, Place own) {
    return {child.origin.u + child.scale * own.u, child.origin.v + child.scale * own.v};
}

Sender::Sender(const Mesh &mesh, int e) {
    const Element &element = mesh.element(e);
    for (const Node &node : mesh.nodes(e))
        nodes[std::size_t(count++)] = node;
    corners = element.corners, sides = cornersOf(mesh, e).size();
    area = element.area, turned = element.turned, fullness = element.fullness;
    isPlane = element.isPlane;
}

float Sender::factor(Vec3 P, Vec3 N, bool byContour, float *row, float &missed) const {
    float rule = 0;
    for (int j = 0; j < count; ++j)
        rule += row[j] = pointFactor(P, N, nodes[std::size_t(j)]);
    if (!byContour || !isPlane)
        return rule;
    const float exact = fullness * contourFactor(P, N, std::span(corners).first(sides), turned);
    missed = std::max(missed, std::fabs(exact - rule));
    for (int j = 0; j < count; ++j)
        row[j] = rule > 0 ? row[j] * (exact / rule) : exact * (nodes[std::size_t(j)].area / area);
    return exact;
}

std::array<Sender, 4> Sender::quartersOf(const Mesh &mesh, int e) {
    const Sender whole(mesh, e);
    std::array<Sender, 4> quarters{whole, whole, whole, whole};
    const Basis &basis = mesh.basis(e), &shape = shapeOf(mesh, e);
    const std::span<const Place> corner = Basis::corners(basis.isTriangle());
    for (int c = 0; c < Basis::children; ++c) {
        Sender &quarter = quarters[std::size_t(c)];
        const Basis::ChildPlace child = Basis::child(basis.isTriangle(), c);
        quarter.area = 0;
        for (int k = 0; k < basis.nodes(); ++k) {
            Node &node = quarter.nodes[std::size_t(k)];
            node = between(shape, whole.nodes.data(), inParent(child, basis.node(k)));
            node.area *= basis.weight(k) / 4;
            quarter.area += node.area;
        }
        for (std::size_t k = 0; k < whole.sides; ++k) {
            const Place at = inParent(child, corner[k]);
            const std::array<Vec3, 4> &p = whole.corners;
            quarter.corners[k] = basis.isTriangle()
                                     ? p[0] * (1 - at.u - at.v) + p[1] * at.u + p[2] * at.v
                                     : (p[0] * (1 - at.u) + p[1] * at.u) * (1 - at.v) +
                                           (p[3] * (1 - at.u) + p[2] * at.u) * at.v;
        }
    }
    return quarters;
}

} // namespace candela::radiosity
