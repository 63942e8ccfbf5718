// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_blocks.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

namespace candela {

namespace {

/// The bin's light shaders are told more of what they light than where it is.
bool isToldOfSurfaces(const SourceBin &bin) {
    return bin.asked == SourceBin::Asked::PointShader
               ? readsWhatIsLit(*bin.shader, false)
               : bin.asked == SourceBin::Asked::ClassicArea && readsWhatIsLit(*bin.shader, true);
}

/// bin[i] of the lanes' sources, -1 where there is none.
CANDELA_HOT void lookUpBins(int count, const std::int32_t *__restrict source,
                            const std::int32_t *__restrict table, int stride,
                            std::int32_t *__restrict bin) {
    for (int i = 0; i < count; ++i)
        bin[i] = source[i] < 0 ? -1 : table[stride * (source[i] < 0 ? 0 : source[i])];
}

} // namespace

void setBlack(const LightSamples &samples, int i) {
    samples.L[0][i] = samples.L[1][i] = 0, samples.L[2][i] = 1;
    samples.distance[i] = 0, samples.pdfSolidAngle[i] = 0;
    samples.light[i] = 0, samples.castsShadow[i] = 0;
    for (float *value : samples.value)
        value[i] = 0;
    if (samples.probability)
        samples.probability[i] = samples.normal[0][i] = samples.normal[1][i] =
            samples.normal[2][i] = 0;
}

LightBlock LightBlocks::part(const LightBlock &all, int first, int count) {
    LightBlock block = all;
    block.count = count;
    for (auto *planes : {&block.P, &block.Ps, &block.Ns, &block.I})
        for (const float *&plane : *planes)
            if (plane)
                plane += first;
    for (const float **plane : {&block.probability, &block.time, &block.u, &block.v})
        *plane += first;
    block.source += first;
    LightSamples &out = block.out;
    for (float *&plane : out.L)
        plane += first;
    for (float *&plane : out.value)
        plane += first;
    out.distance += first, out.pdfSolidAngle += first;
    out.light += first, out.castsShadow += first;
    if (out.probability) {
        out.probability += first;
        for (float *&plane : out.normal)
            plane += first;
    }
    return block;
}

LightBlock LightBlocks::gather(const LightBlock &all, const SourceBin &bin,
                               const std::int32_t *lane, int count) {
    LightBlock block;
    block.count = count;
    int plane = 0;
    auto take = [&](const float *from) {
        float *to = asked_[plane++];
        lanes::gather(count, lane, from, to);
        return to;
    };
    for (int c = 0; c < 3; ++c)
        block.P[c] = take(all.P[c]), block.Ps[c] = take(all.Ps[c]);
    for (int c = 0; c < 3 && isToldOfSurfaces(bin); ++c) {
        block.Ns[c] = all.Ns[c] ? take(all.Ns[c]) : nullptr;
        block.I[c] = all.I[c] ? take(all.I[c]) : nullptr;
    }
    block.probability = take(all.probability), block.time = take(all.time);
    block.u = take(all.u), block.v = take(all.v);
    lanes::gather(count, lane, all.source, integers_[0]);
    block.source = integers_[0];
    block.out.L = {answered_[0], answered_[1], answered_[2]};
    block.out.distance = answered_[3], block.out.pdfSolidAngle = answered_[4];
    for (int c = 0; c < colorSamples; ++c)
        block.out.value[c] = answered_[5 + c];
    block.out.light = integers_[1], block.out.castsShadow = bytes_[0];
    if (all.out.probability) {
        constexpr int first = 5 + colorSamples;
        block.out.probability = answered_[first];
        block.out.normal = {answered_[first + 1], answered_[first + 2], answered_[first + 3]};
    }
    return block;
}

void LightBlocks::putBack(const LightSamples &from, const std::int32_t *lane, int count,
                          const LightSamples &to) {
    auto put = [&](const auto *answers, auto *plane) {
        for (int k = 0; k < count; ++k)
            plane[lane[k]] = answers[k];
    };
    for (int c = 0; c < 3; ++c)
        put(from.L[c], to.L[c]);
    for (int c = 0; c < colorSamples; ++c)
        put(from.value[c], to.value[c]);
    put(from.distance, to.distance), put(from.pdfSolidAngle, to.pdfSolidAngle);
    put(from.light, to.light), put(from.castsShadow, to.castsShadow);
    if (to.probability) {
        put(from.probability, to.probability);
        for (int c = 0; c < 3; ++c)
            put(from.normal[c], to.normal[c]);
    }
}

int LightBlocks::sort(const LightTable &table, const LightBlock &all) {
    const auto allBlack = [&] {
        for (int i = 0; i < all.count; ++i)
            setBlack(all.out, i);
    };
    binEnd_.clear();
    if (table.sources.empty()) {
        allBlack();
        return -1;
    }
    std::int32_t *bin = lanes_.get(2 * std::size_t(all.count)), *order = bin + all.count;
    order_ = order;
    constexpr int words = sizeof(LightSource) / sizeof(std::int32_t);
    const bool oneSource = lanes::allEqual(all.count, all.source, all.source[0]);
    lookUpBins(oneSource ? 1 : all.count, all.source, &table.sources[0].bin, words, bin);
    if (oneSource || lanes::allEqual(all.count, bin, bin[0])) {
        if (bin[0] < 0)
            allBlack();
        return bin[0];
    }
    std::vector<std::int32_t> &end = binEnd_;
    end.assign(table.bins.size() + 1, 0);
    for (int i = 0; i < all.count; ++i)
        if (bin[i] >= 0)
            ++end[std::size_t(bin[i]) + 1];
        else
            setBlack(all.out, i);
    for (std::size_t b = 0; b < table.bins.size(); ++b)
        end[b + 1] += end[b];
    for (int i = 0; i < all.count; ++i)
        if (bin[i] >= 0)
            order[end[std::size_t(bin[i])]++] = i;
    end.pop_back();
    return -1;
}

} // namespace candela
