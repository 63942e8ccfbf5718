// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/near_light.h"

#include "light/radiosity/donors.h"

#include <algorithm>

namespace candela::radiosity {

namespace {

/// How visibility varies over the receiver, by what it has left of the kernel's rows.
std::array<float, mostNodes> sharesOf(const Mesh &mesh, const Link &link, const float *kernel) {
    const std::span<const Node> to = mesh.nodes(link.receiver);
    const std::size_t senders = mesh.nodes(link.sender).size();
    const Sender sender(mesh, link.outline);
    std::array<float, mostNodes> shares, row;
    for (std::size_t i = 0; i < to.size(); ++i) {
        float missed = 0, left = 0;
        const float whole = sender.factor(to[i].P, to[i].N, link.isNear, row.data(), missed);
        for (std::size_t j = 0; j < senders; ++j)
            left += kernel[i * senders + j];
        shares[i] = whole > 0 ? std::clamp(left / whole, 0.0f, 2.0f) : 1.0f;
    }
    return shares;
}

/// What a sliver sends, all over.
Color sentByDonor(const Mesh &mesh, const NearRecord &record, const Color *sent) {
    const std::array<float, mostNodes> weights = donorWeights(mesh, record.receiver, record.sender);
    Color sum{};
    for (std::size_t j = 0; j < mesh.nodes(record.sender).size(); ++j)
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += weights[j] * sent[j][k];
    return sum;
}

} // namespace

std::vector<NearRecord> nearRecords(const Mesh &mesh, const Links &links) {
    std::vector<NearRecord> records;
    for (const Link &link : links.links) // By receiver.
        if (link.isRough) {
            NearRecord record{link.receiver, link.sender,     link.outline,
                              link.isNear,   link.visibility, {}};
            const bool isClear = *std::ranges::min_element(link.visibility) >= 1;
            record.share.fill(1);
            if (!isClear)
                record.share = sharesOf(mesh, link, links.kernels.data() + link.kernel);
            records.push_back(record);
        }
    return records;
}

NearLight::NearLight(const Mesh &mesh, std::span<const NearRecord> records,
                     const std::vector<Color> &sent)
    : first_(std::size_t(mesh.size()) + 1, 0) {
    for (const NearRecord &record : records) {
        Source source{record, Sender(mesh, record.outline), {}};
        const std::size_t at = std::size_t(record.sender) * std::size_t(mesh.stride());
        if (record.outline == record.sender)
            std::copy_n(sent.begin() + std::ptrdiff_t(at), mesh.stride(), source.sent.begin());
        else
            source.sent.fill(sentByDonor(mesh, record, sent.data() + at));
        sources_.push_back(source);
        ++first_[std::size_t(record.receiver) + 1];
    }
    for (std::size_t e = 1; e < first_.size(); ++e)
        first_[e] += first_[e - 1];
}

std::vector<NearRecord> NearLight::records() const {
    std::vector<NearRecord> records;
    for (const Source &source : sources_)
        records.push_back(source.link);
    return records;
}

void NearLight::add(const Mesh &mesh, int element, const float *value, Vec3 P, Vec3 N,
                    Color &irradiance) const {
    std::array<float, mostNodes> row;
    for (std::size_t s = first_[std::size_t(element)]; s < first_[std::size_t(element) + 1]; ++s) {
        const Source &source = sources_[s];
        float missed = 0, share = 0;
        source.sender.factor(P, N, source.link.isNear != 0, row.data(), missed);
        for (std::size_t i = 0; i < mesh.nodes(element).size(); ++i)
            share += value[i] * source.link.share[i];
        for (int j = 0; j < source.sender.count; ++j)
            for (std::size_t k = 0; k < colorSamples; ++k)
                irradiance[k] += share * source.link.visibility[k] * row[std::size_t(j)] *
                                 source.sent[std::size_t(j)][k];
    }
}

} // namespace candela::radiosity
