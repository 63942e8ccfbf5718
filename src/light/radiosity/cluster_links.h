// SPDX-License-Identifier: Apache-2.0
// Which clusters exchange light as a whole, and which faces are to be looked at one by one.
#pragma once

#include "light/radiosity/clusters.h"
#include "light/radiosity/visibility.h"

namespace candela::radiosity {

struct ClusterLink {
    std::int32_t receiver, sender;
    Color visibility;
};

struct ClusterExchange {
    std::vector<ClusterLink> links;          ///< By receiver.
    std::vector<VisibilityRays::Pair> faces; ///< Pairs of root elements; the rest.
};

/// Clusters are linked where what they exchange, as far as they may get it wrong, times the
/// receiver's area is below `tolerance` (W); none if it is 0.
ClusterExchange exchangeOfClusters(const Mesh &, const ClusterTree &,
                                   const std::vector<Color> &exitance, double tolerance);

/// Adds what links bring to the irradiance of roots.
void gatherFromClusters(const Mesh &, const ClusterTree &, std::span<const ClusterLink>,
                        const std::vector<Color> &exitance, std::vector<Color> &irradiance);

} // namespace candela::radiosity
