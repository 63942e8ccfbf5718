// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/basis.h"

#include <algorithm>
#include <cmath>

namespace candela::radiosity {

namespace {

struct Gauss {
    int count;
    std::array<double, 3> place, weight; ///< On [0,1].
};

/// Of as many points; the constant basis takes two, too: visibility and curved surfaces want them.
Gauss gaussOf(int order) {
    const double second = std::sqrt(1.0 / 3) / 2, third = std::sqrt(0.6) / 2;
    if (order <= 2)
        return {2, {0.5 - second, 0.5 + second}, {0.5, 0.5}};
    return {3, {0.5 - third, 0.5, 0.5 + third}, {5.0 / 18, 8.0 / 18, 5.0 / 18}};
}

} // namespace

const Basis &Basis::of(bool triangle, int order) {
    static const Basis all[2][3] = {{{false, 1}, {false, 2}, {false, 3}},
                                    {{true, 1}, {true, 2}, {true, 3}}};
    return all[triangle ? 1 : 0][std::clamp(order, 1, 3) - 1];
}

Basis::Basis(bool triangle, int order) : triangle_(triangle), order_(order) {
    placeNodes(order);
    invertMonomials();
    for (int c = 0; c < children; ++c) {
        const ChildPlace child = Basis::child(triangle, c);
        for (int i = 0; i < nodes_; ++i) {
            const Place own = place_[i];
            float value[mostNodes];
            values({child.origin.u + child.scale * own.u, child.origin.v + child.scale * own.v},
                   value);
            for (int j = 0; j < nodes_; ++j) {
                toChild_[c][i][j] = value[j];
                // <p_j, f> / <p_j, p_j>, the rule being exact for both.
                fromChild_[c][j][i] = value[j] * weight_[i] / (4 * weight_[j]);
            }
        }
    }
}

void Basis::placeNodes(int order) {
    const auto add = [&](double u, double v, double weight) {
        place_[nodes_] = {float(u), float(v)};
        weight_[nodes_++] = float(weight);
    };
    if (!triangle_) {
        const Gauss gauss = gaussOf(order);
        for (int y = 0; y < gauss.count; ++y)
            for (int x = 0; x < gauss.count; ++x)
                add(gauss.place[x], gauss.place[y], gauss.weight[x] * gauss.weight[y]);
        return;
    }
    // Rules of degree 2 and 4 (Strang and Fix; Dunavant).
    const auto addThree = [&](double a, double weight) {
        add(a, a, weight), add(1 - 2 * a, a, weight), add(a, 1 - 2 * a, weight);
    };
    if (order <= 2)
        return addThree(1.0 / 6, 1.0 / 6);
    addThree(0.445948490915965, 0.223381589678011 / 2);
    addThree(0.091576213509771, 0.109951743655322 / 2);
}

template <class Number> int Basis::monomials(Place at, Number *value) const {
    const Number u[] = {1, Number(at.u), Number(at.u) * Number(at.u)};
    const Number v[] = {1, Number(at.v), Number(at.v) * Number(at.v)};
    int count = 0;
    const int degree = nodes_ > 4 ? 2 : 1;
    for (int y = 0; y <= degree; ++y)
        for (int x = 0; x <= (triangle_ ? degree - y : degree); ++x)
            value[count++] = u[x] * v[y];
    return count;
}

/// Gauss-Jordan on the matrix of the monomials at the nodes.
void Basis::invertMonomials() {
    double matrix[mostNodes][2 * mostNodes] = {};
    for (int i = 0; i < nodes_; ++i) {
        monomials(place_[i], matrix[i]);
        matrix[i][nodes_ + i] = 1;
    }
    for (int column = 0; column < nodes_; ++column) {
        int pivot = column;
        for (int row = column + 1; row < nodes_; ++row)
            if (std::fabs(matrix[row][column]) > std::fabs(matrix[pivot][column]))
                pivot = row;
        std::swap_ranges(matrix[column], matrix[column] + 2 * nodes_, matrix[pivot]);
        const double scale = 1 / matrix[column][column];
        for (double &value : matrix[column])
            value *= scale;
        for (int row = 0; row < nodes_; ++row) {
            const double factor = matrix[row][column];
            for (int k = 0; row != column && k < 2 * nodes_; ++k)
                matrix[row][k] -= factor * matrix[column][k];
        }
    }
    for (int k = 0; k < nodes_; ++k)
        for (int i = 0; i < nodes_; ++i)
            inverse_[k][i] = float(matrix[k][nodes_ + i]);
}

void Basis::values(Place at, float *value) const {
    if (order_ == 1) {
        for (int i = 0; i < nodes_; ++i)
            value[i] = weight_[i] / domainArea();
        return;
    }
    float monomial[mostNodes];
    monomials(at, monomial);
    for (int i = 0; i < nodes_; ++i)
        value[i] = 0;
    for (int k = 0; k < nodes_; ++k)
        for (int i = 0; i < nodes_; ++i)
            value[i] += monomial[k] * inverse_[k][i];
}

std::span<const Place> Basis::corners(bool triangle) {
    static constexpr Place ofSquare[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static constexpr Place ofTriangle[] = {{0, 0}, {1, 0}, {0, 1}};
    return triangle ? std::span<const Place>(ofTriangle) : ofSquare;
}

Place Basis::centre(bool triangle) {
    return triangle ? Place{1.0f / 3, 1.0f / 3} : Place{0.5f, 0.5f};
}

Basis::ChildPlace Basis::child(bool triangle, int c) {
    if (triangle && c == 3)
        return {{0.5f, 0.5f}, -0.5f};
    return {{(c & 1) ? 0.5f : 0.0f, (c & 2) ? 0.5f : 0.0f}, 0.5f};
}

int Basis::childAt(bool triangle, Place &at) {
    int c = (at.u >= 0.5f ? 1 : 0) + (at.v >= 0.5f ? 2 : 0);
    if (triangle && c == 0 && at.u + at.v > 0.5f)
        c = 3;
    const ChildPlace place = child(triangle, c);
    at = {(at.u - place.origin.u) / place.scale, (at.v - place.origin.v) / place.scale};
    return c;
}

} // namespace candela::radiosity
