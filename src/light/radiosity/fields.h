// SPDX-License-Identifier: Apache-2.0
// What is known at each node of each element.
#pragma once

#include "light/radiosity/mesh.h"

namespace candela::radiosity {

using Color = std::array<float, colorSamples>;

/// W m^-2 but where it says otherwise; values of element e begin at Mesh::stride() * e. Those of
/// elements with children follow from the children's.
struct Fields {
    std::vector<Color> direct;   ///< Irradiance of light sources that samples are taken of.
    std::vector<Color> lamps;    ///< Irradiance of surfaces that shine, which links bring.
    std::vector<Color> emission; ///< Exitance that these surfaces have of themselves.
    std::vector<Color> gathered; ///< Irradiance that links bring to this very element.
    std::vector<Color> indirect; ///< Irradiance of other surfaces, of links to parents too.
    std::vector<Color> exitance;
    std::vector<Color> reflectance, transmittance; ///< See Response.
    std::vector<Color> ambient;                    ///< Exitance that ambient lights leave.

    void resize(const Mesh &mesh) {
        const std::size_t count = std::size_t(mesh.size()) * std::size_t(mesh.stride());
        for (std::vector<Color> *field : {&direct, &lamps, &emission, &gathered, &indirect,
                                          &exitance, &reflectance, &transmittance, &ambient})
            field->resize(count);
    }
};

inline float brightest(const Color &color) {
    float most = 0;
    for (float c : color)
        most = c > most ? c : most;
    return most;
}

/// Values of an element from those of its children.
void pull(const Mesh &, int element, std::vector<Color> &);
/// Values of child `c` of an element: the element's own, where it lies.
void push(const Mesh &, int element, int c, const std::vector<Color> &from, std::vector<Color> &to);

} // namespace candela::radiosity
