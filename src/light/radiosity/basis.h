// SPDX-License-Identifier: Apache-2.0
// Multiwavelets by their smooth functions (ALGORITHMS 6): polynomials over an element, kept by
// their values at the nodes of a Gauss rule. The rule integrates products of two of them exactly,
// so values at nodes are coefficients of an orthogonal basis, products are taken node by node, and
// going from an element to its four children and back is a small matrix.
#pragma once

#include <array>
#include <span>

namespace candela::radiosity {

/// Of an element: M3 on a square.
inline constexpr int mostNodes = 9;

struct Place {
    float u = 0, v = 0;
};

class Basis {
public:
    /// Order 1 is constant (M1), 2 linear or bilinear (M2), 3 quadratic or biquadratic (M3).
    static const Basis &of(bool triangle, int order);

    int nodes() const { return nodes_; }
    /// In the element's own square, or triangle u + v <= 1.
    Place node(int i) const { return place_[i]; }
    /// Of the rule; they sum up to the domain's area, 1 or 1/2.
    float weight(int i) const { return weight_[i]; }
    float domainArea() const { return triangle_ ? 0.5f : 1.0f; }
    bool isTriangle() const { return triangle_; }

    /// What the value at each node counts at a place.
    void values(Place, float *value) const;
    /// What the parent's value at node j counts at node i of child c: exact.
    float toChild(int c, int i, int j) const { return toChild_[c][i][j]; }
    /// What node j of child c counts at the parent's node i: the nearest polynomial.
    float fromChild(int c, int i, int j) const { return fromChild_[c][i][j]; }

    /// Of the domain, in order around it.
    static std::span<const Place> corners(bool triangle);
    static Place centre(bool triangle);

    static constexpr int children = 4;
    /// The child's (u,v) in its parent is origin + scale (u,v).
    struct ChildPlace {
        Place origin;
        float scale; ///< -1/2 of the triangle in the middle of a triangle.
    };
    static ChildPlace child(bool triangle, int c);
    /// The child that a place lies in; the place becomes the child's own.
    static int childAt(bool triangle, Place &);

private:
    Basis(bool triangle, int order);
    void placeNodes(int order);
    void invertMonomials();
    template <class Number> int monomials(Place, Number *) const;

    bool triangle_;
    int order_, nodes_ = 0;
    std::array<Place, mostNodes> place_{};
    std::array<float, mostNodes> weight_{};
    /// Lagrange polynomial i has coefficient inverse_[k][i] at monomial k.
    float inverse_[mostNodes][mostNodes] = {};
    float toChild_[children][mostNodes][mostNodes] = {};
    float fromChild_[children][mostNodes][mostNodes] = {};
};

} // namespace candela::radiosity
