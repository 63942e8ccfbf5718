// SPDX-License-Identifier: Apache-2.0
#include "world/scene/surface_points.h"

#include "foundation/base/hot.h"

#include <algorithm>
#include <cmath>

namespace candela {

void interpolateUv(int count, const std::uint32_t *triangle, const float *baryU, const float *baryV,
                   const std::array<std::uint32_t, 3> *triangles,
                   const std::array<float, 2> *vertexUv, float *u, float *v) {
    for (int i = 0; i < count; ++i) {
        if (triangle[i] == noTriangle) {
            u[i] = baryU[i], v[i] = baryV[i];
            continue;
        }
        const auto &corners = triangles[triangle[i]];
        const auto &a = vertexUv[corners[0]], &b = vertexUv[corners[1]], &c = vertexUv[corners[2]];
        u[i] = a[0] + baryU[i] * (b[0] - a[0]) + baryV[i] * (c[0] - a[0]);
        v[i] = a[1] + baryU[i] * (b[1] - a[1]) + baryV[i] * (c[1] - a[1]);
    }
}

namespace {

struct Rows {
    float m[12];
};

CANDELA_HOT void transformPlanes(int count, Rows rows, float *__restrict x, float *__restrict y,
                                 float *__restrict z) {
    const float *m = rows.m;
    for (int i = 0; i < count; ++i) {
        float px = x[i], py = y[i], pz = z[i];
        x[i] = px * m[0] + py * m[3] + pz * m[6] + m[9];
        y[i] = px * m[1] + py * m[4] + pz * m[7] + m[10];
        z[i] = px * m[2] + py * m[5] + pz * m[8] + m[11];
    }
}

CANDELA_HOT void subtractPlanes(int count, const float *__restrict a, const float *__restrict b,
                                float *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = a[i] - b[i];
}

CANDELA_HOT void roundingPlanes(int count, const float *__restrict x, const float *__restrict y,
                                const float *__restrict z, float share, float *__restrict offset) {
    for (int i = 0; i < count; ++i) {
        float ax = std::abs(x[i]), ay = std::abs(y[i]), az = std::abs(z[i]);
        float most = ax > ay ? ax : ay;
        offset[i] += share * (most > az ? most : az);
    }
}

} // namespace

void transformPoints(int count, const Matrix4 &m, Vec3Planes p) {
    transformPlanes(count,
                    {{m.at(0, 0), m.at(0, 1), m.at(0, 2), m.at(1, 0), m.at(1, 1), m.at(1, 2),
                      m.at(2, 0), m.at(2, 1), m.at(2, 2), m.at(3, 0), m.at(3, 1), m.at(3, 2)}},
                    p.x, p.y, p.z);
}

void transformVectors(int count, const Matrix4 &m, Vec3Planes p) {
    transformPlanes(count,
                    {{m.at(0, 0), m.at(0, 1), m.at(0, 2), m.at(1, 0), m.at(1, 1), m.at(1, 2),
                      m.at(2, 0), m.at(2, 1), m.at(2, 2), 0, 0, 0}},
                    p.x, p.y, p.z);
}

void transformNormals(int count, const Matrix4 &m, float sign, Vec3Planes p) {
    transformPlanes(count,
                    {{sign * m.at(0, 0), sign * m.at(1, 0), sign * m.at(2, 0), sign * m.at(0, 1),
                      sign * m.at(1, 1), sign * m.at(2, 1), sign * m.at(0, 2), sign * m.at(1, 2),
                      sign * m.at(2, 2), 0, 0, 0}},
                    p.x, p.y, p.z);
}

void scatter(int count, const std::int32_t *place, const float *from, float *to) {
    for (int i = 0; i < count; ++i)
        to[place[i]] = from[i];
}

void subtract(int count, const float *a, const float *b, float *to) {
    subtractPlanes(count, a, b, to);
}

void addRounding(int count, Vec3Planes P, float share, float *offset) {
    roundingPlanes(count, P.x, P.y, P.z, share, offset);
}

} // namespace candela
