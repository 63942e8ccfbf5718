// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/cluster_links.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// What of the largest irradiance that a cluster may cause it gets wrong, as a whole.
constexpr float wrong = 0.3f;
/// Ends of links are no larger than this share of their distance.
constexpr float widest = 0.4f;

/// Of one element: exitance times area.
Color powerOf(const Mesh &mesh, int element, const std::vector<Color> &exitance) {
    Color sum{};
    const std::span<const Node> nodes = mesh.nodes(element);
    const std::size_t first = std::size_t(element) * std::size_t(mesh.stride());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += std::max(exitance[first + i][k], 0.0f) * nodes[i].area;
    return sum;
}

/// Radiant intensity of an element's nodes, W sr^-1.
Color intensityOf(const Mesh &mesh, int element, Vec3 direction,
                  const std::vector<Color> &exitance) {
    Color sum{};
    const std::span<const Node> nodes = mesh.nodes(element);
    const std::size_t first = std::size_t(element) * std::size_t(mesh.stride());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const float seen = std::max(dot(nodes[i].N, direction), 0.0f) * nodes[i].area / pi;
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += exitance[first + i][k] * seen;
    }
    return sum;
}

} // namespace

ClusterOracle::ClusterOracle(const Mesh &mesh, const ClusterTree &tree,
                             const std::vector<Color> &exitance, double tolerance)
    : mesh_(mesh), tree_(tree), exitance_(exitance), tolerance_(tolerance),
      power_(tree.power(mesh, exitance)) {}

Vec3 ClusterOracle::centre(int end) const {
    return isCluster(end) ? tree_.clusters()[std::size_t(~end)].centre : mesh_.element(end).centre;
}

float ClusterOracle::radius(int end) const {
    return isCluster(end) ? tree_.clusters()[std::size_t(~end)].radius : mesh_.element(end).radius;
}

float ClusterOracle::area(int end) const {
    return isCluster(end) ? tree_.clusters()[std::size_t(~end)].area : mesh_.element(end).area;
}

Color ClusterOracle::power(int end) const {
    return isCluster(end) ? power_[std::size_t(~end)] : powerOf(mesh_, end, exitance_);
}

bool ClusterOracle::sends(int end) const { return brightest(power(end)) > 0; }

bool ClusterOracle::mayLink(const Pair &pair, bool all) const {
    const float between = length(centre(pair.sender) - centre(pair.receiver));
    const float a = radius(pair.receiver), b = radius(pair.sender);
    const float distance = between - a - b;
    if (!(distance > 0) || std::max(a, b) > widest * between || !(tolerance_ > 0))
        return false;
    const double largest = brightest(power(pair.sender)) / (pi * distance * distance);
    return all || largest * wrong * area(pair.receiver) < tolerance_;
}

void ClusterOracle::open(int cluster, std::vector<int> &ends) const {
    ends.clear();
    const int child = tree_.clusters()[std::size_t(~cluster)].firstChild;
    if (child >= 0)
        ends = {~child, ~(child + 1)};
    else
        for (int root : tree_.rootsOf(~cluster))
            ends.push_back(root);
}

int ClusterOracle::someRoot(int end, std::size_t look) const {
    if (!isCluster(end))
        return end;
    const std::span<const int> roots = tree_.rootsOf(~end);
    return roots[(2 * look + 1) * roots.size() / (2 * looks)];
}

void ClusterOracle::look(const Pair &pair, std::vector<Pair> &pairs) const {
    for (std::size_t k = 0; k < looks; ++k)
        pairs.push_back({someRoot(pair.receiver, k), someRoot(pair.sender, looks - 1 - k)});
}

Color meanVisibility(std::span<const Visibility> looks) {
    Color sum{};
    int rays = 0;
    for (const Visibility &look : looks) {
        rays += look.rays;
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += look.mean[k] * float(look.rays);
    }
    for (float &value : sum)
        value = rays > 0 ? value / float(rays) : 0;
    return sum;
}

void gatherFromClusters(const Mesh &mesh, const ClusterTree &tree,
                        std::span<const ClusterLink> links, const std::vector<Color> &exitance,
                        std::vector<Color> &irradiance) {
    if (links.empty())
        return;
    const std::vector<Directional> sent = tree.sent(mesh, exitance);
    std::vector<Directional> received(tree.clusters().size());
    const auto cluster = [&](int end) -> const Cluster & {
        return tree.clusters()[std::size_t(~end)];
    };
    for (const ClusterLink &link : links) {
        const bool toCluster = isCluster(link.receiver), fromCluster = isCluster(link.sender);
        const Vec3 from =
            fromCluster ? cluster(link.sender).centre : mesh.element(link.sender).centre;
        /// Irradiance across the way from the sender to a point.
        const auto arriving = [&](Vec3 P, Vec3 &direction) {
            const Vec3 way = from - P;
            const float squared = dot(way, way);
            direction = way / std::sqrt(squared);
            Color value = fromCluster ? sent[std::size_t(~link.sender)].cosineAt(-direction)
                                      : intensityOf(mesh, link.sender, -direction, exitance);
            for (std::size_t k = 0; k < colorSamples; ++k)
                value[k] *= link.visibility[k] / squared;
            return value;
        };
        Vec3 direction;
        if (toCluster) {
            const Color value = arriving(cluster(link.receiver).centre, direction);
            received[std::size_t(~link.receiver)].add(direction, value);
            continue;
        }
        const std::span<const Node> nodes = mesh.nodes(link.receiver);
        const std::size_t first = std::size_t(link.receiver) * std::size_t(mesh.stride());
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const Color value = arriving(nodes[i].P, direction);
            const float cosine = std::max(dot(nodes[i].N, direction), 0.0f);
            for (std::size_t k = 0; k < colorSamples; ++k)
                irradiance[first + i][k] += cosine * value[k];
        }
    }
    tree.distribute(mesh, std::move(received), irradiance);
}

} // namespace candela::radiosity
