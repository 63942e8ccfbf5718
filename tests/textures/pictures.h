// SPDX-License-Identifier: Apache-2.0
// Pictures to look things up in, and shaders that tell what they have found.
#pragma once

#include "tests/support/program.h"
#include "tests/support/scratch_folder.h"

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace candela::test {

/// The value of a channel at a pixel.
using Pixels = std::function<float(int x, int y, int channel)>;

/// A float file with channels of these names ("R", "G", "B", "A", or "Y").
void writeExr(const ScratchFolder &, const std::string &name, int width, int height,
              const std::vector<std::string> &channels, const Pixels &);
/// An 8-bit file of 1 or 3 channels that says nothing of its colours (TGA); values from 0 to 255.
void writeEightBit(const ScratchFolder &, const std::string &name, int width, int height,
                   int channels, const Pixels &);

/// A PNG file of 3 channels of 16 bits; values from 0 to 65535. It says of its colours that they
/// are light^(1/gamma), or nothing.
void writeSixteenBit(const ScratchFolder &, const std::string &name, int width, int height,
                     std::optional<float> gamma, const Pixels &);

/// What a surface's expressions of type float come to at one point, (s,t) = (.5,.5), `before` being
/// done first. The run's messages are handed out, too.
struct Told {
    std::vector<float> values;
    Outcome run;
};
struct Telling {
    std::vector<std::string> expressions;
    std::string before{};   ///< Statements of the shader.
    std::string requests{}; ///< Of the RIB, before the world.
    std::string lanes = "16";
    std::string integrator = "classic";
};
Told tell(const ScratchFolder &, const Telling &);

} // namespace candela::test
