// SPDX-License-Identifier: Apache-2.0
// Worlds that are lit by what both ends of a path have to find alike.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

struct World {
    std::string name;     ///< Letters and digits.
    std::string camera;   ///< RIB before the view's translation: mirrorings, scales, turns.
    std::string text;     ///< RIB between WorldBegin and WorldEnd, si units.
    bool mayWarn = false; ///< Not all of it begins paths on lights, and that is said.
};

/// A room of 2 m with an open front, seen from there.
std::vector<World> worlds();

/// The walls of the room: red on the left, green on the right.
std::string room();
/// A lamp of that radiance, made by `shape`.
std::string lamp(const std::string &shape, double radiance, const std::string &more = "");

} // namespace candela::test
