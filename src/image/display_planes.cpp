// SPDX-License-Identifier: Apache-2.0
#include "image/display_planes.h"

#include "foundation/units/color.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

namespace candela {

namespace {

using Source = DisplayPlane::Source;

constexpr std::array<std::string_view, 7> letterModes{"rgb", "rgba", "a",    "z",
                                                      "az",  "rgbz", "rgbaz"};

/// Names of components: those of a place or direction for what is known to be one, else a
/// colour's.
std::string componentName(const ChannelInfo &channel, int component) {
    static constexpr std::array<std::string_view, 3> spatial{"N", "P", "Ng"};
    if (channel.components == 1)
        return channel.name;
    const bool place = channel.isPlace || std::ranges::find(spatial, channel.name) != spatial.end();
    const std::string letters = channel.isList ? "" : place ? "XYZ" : "RGBA";
    const std::string suffix = component < int(letters.size()) && channel.components <= 4
                                   ? std::string(1, letters[component])
                                   : std::to_string(component);
    return channel.name + "." + suffix;
}

void addColor(std::vector<DisplayPlane> &planes) {
    for (int c = 0; c < colorSamples; ++c)
        planes.push_back(
            {Source::Color, "Ci", c, c < 3 ? std::string(1, "RGB"[c]) : "C" + std::to_string(c)});
}

void addLetters(std::vector<DisplayPlane> &planes, std::string_view letters) {
    if (letters.starts_with("rgb"))
        addColor(planes);
    if (letters.find('a') != letters.npos)
        planes.push_back({Source::Alpha, "Oi", 0, "A"});
    if (letters.find('z') != letters.npos)
        planes.push_back({Source::Depth, "z", 0, "Z"});
}

void addComponents(std::vector<DisplayPlane> &planes, Source source, const std::string &filmName,
                   const ChannelInfo &shown) {
    for (int c = 0; c < shown.components; ++c)
        planes.push_back({source, filmName, c, componentName(shown, c)});
}

bool addItem(std::vector<DisplayPlane> &planes, const std::string &name,
             std::span<const ChannelInfo> available) {
    const auto known = std::ranges::find(available, name, &ChannelInfo::name);
    const bool depth = std::ranges::find(available, "z", &ChannelInfo::name) != available.end();
    const bool letters = std::ranges::find(letterModes, name) != letterModes.end();
    if (letters && (depth || name.find('z') == name.npos))
        addLetters(planes, name);
    else if (name == "Ci")
        addColor(planes);
    else if (name == "alpha")
        addLetters(planes, "a");
    else if (name == "Z" && depth)
        addLetters(planes, "z");
    else if (name == "radiance")
        addComponents(planes, Source::Channel, "Ci", {name, colorSamples});
    else if (name == "variance")
        addComponents(planes, Source::Variance, "Ci", {name, colorSamples});
    else if (name == "Oi")
        addComponents(planes, Source::Channel, "Oi", {name, colorSamples});
    else if (known != available.end() && !letters)
        addComponents(planes, Source::Channel, name, *known);
    else
        return false;
    return true;
}

bool isSame(const DisplayPlane &a, const DisplayPlane &b) {
    return a.source == b.source && a.channel == b.channel && a.component == b.component;
}

std::string knownModes(std::span<const ChannelInfo> available) {
    std::string known;
    for (std::string_view mode : letterModes)
        known += std::string(mode) + ", ";
    known += "Ci, Oi, radiance, variance";
    for (const ChannelInfo &channel : available)
        if (channel.name != "Ci" && channel.name != "Oi" && channel.name != "z")
            known += ", " + channel.name;
    return known;
}

/// The last word: the words before it declare its type.
std::string lastWord(const std::string &text) {
    std::istringstream words(text);
    std::string word, last;
    while (words >> word)
        last = word;
    return last;
}

} // namespace

std::optional<std::vector<DisplayPlane>> displayPlanes(const std::string &mode,
                                                       std::span<const ChannelInfo> available,
                                                       std::string &problem) {
    std::vector<DisplayPlane> planes;
    std::istringstream items(mode);
    std::string item;
    while (std::getline(items, item, ',')) {
        const std::string name = lastWord(item);
        if (!addItem(planes, name, available)) {
            problem = "unknown display mode or channel \"" + name + "\"; known are " +
                      knownModes(available);
            return std::nullopt;
        }
    }
    if (planes.empty()) {
        problem = "a display needs a mode; known are " + knownModes(available);
        return std::nullopt;
    }
    return planes;
}

std::string tellApart(std::vector<DisplayPlane> &planes) {
    std::string renamed;
    std::vector<DisplayPlane> kept;
    for (DisplayPlane &plane : planes) {
        const auto taken = [&] { return std::ranges::find(kept, plane.name, &DisplayPlane::name); };
        if (taken() != kept.end() && isSame(*taken(), plane))
            continue;
        const std::string wanted = plane.name;
        while (taken() != kept.end())
            plane.name = "shader." + plane.name;
        if (plane.name != wanted)
            renamed += (renamed.empty() ? "" : ", ") + wanted + " as " + plane.name;
        kept.push_back(std::move(plane));
    }
    planes = std::move(kept);
    return renamed;
}

DisplayRecord defaultDisplay(const std::string &name) {
    DisplayRecord display;
    display.name = name;
    display.type = "file";
    display.mode = "rgba";
    return display;
}

std::vector<DisplayRecord> displaysOf(const Options &options) {
    return options.displays.empty() ? std::vector{defaultDisplay("ri.exr")} : options.displays;
}

std::vector<ChannelInfo> wantedChannels(std::span<const DisplayRecord> displays,
                                        std::span<const ChannelInfo> available) {
    std::vector<ChannelInfo> wanted;
    const auto want = [&](const std::string &name) {
        const auto known = std::ranges::find(available, name, &ChannelInfo::name);
        const bool there = std::ranges::find(wanted, name, &ChannelInfo::name) != wanted.end();
        if (known != available.end() && !there)
            wanted.push_back(*known);
    };
    for (const DisplayRecord &display : displays) {
        std::string problem;
        if (const auto planes = displayPlanes(display.mode, available, problem))
            for (const DisplayPlane &plane : *planes)
                want(plane.channel);
    }
    return wanted;
}

bool wantsHalves(const DisplayRecord &display) {
    return std::ranges::any_of(display.parameters.all, [](const Parameter &parameter) {
        return parameter.name == "halfbuffers" && !parameter.floats.empty() &&
               parameter.floats[0] != 0;
    });
}

bool wantsHalves(std::span<const DisplayRecord> displays) {
    return std::ranges::any_of(displays,
                               [](const DisplayRecord &display) { return wantsHalves(display); });
}

} // namespace candela
