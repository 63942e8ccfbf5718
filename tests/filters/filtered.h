// SPDX-License-Identifier: Apache-2.0
// Runs of the program with the filters of tests/filters/shaders at hand.
#pragma once

#include "image/picture.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

/// Options of small frames: 16 x 12 pixels, a box filter, one sample, si units.
std::string smallFrame(const std::string &more = {});
/// A world: a constant field of that colour behind all of the picture.
std::string plainWorld(const std::string &color = "0.25 0.25 0.25");
/// A world: a matte ball of albedo .6 in front of nothing, without lights.
std::string ballWorld(const std::string &surface = "Color .6 .6 .6 Surface \"matte\" \"Kd\" [1]");

class Filtered : public testing::Test {
protected:
    ScratchFolder folder_;

    Outcome run(const std::string &rib, const std::vector<std::string> &more = {});
    /// `candela filter` on files of the folder.
    Outcome filter(const std::string &in, const std::string &out,
                   const std::vector<std::string> &words);
    /// Renders; all has to go well, without a word.
    void render(const std::string &rib, const std::vector<std::string> &more = {});
    Picture read(const std::string &name);
    /// A channel's value at a pixel of the picture's window; NaN if there is none.
    float at(const std::string &name, const std::string &channel, int x, int y);
    /// Its value if it is the same everywhere; else NaN.
    float everywhere(const std::string &name, const std::string &channel);
    std::vector<std::string> channelsOf(const std::string &name);
};

} // namespace candela::test
