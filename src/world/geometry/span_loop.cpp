// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/span_loop.h"

#include <cmath>
#include <limits>

namespace candela {

namespace {

using Triangles = std::vector<std::array<std::uint32_t, 3>>;
using Area = std::array<double, 3>;

/// Twice the area vector of a triangle.
Area areaOf(Vec3 a, Vec3 b, Vec3 c) {
    double p[3], q[3];
    for (int axis = 0; axis < 3; ++axis)
        p[axis] = double(b[axis]) - a[axis], q[axis] = double(c[axis]) - a[axis];
    return {p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]};
}

double sizeOf(const Area &a) { return std::sqrt(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]); }

/// Cosine of the fold along the diagonal from corner `start`; -1 where a triangle has no area.
double foldCosine(std::span<const Vec3> points, std::span<const int> loop, int start) {
    auto corner = [&](int k) { return points[loop[(start + k) % 4]]; };
    Area a = areaOf(corner(0), corner(1), corner(2)), b = areaOf(corner(0), corner(2), corner(3));
    double size = sizeOf(a) * sizeOf(b);
    return size > 0 ? (a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / size : -1;
}

void append(std::span<const int> loop, int a, int b, int c, Triangles &triangles) {
    triangles.push_back({std::uint32_t(loop[a]), std::uint32_t(loop[b]), std::uint32_t(loop[c])});
}

} // namespace

bool cutQuickly(std::span<const Vec3> points, std::span<const int> loop, Triangles &triangles) {
    if (loop.size() == 3) {
        append(loop, 0, 1, 2, triangles);
        return true;
    }
    if (loop.size() != 4)
        return false;
    double first = foldCosine(points, loop, 0), second = foldCosine(points, loop, 1);
    if (first <= 0 && second <= 0)
        return false;
    int start = first > 0 ? 0 : 1;
    append(loop, start, start + 1, start + 2, triangles);
    append(loop, start, start + 2, (start + 3) % 4, triangles);
    return true;
}

bool spanLoop(std::span<const Vec3> points, std::span<const int> loop, Triangles &triangles) {
    constexpr std::size_t mostCorners = 128;
    int n = int(loop.size());
    if (loop.size() > mostCorners || n < 3)
        return false;
    // Least area of what lies between corners i and j, and the corner that makes it.
    std::vector<double> least(std::size_t(n) * n, 0);
    std::vector<int> apex(std::size_t(n) * n, 0);
    for (int span = 2; span < n; ++span)
        for (int i = 0; i + span < n; ++i) {
            int j = i + span;
            double &best = least[i * n + j] = std::numeric_limits<double>::infinity();
            for (int k = i + 1; k < j; ++k) {
                double own = sizeOf(areaOf(points[loop[i]], points[loop[k]], points[loop[j]]));
                double area = least[i * n + k] + least[k * n + j] + own;
                if (area < best)
                    best = area, apex[i * n + j] = k;
            }
        }
    std::vector<std::array<int, 2>> open{{0, n - 1}};
    while (!open.empty()) {
        auto [i, j] = open.back();
        open.pop_back();
        if (j - i < 2)
            continue;
        int k = apex[i * n + j];
        if (sizeOf(areaOf(points[loop[i]], points[loop[k]], points[loop[j]])) > 0)
            append(loop, i, k, j, triangles);
        open.push_back({i, k});
        open.push_back({k, j});
    }
    return true;
}

} // namespace candela
