// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/visibility.h"

#include <algorithm>
#include <cmath>

namespace candela::radiosity {

namespace {

/// Short of both ends by this share of the way.
constexpr float clearance = 1e-5f;

/// Off the surface, by as much as rays must be that leave it.
Vec3 clearOf(const Mesh &mesh, int e, const Node &node) {
    const float rounding =
        16 * 0x1p-24f * std::max({std::fabs(node.P.x), std::fabs(node.P.y), std::fabs(node.P.z)});
    return node.P + node.N * (mesh.domainOf(e).offset + rounding);
}

} // namespace

VisibilityRays::VisibilityRays()
    : rays_(pairs * raysOfPair), transmittance_(colorSamples, pairs * raysOfPair),
      around_(1, pairs * raysOfPair), atmosphere_(1, pairs * raysOfPair),
      place_(std::size_t(pairs * raysOfPair)) {}

void VisibilityRays::ask(const Mesh &mesh, std::span<const Pair> pairs, Visibility *visibility) {
    std::vector<int> counts(pairs.size(), 0);
    rays_.count = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        const std::span<const Node> to = mesh.nodes(pairs[p].receiver);
        const std::span<const Node> from = mesh.nodes(pairs[p].sender);
        const std::size_t all = to.size() * from.size();
        const std::size_t taken = std::min<std::size_t>(all, raysOfPair);
        for (std::size_t k = 0; k < taken; ++k) {
            const std::size_t at = k * all / taken;
            const Node &a = to[at / from.size()], &b = from[at % from.size()];
            const Vec3 begin = clearOf(mesh, pairs[p].receiver, a);
            const Vec3 way = clearOf(mesh, pairs[p].sender, b) - begin;
            if (!(dot(a.N, b.P - a.P) > 0) || !(dot(b.N, b.P - a.P) < 0))
                continue;
            const int ray = rays_.count++;
            for (int c = 0; c < 3; ++c)
                rays_.origin[c][ray] = begin[c], rays_.direction[c][ray] = way[c];
            rays_.tMin[ray] = clearance, rays_.tMax[ray] = 1 - clearance;
            rays_.time[ray] = mesh.scene().options().camera.shutterOpen;
            rays_.width[ray] = 0, rays_.spread[ray] = 0;
            const PlacedDomain &domain = mesh.domainOf(pairs[p].receiver);
            atmosphere_[0][ray] = mesh.scene().mediaOf(domain.instance, domain.shape).atmosphere;
            place_[std::size_t(ray)] = std::uint8_t(at);
            ++counts[p];
        }
    }
    float *planes[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        planes[c] = transmittance_[c];
    const ShadowMedia media{around_[0], around_[0], atmosphere_[0]};
    const bool isColored =
        rays_.count > 0 &&
        mesh.scene().transmittance(rays_, planes, mesh.scene().hasVolumes() ? &media : nullptr);
    int ray = 0;
    for (std::size_t p = 0; p < pairs.size(); ++p) {
        Visibility &found = visibility[p];
        found.rays = counts[p];
        found.mean = {}, found.share.fill(1);
        const int first = ray;
        for (; ray < first + counts[p]; ++ray)
            for (int c = 0; c < colorSamples; ++c)
                found.mean[std::size_t(c)] += planes[isColored ? c : 0][ray] / float(counts[p]);
        const float mean = *std::ranges::max_element(found.mean);
        for (ray = first; mean > 0 && ray < first + counts[p]; ++ray) {
            float most = 0;
            for (int c = 0; c < colorSamples; ++c)
                most = std::max(most, planes[isColored ? c : 0][ray]);
            found.share[place_[std::size_t(ray)]] = most / mean;
        }
        ray = first + counts[p];
    }
}

} // namespace candela::radiosity
