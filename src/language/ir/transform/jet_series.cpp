// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet_series.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

#include <algorithm>

namespace candela::ir {

Jet Jets::series(std::function<MaybeValue(Order)> rule) {
    return &all_.emplace_back(Series{{}, std::move(rule)});
}

Jet Jets::given(ValueId value, const Companions &beside) {
    Jet result = standing(value);
    for (auto [part, coefficient] : beside)
        result->known[orderOf(part)] = coefficient;
    return result;
}

Jet Jets::standing(ValueId value) {
    Jet result = series({});
    result->known[{}] = value;
    return result;
}

MaybeValue coefficient(Jet jet, Order order) {
    const auto found = jet->known.find(order);
    if (found != jet->known.end())
        return found->second;
    return jet->known[order] = jet->rule ? jet->rule(order) : std::nullopt;
}

ValueId valueOf(Jet jet) { return *coefficient(jet, {}); }

namespace {

MaybeValue plus(Builder &b, MaybeValue x, MaybeValue y) {
    return x && y ? add(b, *x, *y) : x ? x : y;
}
MaybeValue minus(Builder &b, MaybeValue x, MaybeValue y) {
    return x && y ? sub(b, *x, *y) : y ? MaybeValue(neg(b, *y)) : x;
}
/// In one order of the factors, so that the two ways round are one value.
MaybeValue times(Builder &b, MaybeValue x, MaybeValue y) {
    return x && y ? MaybeValue(mul(b, std::max(*x, *y), std::min(*x, *y))) : std::nullopt;
}

/// The sum over all orders o up to `order` of weight(o) x[o] y[order - o]; weight 0 = left out, and
/// then the coefficients are not asked for.
template <class Weight>
MaybeValue convolution(Builder &b, Jet x, Jet y, Order order, Weight weight) {
    MaybeValue result;
    for (int u = order.u; u >= 0; --u)
        for (int v = order.v; v >= 0; --v) {
            const Order o{u, v};
            const float w = weight(o);
            if (w == 0)
                continue;
            const MaybeValue first = coefficient(x, o);
            MaybeValue term = first ? times(b, first, coefficient(y, order - o)) : std::nullopt;
            if (term && w != 1)
                term = mul(b, *term, number(b, w));
            result = plus(b, result, term);
        }
    return result;
}

/// Series are integrated along u where they can be.
Direction along(Order order) { return order.u > 0 ? Direction::U : Direction::V; }

/// The weight of x[o] in the derivative of x along d, over that of the sum of order `order`.
float derivativeWeight(Order o, Order order, Direction d) {
    return float(o.along(d)) / float(order.along(d));
}

} // namespace

Jet constant(Jets &jets, float x) { return jets.standing(number(jets.b, x)); }

Jet sum(Jets &jets, Jet x, Jet y) {
    return jets.series(
        [&jets, x, y](Order o) { return plus(jets.b, coefficient(x, o), coefficient(y, o)); });
}

Jet difference(Jets &jets, Jet x, Jet y) {
    return jets.series(
        [&jets, x, y](Order o) { return minus(jets.b, coefficient(x, o), coefficient(y, o)); });
}

Jet negative(Jets &jets, Jet x) {
    return jets.series([&jets, x](Order o) { return minus(jets.b, {}, coefficient(x, o)); });
}

Jet product(Jets &jets, Jet x, Jet y) {
    return jets.series([&jets, x, y](Order order) {
        return convolution(jets.b, x, y, order, [](Order) { return 1.0f; });
    });
}

Jet choice(Jets &jets, ValueId condition, Jet x, Jet y) {
    return jets.series([&jets, condition, x, y](Order o) -> MaybeValue {
        const MaybeValue yes = coefficient(x, o), no = coefficient(y, o);
        if (!yes && !no)
            return std::nullopt;
        const ValueId zero = number(jets.b, 0);
        return select(jets.b, condition, yes.value_or(zero), no.value_or(zero));
    });
}

Jet where(Jets &jets, ValueId condition, Jet x) {
    return choice(jets, condition, x, jets.series({}));
}

Jet integral(Jets &jets, Jet x, Jet g) {
    return jets.series([&jets, x, g](Order order) {
        const Direction d = along(order);
        return convolution(jets.b, x, g, order,
                           [&](Order o) { return derivativeWeight(o, order, d); });
    });
}

void setQuotient(Jets &jets, Jet y, Jet x, Jet h) {
    y->rule = [&jets, y, x, h](Order order) -> MaybeValue {
        const MaybeValue known =
            convolution(jets.b, y, h, order, [&](Order o) { return o == order ? 0.0f : 1.0f; });
        const MaybeValue rest = minus(jets.b, coefficient(x, order), known);
        return rest ? MaybeValue(div(jets.b, *rest, valueOf(h))) : std::nullopt;
    };
}

void setIntegralOver(Jets &jets, Jet y, Jet x, Jet h) {
    y->rule = [&jets, y, x, h](Order order) -> MaybeValue {
        const Direction d = along(order);
        const MaybeValue known = convolution(jets.b, y, h, order, [&](Order o) {
            return o == order ? 0.0f : derivativeWeight(o, order, d);
        });
        const MaybeValue rest = minus(jets.b, coefficient(x, order), known);
        return rest ? MaybeValue(div(jets.b, *rest, valueOf(h))) : std::nullopt;
    };
}

} // namespace candela::ir
