// SPDX-License-Identifier: Apache-2.0
// How the worlds of these tests are looked at.
#pragma once

#include "tests/support/frames.h"
#include "tests/support/program.h"

#include <numeric>
#include <string>

namespace candela::test {

/// Along +z at [-2,2] x [-2,2], 64 x 64 pixels.
inline std::string view(const std::string &integrator) {
    return "Option \"render\" \"string integrator\" [\"" + integrator +
           "\"]\nFormat 64 64 1\nProjection \"orthographic\"\nScreenWindow -2 2 -2 2\nTranslate 0 "
           "0 "
           "5\n";
}

inline double meanOf(const std::vector<float> &values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
}

/// A run of such a world, for what it says.
Outcome run(const std::string &world, const std::string &integrator = "path",
            const std::string &options = "");

} // namespace candela::test
