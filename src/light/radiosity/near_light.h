// SPDX-License-Identifier: Apache-2.0
// Light that varies faster than elements tell, at edges and contacts: gathered from its links at
// the very point that asks.
#pragma once

#include "light/radiosity/links.h"
#include "light/radiosity/transfer.h"

namespace candela::radiosity {

/// A link whose light is gathered so.
struct NearRecord {
    std::int32_t receiver = 0, sender = 0;
    std::int32_t outline = 0; ///< See Link.
    std::int32_t isNear = 0;  ///< See Transfer.
    Color visibility{};
    std::array<float, mostNodes> share{}; ///< Of the mean visibility, at the receiver's nodes.
};

/// The rough ones of the links, by receiver.
std::vector<NearRecord> nearRecords(const Mesh &, const Links &);

class NearLight {
public:
    NearLight() = default;
    /// `sent`: what the senders send. The records are by receiver.
    NearLight(const Mesh &, std::span<const NearRecord>, const std::vector<Color> &sent);

    std::vector<NearRecord> records() const;

    bool isAt(int element) const {
        return !first_.empty() && first_[std::size_t(element)] != first_[std::size_t(element) + 1];
    }
    /// Adds what rough links bring of the element's own, irradiance at a point of it with the unit
    /// normal N, for which the element's nodes count as `value` says.
    void add(const Mesh &, int element, const float *value, Vec3 P, Vec3 N,
             Color &irradiance) const;

private:
    struct Source {
        NearRecord link;
        Sender sender;
        std::array<Color, mostNodes> sent;
    };
    std::vector<std::uint32_t> first_; ///< By element: its sources are first_[e] to first_[e + 1].
    std::vector<Source> sources_;
};

} // namespace candela::radiosity
