// SPDX-License-Identifier: Apache-2.0
// Links: which elements exchange light at which level (Hanrahan, Salzman and Aupperle 1991; the
// oracle is that of Gortler and others 1993: what the bases miss of the kernel).
#pragma once

#include "light/radiosity/cluster_links.h"
#include "light/radiosity/sources.h"

namespace candela::radiosity {

struct Link {
    std::int32_t receiver, sender;
    Color visibility;   ///< A factor of all coefficients.
    std::size_t kernel; ///< Of the first coefficient: receiver's nodes by sender's.
    /// The receiver's basis misses more than LinkSettings::contrast of it: points are better asked
    /// for it one by one (near_light.h).
    bool isRough = false;
    bool isNear = false; ///< See Transfer.
};

struct Links {
    std::vector<ClusterLink> clusters;
    std::vector<Link> links; ///< By receiver.
    std::vector<float> kernels;
};

struct LinkSettings {
    double tolerance = 0; ///< Of the irradiance that a link gets wrong, times area: W.
    double contrast = 0;  ///< Irradiance that links may get wrong without being rough, W m^-2.
    float leastArea = 0;  ///< No element is divided below it.
    std::size_t mostElements = 0, mostLinks = 0;
    SourceSettings sources; ///< For elements that refinement makes.
    /// Exchanged: exitance; or emission, of lamps that are on for the receiver.
    std::vector<Color> Fields::*sent = &Fields::exitance;
};

/// Links for all light that is sent, dividing elements where it has to.
Links refine(Mesh &, const ClusterTree &, const LinkSettings &, Fields &);

/// Exitance of an element's nodes from the irradiance there.
void reflect(const Mesh &, int element, Fields &);

} // namespace candela::radiosity
