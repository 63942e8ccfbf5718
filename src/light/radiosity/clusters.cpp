// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/clusters.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Faces of a cluster that has no children.
constexpr std::size_t fewFaces = 4;
/// What the clamped cosine makes of harmonics of order 0, 1 and 2.
constexpr float cosineOf[harmonics] = {pi,     2 * pi / 3, 2 * pi / 3, 2 * pi / 3, pi / 4,
                                       pi / 4, pi / 4,     pi / 4,     pi / 4};

} // namespace

std::array<float, harmonics> harmonicsOf(Vec3 d) {
    static const float zero = std::sqrt(1 / (4 * pi)), one = std::sqrt(3 / (4 * pi));
    static const float two = std::sqrt(15 / (4 * pi)), axial = std::sqrt(5 / (16 * pi));
    return {zero,
            one * d.y,
            one * d.z,
            one * d.x,
            two * d.x * d.y,
            two * d.y * d.z,
            axial * (3 * d.z * d.z - 1),
            two * d.x * d.z,
            two / 2 * (d.x * d.x - d.y * d.y)};
}

void Directional::add(Vec3 direction, const Color &value) {
    const std::array<float, harmonics> Y = harmonicsOf(direction);
    for (std::size_t l = 0; l < harmonics; ++l)
        for (std::size_t k = 0; k < colorSamples; ++k)
            coefficients[l][k] += Y[l] * value[k];
}

void Directional::add(const Directional &other, const Color &factor) {
    for (std::size_t l = 0; l < harmonics; ++l)
        for (std::size_t k = 0; k < colorSamples; ++k)
            coefficients[l][k] += factor[k] * other.coefficients[l][k];
}

Color Directional::cosineAt(Vec3 normal) const {
    const std::array<float, harmonics> Y = harmonicsOf(normal);
    Color sum{};
    for (std::size_t l = 0; l < harmonics; ++l)
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += cosineOf[l] * Y[l] * coefficients[l][k];
    for (float &value : sum)
        value = std::max(value, 0.0f);
    return sum;
}

ClusterTree::ClusterTree(const Mesh &mesh) {
    // Sides apart: the inside of a body has nothing to do with what shines on it.
    std::size_t fronts = 0;
    for (bool isBack : {false, true}) {
        for (const Face &face : mesh.faces())
            if (face.root >= 0 && face.isBack == isBack)
                order_.push_back(face.root);
        if (!isBack)
            fronts = order_.size();
    }
    clusters_.emplace_back();
    if (!order_.empty())
        build(mesh, 0, order_.size(), fronts, 0);
}

/// Across the longest axis. Ties by number: the order is the same everywhere.
void ClusterTree::split(const Mesh &mesh, std::size_t first, std::size_t middle, std::size_t last,
                        Vec3 size) {
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    std::nth_element(
        order_.begin() + std::ptrdiff_t(first), order_.begin() + std::ptrdiff_t(middle),
        order_.begin() + std::ptrdiff_t(last), [&](int a, int b) {
            const float x = mesh.element(a).centre[axis], y = mesh.element(b).centre[axis];
            return x != y ? x < y : a < b;
        });
}

int ClusterTree::build(const Mesh &mesh, std::size_t first, std::size_t last, std::size_t fronts,
                       int at) {
    Vec3 low{INFINITY, INFINITY, INFINITY}, high = -low;
    float area = 0;
    for (std::size_t k = first; k < last; ++k) {
        const Element &element = mesh.element(order_[k]);
        for (int c = 0; c < 3; ++c) {
            low[c] = std::min(low[c], element.centre[c] - element.radius);
            high[c] = std::max(high[c], element.centre[c] + element.radius);
        }
        area += element.area;
    }
    Cluster cluster;
    cluster.firstFace = std::uint32_t(first), cluster.faces = std::uint32_t(last - first);
    cluster.centre = (low + high) * 0.5f;
    cluster.radius = length(high - low) / 2;
    cluster.area = area;
    const bool isMixed = first < fronts && fronts < last;
    if (isMixed || last - first > fewFaces) {
        const std::size_t middle = isMixed ? fronts : (first + last) / 2;
        if (!isMixed)
            split(mesh, first, middle, last, high - low);
        cluster.firstChild = std::int32_t(clusters_.size());
        clusters_.resize(clusters_.size() + 2);
        clusters_[std::size_t(at)] = cluster;
        build(mesh, first, middle, fronts, cluster.firstChild);
        build(mesh, middle, last, fronts, cluster.firstChild + 1);
        return at;
    }
    // In a fixed order, whatever the partition has left.
    std::sort(order_.begin() + std::ptrdiff_t(first), order_.begin() + std::ptrdiff_t(last));
    clusters_[std::size_t(at)] = cluster;
    return at;
}

std::vector<Directional> ClusterTree::sent(const Mesh &mesh,
                                           const std::vector<Color> &exitance) const {
    std::vector<Directional> all(clusters_.size());
    for (std::size_t c = clusters_.size(); c-- > 0;) { // Children stand behind their parents.
        const Cluster &cluster = clusters_[c];
        if (cluster.firstChild >= 0) {
            for (int child : {0, 1})
                all[c].add(all[std::size_t(cluster.firstChild + child)], {1, 1, 1});
            continue;
        }
        for (int root : rootsOf(int(c))) {
            const std::span<const Node> nodes = mesh.nodes(root);
            const std::size_t first = std::size_t(root) * std::size_t(mesh.stride());
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                Color value;
                for (std::size_t k = 0; k < colorSamples; ++k)
                    value[k] = exitance[first + i][k] * nodes[i].area / pi;
                all[c].add(nodes[i].N, value);
            }
        }
    }
    return all;
}

std::vector<Color> ClusterTree::power(const Mesh &mesh, const std::vector<Color> &exitance) const {
    std::vector<Color> all(clusters_.size());
    for (std::size_t c = clusters_.size(); c-- > 0;) {
        const Cluster &cluster = clusters_[c];
        for (int child : {0, 1})
            for (std::size_t k = 0; cluster.firstChild >= 0 && k < colorSamples; ++k)
                all[c][k] += all[std::size_t(cluster.firstChild + child)][k];
        if (cluster.firstChild >= 0)
            continue;
        for (int root : rootsOf(int(c))) {
            const std::span<const Node> nodes = mesh.nodes(root);
            const std::size_t first = std::size_t(root) * std::size_t(mesh.stride());
            for (std::size_t i = 0; i < nodes.size(); ++i)
                for (std::size_t k = 0; k < colorSamples; ++k)
                    all[c][k] += std::max(exitance[first + i][k], 0.0f) * nodes[i].area;
        }
    }
    return all;
}

void ClusterTree::distribute(const Mesh &mesh, std::vector<Directional> received,
                             std::vector<Color> &irradiance) const {
    for (std::size_t c = 0; c < clusters_.size(); ++c)
        for (int child : {0, 1})
            if (clusters_[c].firstChild >= 0)
                received[std::size_t(clusters_[c].firstChild + child)].add(received[c], {1, 1, 1});
    parallelFor(clusters_.size(), [&](std::size_t c) {
        if (clusters_[c].firstChild >= 0)
            return;
        for (int root : rootsOf(int(c))) {
            const std::span<const Node> nodes = mesh.nodes(root);
            const std::size_t first = std::size_t(root) * std::size_t(mesh.stride());
            for (std::size_t i = 0; i < nodes.size(); ++i) {
                const Color more = received[c].cosineAt(nodes[i].N);
                for (std::size_t k = 0; k < colorSamples; ++k)
                    irradiance[first + i][k] += more[k];
            }
        }
    });
}

} // namespace candela::radiosity
