// SPDX-License-Identifier: Apache-2.0
// A filter's pixel loops at work: rows on all cores, pixels in lanes, sums in an order of their
// own.
#pragma once

#include "image/filter/bound_maps.h"
#include "image/filter/filter_watch.h"
#include "world/shading/filter_code.h"

#include <cstdint>
#include <vector>

namespace candela {

/// Pixels that one core takes at a time: some rows, or a part of the only one.
struct PixelLoopPortion {
    std::int64_t column, columns, row, rows;
};

/// The columns and rows that a loop runs over.
struct PixelLoopExtent {
    std::int64_t columns, rows;
    float firstColumn, firstRow;

    /// The same whatever the number of cores.
    std::vector<PixelLoopPortion> portions() const;
};

class PixelLoopRun {
public:
    PixelLoopRun(const FilterCode &filter, BoundMaps &maps, FilterWatch &watch)
        : filter_(filter), maps_(maps), watch_(watch) {}

    /// What the filter is called with: loops get it, too. Must outlive them.
    void bind(const ShaderArgs &args) { args_ = &args; }
    PixelLoopRunner runner();
    /// Planes of zeros for all inputs.
    static const float *const *noInputs();

private:
    /// What is the same for all portions.
    struct Job {
        const ir::PixelLoop &loop;
        ShaderFunction code;
        PixelLoopExtent extent;
        std::vector<float> columns; ///< Their numbers.
        const float *captured;
        const float *const *arrays;
    };
    void run(const ir::PixelLoop &, ShaderFunction, const float *given, const float *const *arrays,
             float *results);
    void prepareMaps(const ir::PixelLoop &, const PixelLoopExtent &);
    /// `sums`: of the portion, one each of PixelLoop::sums.
    void runPortion(const Job &, const PixelLoopPortion &, double *sums);

    const FilterCode &filter_;
    BoundMaps &maps_;
    FilterWatch &watch_;
    const ShaderArgs *args_ = nullptr;
};

} // namespace candela
