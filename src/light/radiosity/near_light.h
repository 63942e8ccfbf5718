// SPDX-License-Identifier: Apache-2.0
// Light that varies faster than elements tell, at edges and contacts: gathered from its links at
// the very point that asks.
#pragma once

#include "light/radiosity/links.h"
#include "light/radiosity/transfer.h"

namespace candela::radiosity {

class NearLight {
public:
    NearLight() = default;
    /// The rough ones of the links, and what their senders send.
    NearLight(const Mesh &, const Links &, const std::vector<Color> &sent);

    /// Adds what rough links bring of the element's own, irradiance at a point of it with the unit
    /// normal N; `at` is its place in the element.
    void add(const Mesh &, int element, Place at, Vec3 P, Vec3 N, Color &irradiance) const;

private:
    struct Source {
        Sender sender;
        bool isNear;
        Color visibility;
        std::array<float, mostNodes> share; ///< Of the mean, at the receiver's nodes.
        std::array<Color, mostNodes> sent;
    };
    std::vector<std::uint32_t> first_; ///< By element: its sources are first_[e] to first_[e + 1].
    std::vector<Source> sources_;
};

} // namespace candela::radiosity
