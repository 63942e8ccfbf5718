// SPDX-License-Identifier: Apache-2.0
#include "image/view/view_layers.h"

#include <algorithm>
#include <array>
#include <string_view>

namespace candela {

static int placeOf(const Picture &picture, const std::string &name) {
    const auto found = std::ranges::find(picture.channels, name, &PictureChannel::name);
    return found == picture.channels.end() ? -1 : int(found - picture.channels.begin());
}

std::vector<ViewLayer> layersOf(const Picture &picture) {
    constexpr std::array<std::array<std::string_view, 3>, 2> triples{
        {{"R", "G", "B"}, {"X", "Y", "Z"}}};
    std::vector<ViewLayer> layers;
    std::vector<bool> taken(picture.channels.size(), false);
    const auto addTriple = [&](const std::string &prefix,
                               const std::array<std::string_view, 3> &ends) {
        ViewLayer layer;
        for (const std::string_view end : ends)
            layer.channels.push_back(placeOf(picture, prefix + std::string(end)));
        if (std::ranges::find(layer.channels, -1) != layer.channels.end())
            return;
        const bool isColor = ends == triples[0];
        layer.name =
            prefix.empty() ? (isColor ? "color" : "XYZ") : prefix.substr(0, prefix.size() - 1);
        layer.isLight = isColor && prefix.empty();
        for (const int channel : layer.channels)
            taken[std::size_t(channel)] = true;
        if (isColor)
            layer.alpha = placeOf(picture, prefix + "A");
        if (layer.alpha >= 0)
            taken[std::size_t(layer.alpha)] = true;
        layers.push_back(std::move(layer));
    };
    for (std::size_t k = 0; k < picture.channels.size(); ++k) {
        const std::string &name = picture.channels[k].name;
        const std::string prefix = name.substr(0, name.rfind('.') + 1);
        for (const auto &ends : triples)
            if (!taken[k] && std::ranges::find(ends, name.substr(prefix.size())) != ends.end())
                addTriple(prefix, ends);
        if (!taken[k] && name != prefix + "A") // An alpha may belong to colours behind it.
            layers.push_back({name, {int(k)}, -1, false});
    }
    for (std::size_t k = 0; k < picture.channels.size(); ++k)
        if (const std::string &name = picture.channels[k].name;
            !taken[k] && std::ranges::find(layers, name, &ViewLayer::name) == layers.end())
            layers.push_back({name, {int(k)}, -1, false});
    return layers;
}

} // namespace candela
