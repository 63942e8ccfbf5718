// SPDX-License-Identifier: Apache-2.0
// Runs `candela probe` on scenes and points that tests write, and reads its answers.
#pragma once

#include "tests/support/program.h"

#include <string>
#include <vector>

namespace candela::test {

/// A line of the answer.
struct Answer {
    double R = 0, G = 0, B = 0, total = 0, photometric = 0, halfWidth = 0;
    int samples = 0;
};

struct Probed {
    Outcome run;
    std::vector<Answer> answers; ///< Of plain output; lines that are none are left out.
};

/// The scene is a whole RIB text, the points are lines.
Probed probe(const std::string &scene, const std::string &points,
             std::vector<std::string> options = {});

/// A world behind si units.
std::string siWorld(const std::string &world, const std::string &camera = "");

/// A black lamp of that radiance, switched on for all.
std::string lamp(const std::string &shape, double radiance = 1, bool oneSided = true);

} // namespace candela::test
