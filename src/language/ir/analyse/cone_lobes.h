// SPDX-License-Identifier: Apache-2.0
// Reads importance off classic light loops: the factors of Cl (ALGORITHMS 7, last paragraph).
#pragma once

#include "language/ir/analyse/cones.h"

namespace candela::ir {

/// Cl (A.L) gives (A, 180, 1); Cl pow(A.L, n) gives (A, 180, n); Cl pow(N.H, n) with
/// H = L + V gives (V mirrored about N, 180, n/4). What is weighted by no known cosine keeps
/// `whole`, the cone of the loop itself. Empty if the body is too intricate.
std::vector<Cone> recognizeLobes(const Function &text, const Dependence &, const Instruction &loop,
                                 const Cone &whole);

} // namespace candela::ir
