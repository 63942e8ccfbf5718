// SPDX-License-Identifier: Apache-2.0
// A filter's pixel loops at work: rows on all cores, pixels in lanes, sums in an order of their
// own.
#pragma once

#include "image/filter/bound_maps.h"
#include "image/filter/filter_watch.h"
#include "world/shading/filter_code.h"

namespace candela {

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
    void run(const ir::PixelLoop &, ShaderFunction, const float *given, const float *const *arrays,
             float *results);

    const FilterCode &filter_;
    BoundMaps &maps_;
    FilterWatch &watch_;
    const ShaderArgs *args_ = nullptr;
};

} // namespace candela
