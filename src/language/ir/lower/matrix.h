// SPDX-License-Identifier: Apache-2.0
// Matrices in IR arithmetic, row by row, acting on row vectors: "A * B" is first A, then B.
#pragma once

#include "language/ir/core/builder.h"

namespace candela::ir {

Matrix identityMatrix(Builder &);
Matrix multiply(Builder &, const Matrix &, const Matrix &);
ValueId determinant(Builder &, const Matrix &);
/// Not finite if the matrix is singular.
Matrix inverse(Builder &, const Matrix &);

} // namespace candela::ir
