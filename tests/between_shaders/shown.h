// SPDX-License-Identifier: Apache-2.0
// Runs of the program with the shaders of tests/between_shaders/shaders at hand, and a look at the
// planes of what they show.
#pragma once

#include "image/picture.h"
#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>

namespace candela::test {

/// Options: an orthographic view of [-1,1] x [-1,1], 8 x 8 pixels, one sample, a box filter.
std::string smallView(const std::string &displays);
/// A square of [-1,1] x [-1,1] at z, whose u runs from left to right.
std::string squareAt(const std::string &z);

class Shown : public testing::Test {
protected:
    ScratchFolder folder_;

    /// Renders; all has to go well, without a word.
    void render(const std::string &rib, const std::vector<std::string> &more = {});
    /// The values of a file's channel, row by row; empty (and a failure) if it is not there.
    std::vector<float> plane(const std::string &file, const std::string &channel);
    std::string bytes(const std::string &file) { return folder_.read(file); }
};

/// The mean of all of them.
double meanOf(const std::vector<float> &);

} // namespace candela::test
