// SPDX-License-Identifier: Apache-2.0
// Cones as values: what states them in outputs, and what classic loops test directions with.
#pragma once

#include "language/ir/analyse/cones.h"

#include <optional>
#include <vector>

namespace candela::ir {

class ValueMapping;

/// A cone as outputs have it.
struct StatedCone {
    Triple axis{};
    ValueId angle = 0, exponent = 0;
    std::optional<ValueId> importance; ///< Only if the shader states it.
};
/// Where the text's instruction `request` stands where it is written anew.
StatedCone stateCone(ValueMapping &, Builder &, const Instruction &request, const Cone &);

/// What a classic loop tests directions with: its axis, the cosine of the half angle.
struct ConeTest {
    bool known = false;
    Triple axis{};
    ValueId cosine = 0;
};

/// Adds the values of the tests to the text before its classic loops.
std::vector<ConeTest> addConeTests(Function &text);

} // namespace candela::ir
