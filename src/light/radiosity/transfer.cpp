// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/transfer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

constexpr double pi = std::numbers::pi;
/// Senders nearer than so many of their radii are integrated in closed form.
constexpr float nearby = 6;

struct Vec3d {
    double x, y, z;
};
Vec3d cross(Vec3d a, Vec3d b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
double dot(Vec3d a, Vec3d b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

std::span<const Vec3> cornersOf(const Mesh &mesh, int e) {
    return {mesh.element(e).corners.data(), std::size_t(mesh.domainOf(e).domain.triangles ? 3 : 4)};
}

/// Of the Gauss rule: what a node of the sender gives to a point.
float pointFactor(const Vec3 &P, const Vec3 &N, const Node &sender) {
    const Vec3 way = sender.P - P;
    const float squared = candela::dot(way, way);
    const float here = candela::dot(N, way), there = -candela::dot(sender.N, way);
    if (!(here > 0) || !(there > 0) || !(squared > 0))
        return 0;
    return here * there / (float(pi) * squared * squared) * sender.area;
}

} // namespace

double contourFactor(Vec3 P, Vec3 N, std::span<const Vec3> corners, float turned) {
    std::array<Vec3d, 9> line;
    const Vec3d up{N.x, N.y, N.z};
    int count = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        const auto relative = [&](Vec3 p) {
            return Vec3d{double(p.x) - P.x, double(p.y) - P.y, double(p.z) - P.z};
        };
        const Vec3d a = relative(corners[k]), b = relative(corners[(k + 1) % corners.size()]);
        const double above = dot(a, up), next = dot(b, up);
        if (above >= 0)
            line[std::size_t(count++)] = a;
        if ((above < 0) != (next < 0)) {
            const double t = above / (above - next);
            line[std::size_t(count++)] = {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y),
                                          a.z + t * (b.z - a.z)};
        }
    }
    double sum = 0;
    for (int k = 0; k < count; ++k) {
        const Vec3d a = line[std::size_t(k)], b = line[std::size_t((k + 1) % count)];
        const Vec3d normal = cross(a, b);
        const double sine = std::sqrt(dot(normal, normal));
        if (sine > 0)
            sum += dot(normal, up) * (std::atan2(sine, dot(a, b)) / sine);
    }
    return std::max(0.0, -double(turned) * sum / (2 * pi));
}

Transfer transferBetween(const Mesh &mesh, int receiver, int sender) {
    const std::span<const Node> to = mesh.nodes(receiver), from = mesh.nodes(sender);
    const Element &a = mesh.element(receiver), &b = mesh.element(sender);
    const std::span<const Vec3> corners = cornersOf(mesh, sender);
    Transfer transfer;
    transfer.senders = int(from.size());
    const float distance = length(b.centre - a.centre) - a.radius;
    const bool isNear = distance < nearby * b.radius;
    const auto factorAt = [&](Vec3 P, Vec3 N, float *row) {
        float rule = 0;
        for (std::size_t j = 0; j < from.size(); ++j)
            rule += row[j] = pointFactor(P, N, from[j]);
        if (!isNear)
            return rule;
        const float exact = float(contourFactor(P, N, corners, b.turned));
        transfer.senderError = std::max(transfer.senderError, std::fabs(exact - rule));
        // The rule says where on the sender light comes from, the contour how much.
        for (std::size_t j = 0; j < from.size(); ++j)
            row[j] = rule > 0 ? row[j] * (exact / rule) : exact * (from[j].area / b.area);
        return exact;
    };
    std::array<float, mostNodes> factor{};
    for (std::size_t i = 0; i < to.size(); ++i) {
        factor[i] = factorAt(to[i].P, to[i].N, &transfer.kernel[i * from.size()]);
        transfer.largest = std::max(transfer.largest, factor[i]);
    }
    const Basis &basis = mesh.basis(receiver);
    const auto missed = [&](Place at, float found) {
        std::array<float, mostNodes> value;
        basis.values(at, value.data());
        float sum = 0;
        for (std::size_t i = 0; i < to.size(); ++i)
            sum += value[i] * factor[i];
        transfer.receiverError = std::max(transfer.receiverError, std::fabs(found - sum));
    };
    std::array<float, mostNodes> row;
    const Place centre = basis.isTriangle() ? Place{1.0f / 3, 1.0f / 3} : Place{0.5f, 0.5f};
    const float atCentre = factorAt(a.centre, a.normal, row.data());
    transfer.largest = std::max(transfer.largest, atCentre);
    missed(centre, atCentre);
    if (mesh.order() == 1)
        for (std::size_t i = 0; i < to.size(); ++i)
            missed(basis.node(int(i)), factor[i]);
    if (!isNear && distance > 0) {
        const float seen = b.radius / (distance + b.radius);
        transfer.senderError = 0.5f * transfer.largest * seen * seen;
    }
    return transfer;
}

namespace {

bool isBehind(std::span<const Node> nodes, const Mesh &mesh, int other) {
    const Element &element = mesh.element(other);
    for (const Node &node : nodes) {
        const auto sees = [&](Vec3 P) { return candela::dot(node.N, P - node.P) > 0; };
        for (Vec3 corner : cornersOf(mesh, other))
            if (sees(corner))
                return false;
        if (sees(element.centre))
            return false;
    }
    return true;
}

} // namespace

bool areTurnedAway(const Mesh &mesh, int a, int b) {
    return isBehind(mesh.nodes(a), mesh, b) || isBehind(mesh.nodes(b), mesh, a);
}

} // namespace candela::radiosity
