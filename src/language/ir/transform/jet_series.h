// SPDX-License-Identifier: Apache-2.0
// Arithmetic on Taylor series in u and v whose coefficients are values of a function. A coefficient
// is written when it is first asked for, and then kept; nothing stands for zero.
#pragma once

#include "language/ir/core/builder.h"
#include "language/ir/transform/companions.h"
#include "language/ir/transform/jet_order.h"

#include <deque>
#include <functional>
#include <map>
#include <optional>

namespace candela::ir {

using MaybeValue = std::optional<ValueId>;

struct Series {
    std::map<Order, MaybeValue> known;
    std::function<MaybeValue(Order)> rule; ///< For what is not known; none = zero.
};
using Jet = Series *;

/// Owns the series that are made; all are gone with it.
class Jets {
public:
    explicit Jets(Builder &b) : b(b) {}
    Jets(const Jets &) = delete;
    Jets &operator=(const Jets &) = delete;

    Builder &b;

    Jet series(std::function<MaybeValue(Order)> rule);
    /// Of a value that stands, with what stands beside it.
    Jet given(ValueId, const Companions &);
    /// Of a value that stands; the rule for the rest is set later, and may name the series itself.
    Jet standing(ValueId);

private:
    std::deque<Series> all_;
};

MaybeValue coefficient(Jet, Order);
/// Order (0, 0), which is always there.
ValueId valueOf(Jet);

Jet constant(Jets &, float);
Jet sum(Jets &, Jet, Jet);
Jet difference(Jets &, Jet, Jet);
Jet negative(Jets &, Jet);
Jet product(Jets &, Jet, Jet);
/// `condition` chooses x or y, whatever the order.
Jet choice(Jets &, ValueId condition, Jet x, Jet y);
/// What has a slope where the condition holds, and else none.
Jet where(Jets &, ValueId condition, Jet);

/// The series whose derivative is that of x times g; of order 0 there is none.
Jet integral(Jets &, Jet x, Jet g);
/// Makes y, whose value stands, the series that times h gives x.
void setQuotient(Jets &, Jet y, Jet x, Jet h);
/// Makes y, whose value stands, the series whose derivative times h is that of x.
void setIntegralOver(Jets &, Jet y, Jet x, Jet h);

} // namespace candela::ir
