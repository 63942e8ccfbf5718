// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_tree_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int binCount = 12;
/// Below this depth splits are halves, which need at most 31 levels more.
constexpr int deepestHeuristic = 32;

struct Bound {
    Box3 box;
    Vec3 axis;
    double normal = -1, emission = 0, power = 0; ///< Normal -1 = of nothing.
};

bool isSound(Vec3 v) {
    return isFinite(v) && std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}) < 1e18f;
}

/// Broken input becomes what bounds it safely, or black.
Bound boundOf(const EmitterBound &e) {
    Bound b;
    bool placed = !e.box.empty() && isSound(e.box.low) && isSound(e.box.high);
    b.box = placed ? e.box : Box3{{0, 0, 0}, {0, 0, 0}};
    b.power = placed && e.power > 0 && std::isfinite(e.power) ? e.power : 0;
    b.axis = isFinite(e.axis) ? normalize(e.axis) : Vec3{};
    bool directed = dot(b.axis, b.axis) > 0.5f && e.normalSpread >= 0;
    if (!directed)
        b.axis = {0, 0, 1};
    b.normal = directed ? std::min<double>(e.normalSpread, pi) : pi;
    b.emission = e.emissionSpread >= 0 ? std::min<double>(e.emissionSpread, pi) : pi;
    return b;
}

/// The smallest cone about two cones, by turning the wider one's axis towards the other.
void addCone(Bound &a, Vec3 axis, double normal) {
    if (a.normal < 0 || normal >= pi) {
        a.axis = axis, a.normal = normal;
        return;
    }
    if (a.normal >= pi || (a.axis == axis && normal <= a.normal))
        return;
    Vec3 wideAxis = a.axis, otherAxis = axis;
    double wide = a.normal, other = normal;
    if (wide < other)
        std::swap(wide, other), std::swap(wideAxis, otherAxis);
    double between = std::acos(std::clamp<double>(dot(wideAxis, otherAxis), -1, 1));
    a.axis = wideAxis, a.normal = wide;
    if (between + other <= wide)
        return;
    // The turned axis is a rounded float; the cone is opened a little to cover that.
    double spread = (wide + between + other) / 2 + 1e-6, turn = spread - wide;
    Vec3 across = otherAxis - wideAxis * dot(wideAxis, otherAxis);
    if (spread >= pi || !(dot(across, across) > 1e-12f)) {
        a.normal = spread >= pi || between > 1 ? pi : spread + turn;
        return;
    }
    a.axis =
        normalize(wideAxis * float(std::cos(turn)) + normalize(across) * float(std::sin(turn)));
    a.normal = spread;
}

void add(Bound &a, const Bound &b) {
    if (!(b.power > 0)) // Black: bounds nothing.
        return;
    a.box.add(b.box);
    addCone(a, b.axis, b.normal);
    a.emission = std::max(a.emission, b.emission);
    a.power += b.power;
}

double area(const Box3 &box) {
    Vec3 e = box.extent();
    return 2 * (double(e.x) * e.y + double(e.y) * e.z + double(e.z) * e.x);
}

/// The solid angle, weighted by a cosine past the normals, that a bound may light; emission past
/// a right angle counts as that of a second side.
double orientation(const Bound &b) {
    double o = b.normal, w = std::min(o + std::min(b.emission, pi / 2), pi);
    double side =
        2 * pi * (1 - std::cos(o)) +
        pi / 2 * (2 * w * std::sin(o) - std::cos(o - 2 * w) - 2 * o * std::sin(o) + std::cos(o));
    bool bothSides = b.emission > pi / 2 + 1e-5;
    return std::clamp(bothSides ? 2 * side : side, 1e-3, 4 * pi);
}

double cost(const Bound &b) { return b.power > 0 ? b.power * area(b.box) * orientation(b) : 0; }

class Builder {
public:
    Builder(std::span<const EmitterBound> emitters, std::vector<LightTree::Node> &nodes,
            std::vector<std::uint64_t> &trails)
        : nodes_(nodes), trails_(trails) {
        for (const EmitterBound &e : emitters)
            order_.push_back({boundOf(e), std::int32_t(order_.size())});
        nodes_.reserve(order_.size() * 2);
        trails_.resize(order_.size());
        if (!order_.empty())
            build(0, int(order_.size()), 0, 0);
    }

private:
    struct Item {
        Bound bound;
        std::int32_t emitter;
    };

    void build(int first, int last, int depth, std::uint64_t trail) {
        Bound all;
        for (int i = first; i < last; ++i)
            add(all, order_[i].bound);
        std::size_t here = nodes_.size();
        nodes_.push_back(nodeOf(all));
        if (last - first == 1) {
            nodes_[here].link = ~order_[first].emitter;
            trails_[order_[first].emitter] = trail;
            return;
        }
        int middle = depth < deepestHeuristic ? split(first, last) : (first + last) / 2;
        build(first, middle, depth + 1, trail);
        nodes_[here].link = std::int32_t(nodes_.size());
        build(middle, last, depth + 1, trail | std::uint64_t(1) << depth);
    }

    static LightTree::Node nodeOf(const Bound &b) {
        LightTree::Node node{};
        if (!(b.power > 0))
            return node;
        node.centre = b.box.centre();
        for (int k = 0; k < 3; ++k) {
            float reach = std::max(b.box.high[k] - node.centre[k], node.centre[k] - b.box.low[k]);
            node.half[k] = std::nextafter(reach, Box3::infinity);
        }
        node.axis = b.axis;
        node.cosNormal = float(std::cos(b.normal)), node.sinNormal = float(std::sin(b.normal));
        node.cosEmission = float(std::cos(b.emission));
        node.intensity = float(std::clamp(b.power / orientation(b), 0x1p-126, 3e38));
        return node;
    }

    /// Bins along the longest axis of the centres; halves where that tells nothing apart.
    int split(int first, int last) {
        Box3 centres;
        for (int i = first; i < last; ++i)
            centres.add(order_[i].bound.box.centre());
        Vec3 e = centres.extent();
        int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
        if (!(e[axis] > 0))
            return (first + last) / 2;
        auto binOf = [&](const Item &item) {
            double at = (item.bound.box.centre()[axis] - double(centres.low[axis])) / e[axis];
            return std::clamp(int(at * binCount), 0, binCount - 1);
        };
        std::array<Bound, binCount> bins;
        for (int i = first; i < last; ++i)
            add(bins[binOf(order_[i])], order_[i].bound);
        int best = bestCut(bins);
        auto middle = std::stable_partition(order_.begin() + first, order_.begin() + last,
                                            [&](const Item &i) { return binOf(i) <= best; });
        int at = int(middle - order_.begin());
        return at > first && at < last ? at : (first + last) / 2;
    }

    static int bestCut(const std::array<Bound, binCount> &bins) {
        std::array<double, binCount> above{};
        Bound sum;
        for (int b = binCount - 1; b > 0; --b)
            add(sum, bins[b]), above[b - 1] = cost(sum);
        sum = {};
        int best = binCount / 2 - 1;
        double least = std::numeric_limits<double>::infinity();
        for (int b = 0; b + 1 < binCount; ++b) {
            add(sum, bins[b]);
            if (double c = cost(sum) + above[b]; c < least)
                least = c, best = b;
        }
        return best;
    }

    std::vector<Item> order_;
    std::vector<LightTree::Node> &nodes_;
    std::vector<std::uint64_t> &trails_;
};

} // namespace

void buildLightTree(std::span<const EmitterBound> emitters, std::vector<LightTree::Node> &nodes,
                    std::vector<std::uint64_t> &trails) {
    Builder(emitters, nodes, trails);
}

} // namespace candela
