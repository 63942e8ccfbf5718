// SPDX-License-Identifier: Apache-2.0
#include "tests/light/linked_lamps.h"

namespace candela::test {

std::string taggedLamp(int number, double x, double y, double size, double radiance,
                       const std::string &tags) {
    const double a = size / 2;
    auto corner = [&](double dx, double dy) {
        return std::to_string(x + dx) + " " + std::to_string(y + dy) + " 1.5 ";
    };
    return "AttributeBegin\nAreaLightSource \"taggedlamp\" " + std::to_string(number) +
           " \"float radiance\" [" + std::to_string(radiance) + "] " + tags +
           "\nSurface \"matte\" \"float Kd\" [0] \"float Ka\" [0]\nPolygon \"P\" [" +
           corner(-a, -a) + corner(a, -a) + corner(a, a) + corner(-a, a) +
           "]\nAttributeEnd\nIlluminate " + std::to_string(number) + " 1\n";
}

} // namespace candela::test
