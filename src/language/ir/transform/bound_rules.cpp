// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/bound_rules.h"

#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"
#include "language/ir/transform/bound_functions.h"
#include "language/ir/transform/bound_noise.h"
#include "language/ir/transform/bound_sources.h"
#include "language/ir/transform/bound_variation.h"

#include <algorithm>
#include <limits>

namespace candela::ir {

BoundRules::BoundRules(const Function &old, Builder &b) : old_(old), b_(b), idioms_(old) {}

void BoundRules::write(const Instruction &i, std::vector<BoundedValue> &written) {
    written_ = &written;
    Operands operands;
    Values middles;
    for (ValueId v : i.operands) {
        operands.push_back(written[v]);
        middles.push_back(written[v].middle);
    }
    const Values results = b_.emit(i.op, middles, i.immediate, i.number);
    for (std::size_t k = 0; k < i.results.size(); ++k)
        written[i.results[k]] = {results[k]};
    const bool varies = std::ranges::any_of(operands, &BoundedValue::varies);
    if (!varies && !variesByItself(old_, i))
        return;
    if (i.op == Op::Call) {
        const auto forms = boundOfNoise(b_, RuntimeFunction(i.immediate), operands, results);
        for (std::size_t k = 0; k < i.results.size(); ++k)
            written[i.results[k]].form = forms[k];
        return;
    }
    for (std::size_t k = 0; k < i.results.size(); ++k)
        written[i.results[k]] = bound(i, operands, results[k]);
}

namespace {

/// Whether one of two numbers is below the other, if their difference lies there all over the box.
ValueId isUndecided(Builder &b, Op op, const FormParts &difference) {
    const ValueId zero = number(b, 0);
    const ValueId least = difference.least, greatest = difference.greatest;
    switch (op) {
    case Op::Less: return negate(b, either(b, less(b, greatest, zero), lessEqual(b, zero, least)));
    case Op::LessEqual:
        return negate(b, either(b, lessEqual(b, greatest, zero), less(b, zero, least)));
    default: // Or they differ by the same all over the box.
        return negate(b, either(b, either(b, less(b, greatest, zero), less(b, zero, least)),
                                equal(b, least, greatest)));
    }
}

/// Not even that it is a number.
ValueId isUnknown(Builder &b, const FormParts &f) {
    const float endless = std::numeric_limits<float>::infinity();
    const ValueId isKnown = both(
        b, lessEqual(b, f.least, f.greatest),
        either(b, less(b, number(b, -endless), f.least), less(b, f.greatest, number(b, endless))));
    return negate(b, isKnown);
}

BoundedValue logic(Builder &b, Op op, const std::vector<BoundedValue> &x, ValueId middle) {
    if (op == Op::Not)
        return {middle, {}, x[0].unsure};
    // Sure is And if one is false for sure, Or if one is true for sure.
    const auto decides = [&](const BoundedValue &v) {
        const ValueId truth = op == Op::And ? negate(b, v.middle) : v.middle;
        return both(b, truth, negate(b, unsureOf(b, v)));
    };
    const ValueId any = either(b, unsureOf(b, x[0]), unsureOf(b, x[1]));
    return {middle, {}, both(b, any, negate(b, either(b, decides(x[0]), decides(x[1]))))};
}

FormParts negative(Builder &b, const FormParts &f) {
    return {neg(b, f.alongU), neg(b, f.alongV), f.off, neg(b, f.greatest), neg(b, f.least)};
}

} // namespace

BoundedValue BoundRules::bound(const Instruction &i, const Operands &x, ValueId middle) {
    const auto pair = [&](RuntimeFunction function) {
        return BoundedValue{middle, callBound(b_, function, x)};
    };
    switch (info(i.op).bound) {
    case BoundRule::Source:
        return {middle, i.op == Op::Input ? inputForm(b_, i.immediate) : boundless(i)};
    case BoundRule::Sum: return {middle, sum(i, x, middle)};
    case BoundRule::Difference: return {middle, difference(i, x)};
    case BoundRule::Product: return {middle, product(i, x, middle)};
    case BoundRule::Quotient: return pair(RuntimeFunction::bound_quotient);
    case BoundRule::Negation: return {middle, negative(b_, formOf(b_, x[0]))};
    case BoundRule::Magnitude: return pair(RuntimeFunction::bound_magnitude);
    case BoundRule::Least: return pair(RuntimeFunction::bound_least);
    case BoundRule::Greatest: return pair(RuntimeFunction::bound_greatest);
    case BoundRule::First: return {middle, x[0].form};
    case BoundRule::Increasing:
    case BoundRule::Decreasing:
        if (i.op == Op::IntegerFromFloat || i.op == Op::StringFromFloat) {
            const FormParts f = formOf(b_, x[0]);
            const ValueId isOne =
                equal(b_, unary(b_, Op::Floor, f.least), unary(b_, Op::Floor, f.greatest));
            return {middle, {}, negate(b_, isOne)};
        }
        return {middle, monotone(i, x[0], middle)};
    case BoundRule::Periodic:
        return {middle, i.op == Op::Tan ? boundOfMonotone(b_, i.op, x[0], middle)
                                        : boundOfWave(b_, i.op, x[0], middle)};
    case BoundRule::Angle: return {middle, boundOfAngle(b_, x[0], x[1], middle)};
    case BoundRule::Power: return {middle, boundOfPower(b_, x[0], x[1], middle)};
    case BoundRule::Comparison:
        if (i.op == Op::StringEqual)
            return {middle, {}, either(b_, unsureOf(b_, x[0]), unsureOf(b_, x[1]))};
        if (i.operands[0] == i.operands[1]) // Whether it is a number.
            return {middle, {}, isUnknown(b_, formOf(b_, x[0]))};
        return {
            middle, {}, isUndecided(b_, i.op, callBound(b_, RuntimeFunction::bound_difference, x))};
    case BoundRule::Logic: return logic(b_, i.op, x, middle);
    case BoundRule::Union: return selected(i, x, middle);
    case BoundRule::Fraction: return {middle, rangeForm(b_, middle, number(b_, 0), number(b_, 1))};
    default: {
        if (b_.type(middle) == Type::Float)
            return {middle, boundless(i)};
        boundless(i);
        return {middle, {}, boolean(b_, true)};
    }
    }
}

FormParts BoundRules::monotone(const Instruction &i, const BoundedValue &x, ValueId middle) {
    return i.op == Op::Floor || i.op == Op::Ceil || i.op == Op::Round
               ? boundOfStep(b_, i.op, x, middle)
               : boundOfMonotone(b_, i.op, x, middle);
}

FormParts BoundRules::product(const Instruction &i, const Operands &x, ValueId middle) {
    if (i.operands[0] == i.operands[1])
        return callBound(b_, RuntimeFunction::bound_square, {x[0]});
    const FormParts plain = callBound(b_, RuntimeFunction::bound_product, x);
    for (std::size_t k : {0u, 1u})
        if (const auto scaled = idioms_.scaledBy(i.operands[k])) {
            const auto &vector = scaled->vector;
            const auto found = std::ranges::find(vector, i.operands[1 - k]);
            if (found == vector.end())
                continue;
            const auto &w = *written_;
            const FormParts unit =
                boundOfUnit(b_, {w[vector[0]], w[vector[1]], w[vector[2]]},
                            std::size_t(found - vector.begin()), w[scaled->length].middle, middle);
            return select(b_, less(b_, unit.off, plain.off), unit, plain);
        }
    return plain;
}

/// Where a vector is known to be no longer than 1 (and a little): made so by normalize(), turned
/// round, chosen among such, mirrored; or the same all over the box. Nothing if that is not known.
std::optional<ValueId> BoundRules::isUnit(const std::array<ValueId, 3> &v, int depth) {
    const auto &w = *written_;
    if (!w[v[0]].varies() && !w[v[1]].varies() && !w[v[2]].varies()) {
        ValueId squared = number(b_, 0);
        for (ValueId c : v)
            squared = add(b_, squared, mul(b_, w[c].middle, w[c].middle));
        return lessEqual(b_, squared, number(b_, 1.000001f));
    }
    const std::array<const Instruction *, 3> made{
        idioms_.definition(v[0]), idioms_.definition(v[1]), idioms_.definition(v[2])};
    const auto areAll = [&](Op op) {
        return std::ranges::all_of(made, [&](const Instruction *i) { return i && i->op == op; });
    };
    const auto operands = [&](std::size_t k) {
        return std::array{made[0]->operands[k], made[1]->operands[k], made[2]->operands[k]};
    };
    if (depth == 0)
        return std::nullopt;
    const auto isOne = [&](std::size_t k) {
        return operands(k) ==
               std::array{made[0]->operands[k], made[0]->operands[k], made[0]->operands[k]};
    };
    if (areAll(Op::Neg))
        return isUnit(operands(0), depth - 1);
    if (areAll(Op::Mul))
        for (std::size_t k : {0u, 1u})
            if (const auto scaled = idioms_.scaledBy(made[0]->operands[k]);
                scaled && isOne(k) && scaled->vector == operands(1 - k))
                return less(b_, number(b_, 1e-15f), formOf(b_, w[scaled->length]).least);
    const auto bothOf = [&](const std::array<ValueId, 3> &x,
                            const std::array<ValueId, 3> &y) -> std::optional<ValueId> {
        const auto one = isUnit(x, depth - 1), other = isUnit(y, depth - 1);
        return one && other ? std::optional(both(b_, *one, *other)) : std::nullopt;
    };
    if (areAll(Op::Select) && isOne(0))
        return bothOf(operands(1), operands(2));
    if (!areAll(Op::Sub)) // I - 2 (I.N) N
        return std::nullopt;
    const std::array<ValueId, 3> moved = operands(1);
    std::array<ValueId, 3> normal;
    for (std::size_t k = 0; k < 3; ++k) {
        const Instruction *scaled = idioms_.definition(moved[k], Op::Mul);
        if (!scaled)
            return std::nullopt;
        normal[k] = scaled->operands[0];
        const Instruction *twice = idioms_.definition(scaled->operands[1], Op::Mul);
        const Instruction *sum = twice && idioms_.isNumber(twice->operands[0], 2)
                                     ? idioms_.definition(twice->operands[1], Op::Add)
                                     : nullptr;
        const auto dot = sum ? idioms_.dotOf(*sum) : std::nullopt;
        if (!dot || (*dot)[0] != operands(0))
            return std::nullopt;
        if (k == 2 && (*dot)[1] == normal)
            return bothOf(operands(0), normal);
    }
    return std::nullopt;
}

/// The dot product of two vectors of unit length lies between -1 and 1.
FormParts BoundRules::cutAsDot(const Instruction &sum, const FormParts &f) {
    const auto vectors = idioms_.dotOf(sum);
    const auto one = vectors ? isUnit((*vectors)[0], 4) : std::nullopt;
    const auto other = one ? isUnit((*vectors)[1], 4) : std::nullopt;
    if (!other)
        return f;
    FormParts cut = f;
    cut.least = max(b_, f.least, number(b_, -1.00001f));
    cut.greatest = min(b_, f.greatest, number(b_, 1.00001f));
    return select(b_, both(b_, *one, *other), cut, f);
}

/// A mix() of two forms is known by what it is made of better than as a sum: a + t (b - a), which
/// lies between a and b if t does between 0 and 1.
FormParts BoundRules::sum(const Instruction &i, const Operands &x, ValueId middle) {
    const FormParts plain = callBound(b_, RuntimeFunction::bound_sum, x);
    const auto mix = idioms_.mixOf(i);
    if (!mix)
        return cutAsDot(i, plain);
    const BoundedValue one{number(b_, 1)};
    const auto given = [&](std::optional<ValueId> v) { return v ? (*written_)[*v] : one; };
    const BoundedValue from = given(mix->from), to = given(mix->to), share = given(mix->share);
    const BoundedValue way{sub(b_, to.middle, from.middle),
                           callBound(b_, RuntimeFunction::bound_difference, {to, from})};
    const BoundedValue gone{mul(b_, share.middle, way.middle),
                            callBound(b_, RuntimeFunction::bound_product, {share, way})};
    FormParts other = callBound(b_, RuntimeFunction::bound_sum, {from, gone});
    // Its middle is rounded otherwise.
    const auto size = [&](ValueId v) { return unary(b_, Op::Abs, v); };
    const ValueId apart = size(sub(b_, add(b_, from.middle, gone.middle), middle));
    const ValueId slack =
        add(b_, apart, mul(b_, add(b_, size(from.middle), size(to.middle)), number(b_, 0x1p-21f)));
    other.off = add(b_, other.off, slack);
    const FormParts f = formOf(b_, from), t = formOf(b_, to), s = formOf(b_, share);
    const ValueId isBetween =
        both(b_, lessEqual(b_, number(b_, 0), s.least), lessEqual(b_, s.greatest, number(b_, 1)));
    const ValueId least = min(b_, f.least, t.least), greatest = max(b_, f.greatest, t.greatest);
    const auto more = [&](ValueId end) { return mul(b_, size(end), number(b_, 0x1p-21f)); };
    FormParts best = select(b_, less(b_, other.off, plain.off), other, plain);
    best.least =
        select(b_, isBetween, max(b_, plain.least, sub(b_, least, more(least))), plain.least);
    best.greatest = select(
        b_, isBetween, min(b_, plain.greatest, add(b_, greatest, more(greatest))), plain.greatest);
    return callBound(b_, RuntimeFunction::bound_settle, {{middle, best}}, {slack});
}

/// What part of another value a value is: a factor that is the same all over the box.
std::optional<ValueId> BoundRules::shareOf(ValueId part, ValueId whole) const {
    if (const Instruction *product = idioms_.definition(part, Op::Mul))
        for (std::size_t k : {0u, 1u})
            if (product->operands[k] == whole && !(*written_)[product->operands[1 - k]].varies())
                return product->operands[1 - k];
    return std::nullopt;
}

/// x - Floor(x), x - period Floor(x / period), and x - Min(Floor(x), last) of a spline's segments:
/// from 0 to 1 (or a period), which the forms of both alone do not tell; x - k x, (x + y) - x
/// and x - x.
FormParts BoundRules::difference(const Instruction &i, const Operands &x) {
    const FormParts f = callBound(b_, RuntimeFunction::bound_difference, x);
    const auto isFloorOf = [&](ValueId v, ValueId of) {
        const Instruction *floor = idioms_.definition(v, Op::Floor);
        return floor && floor->operands[0] == of;
    };
    const ValueId whole = i.operands[0], part = i.operands[1];
    if (whole == part) // 0, of a number that is finite.
        return select(b_,
                      less(b_, x[0].form->off, number(b_, std::numeric_limits<float>::infinity())),
                      formOf(b_, {number(b_, 0)}), f);
    if (const auto rest = idioms_.summandBeside(whole, part)) {
        const BoundedValue &kept = (*written_)[*rest];
        FormParts form = formOf(b_, kept);
        const auto size = [&](ValueId v) { return unary(b_, Op::Abs, v); };
        const auto sizes = [&](const FormParts &g) {
            return add(b_, size(g.least), size(g.greatest));
        };
        const ValueId slack = mul(b_, add(b_, sizes(formOf(b_, x[0])), sizes(formOf(b_, x[1]))),
                                  number(b_, 0x1p-22f));
        form = {form.alongU, form.alongV, add(b_, form.off, slack), sub(b_, form.least, slack),
                add(b_, form.greatest, slack)};
        return select(b_, less(b_, form.off, f.off), form, f);
    }
    const ValueId zero = number(b_, 0), one = number(b_, 1);
    const auto within = [&](ValueId least, ValueId most, ValueId holds) {
        FormParts cut = f;
        cut.least = max(b_, f.least, least);
        cut.greatest = min(b_, f.greatest, most);
        return select(b_, holds, cut, f);
    };
    if (isFloorOf(part, whole))
        return within(zero, one, boolean(b_, true));
    const FormParts ofX = formOf(b_, x[0]);
    if (const Instruction *least = idioms_.definition(part, Op::Min);
        least && isFloorOf(least->operands[0], whole)) {
        const FormParts last = formOf(b_, (*written_)[least->operands[1]]);
        return within(zero, one, lessEqual(b_, ofX.greatest, add(b_, last.least, one)));
    }
    if (const auto share = shareOf(part, whole)) {
        const BoundedValue rest{sub(b_, one, (*written_)[*share].middle)};
        FormParts kept = callBound(b_, RuntimeFunction::bound_product, {x[0], rest});
        const auto size = [&](ValueId v) { return unary(b_, Op::Abs, v); };
        // Both are rounded otherwise.
        const ValueId slack =
            mul(b_, add(b_, size(ofX.least), size(ofX.greatest)), number(b_, 0x1p-21f));
        kept.off = add(b_, kept.off, slack);
        kept.least = sub(b_, kept.least, slack);
        kept.greatest = add(b_, kept.greatest, slack);
        return kept;
    }
    const Instruction *product = idioms_.definition(part, Op::Mul);
    for (std::size_t k = 0; product && k < 2; ++k) {
        const ValueId period = product->operands[k];
        const Instruction *floor = idioms_.definition(product->operands[1 - k], Op::Floor);
        const Instruction *ratio =
            floor ? idioms_.definition(floor->operands[0], Op::Div) : nullptr;
        if (!ratio || ratio->operands[0] != whole || ratio->operands[1] != period)
            continue;
        const FormParts of = formOf(b_, (*written_)[period]);
        // Quotient and product are rounded.
        const ValueId most =
            max(b_, unary(b_, Op::Abs, ofX.least), unary(b_, Op::Abs, ofX.greatest));
        const ValueId slack = mul(b_, most, number(b_, 0x1p-21f));
        return within(neg(b_, slack), add(b_, of.greatest, slack), less(b_, zero, of.least));
    }
    return f;
}

BoundedValue BoundRules::selected(const Instruction &i, const Operands &x, ValueId middle) {
    if (i.op == Op::FloatFromBool) {
        const FormParts either = rangeForm(b_, middle, number(b_, 0), number(b_, 1));
        return {middle, select(b_, unsureOf(b_, x[0]), either, formOf(b_, {middle}))};
    }
    BoundedValue result = choice(b_, x[0], x[1], x[2]);
    result.middle = middle;
    if (const auto t = idioms_.smoothStepOf(i)) {
        const FormParts steps = boundOfSmoothStep(b_, (*written_)[*t], middle);
        const Instruction *ratio = idioms_.definition(*t, Op::Div);
        const bool rises = !ratio || idioms_.definition(ratio->operands[1], Op::ConstFloat);
        const auto isAbove0 = [&] {
            return less(b_, number(b_, 0), formOf(b_, (*written_)[ratio->operands[1]]).least);
        };
        result.form = rises ? steps : select(b_, isAbove0(), steps, formOf(b_, result));
    }
    return result;
}

FormParts BoundRules::boundless(const Instruction &i) {
    std::string what = "light";
    if (i.op == Op::Variable)
        what = "the primitive variable \"" + old_.variables[std::size_t(i.immediate)].name + "\"";
    else if (isService(i.op))
        what = std::string(serviceOf(old_, i).info->name) + "()";
    if (const BoundlessNote note{i.line, what}; std::ranges::find(notes_, note) == notes_.end())
        notes_.push_back(note);
    return unknownForm(b_);
}

} // namespace candela::ir
