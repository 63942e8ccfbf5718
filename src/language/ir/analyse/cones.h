// SPDX-License-Identifier: Apache-2.0
// Where light matters: the cones that a shader states, and those that are read off its text
// (ALGORITHMS 1 and the last paragraph of 7).
#pragma once

#include "language/ir/analyse/dependence.h"
#include "language/ir/core/builder.h"

#include <optional>

namespace candela::ir {

/// One importance cone of a request. Values are of the text.
struct Cone {
    enum class Kind {
        Stated,  ///< By an extended loop, as its operands have it.
        Sphere,  ///< A loop over everything: about N, 360 degrees.
        Classic, ///< A loop's axis and twice its half angle.
        Lobe,    ///< Read off the text: a power of a cosine about an axis.
        Delta,   ///< A traced answer.
    };
    int request = 0;
    Kind kind = Kind::Sphere;
    int index = 0; ///< Stated: which of the loop's cones.
    Triple axis{};
    /// Lobe: the axis is mirrored about `axis`: 2 (n.v) n - v for this v (a half-vector lobe).
    std::optional<Triple> mirrored;
    /// Lobe: exponent = value of `exponent` (none = 1) times exponentScale.
    std::optional<ValueId> exponent;
    float exponentScale = 1;
    /// Lobe: for each of the loop's results, the products that the lobe's cosine is weighted with.
    struct Weight {
        int result;
        std::vector<ValueId> factors;
    };
    std::vector<Weight> weights;
    /// Lobe: what the loop adds is this power of the cosine, at least 0, times what does not depend
    /// on the direction: no light matters outside the lobe, and none more than it says.
    bool exact = false;
};

/// The cones of all requests in the text, in request order. `recognize`: read lobes off classic
/// loops; their values may stand in the loops' bodies, which are computed before if binding times
/// are told apart.
std::vector<Cone> conesOf(const Function &text, const Dependence &, bool recognize);

} // namespace candela::ir
