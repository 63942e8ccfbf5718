// SPDX-License-Identifier: Apache-2.0
#include "render/filter_file.h"

#include "foundation/base/parallel.h"
#include "foundation/base/whole_file.h"
#include "image/imaging.h"
#include "image/picture_file.h"
#include "image/picture_maps.h"
#include "render/filter_words.h"
#include "render/filtering.h"
#include "render/interrupt.h"
#include "render/picture_output.h"
#include "render/shader_folders.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fmt/format.h>
#include <new>
#include <unistd.h>

namespace candela {

namespace {

/// Filters want light, that of whole pixels.
void makeLinear(Picture &picture) {
    const PictureChannel *const alpha = picture.find("A");
    for (PictureChannel &channel : picture.channels)
        if (isColorChannel(channel.name) || channel.name == "Y")
            for (std::size_t i = 0; i < channel.values.size(); ++i)
                channel.values[i] =
                    wholeColor(linearOfSrgb(channel.values[i]), alpha ? alpha->values[i] : 1);
    picture.hasDisplayValues = false;
}

void note(Picture &picture, const FilterStack &stack) {
    if (stack.records().empty())
        return;
    std::string &text = picture.metadata["filters"]; // Of a picture that has been filtered before,
    text += (text.empty() ? "" : "; ") + textOf(stack.records(), int(stack.records().size()));
}

/// Everything behind the command line; what is wrong is reported.
class FilterRun {
public:
    explicit FilterRun(const FilterFileSettings &settings)
        : settings_(settings),
          console_(settings.quiet ? Console::Words::Messages : Console::Words::Results),
          folders_(shaderFolders("", settings.shaderPath, console_)),
          shaders_({folders_.all, folders_.library, settings.jit, {"."}}, console_) {}

    int status() {
        const bool written = run();
        return interrupted_ ? statusOfInterrupt : written && !console_.failed() ? 0 : 1;
    }

private:
    bool run() {
        std::vector<ShaderRecord> records;
        if (!readFilters(settings_.filters, shaders_, options_, records, console_))
            return false;
        const FilterStack stack(records, shaders_, options_);
        if (stack.records().size() < records.size()) // It has said why.
            return false;
        std::string problem;
        std::optional<Picture> picture;
        if (canWriteFile(settings_.output, problem))
            picture = readPicture(settings_.input, problem);
        if (!picture)
            return fail(problem);
        if (picture->hasDisplayValues)
            makeLinear(*picture);
        return filter(stack, *picture);
    }

    bool filter(const FilterStack &stack, Picture &picture) {
        std::string problem;
        ImageMaps maps = mapsOf(picture, mapNames(stack), problem);
        if (!problem.empty())
            return fail(settings_.input + ": " + problem);
        const std::vector<std::string> given = maps.names();
        makeFinite(*maps.find("Ci"), "the picture", console_);
        console_.begin("filtering");
        interrupted_ = runFilters(stack, maps, console_, console_).interrupted;
        if (interrupted_)
            return fail("interrupted: nothing is written");
        const std::vector<std::string> lost = putMaps(maps, toWrite(stack, given), picture);
        if (!lost.empty())
            console_.warning({},
                             fmt::format("filters have changed the size of the picture, so that "
                                         "these channels are left out: {}",
                                         fmt::join(lost, ", ")));
        note(picture, stack);
        if (!writePicture(picture, settings_.output, settings_.exposure, problem))
            return fail(problem);
        console_.end("wrote " + settings_.output);
        return true;
    }

    /// Of the maps that filters set those that the picture has, and those that are asked for:
    /// others are for the filters' own use.
    std::vector<std::string> toWrite(const FilterStack &stack,
                                     const std::vector<std::string> &given) const {
        const auto isIn = [](const std::vector<std::string> &names, const std::string &name) {
            return std::ranges::find(names, name) != names.end();
        };
        std::vector<std::string> names;
        for (const MapInfo &map : stack.mapsSet())
            if (isIn(given, map.name) || isIn(settings_.kept, map.name))
                names.push_back(map.name);
        return names;
    }

    bool fail(const std::string &problem) {
        console_.error({}, problem);
        return false;
    }

    const FilterFileSettings &settings_;
    Console console_;
    ShaderFolders folders_;
    ShaderLibrary shaders_;
    const Options options_;
    bool interrupted_ = false;
};

} // namespace

int filterFile(const FilterFileSettings &settings) {
    const ThreadLimit threads(settings.threads);
    FilterRun run(settings);
    try {
        return run.status();
    } catch (const std::bad_alloc &) {
        std::fprintf(stderr, "error: there is not enough memory for this picture; nothing is "
                             "written\n");
        return 1;
    }
}

} // namespace candela
