// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/lanes.h"

#include "foundation/base/hot.h"

#include <algorithm>
#include <cstring>
#include <immintrin.h>
#include <span>

namespace candela::lanes {

namespace {

// ---- What needs instructions that compilers do not find ----

#ifdef CANDELA_WIDE
/// Lanes whose keys equal `key`, or differ from it, sixteen at a time.
CANDELA_WIDE int compactLanes(int count, const int *keys, int key, bool equal, int *lanes) {
    const __m512i wanted = _mm512_set1_epi32(key), step = _mm512_set1_epi32(16);
    __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    int kept = 0;
    for (int i = 0; i < count; i += 16, lane = _mm512_add_epi32(lane, step)) {
        const __mmask16 there = count - i >= 16 ? 0xffff : __mmask16((1u << (count - i)) - 1);
        const __m512i here = _mm512_maskz_loadu_epi32(there, keys + i);
        const __mmask16 keep = equal ? _mm512_mask_cmpeq_epi32_mask(there, here, wanted)
                                     : _mm512_mask_cmpneq_epi32_mask(there, here, wanted);
        // A whole vector is stored; the next overwrites what does not count.
        _mm512_storeu_si512(lanes + kept, _mm512_maskz_compress_epi32(keep, lane));
        kept += __builtin_popcount(keep);
    }
    return kept;
}

/// Sixteen increasing indices mostly span fewer than 32 lanes: two loads and a permutation.
CANDELA_WIDE void takeLanes(int count, const int *order, std::span<const Move> moves) {
    for (int i = 0; i < count; i += 16) {
        const int lanes = count - i < 16 ? count - i : 16;
        const auto there = __mmask16((1u << lanes) - 1);
        const __m512i index = _mm512_maskz_loadu_epi32(there, order + i);
        const int first = order[i], span = order[i + lanes - 1] - first;
        const __m512i place = _mm512_sub_epi32(index, _mm512_set1_epi32(first));
        // No further than the last: planes may end there.
        const auto within = __mmask16(span < 16 ? (2u << span) - 1 : 0xffff);
        const auto beyond = __mmask16(span < 16 ? 0 : (2u << (span & 15)) - 1);
        for (const Move &move : moves) {
            const int *source = static_cast<const int *>(move.from);
            int *target = static_cast<int *>(move.to) + i;
            __m512i taken = _mm512_maskz_loadu_epi32(within, source + first);
            if (span >= 32) {
                taken = _mm512_mask_i32gather_epi32(taken, there, index, source, 4);
            } else if (span >= lanes) {
                const __m512i high = _mm512_maskz_loadu_epi32(beyond, source + first + 16);
                taken = _mm512_permutex2var_epi32(taken, place, high);
            } // Else they are consecutive.
            _mm512_mask_storeu_epi32(target, there, taken);
        }
    }
}

/// Four columns of sixteen rows: four rows to a vector, then transposed within its quarters. Many
/// times as fast as gathering each column.
CANDELA_WIDE inline void transposeColumns(const float *table, const int *row, __m512 *column) {
    __m512 rows[4];
    for (int k = 0; k < 4; ++k) {
        rows[k] = _mm512_castps128_ps512(_mm_loadu_ps(table + row[k]));
        rows[k] = _mm512_insertf32x4(rows[k], _mm_loadu_ps(table + row[4 + k]), 1);
        rows[k] = _mm512_insertf32x4(rows[k], _mm_loadu_ps(table + row[8 + k]), 2);
        rows[k] = _mm512_insertf32x4(rows[k], _mm_loadu_ps(table + row[12 + k]), 3);
    }
    const __m512d low01 = _mm512_castps_pd(_mm512_maskz_unpacklo_ps(0xffff, rows[0], rows[1]));
    const __m512d low23 = _mm512_castps_pd(_mm512_maskz_unpacklo_ps(0xffff, rows[2], rows[3]));
    const __m512d high01 = _mm512_castps_pd(_mm512_maskz_unpackhi_ps(0xffff, rows[0], rows[1]));
    const __m512d high23 = _mm512_castps_pd(_mm512_maskz_unpackhi_ps(0xffff, rows[2], rows[3]));
    column[0] = _mm512_castpd_ps(_mm512_maskz_unpacklo_pd(0xff, low01, low23));
    column[1] = _mm512_castpd_ps(_mm512_maskz_unpackhi_pd(0xff, low01, low23));
    column[2] = _mm512_castpd_ps(_mm512_maskz_unpacklo_pd(0xff, high01, high23));
    column[3] = _mm512_castpd_ps(_mm512_maskz_unpackhi_pd(0xff, high01, high23));
}

CANDELA_WIDE void gatherTable(int count, const float *table, const int *row, int columns,
                              float *const *planes) {
    for (int i = 0; i < count; i += 16) {
        alignas(64) int rows[16] = {};
        std::memcpy(rows, row + i, sizeof(int) * std::size_t(count - i < 16 ? count - i : 16));
        for (int c = 0; c < columns; c += 4) {
            const int wanted = columns - c < 4 ? columns - c : 4;
            if (std::all_of(planes + c, planes + c + wanted, [](float *p) { return !p; }))
                continue;
            __m512 column[4];
            transposeColumns(table + c, rows, column);
            for (int k = 0; k < wanted; ++k)
                if (planes[c + k])
                    _mm512_store_ps(planes[c + k] + i, column[k]);
        }
    }
}
#endif

CANDELA_PLAIN int compactLanes(int count, const int *keys, int key, bool equal, int *lanes) {
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        lanes[kept] = i; // Without a branch: what isn't kept is overwritten by the next.
        kept += (keys[i] == key) == equal;
    }
    return kept;
}

CANDELA_PLAIN void takeLanes(int count, const int *order, std::span<const Move> moves) {
    for (const Move &move : moves) {
        const char *source = static_cast<const char *>(move.from);
        char *target = static_cast<char *>(move.to);
        for (int i = 0; i < count; ++i)
            std::memcpy(target + 4 * std::size_t(i), source + 4 * std::size_t(order[i]), 4);
    }
}

CANDELA_PLAIN void gatherTable(int count, const float *table, const int *row, int columns,
                               float *const *planes) {
    for (int c = 0; c < columns; ++c)
        if (planes[c])
            for (int i = 0; i < count; ++i)
                planes[c][i] = table[row[i] + c];
}

} // namespace

void gatherRows(int count, const float *table, const int *row, int columns, float *const *planes) {
    gatherTable(count, table, row, columns, planes);
}

int compactEqual(int count, const int *key, int wanted, int *lanes) {
    return compactLanes(count, key, wanted, true, lanes);
}

int compactUnequal(int count, const int *key, int unwanted, int *lanes) {
    return compactLanes(count, key, unwanted, false, lanes);
}

void take(int count, const int *increasing, std::initializer_list<Move> moves) {
    takeLanes(count, increasing, {moves.begin(), moves.size()});
}

// ---- What compilers make vectors of ----

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

CANDELA_HOT void gather(int count, const int *__restrict order,
                        const std::uint32_t *__restrict from, std::uint32_t *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = from[order[i]];
}

CANDELA_HOT void fill(int count, float value, float *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = value;
}

CANDELA_HOT void fill(int count, int value, int *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = value;
}

CANDELA_HOT void add(int count, const float *__restrict b, float *__restrict a) {
    for (int i = 0; i < count; ++i)
        a[i] += b[i];
}

CANDELA_HOT void multiply(int count, const float *__restrict b, float *__restrict a) {
    for (int i = 0; i < count; ++i)
        a[i] *= b[i];
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

} // namespace candela::lanes
