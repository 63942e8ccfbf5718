// SPDX-License-Identifier: Apache-2.0
#include "image/filter/filter_stack.h"

#include "foundation/base/hot.h"
#include "foundation/base/parallel.h"
#include "image/filter/filter_run.h"
#include "image/filter/filter_watch.h"
#include "image/filter/image_uses.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace candela {

FilterStack::FilterStack(const std::vector<ShaderRecord> &records, ShaderLibrary &library,
                         const Options &options) {
    for (const ShaderRecord &record : records)
        if (auto filter = library.filter(record, options)) {
            filters_.push_back(std::move(filter));
            records_.push_back(record);
        }
}

namespace {

/// By name, with the most channels of a use.
std::map<std::string, int> mapsOf(const FilterCode &filter, ir::Op op) {
    std::map<std::string, int> maps;
    forEachImageUse(filter.driver(), [&](const MapAccess &access) {
        const std::string &map = filter.driver().maps[std::size_t(access.use.map)];
        if (access.instruction.op == op && map != "Cs" && map != "Ci")
            maps[map] = std::max(maps[map], access.use.values);
    });
    return maps;
}

/// The first filter that names a map makes it.
std::map<std::string, int> mapsOf(const std::vector<std::shared_ptr<const FilterCode>> &filters,
                                  ir::Op op) {
    std::map<std::string, int> maps;
    for (const auto &filter : filters)
        maps.merge(mapsOf(*filter, op));
    return maps;
}

bool isFinite(float x) { return std::abs(x) <= std::numeric_limits<float>::max(); }

/// How many numbers of the row are not finite.
CANDELA_HOT int countNotFinite(const float *row, int count) {
    int bad = 0;
    for (int x = 0; x < count; ++x)
        bad += !isFinite(row[x]);
    return bad;
}

} // namespace

void makeFinite(OwnedImage &image, const std::string &what, DiagnosticSink &diagnostics) {
    std::atomic<std::int64_t> bad{0};
    parallelFor(std::size_t(image.height()), [&](std::size_t y) {
        for (int c = 0; c < image.channels(); ++c)
            if (const int inRow = countNotFinite(image.row(c, int(y)), image.width())) {
                std::replace_if(
                    image.row(c, int(y)), image.row(c, int(y)) + image.width(),
                    [](float x) { return !isFinite(x); }, 0.0f);
                bad += inRow;
            }
    });
    if (bad > 0)
        diagnostics.warning({}, fmt::format("{} values of {} are not finite (inf or nan); they "
                                            "count as 0",
                                            bad.load(), what));
}

std::vector<std::string> FilterStack::mapsRead() const {
    std::vector<std::string> names;
    for (const auto &[name, channels] : mapsOf(filters_, ir::Op::ImageLoad))
        names.push_back(name);
    return names;
}

std::vector<MapInfo> FilterStack::mapsSet() const {
    std::vector<MapInfo> maps;
    for (const auto &[name, channels] : mapsOf(filters_, ir::Op::ImageStore))
        maps.push_back({name, channels});
    return maps;
}

bool FilterStack::run(ImageMaps &maps, const FilterListeners &listeners) const {
    FilterWatch watch(listeners);
    int done = 0;
    for (const auto &filter : filters_) {
        if (done > 0)
            makeFinite(*maps.find("Ci"), "what the filter before \"" + filter->name() + "\" made",
                       listeners.diagnostics);
        watch.begin(filter->name(), done++);
        runFilter(*filter, maps, watch, listeners.diagnostics);
        if (watch.isInterrupted())
            return false;
    }
    return true;
}

} // namespace candela
