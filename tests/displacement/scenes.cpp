// SPDX-License-Identifier: Apache-2.0
#include "tests/displacement/scenes.h"

#include "tests/bodies/bodies.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace candela::test {

namespace {

using Point = std::array<double, 3>;

Point operator+(Point a, Point b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Point operator-(Point a, Point b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point operator*(Point a, double s) { return {a[0] * s, a[1] * s, a[2] * s}; }
Point cross(Point a, Point b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit(Point a) { return a * (1 / std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2])); }

/// What the shader "waves" makes of a point with that normal.
Point waved(Point p, Point normal) {
    return p + unit(normal) * (.1 * std::sin(6 * p[0]) * std::cos(6 * p[1]));
}

/// A place of a surface, by coordinates in [0,1].
using Place = std::function<Point(double, double)>;

/// The normal along the product of the derivatives.
Point normalAt(const Place &place, double u, double v) {
    constexpr double step = 1e-5;
    const auto inside = [](double x) { return x < .5 ? x : x - step; };
    const double a = inside(u), b = inside(v);
    const Point p = place(a, b);
    return unit(cross(place(a + step, b) - p, place(a, b + step) - p));
}

std::string grid(const Place &place, int columns, int rows, bool triangle) {
    std::vector<double> P, N, counts, vertices;
    for (int row = 0; row <= rows; ++row)
        for (int column = 0; column <= columns; ++column) {
            const double u = double(column) / columns, v = double(row) / rows;
            const Point p = place(u, v), n = normalAt(place, u, v);
            P.insert(P.end(), p.begin(), p.end()), N.insert(N.end(), n.begin(), n.end());
        }
    const auto at = [&](int column, int row) { return double(row * (columns + 1) + column); };
    const auto add = [&](double a, double b, double c) {
        counts.push_back(3), vertices.insert(vertices.end(), {a, b, c});
    };
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns && (!triangle || column + row < columns); ++column) {
            add(at(column, row), at(column + 1, row), at(column, row + 1));
            if (!triangle || column + row + 1 < columns)
                add(at(column + 1, row), at(column + 1, row + 1), at(column, row + 1));
        }
    return "PointsPolygons " + array(counts) + " " + array(vertices) + " \"P\" " + array(P) +
           " \"N\" " + array(N) + "\n";
}

DenseScene sphere() {
    const auto place = [](double u, double v) {
        const double theta = 2 * std::numbers::pi * u;
        const double phi = std::numbers::pi * (.002 + .996 * v - .5); // Poles have no product.
        const Point p{std::cos(theta) * std::cos(phi), std::sin(theta) * std::cos(phi),
                      std::sin(phi)};
        return waved(p, p);
    };
    return {"Sphere", "Sphere 1 -1 1 360\n", grid(place, 200, 100, false)};
}

DenseScene plane(const std::string &name, const std::string &rib) {
    const auto place = [](double u, double v) {
        return waved({2 * u - 1, 2 * v - 1, 0}, {0, 0, 1});
    };
    return {name, rib, grid(place, 100, 100, false)};
}

/// An octahedron with normals that lean outward at its corners.
DenseScene mesh() {
    const std::array<Point, 6> corner{Point{1, 0, 0},  Point{0, 1, 0},  Point{0, 0, 1},
                                      Point{-1, 0, 0}, Point{0, -1, 0}, Point{0, 0, -1}};
    std::vector<double> counts, vertices, points;
    std::string dense;
    for (const Point &p : corner)
        points.insert(points.end(), p.begin(), p.end());
    for (int face = 0; face < 8; ++face) {
        std::array<int, 3> k{face & 1 ? 3 : 0, face & 2 ? 4 : 1, face & 4 ? 5 : 2};
        if (((face & 1) + (face >> 1 & 1) + (face >> 2)) % 2 == 1)
            std::swap(k[1], k[2]);
        counts.push_back(3), vertices.insert(vertices.end(), k.begin(), k.end());
        const Point a = corner[k[0]], toB = corner[k[1]] - a, toC = corner[k[2]] - a;
        const auto place = [=](double u, double v) {
            const Point p = a + toB * u + toC * v;
            return waved(p, p); // The normals are what the corners are.
        };
        dense += grid(place, 60, 60, true);
    }
    return {"Mesh",
            "PointsPolygons " + array(counts) + " " + array(vertices) + " \"P\" " + array(points) +
                " \"N\" " + array(points) + "\n",
            dense};
}

} // namespace

std::vector<DenseScene> denseScenes() {
    return {sphere(), plane("Polygon", "Polygon \"P\" [-1 -1 0 1 -1 0 1 1 0 -1 1 0]\n"),
            plane("Patch", "Patch \"bilinear\" \"P\" [-1 -1 0 1 -1 0 -1 1 0 1 1 0]\n"), mesh()};
}

} // namespace candela::test
