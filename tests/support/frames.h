// SPDX-License-Identifier: Apache-2.0
// Many small pictures of one run.
#pragma once

#include "foundation/base/student.h"

#include <string>
#include <vector>

namespace candela::test {

struct Frame {
    std::string name;    ///< For messages.
    std::string options; ///< RIB before WorldBegin: the projection, transformations, options.
    std::string world;   ///< RIB between WorldBegin and WorldEnd.
};

struct FramePixels {
    std::vector<float> red, alpha, green;
};

struct FrameSettings {
    int samples = 1; ///< A pixel.
    int seed = 1;
    std::string shaders; ///< A folder of tests/ with shaders.
    bool mayWarn = false;
};

/// Renders all frames in one run, in si units with a box filter of one pixel; 8 x 8 pixels, unless
/// options have another Format. A run that fails gives nothing.
std::vector<FramePixels> render(const std::vector<Frame> &frames, const FrameSettings &);

/// The red of a picture, and by how much it is more than another's, over all pixels.
struct RedComparison {
    double mean = 0; ///< Of the first picture.
    MeanAndError difference;
};
RedComparison compareRed(const FramePixels &, const FramePixels &other);

} // namespace candela::test
