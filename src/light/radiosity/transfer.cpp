// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/transfer.h"

#include "light/radiosity/rectangle_factor.h"

#include <algorithm>
#include <cmath>

namespace candela::radiosity {

namespace {

/// Senders nearer than so many of their radii are integrated in closed form.
constexpr float nearby = 6;
/// Receivers whose basis misses more of what they get than this share of it take a finer rule.
constexpr float roughly = 0.01f;
/// Points that are no higher over an element than this share of its radius lie on it.
constexpr float touching = 1e-4f;

/// What nodes of a hollow element give to themselves is what the others give, on average.
void completeDiagonal(const Sender &from, Transfer &transfer) {
    for (int i = 0; i < from.count; ++i) {
        float sum = 0;
        for (int j = 0; j < from.count; ++j)
            if (j != i)
                sum += transfer(i, j) / from.nodes[std::size_t(j)].area;
        transfer.kernel[std::size_t(i * transfer.senders + i)] =
            sum / float(from.count - 1) * from.nodes[std::size_t(i)].area;
    }
}

} // namespace

Transfer transferBetween(const Mesh &mesh, int receiver, int sender) {
    const std::span<const Node> to = mesh.nodes(receiver);
    const Element &a = mesh.element(receiver), &b = mesh.element(sender);
    Transfer transfer;
    const Sender from(mesh, sender);
    transfer.senders = from.count;
    const float distance = length(b.centre - a.centre) - a.radius;
    transfer.isNear = distance < nearby * b.radius;
    float missedByRule = 0;
    std::array<float, mostNodes> factor{};
    for (std::size_t i = 0; i < to.size(); ++i) {
        factor[i] = from.factor(to[i].P, to[i].N, transfer.isNear,
                                &transfer.kernel[i * std::size_t(from.count)], missedByRule);
        transfer.largest = std::max(transfer.largest, factor[i]);
    }
    if (receiver == sender)
        completeDiagonal(from, transfer);
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
    const float atCentre =
        from.factor(a.centre, a.normal, transfer.isNear, row.data(), missedByRule);
    transfer.largest = std::max(transfer.largest, atCentre);
    missed(Basis::centre(basis.isTriangle()), atCentre);
    if (mesh.order() == 1)
        for (std::size_t i = 0; i < to.size(); ++i)
            missed(basis.node(int(i)), factor[i]);
    const float seen = b.radius / (std::max(distance, 0.0f) + b.radius);
    transfer.curvature = transfer.largest * seen * seen;
    transfer.senderError = transfer.isNear ? missedByRule : 0.5f * transfer.curvature;
    return transfer;
}

namespace {

/// A point of an element's border.
struct BorderPoint {
    Place at;
    Vec3 P;
};

/// The corners, and, where the border is straight, its point that is nearest to `to`.
int borderPoints(const Mesh &mesh, int e, Vec3 to, std::array<BorderPoint, 5> &points) {
    const std::span<const Vec3> corners = cornersOf(mesh, e);
    const std::span<const Place> places = Basis::corners(mesh.basis(e).isTriangle());
    int count = 0;
    float least = INFINITY;
    BorderPoint nearest;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        points[std::size_t(count++)] = {places[k], corners[k]};
        const std::size_t next = (k + 1) % corners.size();
        const Vec3 edge = corners[next] - corners[k];
        const float squared = std::max(dot(edge, edge), 1e-30f);
        const float share = std::clamp(dot(to - corners[k], edge) / squared, 0.0f, 1.0f);
        const Vec3 P = corners[k] + edge * share;
        if (const float distance = length(P - to); distance < least) {
            least = distance;
            nearest = {{places[k].u + share * (places[next].u - places[k].u),
                        places[k].v + share * (places[next].v - places[k].v)},
                       P};
        }
    }
    if (mesh.element(e).isPlane)
        points[std::size_t(count++)] = nearest;
    return count;
}

} // namespace

float errorAtBorder(const Mesh &mesh, int receiver, int sender, const Transfer &transfer) {
    const Element &a = mesh.element(receiver), &b = mesh.element(sender);
    if (receiver == sender || length(b.centre - a.centre) > nearby * (a.radius + b.radius))
        return transfer.receiverError;
    const Sender from(mesh, sender);
    const Basis &basis = mesh.basis(receiver);
    std::array<BorderPoint, 5> points;
    const int count = borderPoints(mesh, receiver, b.centre, points);
    float worst = transfer.receiverError, missed = 0;
    std::array<float, mostNodes> row, value;
    for (int k = 0; k < count; ++k) {
        const auto &[at, border] = points[std::size_t(k)];
        basis.values(at, value.data());
        float told = 0;
        for (int i = 0; i < basis.nodes(); ++i)
            for (int j = 0; j < transfer.senders; ++j)
                told += value[std::size_t(i)] * transfer(i, j);
        const Vec3 N = between(shapeOf(mesh, receiver), mesh.nodes(receiver).data(), at).N;
        // A little inside: on the very edge the factor jumps. Of large elements that lie close to
        // each other only what is closer to the border sees anything of it.
        const float height = std::fabs(dot(b.normal, border - b.centre));
        const float near = height > touching * b.radius ? std::min(b.radius, height) : b.radius;
        const float inside = 0.1f * std::min(1.0f, near / a.radius);
        const Vec3 P = border + (a.centre - border) * inside;
        worst = std::max(worst,
                         std::fabs(from.factor(P, N, transfer.isNear, row.data(), missed) - told));
    }
    return worst;
}

void refineKernel(const Mesh &mesh, int receiver, int sender, Transfer &transfer) {
    const float rough = roughly * transfer.largest;
    // Polynomials on what something stands on lead across it.
    const bool finerReceiver = transfer.receiverError > rough && !mesh.element(receiver).isCut;
    const bool finerSender =
        transfer.isNear && transfer.senderError > rough && !mesh.element(sender).isCut;
    if (receiver == sender || (!finerReceiver && !finerSender))
        return;
    const std::array<Sender, 4> quarters = Sender::quartersOf(mesh, sender);
    const Sender whole(mesh, sender);
    const Basis &from = mesh.basis(sender), &to = mesh.basis(receiver);
    const auto rowAt = [&](const Node &at, float *row) {
        float ignored = 0;
        if (!finerSender)
            return void(whole.factor(at.P, at.N, transfer.isNear, row, ignored));
        std::fill_n(row, whole.count, 0.0f);
        std::array<float, mostNodes> part;
        for (int c = 0; c < Basis::children; ++c) {
            quarters[std::size_t(c)].factor(at.P, at.N, true, part.data(), ignored);
            for (int k = 0; k < from.nodes(); ++k)
                for (int j = 0; j < from.nodes(); ++j)
                    row[j] += from.toChild(c, k, j) * part[std::size_t(k)];
        }
    };
    const std::span<const Node> nodes = mesh.nodes(receiver);
    std::array<float, mostNodes> row;
    if (!finerReceiver) {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            rowAt(nodes[i], &transfer.kernel[i * std::size_t(transfer.senders)]);
        return;
    }
    transfer.kernel.fill(0);
    for (int c = 0; c < Basis::children; ++c)
        for (int k = 0; k < to.nodes(); ++k) {
            rowAt(between(shapeOf(mesh, receiver), nodes.data(),
                          inParent(Basis::child(to.isTriangle(), c), to.node(k))),
                  row.data());
            for (int i = 0; i < to.nodes(); ++i)
                for (int j = 0; j < transfer.senders; ++j)
                    transfer.kernel[std::size_t(i * transfer.senders + j)] +=
                        to.fromChild(c, i, k) * row[std::size_t(j)];
        }
}

void completeKernel(const Mesh &mesh, int receiver, int sender, Transfer &transfer) {
    if (!transfer.isNear || !mesh.element(receiver).isPlane || !mesh.element(sender).isPlane)
        return;
    const std::optional<double> exact =
        rectangleFactor(cornersOf(mesh, receiver), cornersOf(mesh, sender));
    const std::span<const Node> nodes = mesh.nodes(receiver);
    double told = 0;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (int j = 0; j < transfer.senders; ++j)
            told += double(transfer(int(i), j)) * nodes[i].area / mesh.element(receiver).area;
    if (!exact || !(told > 0))
        return;
    for (float &value : transfer.kernel)
        value *= float(*exact / told);
}

namespace {

/// Of coordinates: the two sides of a plane, and planes that go on beside each other, are no
/// higher.
constexpr float roundings = 8 * 0x1p-24f;

bool isBehind(std::span<const Node> nodes, const Mesh &mesh, int other) {
    const Element &element = mesh.element(other);
    for (const Node &node : nodes) {
        const float rounding = roundings * std::max({std::fabs(node.P.x), std::fabs(node.P.y),
                                                     std::fabs(node.P.z), element.radius});
        const auto sees = [&](Vec3 P) { return dot(node.N, P - node.P) > rounding; };
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
