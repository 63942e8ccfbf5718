// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_tree_builder.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace candela {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int binCount = 12;
/// What a cosine weighs where light is hardly possible.
constexpr float leastCosine = 0.01f;
/// Below this depth splits are halves, which need at most 31 levels more.
constexpr int deepestHeuristic = 32;

struct Bound {
    Box3 box;
    Vec3 axis;
    double normal = -1, emission = 0, power = 0; ///< Normal -1 = of nothing.
    bool loose = false;
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
    b.loose = e.isLoose;
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
    a.loose |= b.loose;
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

/// A subtree: the first child follows its parent.
struct Branch {
    Bound bound;
    std::int32_t link; ///< The second child, or ~emitter in a leaf.
};

class Splitter {
public:
    explicit Splitter(std::span<const EmitterBound> emitters) {
        for (const EmitterBound &e : emitters)
            order_.push_back({boundOf(e), std::int32_t(order_.size())});
        branches_.reserve(order_.size() * 2);
        if (!order_.empty())
            build(0, int(order_.size()), 0);
    }
    std::vector<Branch> take() { return std::move(branches_); }

private:
    struct Item {
        Bound bound;
        std::int32_t emitter;
    };

    void build(int first, int last, int depth) {
        Bound all;
        for (int i = first; i < last; ++i)
            add(all, order_[i].bound);
        std::size_t here = branches_.size();
        branches_.push_back({all, ~order_[first].emitter});
        if (last - first == 1)
            return;
        int middle = depth < deepestHeuristic ? split(first, last) : (first + last) / 2;
        build(first, middle, depth + 1);
        branches_[here].link = std::int32_t(branches_.size());
        build(middle, last, depth + 1);
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
    std::vector<Branch> branches_;
};

} // namespace

/// Joins levels of branches to wide nodes.
class LightTreeBuilder {
public:
    LightTreeBuilder(std::span<const EmitterBound> emitters, LightTree &tree)
        : tree_(tree), branches_(Splitter(emitters).take()) {
        if (branches_.empty())
            return;
        tree_.leaves_.resize(emitters.size());
        double strongest = 0;
        for (const Branch &branch : branches_)
            strongest = std::max(strongest, intensityOf(branch.bound));
        tree_.unit_ = strongest > 0 ? strongest : 1;
        tree_.nodes_.reserve(branches_.size() / 8 + 2);
        tree_.nodes_.emplace_back();
        hang(0, 0, 0);
    }

private:
    static constexpr int width = LightTree::Node::width;

    static double intensityOf(const Bound &b) { return b.power > 0 ? b.power / orientation(b) : 0; }

    /// Hangs a branch on a slot of a node, with a node of its own if it's no leaf.
    void hang(std::int32_t branch, std::int32_t node, std::int32_t slot) {
        describe(branches_[branch].bound, tree_.nodes_[node], slot);
        if (branches_[branch].link < 0) {
            tree_.nodes_[node].link[slot] = branches_[branch].link;
            tree_.leaves_[~branches_[branch].link] = {node, slot};
            return;
        }
        const auto own = std::int32_t(tree_.nodes_.size());
        tree_.nodes_[node].link[slot] = own;
        tree_.nodes_.emplace_back();
        tree_.nodes_[own].parent = node, tree_.nodes_[own].slot = slot;
        const std::vector<std::int32_t> children = childrenOf(branch);
        for (std::size_t k = 0; k < children.size(); ++k)
            hang(children[k], own, std::int32_t(k));
    }

    /// The branches below one that are told apart at once: the costliest are opened.
    std::vector<std::int32_t> childrenOf(std::int32_t branch) const {
        std::vector<std::int32_t> children{branch + 1, branches_[branch].link};
        while (children.size() < width) {
            int widest = -1;
            double most = -1;
            for (int k = 0; k < int(children.size()); ++k)
                if (const Branch &b = branches_[children[k]]; b.link >= 0 && cost(b.bound) > most)
                    widest = k, most = cost(b.bound);
            if (widest < 0)
                break;
            const std::int32_t opened = children[widest];
            children[widest] = opened + 1;
            children.insert(children.begin() + widest + 1, branches_[opened].link);
        }
        return children;
    }

    void describe(const Bound &b, LightTree::Node &node, int slot) const {
        if (!(b.power > 0))
            return;
        const Vec3 centre = b.box.centre();
        for (int k = 0; k < 3; ++k) {
            float reach = std::max(b.box.high[k] - centre[k], centre[k] - b.box.low[k]);
            node.centre[k][slot] = centre[k];
            node.half[k][slot] = std::nextafter(reach, Box3::infinity);
            node.axis[k][slot] = b.axis[k];
        }
        node.cosNormal[slot] = float(std::cos(b.normal));
        node.sinNormal[slot] = float(std::sin(b.normal));
        node.cosEmission[slot] = float(std::cos(b.emission));
        node.beyond[slot] = b.loose ? leastCosine : 0;
        node.backs[slot] = b.emission > pi / 2 + 1e-5;
        node.intensity[slot] = float(std::clamp(intensityOf(b) / tree_.unit_, 0x1p-100, 1.0));
    }

    LightTree &tree_;
    std::vector<Branch> branches_;
};

void buildLightTree(std::span<const EmitterBound> emitters, LightTree &tree) {
    LightTreeBuilder(emitters, tree);
}

} // namespace candela
