// SPDX-License-Identifier: Apache-2.0
#include "tests/filter_library/support/filter_run.h"

#include "foundation/base/parallel.h"
#include "image/filter/filter_stack.h"

#include <gtest/gtest.h>

namespace candela::filters {

namespace {

ShaderLibrarySettings settingsFor(const Ways &ways) {
    const std::string source = CANDELA_SOURCE_DIR;
    ShaderLibrarySettings settings;
    settings.folders = {source + "/shaders/filter", source + "/tests/filter_library/shaders"};
    settings.libraryFolders = {source + "/shaders/surface"};
    settings.jit.width = ways.lanes;
    settings.jit.level = ways.level;
    return settings;
}

std::vector<float> planeOf(const Picture &picture, int channel) {
    std::vector<float> plane;
    plane.reserve(picture.pixels.size());
    for (const Rgb &pixel : picture.pixels)
        plane.push_back(float(pixel[channel]));
    return plane;
}

} // namespace

Filter Filter::with(const std::string &name, const std::string &value) const {
    Parameter parameter;
    parameter.name = name;
    parameter.declaration.type = ValueType::String;
    parameter.strings = {value};
    return with(std::move(parameter));
}

Filter Filter::withAll(const std::string &name, const std::vector<double> &values) const {
    Parameter parameter;
    parameter.name = name;
    parameter.declaration.arraySize = int(values.size());
    parameter.floats.assign(values.begin(), values.end());
    return with(std::move(parameter));
}

ShaderRecord Filter::record() const {
    ShaderRecord record;
    record.name = name_;
    record.parameters.all = parameters_;
    return record;
}

Filter Filter::with(Parameter parameter) const {
    Filter changed = *this;
    auto &all = changed.parameters_;
    std::erase_if(all, [&](const Parameter &old) { return old.name == parameter.name; });
    all.push_back(std::move(parameter));
    return changed;
}

ImageMaps mapsOf(const Picture &picture) {
    ImageMaps maps;
    setMap(maps, "Ci", picture);
    setMap(maps, "Oi", Picture(picture.width, picture.height, {1, 1, 1}));
    return maps;
}

void setMap(ImageMaps &maps, const std::string &name, const Picture &picture) {
    maps.set(name, OwnedImage(picture.width, picture.height, 3));
    for (int c = 0; c < 3; ++c)
        maps.setPlane(name, c, planeOf(picture, c));
}

Picture pictureOf(const ImageMaps &maps, const std::string &name) {
    const OwnedImage *image = maps.find(name);
    if (!image)
        return {};
    Picture picture(image->width(), image->height());
    for (int c = 0; c < 3; ++c) {
        const std::vector<float> plane = maps.plane(name, c < image->channels() ? c : 0);
        for (std::size_t i = 0; i < plane.size(); ++i)
            picture.pixels[i][c] = plane[i];
    }
    return picture;
}

void run(const std::vector<Filter> &filters, ImageMaps &maps, const Ways &ways,
         std::string *messages) {
    DiagnosticList diagnostics;
    ShaderLibrary library(settingsFor(ways), diagnostics);
    std::vector<ShaderRecord> records;
    for (const Filter &filter : filters)
        records.push_back(filter.record());
    const FilterStack stack(records, library, Options());
    const ThreadLimit limit(ways.threads);
    makeFinite(*maps.find("Ci"), "the picture", diagnostics);
    EXPECT_TRUE(stack.run(maps, {diagnostics, {}, {}}));
    if (messages)
        *messages = diagnostics.text();
    else
        EXPECT_EQ(diagnostics.text(), "");
}

Picture filtered(const Filter &filter, const Picture &picture, const Ways &ways) {
    ImageMaps maps = mapsOf(picture);
    run({filter}, maps, ways);
    return pictureOf(maps);
}

} // namespace candela::filters
