// SPDX-License-Identifier: Apache-2.0
#include "render/frame_film.h"

#include "image/displays.h"
#include "image/film_maps.h"
#include "light/path/first_hit.h"
#include "light/path/shader_channels.h"
#include "render/filtering.h"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <unistd.h>

namespace candela {

static double gigabytesOfMemory() {
    return double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE)) / 1e9;
}

bool canHold(const Film::Settings &film, double maps, const Options &options,
             DiagnosticSink &diagnostics) {
    const FrameWindow &window = film.window;
    if (window.x0 >= window.x1 || window.y0 >= window.y1) {
        diagnostics.error(options.places.cropWindow,
                          "the crop window holds no pixel; the frame is not rendered");
        return false;
    }
    const double needed = (Film::bytesNeeded(film) + maps) / 1e9, there = gigabytesOfMemory();
    if (needed > there) {
        diagnostics.error(
            options.places.format,
            fmt::format("a picture of {} x {} pixels takes {:.0f} GB of memory{}, and "
                        "this machine has {:.0f}; the frame is not rendered",
                        window.columns(), window.rows(), needed,
                        maps > 0 ? " with its filters" : "", there));
        return false;
    }
    return true;
}

/// What estimators give: what a first hit tells, and what shaders leave in output parameters.
static std::vector<ChannelInfo> channelsGiven(const Scene &scene) {
    std::vector<ChannelInfo> channels = firstHitChannels(), own = outputParametersOf(scene);
    channels.insert(channels.end(), own.begin(), own.end());
    return channels;
}

std::vector<ChannelInfo> channelsToShow(const Scene &scene, const FilterStack &filters) {
    std::vector<ChannelInfo> channels = channelsGiven(scene);
    const std::vector<ChannelInfo> others = mapsOfEveryFilm();
    for (const MapInfo &map : filters.mapsSet())
        if (std::ranges::find(channels, map.name, &ChannelInfo::name) == channels.end() &&
            std::ranges::find(others, map.name, &ChannelInfo::name) == others.end())
            channels.push_back({map.name, map.channels});
    return channels;
}

Film::Settings filmSettings(const Scene &scene, const std::array<int, 4> &crop,
                            const PixelFilterSampler &filter, const FilterStack &filters) {
    const Options &options = scene.options();
    const std::vector<DisplayRecord> displays = displaysOf(options);
    const auto [width, height] = options.format.effectiveResolution();
    const auto [x0, x1, y0, y1] = crop;
    const std::vector<ChannelInfo> given = channelsGiven(scene);
    Film::Settings settings{{width, height, x0, x1, y0, y1},
                            wantedChannels(displays, channelsToShow(scene, filters)),
                            filter.hasNegativeLobes(),
                            wantsHalves(displays)};
    settings.splats = scene.isBidirectional();
    // Sums of splats are exact to a share of what light there is, in rooms and under the stars.
    if (const double typical = scene.lights().typicalRadiance(); settings.splats && typical > 0)
        settings.splatUnits.fill(commonSplatUnit * std::exp2(std::floor(std::log2(typical))));
    std::erase_if(settings.channels, [&](const ChannelInfo &channel) {
        return std::ranges::find(given, channel.name, &ChannelInfo::name) == given.end();
    });
    wantMaps(mapNames(filters), given, settings);
    return settings;
}

} // namespace candela
