// SPDX-License-Identifier: Apache-2.0
// Links of which one end or both are clusters. Ends are numbered: elements from 0 on, cluster c is
// ~c.
#pragma once

#include "light/radiosity/clusters.h"
#include "light/radiosity/visibility.h"

namespace candela::radiosity {

using Pair = VisibilityRays::Pair;

inline bool isCluster(int end) { return end < 0; }
inline bool hasCluster(const Pair &pair) {
    return isCluster(pair.receiver) || isCluster(pair.sender);
}

struct ClusterLink {
    std::int32_t receiver, sender;
    Color visibility;
};

/// Whether clusters may exchange light as a whole.
class ClusterOracle {
public:
    /// `exitance`: what is sent; `tolerance`: of what a link gets wrong times the receiver's area,
    /// W; 0: none may be linked.
    ClusterOracle(const Mesh &, const ClusterTree &, const std::vector<Color> &exitance,
                  double tolerance);

    bool sends(int end) const;
    /// The pair is small beside its distance, and what it exchanges beside the tolerance, or `all`.
    bool mayLink(const Pair &, bool all) const;
    float radius(int end) const;
    /// What stands in the place of a cluster: two clusters, or elements.
    void open(int cluster, std::vector<int> &ends) const;
    /// Pairs of elements that stand for the pair where visibility is asked for, `looks` of them.
    static constexpr std::size_t looks = 4;
    void look(const Pair &, std::vector<Pair> &) const;

private:
    Vec3 centre(int end) const;
    float area(int end) const;
    Color power(int element) const;
    int someRoot(int end, std::size_t look) const;

    const Mesh &mesh_;
    const ClusterTree &tree_;
    const std::vector<Color> &exitance_;
    const double tolerance_;
    const std::vector<Color> power_;
};

/// The mean over looks, by the rays that they have sent.
Color meanVisibility(std::span<const Visibility>);

/// Adds what links bring to the irradiance of elements.
void gatherFromClusters(const Mesh &, const ClusterTree &, std::span<const ClusterLink>,
                        const std::vector<Color> &exitance, std::vector<Color> &irradiance);

} // namespace candela::radiosity
