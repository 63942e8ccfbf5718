// SPDX-License-Identifier: Apache-2.0
#include "world/points/surface_points.h"

#include "foundation/base/hot.h"

#include <algorithm>
#include <cmath>

namespace candela {

void interpolateUv(int count, const std::uint32_t *element, const float *baryU, const float *baryV,
                   const std::array<std::uint32_t, 3> *triangles,
                   const std::array<float, 2> *vertexUv, float *u, float *v) {
    for (int i = 0; i < count; ++i) {
        const auto &corners = triangles[element[i]];
        const auto &a = vertexUv[corners[0]], &b = vertexUv[corners[1]], &c = vertexUv[corners[2]];
        const float toB = baryU[i], toC = baryV[i]; // The answer may take their place.
        u[i] = a[0] + toB * (b[0] - a[0]) + toC * (c[0] - a[0]);
        v[i] = a[1] + toB * (b[1] - a[1]) + toC * (c[1] - a[1]);
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

CANDELA_HOT void unitPlanes(int count, const float *__restrict sign, float *__restrict x,
                            float *__restrict y, float *__restrict z) {
    for (int i = 0; i < count; ++i) {
        // Squares of a normal, an area, leave the range of floats long before it does.
        float ax = std::fabs(x[i]), ay = std::fabs(y[i]), az = std::fabs(z[i]);
        float most = ax > ay ? ax : ay;
        most = az > most ? az : most;
        float down = most > 0 ? 1 / most : 1.0f;
        float sx = x[i] * down, sy = y[i] * down, sz = z[i] * down;
        float squared = sx * sx + sy * sy + sz * sz;
        float scale = sign[i] / std::sqrt(squared > 0 ? squared : 1.0f);
        x[i] = sx * scale, y[i] = sy * scale, z[i] = sz * scale;
    }
}

CANDELA_HOT void limitPlanes(int count, const float *__restrict x, const float *__restrict y,
                             const float *__restrict z, const float *__restrict share,
                             float *__restrict offset) {
    for (int i = 0; i < count; ++i) {
        float limit = share[i] * std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        offset[i] = limit < offset[i] ? limit : offset[i]; // In this form NaN limits nothing.
    }
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

void transformNormals(int count, const Matrix4 &m, Vec3Planes p) {
    transformPlanes(count,
                    {{m.at(0, 0), m.at(1, 0), m.at(2, 0), m.at(0, 1), m.at(1, 1), m.at(2, 1),
                      m.at(0, 2), m.at(1, 2), m.at(2, 2), 0, 0, 0}},
                    p.x, p.y, p.z);
}

void transformPointsEach(int count, const float *matrices, const std::uint32_t *row, Vec3Planes p) {
    for (int i = 0; i < count; ++i) {
        const float *m = matrices + 32 * std::size_t(row[i]);
        float x = p.x[i], y = p.y[i], z = p.z[i];
        p.x[i] = x * m[0] + y * m[4] + z * m[8] + m[12];
        p.y[i] = x * m[1] + y * m[5] + z * m[9] + m[13];
        p.z[i] = x * m[2] + y * m[6] + z * m[10] + m[14];
    }
}

void transformVectorsEach(int count, const float *matrices, const std::uint32_t *row,
                          Vec3Planes p) {
    for (int i = 0; i < count; ++i) {
        const float *m = matrices + 32 * std::size_t(row[i]);
        float x = p.x[i], y = p.y[i], z = p.z[i];
        p.x[i] = x * m[0] + y * m[4] + z * m[8];
        p.y[i] = x * m[1] + y * m[5] + z * m[9];
        p.z[i] = x * m[2] + y * m[6] + z * m[10];
    }
}

void transformNormalsEach(int count, const float *matrices, const std::uint32_t *row,
                          Vec3Planes p) {
    for (int i = 0; i < count; ++i) {
        const float *m = matrices + 32 * std::size_t(row[i]) + 16;
        float x = p.x[i], y = p.y[i], z = p.z[i];
        p.x[i] = x * m[0] + y * m[1] + z * m[2];
        p.y[i] = x * m[4] + y * m[5] + z * m[6];
        p.z[i] = x * m[8] + y * m[9] + z * m[10];
    }
}

void scatter(int count, const std::int32_t *place, const float *from, float *to) {
    for (int i = 0; i < count; ++i)
        to[place[i]] = from[i];
}

void subtract(int count, const float *a, const float *b, float *to) {
    subtractPlanes(count, a, b, to);
}

void makeUnit(int count, const float *sign, Vec3Planes v) {
    unitPlanes(count, sign, v.x, v.y, v.z);
}

void limitOffsets(int count, Vec3Planes P, const float *share, float *offset) {
    limitPlanes(count, P.x, P.y, P.z, share, offset);
}

void addRounding(int count, Vec3Planes P, float share, float *offset) {
    roundingPlanes(count, P.x, P.y, P.z, share, offset);
}

} // namespace candela
