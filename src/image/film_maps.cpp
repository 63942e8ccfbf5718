// SPDX-License-Identifier: Apache-2.0
#include "image/film_maps.h"

#include "foundation/units/color.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

namespace {

/// The maps that are not named as the film's channels are.
struct Source {
    const char *map, *channel;
    FilmHalf half = FilmHalf::Both;
    bool variance = false;
};
constexpr std::array<Source, 6> sources{{{"Ci", "Ci"},
                                         {"radiance", "Ci"},
                                         {"Z", "z"},
                                         {"half0", "Ci", FilmHalf::Even},
                                         {"half1", "Ci", FilmHalf::Odd},
                                         {"variance", "Ci", FilmHalf::Both, true}}};

Source sourceOf(const std::string &name) {
    const auto known =
        std::ranges::find_if(sources, [&](const Source &source) { return name == source.map; });
    return known == sources.end() ? Source{name.c_str(), name.c_str()} : *known;
}

int componentsOf(std::span<const ChannelInfo> channels, std::string_view name) {
    if (name == "Ci" || name == "Oi")
        return colorSamples;
    const auto known = std::ranges::find(channels, name, &ChannelInfo::name);
    return known == channels.end() ? 0 : known->components;
}

std::vector<float> planeOf(const Film &film, const Source &source, int component) {
    return source.variance ? film.varianceOfMean(component)
                           : film.mean(film.channelIndex(source.channel), component, source.half);
}

void setMap(ImageMaps &maps, const std::string &name, const Film &film) {
    const Source source = sourceOf(name);
    const int components = componentsOf(film.channels(), source.channel);
    if (components == 0 || (source.half != FilmHalf::Both && !film.keepsHalves()))
        return;
    maps.set(name, OwnedImage(film.window().columns(), film.window().rows(), components));
    for (int c = 0; c < components; ++c) {
        std::vector<float> plane = planeOf(film, source, c);
        for (float &value : plane)
            if (!std::isfinite(value))
                value = 0;
        maps.setPlane(name, c, plane);
    }
}

} // namespace

std::vector<ChannelInfo> mapsOfEveryFilm() {
    std::vector<ChannelInfo> maps{{"Oi", colorSamples}};
    for (const Source &source : sources)
        maps.push_back({source.map, source.channel == std::string_view("z") ? 1 : colorSamples});
    return maps;
}

void wantMaps(std::span<const std::string> names, std::span<const ChannelInfo> available,
              Film::Settings &film) {
    for (const std::string &name : names) {
        const Source source = sourceOf(name);
        film.keepHalves |= source.half != FilmHalf::Both;
        const auto known =
            std::ranges::find(available, std::string_view(source.channel), &ChannelInfo::name);
        if (known != available.end() && componentsOf(film.channels, source.channel) == 0)
            film.channels.push_back(*known);
    }
}

void addMaps(const Film &film, std::span<const std::string> names, ImageMaps &maps) {
    setMap(maps, "Ci", film);
    for (const std::string &name : names)
        if (!maps.find(name))
            setMap(maps, name, film);
}

double bytesOfMaps(std::span<const std::string> names, const Film::Settings &film) {
    const FrameWindow &w = film.window;
    const auto bytes = [&](int channels) {
        return OwnedImage::bytesNeeded(w.columns(), w.rows(), channels);
    };
    double sum = 2 * bytes(colorSamples);
    for (const std::string &name : names)
        if (const int channels = componentsOf(film.channels, sourceOf(name).channel); channels > 0)
            sum += bytes(channels);
    return sum;
}

} // namespace candela
