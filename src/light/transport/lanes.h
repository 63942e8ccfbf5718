// SPDX-License-Identifier: Apache-2.0
// Loops over lanes that several steps of a wave share, compiled for wide vectors.
#pragma once

#include <cstdint>

namespace candela::lanes {

/// to[i] = from[order[i]]
void gather(int count, const int *order, const float *from, float *to);
void gather(int count, const int *order, const int *from, int *to);
/// a[i] += b[i]
void add(int count, const float *b, float *a);
/// sum[i] += a[i] * b[i]
void multiplyAdd(int count, const float *a, const float *b, float *sum);
/// True if every value is finite.
bool allFinite(int count, const float *values);
/// True if every value equals `expected`.
bool allEqual(int count, const float *values, float expected);
bool allEqual(int count, const int *values, int expected);
/// True if every value is above 0.
bool allPositive(int count, const float *values);
/// The lanes i with keep[i] != 0, in order; returns how many.
int compact(int count, const int *keep, int *lanes);

} // namespace candela::lanes
