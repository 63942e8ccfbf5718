// SPDX-License-Identifier: Apache-2.0
#include "world/scene/light_aims.h"

#include "foundation/base/hot.h"

#include <cmath>
#include <limits>

namespace candela {

/// Of a point's largest coordinate.
static constexpr float pointRounding = 8 * 0x1p-24f;

CANDELA_HOT void aim(int count, Planes3 point, Planes3 normal, float frontSign,
                     const float *__restrict offset, Planes3 P, const float *__restrict drawnPdf,
                     const float *__restrict probability, const std::int32_t *__restrict index,
                     float *const L[3], float *__restrict distance, float *__restrict pdf,
                     std::int32_t *__restrict light) {
    const float *x = point[0], *y = point[1], *z = point[2];
    const float *nx = normal[0], *ny = normal[1], *nz = normal[2];
    const float *px = P[0], *py = P[1], *pz = P[2];
    float *lx = L[0], *ly = L[1], *lz = L[2];
    constexpr float most = std::numeric_limits<float>::max();
    auto larger = [](float a, float b) { return a > b ? a : b; };
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float dx = x[i] - px[i], dy = y[i] - py[i], dz = z[i] - pz[i];
        const float seen = std::sqrt(dx * dx + dy * dy + dz * dz);
        const float size = std::sqrt(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]);
        const float along = dx * nx[i] + dy * ny[i] + dz * nz[i], height = std::fabs(along) / size;
        const float ofLamp = larger(std::fabs(x[i]), larger(std::fabs(y[i]), std::fabs(z[i])));
        const float ofP = larger(std::fabs(px[i]), larger(std::fabs(py[i]), std::fabs(pz[i])));
        const float zone = offset[i] + pointRounding * larger(ofLamp, ofP);
        const float density = drawnPdf[i] * probability[i];
        const bool sound = (density > 0) & (density <= most) & (seen > 0) & (height > 0) &
                           (along * frontSign <= 0);
        const float before = sound ? larger(1 - zone / height, 0.5f) : 0.0f;
        lx[i] = sound ? dx * before : 0.0f;
        ly[i] = sound ? dy * before : 0.0f;
        lz[i] = sound ? dz * before : 1.0f;
        distance[i] = sound ? seen * before : 0.0f;
        pdf[i] = sound ? density : 0.0f;
        light[i] = sound ? index[i] + 1 : 0;
    }
}

CANDELA_HOT void aimAtDelta(int count, Planes3 given, Planes3 Ps, Planes3 P, bool distant,
                            const std::int32_t *__restrict index, float *const L[3],
                            float *__restrict distance, float *__restrict pdf,
                            std::int32_t *__restrict light) {
    const float *x = given[0], *y = given[1], *z = given[2];
    const float *sx = Ps[0], *sy = Ps[1], *sz = Ps[2];
    const float *px = P[0], *py = P[1], *pz = P[2];
    float *lx = L[0], *ly = L[1], *lz = L[2];
    constexpr float most = std::numeric_limits<float>::max();
    const float shifts = distant ? 0.0f : 1.0f;
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float length = std::sqrt(x[i] * x[i] + y[i] * y[i] + z[i] * z[i]);
        const bool sound = (length > 0) & (length <= most);
        const float far = distant ? std::numeric_limits<float>::infinity() : length;
        lx[i] = sound ? (sx[i] - px[i]) * shifts - x[i] : 0.0f;
        ly[i] = sound ? (sy[i] - py[i]) * shifts - y[i] : 0.0f;
        lz[i] = sound ? (sz[i] - pz[i]) * shifts - z[i] : 1.0f;
        distance[i] = sound ? far : 0.0f;
        pdf[i] = 0;
        light[i] = sound ? index[i] + 1 : 0;
    }
}

CANDELA_HOT void endBeforeZone(int count, Planes3 point, Planes3 normal,
                               const float *__restrict offset, Planes3 P, float *const L[3],
                               float *__restrict distance) {
    const float *x = point[0], *y = point[1], *z = point[2];
    const float *nx = normal[0], *ny = normal[1], *nz = normal[2];
    const float *px = P[0], *py = P[1], *pz = P[2];
    float *lx = L[0], *ly = L[1], *lz = L[2];
    constexpr float same = 1e-4f;
    auto larger = [](float a, float b) { return a > b ? a : b; };
#pragma GCC ivdep
    for (int i = 0; i < count; ++i) {
        const float dx = x[i] - px[i], dy = y[i] - py[i], dz = z[i] - pz[i];
        const float off = std::fabs(dx - lx[i]) + std::fabs(dy - ly[i]) + std::fabs(dz - lz[i]);
        const float size = std::sqrt(nx[i] * nx[i] + ny[i] * ny[i] + nz[i] * nz[i]);
        const float height = std::fabs(lx[i] * nx[i] + ly[i] * ny[i] + lz[i] * nz[i]) / size;
        const float ofLamp = larger(std::fabs(x[i]), larger(std::fabs(y[i]), std::fabs(z[i])));
        const float ofP = larger(std::fabs(px[i]), larger(std::fabs(py[i]), std::fabs(pz[i])));
        const float zone = offset[i] + pointRounding * larger(ofLamp, ofP);
        const bool isThere = (off <= same * distance[i]) & (height > 0);
        const float before = isThere ? larger(1 - zone / height, 0.5f) : 1.0f;
        lx[i] *= before, ly[i] *= before, lz[i] *= before;
        distance[i] *= before;
    }
}

} // namespace candela
