// SPDX-License-Identifier: Apache-2.0
// Loops over the lanes of batches that many steps share, compiled for wide vectors.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace candela::lanes {

/// to[i] = from[order[i]]
void gather(int count, const int *order, const float *from, float *to);
void gather(int count, const int *order, const int *from, int *to);
void gather(int count, const int *order, const std::uint32_t *from, std::uint32_t *to);
/// A plane of words to take lanes from, and where they go; the two don't overlap.
struct Move {
    template <class Word> Move(const Word *from, Word *to) : from(from), to(to) {
        static_assert(sizeof(Word) == 4);
    }
    const void *from;
    void *to;
};
/// to[i] = from[increasing[i]] for all of the planes: as what is wanted lies close together, and is
/// the same in each, faster than gathering.
void take(int count, const int *increasing, std::initializer_list<Move>);
/// planes[c][i] = table[row[i] + c], for columns c of rows of 16 words, `row` counting words; a
/// null plane is left out. Planes are aligned to 64 bytes and may be written up to whole vectors
/// of 16.
void gatherRows(int count, const float *table, const int *row, int columns, float *const *planes);
/// to[i] = value
void fill(int count, float value, float *to);
void fill(int count, int value, int *to);
/// a[i] += b[i]
void add(int count, const float *b, float *a);
/// a[i] *= b[i]
void multiply(int count, const float *b, float *a);
/// sum[i] += a[i] * b[i]
void multiplyAdd(int count, const float *a, const float *b, float *sum);
/// True if every value is finite.
bool allFinite(int count, const float *values);
/// True if every value equals `expected`.
bool allEqual(int count, const float *values, float expected);
bool allEqual(int count, const int *values, int expected);
/// True if every value is above 0.
bool allPositive(int count, const float *values);
/// The lanes i with key[i] == wanted (or != unwanted), in order; returns how many. `lanes` has
/// room for count, and up to 15 more that may be overwritten.
int compactEqual(int count, const int *key, int wanted, int *lanes);
int compactUnequal(int count, const int *key, int unwanted, int *lanes);

} // namespace candela::lanes
