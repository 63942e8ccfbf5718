// SPDX-License-Identifier: Apache-2.0
#include "image/filter/pixel_loop_run.h"

#include "foundation/base/hot.h"
#include "foundation/base/parallel.h"
#include "foundation/base/planes.h"
#include "language/ir/filter/pixel_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <immintrin.h>
#include <limits>

namespace candela {

namespace {

using Extent = PixelLoopExtent;
using Portion = PixelLoopPortion;
using Inputs = std::array<const float *, std::size_t(ShaderInput::Count)>;

/// Turns of a loop from `first` on, by steps of 1, as long as it is below (or not above) `end`.
/// Beyond 2^24 a step of 1 leads nowhere.
std::int64_t turnsOf(float first, float end, bool isClosed) {
    const double length = double(end) - double(first);
    if (!(length >= 0) || (length == 0 && !isClosed))
        return 0;
    const double turns = isClosed ? std::floor(length) + 1 : std::ceil(length);
    return std::int64_t(std::min(turns, 16777216.0));
}

Extent extentOf(const ir::PixelLoop &loop, const float *given) {
    return {turnsOf(given[0], given[1], loop.closedColumns),
            turnsOf(given[2], given[3], loop.closedRows), given[0], given[2]};
}

std::size_t wholeBlocks(std::int64_t columns) {
    constexpr std::int64_t block = mostPixelsTogether;
    return std::size_t((columns + block - 1) / block * block);
}

/// The columns' numbers, for all rows.
std::vector<float> columnsOf(const Extent &extent) {
    std::vector<float> columns(wholeBlocks(extent.columns));
    for (std::size_t k = 0; k < columns.size(); ++k)
        columns[k] = extent.firstColumn + float(k);
    return columns;
}

struct Sum {
    static double join(double a, double b) { return a + b; }
};
struct Least {
    static double join(double a, double b) { return b < a ? b : a; }
};
struct Greatest {
    static double join(double a, double b) { return b > a ? b : a; }
};

/// Joins every sixteenth value of a row to one of sixteen.
template <typename Kind>
inline __attribute__((always_inline)) void joinRow(const float *values, std::int64_t count,
                                                   double *parts) {
    const std::int64_t blocks = count / laneBlock * laneBlock;
    for (std::int64_t k = 0; k < blocks; k += laneBlock)
        for (int lane = 0; lane < laneBlock; ++lane)
            parts[lane] = Kind::join(parts[lane], double(values[k + lane]));
    for (std::int64_t k = blocks; k < count; ++k)
        parts[k - blocks] = Kind::join(parts[k - blocks], double(values[k]));
}

CANDELA_HOT void joinRow(ir::Reduction reduction, const float *values, std::int64_t count,
                         double *parts) {
    switch (reduction) {
    case ir::Reduction::Sum: return joinRow<Sum>(values, count, parts);
    case ir::Reduction::Least: return joinRow<Least>(values, count, parts);
    case ir::Reduction::Greatest: return joinRow<Greatest>(values, count, parts);
    }
}

double joined(ir::Reduction reduction, double a, double b) {
    switch (reduction) {
    case ir::Reduction::Sum: return Sum::join(a, b);
    case ir::Reduction::Least: return Least::join(a, b);
    case ir::Reduction::Greatest: return Greatest::join(a, b);
    }
    return a;
}

/// Of a row: sixteen sums of every sixteenth value, then these one after another.
double reduced(ir::Reduction reduction, const float *values, std::int64_t count) {
    alignas(64) std::array<double, laneBlock> parts;
    parts.fill(ir::neutralOf(reduction));
    joinRow(reduction, values, count, parts.data());
    double all = ir::neutralOf(reduction);
    for (double part : parts)
        all = joined(reduction, all, part);
    return all;
}

/// The border's pixels beyond it, so that rows may be read there.
void fillHalo(const ImageMap &map, int y) {
    for (int c = 0; c < map.channels; ++c) {
        float *row = map.row(c, y);
        std::fill(row - imageHalo, row, row[0]);
        float *const end = row - imageHalo + map.rowStride;
        std::fill(row + map.width, end, row[map.width - 1]);
    }
}

void fillHalos(const ImageMap &map) {
    constexpr int rowsTogether = 256;
    parallelFor(std::size_t((map.height + rowsTogether - 1) / rowsTogether), [&](std::size_t k) {
        const int first = int(k) * rowsTogether;
        for (int y = first; y < std::min(first + rowsTogether, map.height); ++y)
            fillHalo(map, y);
    });
}

/// Whether pixels beside the map may be read.
bool readsBeyond(const ir::PixelLoop &loop, const Extent &extent, int number, const ImageMap &map) {
    const std::vector<int> &around = loop.mapsReadAround;
    const bool isWithin =
        extent.firstColumn >= 0 && double(extent.firstColumn) + double(extent.columns) <= map.width;
    return !isWithin || std::find(around.begin(), around.end(), number) != around.end();
}

/// Where lane 0 stands, as a whole number; far outside if it is none.
std::int32_t wholeColumn(float first) {
    constexpr float farthest = 1 << 20;
    const bool isWhole = std::floor(first) == first && std::abs(first) <= farthest;
    return isWhole ? std::int32_t(first) : std::numeric_limits<std::int32_t>::min() / 2;
}

} // namespace

std::vector<PixelLoopPortion> PixelLoopExtent::portions() const {
    constexpr std::int64_t pixelsTogether = 1 << 15, columnsOfOne = 64;
    const std::int64_t height = std::max<std::int64_t>(1, pixelsTogether / columns);
    const std::int64_t width = rows == 1 ? columnsOfOne : columns;
    std::vector<PixelLoopPortion> all;
    for (std::int64_t y = 0; y < rows; y += height)
        for (std::int64_t x = 0; x < columns; x += width)
            all.push_back({x, std::min(width, columns - x), y, std::min(height, rows - y)});
    return all;
}

const float *const *PixelLoopRun::noInputs() {
    static const std::array<float, laneBlock> zeros{};
    static const auto planes = [] {
        Inputs all;
        all.fill(zeros.data());
        return all;
    }();
    return planes.data();
}

PixelLoopRunner PixelLoopRun::runner() {
    return {this, [](void *context, std::int32_t number, const float *given,
                     const float *const *arrays, float *results) {
                auto &self = *static_cast<PixelLoopRun *>(context);
                self.run(self.filter_.driver().pixelLoops[std::size_t(number)],
                         self.filter_.loop(number), given, arrays, results);
            }};
}

void PixelLoopRun::run(const ir::PixelLoop &loop, ShaderFunction code, const float *given,
                       const float *const *arrays, float *results) {
    const float *captured = given + ir::PixelLoop::bounds, *begin = captured + loop.captured;
    const std::size_t count = loop.sums.size();
    std::copy_n(begin, count, results);
    const Extent extent = extentOf(loop, given);
    if (extent.columns == 0 || extent.rows == 0 || maps_.failed())
        return;
    prepareMaps(loop, extent);
    const Job job{loop, code, extent, columnsOf(extent), captured, arrays};
    const std::vector<Portion> portions = extent.portions();
    std::vector<double> sums(portions.size() * count);
    std::atomic<std::int64_t> done{0};
    const auto runOne = [&](std::size_t number) {
        runPortion(job, portions[number], sums.data() + number * count);
        watch_.progress(double(++done) / double(portions.size()));
    };
    if (portions.size() == 1)
        runOne(0);
    else
        parallelFor(portions.size(), runOne);
    maps_.noteSet(loop);
    for (std::size_t s = 0; s < count; ++s) {
        double all = double(begin[s]);
        for (std::size_t portion = 0; portion < portions.size(); ++portion)
            all = joined(loop.sums[s], all, sums[portion * count + s]);
        results[s] = float(all);
    }
}

void PixelLoopRun::prepareMaps(const ir::PixelLoop &loop, const Extent &extent) {
    const bool isFromCorner = extent.firstColumn == 0 && extent.firstRow == 0;
    maps_.prepare(loop, isFromCorner ? extent.columns : 0, isFromCorner ? extent.rows : 0);
    for (int map : loop.mapsRead)
        if (maps_.wantsHalos(map) && readsBeyond(loop, extent, map, args_->maps[map])) {
            fillHalos(args_->maps[map]);
            maps_.noteHalosFilled(map);
        }
}

void PixelLoopRun::runPortion(const Job &job, const Portion &portion, double *sums) {
    const std::vector<ir::Reduction> &kinds = job.loop.sums;
    const std::size_t width = wholeBlocks(portion.columns);
    std::vector<float> values(kinds.size() * width);
    std::vector<float *> outputs;
    for (std::size_t s = 0; s < kinds.size(); ++s) {
        outputs.push_back(values.data() + s * width);
        sums[s] = ir::neutralOf(kinds[s]);
    }
    std::vector<float> captured(job.captured, job.captured + job.loop.captured);
    captured.insert(captured.begin(), 0); // The row.
    Inputs inputs;
    std::copy_n(args_->inputs, inputs.size(), inputs.begin());
    inputs[std::size_t(ShaderInput::column)] = job.columns.data() + portion.column;

    ShaderArgs args = *args_;
    args.count = std::int32_t(portion.columns);
    args.inputs = inputs.data();
    args.captured = captured.data();
    args.capturedArrays = job.arrays;
    args.firstColumn = wholeColumn(job.extent.firstColumn + float(portion.column));
    args.outputs = outputs.data();
    for (std::int64_t y = portion.row; y < portion.row + portion.rows; ++y) {
        if (watch_.isInterrupted())
            return;
        captured[0] = job.extent.firstRow + float(y);
        job.code(&args);
        for (std::size_t s = 0; s < kinds.size(); ++s)
            sums[s] = joined(kinds[s], sums[s], reduced(kinds[s], outputs[s], portion.columns));
    }
    _mm_sfence(); // Rows may have gone past the caches.
}

} // namespace candela
