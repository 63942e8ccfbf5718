// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/fields.h"

#include <algorithm>

namespace candela::radiosity {

double flux(const Mesh &mesh, const std::vector<Color> &field) {
    double flux = 0;
    for (int e = 0; e < mesh.size(); ++e) {
        const std::size_t first = std::size_t(e) * std::size_t(mesh.stride());
        const std::span<const Node> nodes = mesh.nodes(e);
        for (std::size_t i = 0; mesh.element(e).firstChild < 0 && i < nodes.size(); ++i)
            flux += double(brightest(field[first + i])) * nodes[i].area;
    }
    return flux;
}

namespace {

/// Either side's flux goes to that side's nodes: polynomials would carry it across.
void pullSides(const Mesh &mesh, int element, std::vector<Color> &field) {
    const Sides &sides = mesh.sides(element);
    const std::span<const Node> own = mesh.nodes(element);
    Color *const to = field.data() + std::size_t(mesh.stride()) * std::size_t(element);
    std::fill_n(to, own.size(), Color{});
    for (int c = 0; c < Basis::children; ++c) {
        const int child = mesh.element(element).firstChild + c;
        const Color *const from = field.data() + std::size_t(mesh.stride()) * std::size_t(child);
        for (std::size_t i = 0; i < own.size(); ++i) {
            const int side = sides[std::size_t(c) * mostNodes + i];
            if (side < 0)
                continue;
            const float share = mesh.nodes(child)[i].area / own[std::size_t(side)].area;
            for (std::size_t k = 0; k < colorSamples; ++k)
                to[side][k] += share * from[i][k];
        }
    }
}

} // namespace

void pull(const Mesh &mesh, int element, std::vector<Color> &field) {
    if (mesh.element(element).sides >= 0)
        return pullSides(mesh, element, field);
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
