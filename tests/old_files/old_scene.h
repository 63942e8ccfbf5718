// SPDX-License-Identifier: Apache-2.0
// For tests: scenes in a folder of their own, rendered to eight by eight pixels.
#pragma once

#include "image/picture_file.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace candela::test {

inline const std::string head = "Format 8 8 1\nPixelFilter \"box\" 1 1\n"
                                "Display \"out.exr\" \"openexr\" \"rgb\"\n";
/// A white wall behind, which the eye sees all over, from z = 4.
inline const std::string wall = "Surface \"matte\"\n"
                                "Polygon \"P\" [-9 -9 4  -9 9 4  9 9 4  9 -9 4]\n";

class OldScene : public testing::Test {
protected:
    ScratchFolder folder_;

    Outcome render(const std::string &rib, std::vector<std::string> more = {},
                   const RunSettings &settings = {}) {
        if (std::ranges::find(more, "--spp") == more.end())
            more.insert(more.end(), {"--spp", "16"});
        more.insert(more.begin(),
                    {folder_.write("scene.rib", rib), "--output-dir", folder_.path(), "--quiet"});
        return runCandela(more, settings);
    }
    float red(std::size_t pixel, const std::string &name = "out.exr") {
        return value(pixel, "R", name);
    }
    float value(std::size_t pixel, const std::string &channel, const std::string &name) {
        std::string problem;
        const auto picture = readPicture(folder_.path(name), problem);
        EXPECT_TRUE(picture) << problem;
        return picture ? picture->find(channel)->values.at(pixel) : -1;
    }
};

} // namespace candela::test
