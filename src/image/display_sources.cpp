// SPDX-License-Identifier: Apache-2.0
#include "image/display_sources.h"

#include "foundation/units/color.h"

#include <algorithm>

namespace candela {

namespace {

using Source = DisplayPlane::Source;

/// The map that a filter may have set in the place of the film's plane.
std::string mapName(const DisplayPlane &plane) {
    switch (plane.source) {
    case Source::Color: return "Ci";
    case Source::Alpha: return "Oi";
    case Source::Depth: return "Z";
    case Source::Variance: return "variance";
    case Source::Channel: break;
    }
    return plane.channel == "Ci" ? "radiance" : plane.channel == "z" ? "Z" : plane.channel;
}

const OwnedImage *filteredMap(const DisplaySources &sources, const DisplayPlane &plane) {
    if (!sources.filtered)
        return nullptr;
    const std::string name = mapName(plane);
    const bool set = plane.source == Source::Color ||
                     std::ranges::find(sources.filtered->set, name) != sources.filtered->set.end();
    return set ? sources.filtered->maps.find(name) : nullptr;
}

std::vector<float> ofMap(const ImageMaps &maps, const OwnedImage &map, const DisplayPlane &plane) {
    const std::string name = mapName(plane);
    if (plane.source == Source::Alpha)
        return meanOfPlanes(map.channels(), [&](int c) { return maps.plane(name, c); });
    return maps.plane(name, std::min(plane.component, map.channels() - 1));
}

std::vector<float> ofFilm(const Film &film, const DisplayPlane &plane, FilmHalf half) {
    if (plane.source == Source::Variance)
        return film.varianceOfMean(plane.component);
    const int channel = film.channelIndex(plane.channel);
    if (channel < 0)
        return {};
    if (plane.source == Source::Alpha)
        return meanOfPlanes(colorSamples, [&](int c) { return film.mean(channel, c, half); });
    return film.mean(channel, plane.component, half);
}

bool isImaged(const DisplaySources &sources, const DisplayPlane &plane) {
    return sources.imaged && (plane.source == Source::Color || plane.source == Source::Alpha);
}

} // namespace

std::optional<SourcePlane> sourcePlane(const DisplaySources &sources, const DisplayPlane &plane,
                                       FilmHalf half) {
    const bool whole = half == FilmHalf::Both;
    if (whole && isImaged(sources, plane))
        return SourcePlane{plane.source == Source::Color ? sources.imaged->color[plane.component]
                                                         : sources.imaged->alpha,
                           true};
    if (const OwnedImage *map = whole ? filteredMap(sources, plane) : nullptr)
        return SourcePlane{ofMap(sources.filtered->maps, *map, plane), false};
    std::vector<float> values = ofFilm(sources.film, plane, half);
    return values.empty() ? std::nullopt : std::optional(SourcePlane{std::move(values), false});
}

bool isFiltered(const DisplaySources &sources, const DisplayPlane &plane) {
    return filteredMap(sources, plane) != nullptr;
}

std::optional<PlaneSize> sizeOfPlane(const DisplaySources &sources, const DisplayPlane &plane) {
    if (isImaged(sources, plane))
        return sources.imaged->size;
    if (const OwnedImage *map = filteredMap(sources, plane))
        return PlaneSize{map->width(), map->height()};
    if (sources.film.channelIndex(plane.channel) < 0)
        return std::nullopt;
    return PlaneSize{sources.film.window().columns(), sources.film.window().rows()};
}

} // namespace candela
