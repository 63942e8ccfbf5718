// SPDX-License-Identifier: Apache-2.0
// A triangle, cut along segments: constrained Delaunay triangulation on a grid of whole numbers,
// whose predicates are exact.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace candela {

class ConstrainedTriangulation {
public:
    /// Coordinates are from 0 to this, and no larger in sum.
    static constexpr std::int64_t size = 1 << 22;
    struct Place {
        std::int64_t x = 0, y = 0;
        friend bool operator==(const Place &, const Place &) = default;
    };
    using Triple = std::array<int, 3>;

    /// The triangle (0,0), (size,0), (0,size); its corners are the points 0, 1 and 2.
    ConstrainedTriangulation();

    /// The point there, which is a new one if there is none yet. On a side of the triangle, or
    /// within.
    int insert(Place);
    /// Makes a chain of edges of the segment, where it can: it may cross others, and gets points
    /// there.
    void constrain(int a, int b);

    const std::vector<Place> &points() const { return points_; }
    std::vector<Triple> triangles() const;

private:
    struct Triangle {
        Triple corner;
        Triple beyond;               ///< Across the side from corner k to k + 1; -1: nothing.
        std::array<bool, 3> isFixed; ///< Sides that are parts of segments.
    };
    struct Side {
        int triangle = -1, k = -1; ///< -1: none.
    };
    std::int64_t turn(int a, int b, Place c) const;
    /// The triangle that holds the place, and the side that it lies on, if it does.
    Side find(Place) const;
    Side sideBetween(int a, int b) const;
    /// Calls with each triangle at the point, and the corner that it is there, until told to stop.
    template <class Call> void around(int point, Call) const;
    void set(int triangle, Triple corner, Triple beyond, std::array<bool, 3> isFixed);
    void relink(int triangle, int from, int to);
    void split(int triangle, int point);
    void splitSide(Side, int point);
    Side acrossOf(Side) const;
    /// Turns the diagonal of the two triangles at a side, whose quadrilateral is convex.
    void flip(Side);
    void improve(std::vector<Side>);
    bool isDelaunay(Side) const;
    void fix(Side, bool isFixed);
    /// The sides that the segment crosses; or a point that it goes through, in `through`.
    std::vector<std::array<int, 2>> crossed(int a, int b, int &through) const;
    bool crosses(int a, int b, int p, int q) const;
    bool cutFixed(int a, int b, const std::vector<std::array<int, 2>> &sides);

    std::vector<Place> points_;
    std::vector<Triangle> triangles_;
    std::vector<int> at_;  ///< Of each point one of its triangles.
    mutable int last_ = 0; ///< Where the last place was found.
    int crossings_ = 0;    ///< Points that crossings have made.
};

} // namespace candela
