// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/cone_direction.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

#include <numbers>
#include <utility>

namespace candela::ir {
namespace {

/// Two directions that complete a unit vector to an orthonormal frame (Duff et al. 2017).
std::pair<Triple, Triple> frameAbout(Builder &b, const Triple &n) {
    const ValueId one = number(b, 1);
    const ValueId sign = select(b, less(b, n[2], number(b, 0)), number(b, -1), one);
    const ValueId a = div(b, number(b, -1), add(b, sign, n[2]));
    const ValueId c = mul(b, mul(b, n[0], n[1]), a);
    const Triple x{add(b, one, mul(b, mul(b, sign, mul(b, n[0], n[0])), a)), mul(b, sign, c),
                   neg(b, mul(b, sign, n[0]))};
    const Triple y{c, add(b, sign, mul(b, mul(b, n[1], n[1]), a)), neg(b, n[1])};
    return {x, y};
}

/// Of an angle from the axis, at `x` of the way to the rim.
ValueId cosineAt(Builder &b, ValueId angle, ValueId x, ConeWeight weight) {
    const ValueId one = number(b, 1);
    if (weight == ConeWeight::Uniform)
        return sub(b, one, mul(b, x, sub(b, one, unary(b, Op::Cos, max(b, angle, number(b, 0))))));
    const ValueId quarter = number(b, std::numbers::pi_v<float> / 2);
    const ValueId rim = unary(b, Op::Sin, min(b, max(b, angle, number(b, 0)), quarter));
    return sqrt(b, sub(b, one, mul(b, x, mul(b, rim, rim))));
}

} // namespace

Triple directionInCone(Builder &b, const Triple &axis, ValueId angle, ValueId x, ValueId y,
                       ConeWeight weight) {
    const Triple centre = normalize(b, axis);
    if (const float *known = constantFloat(b, angle); known && *known <= 0)
        return centre;
    const ValueId turn = mul(b, number(b, 2 * std::numbers::pi_v<float>), y);
    const ValueId cosine = cosineAt(b, angle, x, weight);
    const ValueId sine = sqrt(b, sub(b, number(b, 1), mul(b, cosine, cosine)));
    const auto [sideways, upward] = frameAbout(b, centre);
    return add(b, scale(b, centre, cosine),
               add(b, scale(b, sideways, mul(b, sine, unary(b, Op::Cos, turn))),
                   scale(b, upward, mul(b, sine, unary(b, Op::Sin, turn)))));
}

} // namespace candela::ir
