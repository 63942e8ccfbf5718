// SPDX-License-Identifier: Apache-2.0
// Pixel filters by importance: a camera sample is drawn with a density proportional to the
// filter's magnitude and carries the filter's sign as its weight. Each sample then belongs to one
// pixel alone, which keeps pixels independent of tiles, crops and threads.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/options.h"

#include <cstdint>
#include <string_view>
#include <vector>

namespace candela {

/// Where a camera sample lies relative to the centre of its pixel, in pixels, and its weight:
/// constant but for the sign, and of mean 1 over the unit square.
struct FilterSample {
    float dx = 0, dy = 0;
    float weight = 1;
};

/// The kernel of a RI filter (RI 3.2 appendix E, and the customary further ones) at a distance
/// from the pixel centre, not normalised; 0 outside the widths. box, triangle, gaussian, mitchell
/// and blackman-harris stretch to the widths; sinc, catmull-rom and bessel are fixed in pixels and
/// cut off by them. Radial kernels (disk, catmull-rom, bessel) end at the ellipse of the widths;
/// where the widths differ, their distances are in the mean of both. 0 for an unknown name.
double pixelFilterKernel(const PixelFilterRecord &, double dx, double dy);

/// Draws camera samples by a pixel filter. Immutable once made; cheap to share between threads.
class PixelFilterSampler {
public:
    /// Unknown names and widths that are not positive are reported at `where`; then the default
    /// filter (gaussian 2 2) serves.
    PixelFilterSampler(const PixelFilterRecord &, DiagnosticSink &, SourceLocation where = {});

    /// Maps (u, v) of [0,1)^2 by a continuous map with constant |weight|: stratification of the
    /// unit square becomes stratification under the filter.
    FilterSample sample(float u, float v) const {
        if (uniform_)
            return {(u - 0.5f) * record_.xWidth, (v - 0.5f) * record_.yWidth, 1};
        return sampleTables(u, v);
    }

    /// True if some weights are negative (all are 1 otherwise).
    bool hasNegativeLobes() const { return x_.flips.size() + y_.flips.size() > 0; }

    /// What is in use: the record asked for, or the default one after an error.
    const PixelFilterRecord &record() const { return record_; }

    /// Names that are understood.
    static std::vector<std::string_view> knownNames();

private:
    FilterSample sampleTables(float u, float v) const;

    /// The integral of |f| over an interval in equal cells, normalised to 1 at the end and
    /// inverted by a guide from the integral to the cell; and where on that scale f changes sign.
    struct Axis {
        std::vector<float> cumulative;
        std::vector<std::uint16_t> guide;
        float from = 0, cellWidth = 0;
        std::vector<float> flips;
        float firstSign = 1;
        float scale = 1; ///< Integral of |f| over the integral of f.

        float at(float u) const;
        float signAt(float u) const;
    };
    template <class Density>
    static Axis tabulate(double from, double to, bool radial, const Density &);

    PixelFilterRecord record_;
    bool uniform_ = false; ///< The box needs no table.
    bool radial_ = false;
    Axis x_, y_; ///< Radial filters: x_ is the fraction of the radius, y_ stays unused.
};

} // namespace candela
