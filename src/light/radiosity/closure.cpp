// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/closure.h"

#include <algorithm>

namespace candela::radiosity {

namespace {

/// Links are put right by no more: what is farther off has other reasons.
constexpr double least = 0.8;

/// What comes through a surface comes on top of what it sends, and volumes take from both.
bool passesStraightThrough(const Mesh &mesh) {
    const RayBatch none(1);
    Planes<float> transmittance(colorSamples, 1);
    float *planes[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        planes[c] = transmittance[c];
    return mesh.scene().hasVolumes() || mesh.scene().transmittance(none, planes);
}

} // namespace

std::vector<float> closureFactors(const Mesh &mesh, const std::vector<Color> &unit) {
    std::vector<float> factors(unit.size(), 1.0f);
    if (passesStraightThrough(mesh))
        return factors;
    struct Sum {
        double got = 0, area = 0;
    };
    std::vector<Sum> sums(mesh.faces().size());
    const auto first = [&](int e) { return std::size_t(e) * std::size_t(mesh.stride()); };
    const auto isLeaf = [&](int e) { return mesh.element(e).firstChild < 0; };
    for (int e = 0; e < mesh.size(); ++e) {
        Sum &sum = sums[mesh.element(e).face];
        const std::span<const Node> nodes = mesh.nodes(e);
        for (std::size_t i = 0; isLeaf(e) && i < nodes.size(); ++i) {
            sum.got += double(brightest(unit[first(e) + i])) * nodes[i].area;
            sum.area += nodes[i].area;
        }
    }
    for (int e = 0; e < mesh.size(); ++e) {
        const Sum &sum = sums[mesh.element(e).face];
        if (isLeaf(e) && sum.got > sum.area)
            std::fill_n(factors.begin() + std::ptrdiff_t(first(e)), mesh.nodes(e).size(),
                        float(std::max(sum.area / sum.got, least)));
    }
    return factors;
}

} // namespace candela::radiosity
