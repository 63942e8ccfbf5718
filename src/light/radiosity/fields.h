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

/// Calls `serve` with where the values of each node of each root stand, and its area.
template <class Serve> void forEachRootNode(const Mesh &mesh, const Serve &serve) {
    for (const Face &face : mesh.faces()) {
        if (face.root < 0)
            continue;
        const std::size_t first = std::size_t(face.root) * std::size_t(mesh.stride());
        const std::span<const Node> nodes = mesh.nodes(face.root);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            serve(first + i, nodes[i].area);
    }
}

/// Of all leaves: a field's brightest colour times area. Polynomials of large elements may be
/// negative where light is elsewhere.
double flux(const Mesh &, const std::vector<Color> &);

/// Values of an element from those of its children; of cut ones, side by side.
void pull(const Mesh &, int element, std::vector<Color> &);
/// Values of child `c` of an element: the element's own, where it lies.
void push(const Mesh &, int element, int c, const std::vector<Color> &from, std::vector<Color> &to);

} // namespace candela::radiosity
