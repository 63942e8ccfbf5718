// SPDX-License-Identifier: Apache-2.0
#include "render/filtering.h"

#include "render/interrupt.h"

#include <algorithm>
#include <fmt/format.h>

namespace candela {

namespace {

std::string textOf(const Parameter &parameter) {
    std::string text = parameter.name + "=";
    const std::size_t start = text.size();
    for (const std::string &value : parameter.strings)
        text += (text.size() > start ? "," : "") + value;
    for (float value : parameter.floats)
        text += (text.size() > start ? "," : "") + fmt::format("{:g}", value);
    return text;
}

} // namespace

std::string textOf(const std::vector<ShaderRecord> &filters, int count) {
    std::string text;
    for (int k = 0; k < count; ++k) {
        text += (k > 0 ? "; " : "") + filters[k].name;
        for (const Parameter &parameter : filters[k].parameters.all)
            text += " " + textOf(parameter);
    }
    return text;
}

std::vector<std::string> mapNames(const FilterStack &stack) {
    std::vector<std::string> names = stack.mapsRead();
    for (const MapInfo &map : stack.mapsSet())
        names.push_back(map.name);
    std::ranges::sort(names);
    names.erase(std::ranges::unique(names).begin(), names.end());
    return names;
}

FilteringOutcome runFilters(const FilterStack &stack, ImageMaps &maps, Console &console,
                            DiagnosticSink &diagnostics) {
    const Interrupt interrupt;
    const int all = int(stack.records().size());
    FilteringOutcome outcome;
    const auto progress = [&](const std::string &filter, int done, double part) {
        outcome.done = done;
        const int at = std::min(done + 1, all);
        console.step(fmt::format("filtering: {} ({} of {})", filter, at, all), part);
    };
    if (stack.run(maps, {diagnostics, progress, [&] { return interrupt.asked(); }}))
        outcome.done = all;
    else
        outcome.interrupted = true;
    if (outcome.done > 0)
        makeFinite(*maps.find("Ci"), "what filters made", diagnostics);
    return outcome;
}

} // namespace candela
