// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/uniform_field.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/regions.h"
#include "language/ir/transform/specialization.h"

#include <algorithm>

namespace candela::ir {

/// Two vectors across the axis, by one division (Duff and others, 2017).
FieldFrame fieldFrame(Builder &b) {
    const Triple n = input3(b, ShaderInput::fieldAxis);
    const ValueId one = number(b, 1);
    const ValueId sign = select(b, less(b, n[2], number(b, 0)), number(b, -1), one);
    const ValueId a = div(b, number(b, -1), add(b, sign, n[2]));
    const ValueId across = mul(b, mul(b, n[0], n[1]), a);
    const auto alongAxis = [&](ValueId c) { return mul(b, mul(b, c, c), a); };
    return {{add(b, one, mul(b, sign, alongAxis(n[0]))), mul(b, sign, across),
             neg(b, mul(b, sign, n[0]))},
            {across, add(b, sign, alongAxis(n[1])), neg(b, n[1])},
            n};
}

/// A spiral from pole to pole: equal steps along the axis, the golden angle about it.
Triple fieldDirection(Builder &b, const FieldFrame &frame, ValueId k) {
    constexpr float goldenAngle = 2.3999632f;
    const ValueId height =
        sub(b, number(b, 1 - 1.0f / fieldDirections), mul(b, k, number(b, 2.0f / fieldDirections)));
    const ValueId radius = sqrt(b, sub(b, number(b, 1), mul(b, height, height)));
    const ValueId angle = mul(b, k, number(b, goldenAngle));
    return add(b,
               add(b, scale(b, frame.x, mul(b, radius, unary(b, Op::Cos, angle))),
                   scale(b, frame.y, mul(b, radius, unary(b, Op::Sin, angle)))),
               scale(b, frame.z, height));
}

namespace {

/// The one lobe that is the loop's whole answer; null if there is none, or if it is not known here
/// what it is weighted with.
const Cone *wholeAnswer(const Specialization &s, int h, const Instruction &i) {
    const Cone *found = nullptr;
    for (const Cone &cone : *s.options.lobes)
        if (cone.request == i.immediate) {
            if (found || !cone.exact)
                return nullptr;
            found = &cone;
        }
    const auto isKnown = [&](ValueId v) { return s.mapping.known(h, v).has_value(); };
    if (!found || (found->exponent && !isKnown(*found->exponent)))
        return nullptr;
    for (const Cone::Weight &weight : found->weights)
        if (!std::ranges::all_of(weight.factors, isKnown))
            return nullptr;
    return found;
}

class FieldLoop {
public:
    FieldLoop(Specialization &s, int h, const Instruction &i) : s_(s), h_(h), i_(i) {}

    Values results() {
        const Values initial = s_.mapping.values(
            h_, {i_.operands.end() - std::ptrdiff_t(i_.results.size()), i_.operands.end()});
        if (const Cone *lobe = wholeAnswer(s_, h_, i_))
            return integral(*lobe, initial);
        const LightRequest &request = s_.text.requests[std::size_t(i_.immediate)];
        if (request.form != ConeForm::Extended || request.coneCount == 0)
            return sum(initial);
        const ValueId isDelta = lessEqual(s_.b, operand(6), number(s_.b, 0));
        return ifElse(
            s_.b, isDelta,
            [&] {
                return turn({operand(3), operand(4), operand(5)}, 1, initial);
            },
            [&] { return sum(initial); });
    }

private:
    ValueId operand(std::size_t k) { return s_.mapping.value(h_, i_.operands[k]); }

    Values integral(const Cone &lobe, Values results) {
        const ValueId energy = energyOf(s_, h_, lobe);
        for (const Cone::Weight &weight : lobe.weights) {
            ValueId product = energy;
            for (ValueId factor : weight.factors)
                product = mul(s_.b, product, s_.mapping.value(h_, factor));
            ValueId &result = results[std::size_t(weight.result)];
            result = add(s_.b, result, product);
        }
        return results;
    }

    Values sum(const Values &initial) {
        Builder &b = s_.b;
        const ValueId count = number(b, fieldDirections);
        const FieldFrame frame = fieldFrame(b);
        Values carried{boolean(b, true), number(b, 0)};
        carried.insert(carried.end(), initial.begin(), initial.end());
        const Values end = loop(b, carried, [&](const Values &now) {
            const ValueId next = add(b, now[1], number(b, 1));
            const Values sums(now.begin() + 2, now.end());
            const Values more = reached(fieldDirection(b, frame, now[1]), sums);
            Values yields{less(b, next, count), next};
            yields.insert(yields.end(), more.begin(), more.end());
            return yields;
        });
        return {end.begin() + 2, end.end()};
    }

    Values reached(const Triple &L, const Values &sums) {
        const float share = 4.0f / fieldDirections;
        if (s_.text.requests[std::size_t(i_.immediate)].form != ConeForm::Classic)
            return turn(L, share, sums);
        const ConeTest &test = (*s_.options.coneTests)[std::size_t(i_.immediate)];
        const ValueId cosine = dot(s_.b, L, s_.mapping.triple(h_, test.axis));
        return ifElse(
            s_.b, lessEqual(s_.b, s_.mapping.value(h_, test.cosine), cosine),
            [&] { return turn(L, share, sums); }, [&] { return sums; });
    }

    /// The loop's body once, with that light.
    Values turn(const Triple &L, float Cl, const Values &carried) {
        const Region &region = i_.regions[0];
        const int samples = s_.text.colors.samples;
        Values given(L.begin(), L.end());
        given.insert(given.end(), std::size_t(samples), number(s_.b, Cl));
        given.push_back(number(s_.b, 0)); // Of no light.
        given.insert(given.end(), carried.begin(), carried.end());
        for (std::size_t k = 0; k < given.size(); ++k)
            s_.mapping.assign(h_, region.arguments[k], given[k]);
        s_.under({h_}, [&] { walk(s_, region, {s_.options.first, BindingTime::Response}); });
        return s_.mapping.values(h_, region.yields);
    }

    Specialization &s_;
    int h_;
    const Instruction &i_;
};

} // namespace

Values fieldLoop(Specialization &s, int h, const Instruction &i) {
    return FieldLoop(s, h, i).results();
}

} // namespace candela::ir
