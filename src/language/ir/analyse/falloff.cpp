// SPDX-License-Identifier: Apache-2.0
// How a light falls off: a value is homogeneous of degree p in L if stretching L by k > 0, the
// direction kept, multiplies it by k^p. Degrees follow from those of the operands.
#include "language/ir/analyse/falloff.h"

#include "language/ir/core/dataflow.h"

#include <cmath>

namespace candela::ir {

namespace {

struct Degree {
    /// Zero is the number 0, which has every degree.
    enum Kind { Undefined, Zero, Power, Unknown } kind = Undefined;
    float power = 0;

    /// What a decision on it comes to does not change when L is stretched.
    bool isSteady() const { return kind == Zero || (kind == Power && power == 0); }
    bool operator==(const Degree &) const = default;
};

constexpr Degree unknown{Degree::Unknown, 0};
constexpr Degree steady{Degree::Power, 0};

/// A power that is not a number would never equal itself, and the solution never stand still.
Degree ofPower(float power) {
    return std::isfinite(power) ? Degree{Degree::Power, power} : unknown;
}

Degree merged(Degree a, Degree b) {
    if (a.kind == Degree::Undefined || (a.kind == Degree::Zero && b.kind != Degree::Undefined))
        return b;
    if (b.kind == Degree::Undefined || b.kind == Degree::Zero || a == b)
        return a;
    return unknown;
}

/// Of a product, `sign` 1, or a quotient, -1.
Degree product(Degree a, Degree b, float sign) {
    if (a.kind == Degree::Zero || (b.kind == Degree::Zero && sign > 0))
        return {Degree::Zero, 0};
    if (a.kind == Degree::Power && b.kind == Degree::Power)
        return ofPower(a.power + sign * b.power);
    return unknown;
}

struct DegreeAnalysis : ForwardAnalysis<Degree> {
    DegreeAnalysis(const Function &function, const Triple &L)
        : ForwardAnalysis(function), L(L), definition(function.values.size()) {
        forEachInstruction(function.body, [&](const Instruction &i) {
            for (ValueId v : i.results)
                definition[v] = &i;
        });
    }

    bool isL(ValueId v) const { return v == L[0] || v == L[1] || v == L[2]; }

    Degree result(const Instruction &i, std::size_t k, const Enclosing *) const {
        return isL(i.results[k]) ? Degree{Degree::Power, 1} : degreeOf(i);
    }
    Degree array(const Instruction &, const Enclosing *) const { return unknown; }
    Degree given(const Instruction &, std::size_t) const { return unknown; }

    Degree flow(const ValueFlow &flow, const Enclosing *) const {
        if (isL(flow.to))
            return {Degree::Power, 1};
        const auto condition = conditionOf(flow.owner);
        if (!condition)
            return unknown;
        // A loop starts from what it carries at first; a second sweep sees what it comes to.
        const Degree decides = at(*condition);
        const bool isFirst = decides.kind == Degree::Undefined && at(flow.owner, 0).isSteady();
        // What loops carry only rises; what an If gives follows the latest that its sides are.
        Degree all = flow.owner.op == Op::Loop ? at(flow.to) : Degree{};
        for (ValueId v : flow.from)
            all = merged(all, at(v));
        return isFirst || decides.isSteady() ? all : unknown;
    }

    Degree degreeOf(const Instruction &i) const {
        if (i.op == Op::ConstFloat)
            return i.number == 0 ? Degree{Degree::Zero, 0} : steady;
        if (i.op == Op::Input) { // Ps moves when L is stretched, and what the viewer sees of it.
            const auto isOf = [&](ShaderInput first, ShaderInput last) {
                return i.immediate >= int(first) && i.immediate <= int(last);
            };
            return isOf(ShaderInput::Ps, ShaderInput::PsLast_) ||
                           isOf(ShaderInput::Is, ShaderInput::IsLast_)
                       ? unknown
                       : steady;
        }
        if (!isPure(i.op) || info(i.op).kind == OpClass::Random)
            return unknown;
        if (isFloatComparison(i.op)) // Both sides grow alike.
            return merged(at(i, 0), at(i, 1)).kind == Degree::Unknown ? unknown : steady;
        if (i.op == Op::Sqrt)
            return at(i, 0).kind == Degree::Power ? Degree{Degree::Power, at(i, 0).power / 2}
                                                  : at(i, 0);
        switch (info(i.op).slope) {
        case SlopeRule::Sum:
        case SlopeRule::Difference:
        case SlopeRule::Least:
        case SlopeRule::Greatest: return merged(at(i, 0), at(i, 1));
        case SlopeRule::Negation:
        case SlopeRule::Magnitude: return at(i, 0);
        case SlopeRule::Product: return product(at(i, 0), at(i, 1), 1);
        case SlopeRule::Quotient: return product(at(i, 0), at(i, 1), -1);
        case SlopeRule::Choice: return chosen(i);
        case SlopeRule::Power: return raised(i);
        default: return steadyIfOperandsAre(i);
        }
    }

    Degree steadyIfOperandsAre(const Instruction &i) const {
        for (ValueId operand : i.operands)
            if (!at(operand).isSteady())
                return unknown;
        return steady;
    }

    /// Something is 0: guards a division, and holds almost nowhere.
    bool testsForZero(ValueId condition) const {
        const Instruction *i = definition[condition];
        return i && i->op == Op::Equal &&
               (at(*i, 0).kind == Degree::Zero || at(*i, 1).kind == Degree::Zero);
    }

    Degree chosen(const Instruction &i) const {
        if (testsForZero(i.operands[0]))
            return at(i, 2);
        return at(i, 0).isSteady() ? merged(at(i, 1), at(i, 2)) : unknown;
    }

    Degree raised(const Instruction &i) const {
        const Instruction *exponent = definition[i.operands[1]];
        if (at(i, 0).kind == Degree::Power && exponent && exponent->op == Op::ConstFloat)
            return ofPower(at(i, 0).power * exponent->number);
        return steadyIfOperandsAre(i);
    }

    const Triple L;
    std::vector<const Instruction *> definition; ///< Null for arguments of regions.
};

} // namespace

std::optional<float> powerOfDistance(const Function &function, const Triple &L) {
    DegreeAnalysis degrees(function, L);
    solve(degrees);
    std::optional<Degree> all;
    forEachInstruction(function.body, [&](const Instruction &i) {
        if (i.op == Op::Output && function.outputs[size_t(i.immediate)].name == OutputKind::Cl)
            all = merged(all.value_or(Degree{}), degrees.at(i, 0));
    });
    if (!all || all->kind == Degree::Unknown)
        return std::nullopt;
    return all->kind == Degree::Zero ? 0 : all->power;
}

} // namespace candela::ir
