// SPDX-License-Identifier: Apache-2.0
#include "image/picture_maps.h"

#include "foundation/units/color.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace candela {

namespace {

using Planes = std::vector<const PictureChannel *>;

/// The channels of these names; empty unless all are there.
Planes channelsOf(const Picture &picture, std::initializer_list<std::string> names) {
    Planes planes;
    for (const std::string &name : names)
        if (const PictureChannel *channel = picture.find(name))
            planes.push_back(channel);
    return planes.size() == names.size() ? planes : Planes{};
}

Planes firstOf(std::initializer_list<Planes> choices) {
    for (const Planes &planes : choices)
        if (!planes.empty())
            return planes;
    return {};
}

/// The channel of that name, or those of the layer: directions in XYZ, colours in RGB, others by
/// number.
Planes layer(const Picture &picture, const std::string &name) {
    Planes numbered;
    while (const PictureChannel *next = picture.find(name + "." + std::to_string(numbered.size())))
        numbered.push_back(next);
    return firstOf({channelsOf(picture, {name}),
                    channelsOf(picture, {name + ".R", name + ".G", name + ".B", name + ".A"}),
                    channelsOf(picture, {name + ".R", name + ".G", name + ".B"}),
                    channelsOf(picture, {name + ".X", name + ".Y", name + ".Z"}), numbered});
}

/// One channel counts for all samples of a color.
Planes ofColor(Planes planes) {
    if (planes.size() == 1)
        planes.resize(colorSamples, planes[0]);
    return planes;
}

Planes channelsOfColor(const Picture &picture) {
    return ofColor(firstOf({channelsOf(picture, {"R", "G", "B"}), channelsOf(picture, {"Y"}),
                            layer(picture, "radiance")}));
}

Planes channelsOfMap(const Picture &picture, const std::string &name) {
    if (name == "Ci")
        return channelsOfColor(picture);
    if (name == "Oi")
        return ofColor(firstOf({layer(picture, "Oi"), channelsOf(picture, {"A"})}));
    return layer(picture, name);
}

void setMap(ImageMaps &maps, const std::string &name, const Picture &picture) {
    const Planes planes = channelsOfMap(picture, name);
    if (planes.empty() && name == "Oi") { // Who says nothing of opacity has an opaque picture.
        const std::vector<float> opaque(picture.window.pixels(), 1);
        maps.set(name, OwnedImage(picture.window.columns(), picture.window.rows(), colorSamples));
        for (int c = 0; c < colorSamples; ++c)
            maps.setPlane(name, c, opaque);
    }
    if (planes.empty())
        return;
    maps.set(name, OwnedImage(picture.window.columns(), picture.window.rows(), int(planes.size())));
    for (std::size_t c = 0; c < planes.size(); ++c) {
        std::vector<float> values = planes[c]->values;
        for (float &value : values)
            if (name != "Ci" && !std::isfinite(value))
                value = 0;
        maps.setPlane(name, int(c), values);
    }
}

/// Where a map goes: the channels that it came from, else new ones.
std::vector<std::string> channelNames(const Picture &picture, const std::string &map,
                                      int channels) {
    if (map == "Ci")
        return {"R", "G", "B"};
    std::vector<std::string> names;
    for (const PictureChannel *channel : layer(picture, map))
        names.push_back(channel->name);
    if (int(names.size()) == channels)
        return names;
    if (map == "Oi" || channels == 1)
        return {map == "Oi" ? "A" : map};
    names.clear();
    for (int c = 0; c < channels; ++c)
        names.push_back(map + "." +
                        (channels <= 4 ? std::string(1, "RGBA"[c]) : std::to_string(c)));
    return names;
}

/// Plane `c` of those that channelNames() has `count` names for; of fewer names than the map has
/// channels, their mean.
std::vector<float> planeOf(const ImageMaps &maps, const std::string &name, int c, int count) {
    const int channels = maps.find(name)->channels();
    if (count == channels)
        return maps.plane(name, c);
    return meanOfPlanes(channels, [&](int other) { return maps.plane(name, other); });
}

void putChannel(Picture &picture, const std::string &name, std::vector<float> values) {
    const auto at = std::ranges::find(picture.channels, name, &PictureChannel::name);
    if (at == picture.channels.end())
        picture.channels.push_back({name, std::move(values)});
    else
        at->values = std::move(values);
}

/// A picture of another size is a frame of its own; channels that are not set are taken out.
std::vector<std::string> resize(Picture &picture, int width, int height) {
    std::vector<std::string> lost;
    for (const PictureChannel &channel : picture.channels)
        lost.push_back(channel.name);
    picture.channels.clear();
    picture.window = {width, height, 0, width, 0, height};
    picture.worldToNdc.reset(); // Nobody knows what the pixels show now.
    return lost;
}

} // namespace

ImageMaps mapsOf(const Picture &picture, std::span<const std::string> names, std::string &problem) {
    ImageMaps maps;
    setMap(maps, "Ci", picture);
    if (!maps.find("Ci")) {
        problem = "it has no colours: expected channels R, G, B (or Y, or radiance.R ...)";
        return {};
    }
    for (const std::string &name : names)
        if (!maps.find(name))
            setMap(maps, name, picture);
    return maps;
}

std::vector<std::string> putMaps(const ImageMaps &maps, std::span<const std::string> set,
                                 Picture &picture) {
    const OwnedImage &Ci = *maps.find("Ci");
    std::vector<std::string> names{"Ci"}, lost;
    for (const std::string &name : set)
        if (const OwnedImage *map = maps.find(name);
            map && map->width() == Ci.width() && map->height() == Ci.height())
            names.push_back(name);
    std::vector<std::vector<std::string>> channels;
    for (const std::string &name : names)
        channels.push_back(channelNames(picture, name, maps.find(name)->channels()));
    if (Ci.width() != picture.window.columns() || Ci.height() != picture.window.rows())
        lost = resize(picture, Ci.width(), Ci.height());
    else // Grey has become colours.
        std::erase_if(picture.channels,
                      [](const PictureChannel &channel) { return channel.name == "Y"; });
    for (std::size_t k = 0; k < names.size(); ++k)
        for (std::size_t c = 0; c < channels[k].size(); ++c)
            putChannel(picture, channels[k][c],
                       planeOf(maps, names[k], int(c), int(channels[k].size())));
    std::erase_if(lost, [&](const std::string &name) { return picture.find(name) != nullptr; });
    return lost;
}

} // namespace candela
