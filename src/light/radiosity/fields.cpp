// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/fields.h"

namespace candela::radiosity {

double flux(const Mesh &mesh, const std::vector<Color> &field) {
    double flux = 0;
    forEachRootNode(
        mesh, [&](std::size_t at, float area) { flux += double(brightest(field[at])) * area; });
    return flux;
}

void pull(const Mesh &mesh, int element, std::vector<Color> &field) {
    const Basis &basis = mesh.basis(element);
    const std::size_t stride = std::size_t(mesh.stride());
    const std::size_t first = stride * std::size_t(mesh.element(element).firstChild);
    for (int i = 0; i < basis.nodes(); ++i) {
        Color sum{};
        for (int c = 0; c < Basis::children; ++c)
            for (int j = 0; j < basis.nodes(); ++j)
                for (std::size_t k = 0; k < colorSamples; ++k)
                    sum[k] += basis.fromChild(c, i, j) *
                              field[first + stride * std::size_t(c) + std::size_t(j)][k];
        field[stride * std::size_t(element) + std::size_t(i)] = sum;
    }
}

void push(const Mesh &mesh, int element, int c, const std::vector<Color> &from,
          std::vector<Color> &to) {
    const Basis &basis = mesh.basis(element);
    const std::size_t stride = std::size_t(mesh.stride());
    const std::size_t child = stride * std::size_t(mesh.element(element).firstChild + c);
    for (int i = 0; i < basis.nodes(); ++i) {
        Color sum{};
        for (int j = 0; j < basis.nodes(); ++j)
            for (std::size_t k = 0; k < colorSamples; ++k)
                sum[k] += basis.toChild(c, i, j) *
                          from[stride * std::size_t(element) + std::size_t(j)][k];
        to[child + std::size_t(i)] = sum;
    }
}

} // namespace candela::radiosity
