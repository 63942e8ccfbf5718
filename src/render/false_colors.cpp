// SPDX-License-Identifier: Apache-2.0
#include "render/false_colors.h"

#include "image/picture_maps.h"
#include "render/filter_words.h"
#include "render/filtering.h"

namespace candela {

bool showInFalseColors(Picture &picture, ProbeQuantity quantity,
                       const std::vector<std::string> &parameters, ShaderLibrary &shaders,
                       const Options &options, const FrameListeners &listeners) {
    std::vector<std::string> words{"falsecolor", quantity == ProbeQuantity::Irradiance
                                                     ? "quantity=illuminance"
                                                     : "quantity=luminance"};
    words.push_back("legend=2");
    words.insert(words.end(), parameters.begin(), parameters.end());
    std::vector<ShaderRecord> records;
    if (!readFilters(words, shaders, options, records, listeners.diagnostics))
        return false;
    const FilterStack stack(records, shaders, options);
    std::string problem;
    ImageMaps maps = mapsOf(picture, mapNames(stack), problem);
    if (stack.empty() || !problem.empty()) // What ails a filter has been said.
        return false;
    if (runFilters(stack, maps, listeners.console, listeners.diagnostics).interrupted) {
        listeners.diagnostics.error({}, "interrupted: nothing is written");
        return false;
    }
    putMaps(maps, {}, picture);
    picture.metadata["filters"] = textOf(stack.records(), 1);
    return true;
}

} // namespace candela
