// SPDX-License-Identifier: Apache-2.0
// PixelVariance: pixels get the samples that they need (docs/adaptive-sampling.md). A pixel's even
// and odd samples are independent sequences, and each half's first samples, with those of pixels
// around, say how many the other half takes. So no number of samples depends on the values that it
// is the number of, and means stay unbiased.
#pragma once

#include "light/frame/tiles.h"
#include "light/path/stages.h"

#include <cstdint>
#include <vector>

namespace candela {

/// How many samples each half of a pixel shall have: two numbers a pixel, tile by tile.
using SampleWishes = std::vector<std::int32_t>;

/// Pixels of a tile, as consecutive numbers in Morton order, that make one wave.
struct TilePart {
    Tile tile;
    int first, last;
};

class AdaptiveSampling {
public:
    explicit AdaptiveSampling(const IntegratorSettings &);

    /// Whether the samples of pixels may differ in number.
    bool isOn() const { return pilot_ > 0; }
    /// Room for the wishes of all pixels.
    std::size_t wishes() const;
    /// Of the pass that begins with sample `first`. The first pass is the pilot: all pixels take
    /// part, and it decides. Numbers of samples double up to the usual length of passes.
    int passEnd(int first) const;
    bool isPilot(int firstSample) const { return firstSample == 0; }

    /// The waves of the pass of samples [first, last).
    std::vector<TilePart> parts(int first, int last, const SampleWishes &) const;
    /// Of one of them: its pixels, and which halves of their samples are to be taken.
    struct Pixels {
        std::vector<int> x, y;
        std::vector<Halves> halves;
    };
    void pixelsOf(const TilePart &, int firstSample, const SampleWishes &, Pixels &) const;

    /// What the pixels of a wave of the pilot wish for.
    void decide(const TilePart &, const PathResults &, SampleWishes &) const;

private:
    /// Which halves of a tile's pixel take part in the pass that begins with that sample.
    Halves halvesOf(const Tile &, int pixel, int firstSample, const SampleWishes &) const;
    std::size_t wishOf(const Tile &, int pixel) const;

    std::array<int, 4> crop_;
    double variance_; ///< That a pixel's mean may have.
    int pilot_ = 0;
};

} // namespace candela
