// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/cluster_links.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

namespace candela::radiosity {

namespace {

using Pair = VisibilityRays::Pair;

constexpr float pi = std::numbers::pi_v<float>;
/// What of the largest irradiance that a cluster may cause it gets wrong, as a whole.
constexpr float wrong = 0.3f;
/// Clusters that are linked are no larger than this share of their distance.
constexpr float widest = 0.4f;
/// Pairs of elements whose visibility stands for that of clusters.
constexpr std::size_t looks = 4;

class Exchange {
public:
    Exchange(const Mesh &mesh, const ClusterTree &tree, const std::vector<Color> &exitance,
             double tolerance)
        : mesh_(mesh), tree_(tree), tolerance_(tolerance), power_(tree.power(mesh, exitance)) {}

    ClusterExchange run() {
        open({0, 0});
        while (!waiting_.empty()) {
            const Pair pair = waiting_.back();
            waiting_.pop_back();
            serve(pair);
        }
        findVisibility();
        std::ranges::stable_sort(exchange_.links, {}, &ClusterLink::receiver);
        return std::move(exchange_);
    }

private:
    void serve(const Pair &pair) {
        const Cluster &a = tree_.clusters()[std::size_t(pair.receiver)];
        const Cluster &b = tree_.clusters()[std::size_t(pair.sender)];
        const float power = brightest(power_[std::size_t(pair.sender)]);
        if (!(power > 0))
            return;
        const float between = length(b.centre - a.centre);
        const float distance = between - a.radius - b.radius;
        if (distance > 0 && std::max(a.radius, b.radius) < widest * between) {
            const double largest = power / (pi * distance * distance);
            if (largest * wrong * a.area < tolerance_) {
                exchange_.links.push_back({pair.receiver, pair.sender, {}});
                return;
            }
        }
        open(pair);
    }

    /// The larger of the two, if it has children.
    void open(const Pair &pair) {
        const Cluster &a = tree_.clusters()[std::size_t(pair.receiver)];
        const Cluster &b = tree_.clusters()[std::size_t(pair.sender)];
        if (a.firstChild < 0 && b.firstChild < 0) {
            for (int receiver : tree_.rootsOf(pair.receiver))
                for (int sender : tree_.rootsOf(pair.sender))
                    exchange_.faces.push_back({receiver, sender});
            return;
        }
        const bool opensReceiver = a.firstChild >= 0 && (b.firstChild < 0 || a.radius > b.radius);
        const bool opensBoth = pair.receiver == pair.sender;
        for (int child : {0, 1}) {
            if (opensBoth)
                for (int other : {0, 1})
                    waiting_.push_back({a.firstChild + child, a.firstChild + other});
            else if (opensReceiver)
                waiting_.push_back({a.firstChild + child, pair.sender});
            else
                waiting_.push_back({pair.receiver, b.firstChild + child});
        }
    }

    void findVisibility() {
        constexpr std::size_t batch = VisibilityRays::pairs / looks;
        parallelFor((exchange_.links.size() + batch - 1) / batch, [&](std::size_t k) {
            thread_local std::unique_ptr<VisibilityRays> rays;
            if (!rays)
                rays = std::make_unique<VisibilityRays>();
            const std::size_t first = k * batch;
            const std::size_t last = std::min(first + batch, exchange_.links.size());
            std::vector<Pair> pairs;
            for (std::size_t l = first; l < last; ++l)
                for (std::size_t look = 0; look < looks; ++look)
                    pairs.push_back({someRoot(exchange_.links[l].receiver, look),
                                     someRoot(exchange_.links[l].sender, looks - 1 - look)});
            std::vector<Visibility> visibility(pairs.size());
            rays->ask(mesh_, pairs, visibility.data());
            for (std::size_t l = first; l < last; ++l)
                exchange_.links[l].visibility = mean(visibility.data() + (l - first) * looks);
        });
    }

    int someRoot(int cluster, std::size_t look) const {
        const std::span<const int> roots = tree_.rootsOf(cluster);
        return roots[(2 * look + 1) * roots.size() / (2 * looks)];
    }

    /// Of those that face each other.
    static Color mean(const Visibility *visibility) {
        Color sum{};
        int rays = 0;
        for (std::size_t look = 0; look < looks; ++look) {
            rays += visibility[look].rays;
            for (std::size_t k = 0; k < colorSamples; ++k)
                sum[k] += visibility[look].mean[k] * float(visibility[look].rays);
        }
        for (float &value : sum)
            value = rays > 0 ? value / float(rays) : 1;
        return sum;
    }

    const Mesh &mesh_;
    const ClusterTree &tree_;
    const double tolerance_;
    const std::vector<Color> power_;
    std::vector<Pair> waiting_; ///< Of clusters.
    ClusterExchange exchange_;
};

} // namespace

ClusterExchange exchangeOfClusters(const Mesh &mesh, const ClusterTree &tree,
                                   const std::vector<Color> &exitance, double tolerance) {
    return Exchange(mesh, tree, exitance, tolerance).run();
}

void gatherFromClusters(const Mesh &mesh, const ClusterTree &tree,
                        std::span<const ClusterLink> links, const std::vector<Color> &exitance,
                        std::vector<Color> &irradiance) {
    if (links.empty())
        return;
    const std::vector<Directional> sent = tree.sent(mesh, exitance);
    std::vector<Directional> received(tree.clusters().size());
    for (const ClusterLink &link : links) {
        const Vec3 way = tree.clusters()[std::size_t(link.sender)].centre -
                         tree.clusters()[std::size_t(link.receiver)].centre;
        const float squared = dot(way, way);
        const Vec3 direction = way / std::sqrt(squared);
        Color value = sent[std::size_t(link.sender)].cosineAt(-direction);
        for (std::size_t k = 0; k < colorSamples; ++k)
            value[k] *= link.visibility[k] / squared;
        received[std::size_t(link.receiver)].add(direction, value);
    }
    tree.distribute(mesh, std::move(received), irradiance);
}

} // namespace candela::radiosity
