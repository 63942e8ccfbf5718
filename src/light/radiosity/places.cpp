// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/places.h"

#include <algorithm>

namespace candela::radiosity {

namespace {

/// So many levels above its leaf nodes are looked for that a point can reach; beyond, it lies in a
/// gap that no node has seen.
constexpr int mostLevels = 3;

int ancestorOf(const Mesh &mesh, int e, int levels) {
    for (; levels > 0 && mesh.element(e).parent >= 0; --levels)
        e = mesh.element(e).parent;
    return e;
}

template <class Serve> void forEachLeaf(const Mesh &mesh, int e, const Serve &serve) {
    const int child = mesh.element(e).firstChild;
    if (child < 0)
        return serve(e);
    for (int c = 0; c < Basis::children; ++c)
        forEachLeaf(mesh, child + c, serve);
}

} // namespace

void NodeWeights::ofLeaf(int stride, float *value) const {
    std::fill_n(value, stride, 0.0f);
    float sum = 0;
    for (std::size_t i = 0; i < std::size_t(count); ++i)
        if (node[i] / stride == leaf)
            value[node[i] % stride] = weight[i], sum += weight[i];
    for (int i = 0; i < stride; ++i)
        value[i] /= sum;
}

void PlaceLookup::add(const Mesh &mesh, std::int32_t face, Place place, Vec3 P) {
    Point &point = points_.emplace_back();
    point.own = mesh.leafAt(face, place), point.P = P;
    if (point.own < 0)
        return;
    const Basis &basis = mesh.basis(point.own);
    NodeWeights &found = point.found;
    found.count = basis.nodes(), found.leaf = point.own;
    basis.values(place, found.weight.data());
    for (int i = 0; i < found.count; ++i)
        found.node[std::size_t(i)] = point.own * mesh.stride() + i;
}

void PlaceLookup::find(const Mesh &mesh) {
    std::vector<std::size_t> waiting;
    for (std::size_t p = 0; p < points_.size(); ++p)
        if (points_[p].own >= 0 && mesh.element(points_[p].own).isCut)
            waiting.push_back(p);
    for (int levels = 0; levels <= mostLevels && !waiting.empty(); ++levels) {
        look(mesh, levels, waiting);
        take(mesh, waiting);
    }
}

/// Which nodes the waiting points reach, among those below an element that many levels above.
void PlaceLookup::look(const Mesh &mesh, int levels, const std::vector<std::size_t> &waiting) {
    candidates_.clear(), isReached_.clear();
    const auto trace = [&] {
        rays_.trace(mesh.scene());
        for (int i = 0; i < rays_.count(); ++i)
            isReached_.push_back(!rays_.isStopped(i));
        rays_.clear();
    };
    rays_.clear();
    for (const std::size_t p : waiting) {
        const Point &point = points_[p];
        forEachLeaf(mesh, ancestorOf(mesh, point.own, levels), [&](int leaf) {
            const std::span<const Node> nodes = mesh.nodes(leaf);
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                candidates_.push_back(
                    {p, leaf * mesh.stride() + std::int32_t(i), length(nodes[i].P - point.P)});
                rays_.add(mesh, point.own, point.P, nodes[i].P);
                if (rays_.isFull())
                    trace();
            }
        });
    }
    trace();
}

/// Points that reach all of their leaf's nodes are as they were; others take the nearest ones that
/// they reach, by inverse squares of distances. Those that reach none go on waiting.
void PlaceLookup::take(const Mesh &mesh, std::vector<std::size_t> &waiting) {
    std::vector<Candidate> reached;
    std::vector<std::size_t> still;
    for (std::size_t at = 0; at < candidates_.size();) {
        const std::size_t p = candidates_[at].point;
        reached.clear();
        std::size_t all = 0;
        for (; at < candidates_.size() && candidates_[at].point == p; ++at, ++all)
            if (isReached_[at])
                reached.push_back(candidates_[at]);
        Point &point = points_[p];
        const std::size_t own = mesh.nodes(point.own).size();
        if (reached.empty())
            still.push_back(p);
        if (reached.empty() || (reached.size() == all && all == own))
            continue;
        std::ranges::stable_sort(reached, {}, &Candidate::distance);
        reached.resize(std::min(reached.size(), own));
        const float smallest = 1e-6f * mesh.element(point.own).radius;
        float sum = 0;
        point.found.count = int(reached.size());
        point.found.leaf = reached.front().node / mesh.stride();
        for (std::size_t i = 0; i < reached.size(); ++i) {
            const float distance = std::max(reached[i].distance, smallest);
            point.found.node[i] = reached[i].node;
            sum += point.found.weight[i] = 1 / (distance * distance);
        }
        for (std::size_t i = 0; i < reached.size(); ++i)
            point.found.weight[i] /= sum;
    }
    waiting.swap(still);
}

} // namespace candela::radiosity
