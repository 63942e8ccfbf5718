// SPDX-License-Identifier: Apache-2.0
// Links: which elements exchange light at which level.
#pragma once

#include "light/radiosity/link_oracle.h"

namespace candela::radiosity {

struct Link {
    std::int32_t receiver, sender;
    Color visibility;   ///< A factor of all coefficients.
    std::size_t kernel; ///< Of the first coefficient: receiver's nodes by sender's.
    /// The receiver's basis misses more than LinkSettings::contrast of it: points are better asked
    /// for it one by one (near_light.h).
    bool isRough = false;
    bool isNear = false; ///< See Transfer.
    /// Whose outline sends what the sender knows: its own, or a sliver's (donors.h).
    std::int32_t outline = -1;
};

struct Links {
    std::vector<ClusterLink> clusters;
    std::vector<Link> links; ///< By receiver.
    std::vector<float> kernels;
};

/// Links for all light that is sent, dividing elements where it has to.
Links refine(Mesh &, const ClusterTree &, const LinkSettings &, Fields &);

/// Exitance of an element's nodes from the irradiance there.
void reflect(const Mesh &, int element, Fields &);

} // namespace candela::radiosity
