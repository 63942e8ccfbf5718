// SPDX-License-Identifier: Apache-2.0
#include "light/transport/lanes.h"

#include "foundation/base/hot.h"

namespace candela::lanes {

CANDELA_HOT void gather(int count, const int *__restrict order, const float *__restrict from,
                        float *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = from[order[i]];
}

CANDELA_HOT void gather(int count, const int *__restrict order, const int *__restrict from,
                        int *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = from[order[i]];
}

CANDELA_HOT void add(int count, const float *__restrict b, float *__restrict a) {
    for (int i = 0; i < count; ++i)
        a[i] += b[i];
}

CANDELA_HOT void multiplyAdd(int count, const float *__restrict a, const float *__restrict b,
                             float *__restrict sum) {
    for (int i = 0; i < count; ++i)
        sum[i] += a[i] * b[i];
}

CANDELA_HOT bool allFinite(int count, const float *__restrict values) {
    int bad = 0;
    for (int i = 0; i < count; ++i)
        bad |= !(values[i] * 0 == 0); // Infinities and NaN become NaN.
    return bad == 0;
}

CANDELA_HOT bool allEqual(int count, const float *__restrict values, float expected) {
    int other = 0;
    for (int i = 0; i < count; ++i)
        other |= values[i] != expected;
    return other == 0;
}

CANDELA_HOT bool allEqual(int count, const int *__restrict values, int expected) {
    int other = 0;
    for (int i = 0; i < count; ++i)
        other |= values[i] ^ expected;
    return other == 0;
}

CANDELA_HOT bool allPositive(int count, const float *__restrict values) {
    int others = 0;
    for (int i = 0; i < count; ++i)
        others |= !(values[i] > 0);
    return others == 0;
}

int compact(int count, const int *keep, int *lanes) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        lanes[kept] = i; // Without a branch: what isn't kept is overwritten by the next.
        kept += keep[i] != 0;
    }
    return kept;
}

} // namespace candela::lanes
