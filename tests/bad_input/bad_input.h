// SPDX-License-Identifier: Apache-2.0
// A scene that is all right but for one thing.
#pragma once

#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <gtest/gtest.h>
#include <string>
#include <vector>

namespace candela::test {

/// A white disc in the middle of an 8 x 8 picture "out.exr"; `line` 8 of the file is the place for
/// what is wrong, before the disc.
std::string sceneWith(const std::string &wrong);
inline constexpr int wrongLine = 8;

class BadInput : public testing::Test {
protected:
    ScratchFolder folder_;

    /// Renders the text as scene.rib into the scratch folder.
    Outcome render(const std::string &rib, const std::vector<std::string> &more = {},
                   RunSettings settings = {});
    /// Did the disc come out: 1 in the middle of the picture, 0 in its corner?
    void expectDisc(const std::string &picture = "out.exr");
    /// Exit status 1, an error that says all these things, and the disc all the same.
    void expectReportedAndRendered(const std::string &wrong, const std::vector<std::string> &said);
    /// The same with the place of the wrong line.
    void expectErrorAtTheLine(const std::string &wrong, std::vector<std::string> said);
};

} // namespace candela::test
