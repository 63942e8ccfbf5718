// SPDX-License-Identifier: Apache-2.0
// Points that ask for light, by what has to be asked of the sources that they have chosen: blocks
// of one bin, as they lie where that is all there is, else gathered and put back.
#pragma once

#include "foundation/base/planes.h"
#include "foundation/base/scratch.h"
#include "world/scene/light_question.h"
#include "world/scene/light_sources.h"
#include "world/scene/lights.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace candela {

/// Points whose sources share a bin, up to lightBatchSize: who asks, and where the answers go.
struct LightBlock {
    int count = 0;
    const std::int32_t *source = nullptr;
    const float *probability = nullptr;                ///< Of the source, as far as it counts.
    std::array<const float *, 3> P{}, Ps{}, Ns{}, I{}; ///< As in LightQuery.
    const float *time = nullptr, *u = nullptr, *v = nullptr;
    LightSamples out;
};

/// No sample at lane i.
void setBlack(const LightSamples &, int i);

class LightBlocks {
public:
    /// Calls ask(bin, block) for all lanes that have a source; the others are black.
    template <class Ask> void forEach(const LightTable &table, const LightBlock &all, Ask ask) {
        const int only = sort(table, all);
        for (int first = 0; only >= 0 && first < all.count; first += lightBatchSize)
            ask(table.bins[std::size_t(only)],
                part(all, first, std::min(lightBatchSize, all.count - first)));
        if (only >= 0)
            return;
        for (int b = 0, first = 0; b < int(binEnd_.size()); ++b)
            for (int count; first < binEnd_[std::size_t(b)]; first += count) {
                count = std::min(lightBatchSize, binEnd_[std::size_t(b)] - first);
                const SourceBin &bin = table.bins[std::size_t(b)];
                const LightBlock block = gather(all, bin, order_ + first, count);
                ask(bin, block);
                putBack(block.out, order_ + first, count, all.out);
            }
    }

private:
    /// The bin of all lanes; -1 if they differ: then they are sorted, and those without a source
    /// set black.
    int sort(const LightTable &, const LightBlock &all);
    /// The lanes [first, first + count), where they lie.
    static LightBlock part(const LightBlock &all, int first, int count);
    /// The lanes lane[0..count), to be asked of the bin.
    LightBlock gather(const LightBlock &all, const SourceBin &, const std::int32_t *lane,
                      int count);
    static void putBack(const LightSamples &from, const std::int32_t *lane, int count,
                        const LightSamples &to);

    Planes<float> asked_{16, lightBatchSize}, answered_{9 + colorSamples, lightBatchSize};
    Planes<std::int32_t> integers_{2, lightBatchSize};
    Planes<std::uint8_t> bytes_{1, lightBatchSize};
    Scratch<std::int32_t> lanes_;
    const std::int32_t *order_ = nullptr; ///< Lanes by bin.
    std::vector<std::int32_t> binEnd_;    ///< In that.
};

} // namespace candela
