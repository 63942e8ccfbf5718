// SPDX-License-Identifier: Apache-2.0
// Small worlds with volumes, seen along +z from the origin by parallel rays, and what of them is to
// be seen.
#pragma once

#include <string>
#include <vector>

namespace candela::test {

enum class By { Both, Classic, Path };

struct World {
    std::string name, rib;
    double red, alpha = 1;
    By by = By::Both;
    std::string options = ""; ///< Of the picture.
};

/// Renders each by its integrators, and expects every pixel to be as far from its numbers as
/// `tolerance` (relative, and beside 1 absolute) at the most.
void expectEach(const std::vector<World> &, double tolerance, int samples = 1);

/// The mean of all pixels of all seeds from 1 on, by `path` or `classic`.
std::vector<double> meansOf(const World &, const std::string &integrator, int seeds, int samples);

/// A square about (0,0,z), 2 wide, with these words before it: facing the eye, or turned away.
std::string square(double z, const std::string &words = "", bool turned = false);
/// One that is of this colour, and this opaque.
std::string sheet(double z, double color, double opacity = 1);
/// "Atmosphere "name" ..."
std::string fogOf(double distance, double background);
std::string text(double);

} // namespace candela::test
