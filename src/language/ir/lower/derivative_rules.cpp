// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/derivative_rules.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"
#include "language/runtime/runtime_functions.h"

#include <algorithm>
#include <cmath>

namespace candela::ir {
namespace {

using runtime::RuntimeFunction;
using MaybeValue = std::optional<ValueId>;

struct InputSlope {
    ShaderInput of, byU, byV;
};

// I runs from the eye, which stands still while u and v move P.
const InputSlope inputSlopes[] = {
    {ShaderInput::P, ShaderInput::dPdu, ShaderInput::dPdv},
    {ShaderInput::I, ShaderInput::dPdu, ShaderInput::dPdv},
    {ShaderInput::N, ShaderInput::dNdu, ShaderInput::dNdv},
    {ShaderInput::s, ShaderInput::dsdu, ShaderInput::dsdv},
    {ShaderInput::t, ShaderInput::dtdu, ShaderInput::dtdv},
};

/// The rules for one direction.
class Rule {
public:
    Rule(Builder &b, const Instruction &i, Slopes &slopes, int direction)
        : b(b), i(i), slopes(slopes), direction(direction) {}

    void apply() {
        if (i.op == Op::Call)
            return runtime::withSlopes(RuntimeFunction(i.immediate)) ? lattice() : latticeSlopes();
        if (const MaybeValue slope = i.op == Op::Input ? inputSlope() : arithmetic())
            slopes[i.results[0]][direction] = slope;
    }

private:
    MaybeValue slope(int operand) const {
        const auto found = slopes.find(i.operands[size_t(operand)]);
        return found == slopes.end() ? std::nullopt : found->second[direction];
    }
    ValueId x() const { return i.operands[0]; }
    ValueId y() const { return i.operands[1]; }
    ValueId result() const { return i.results[0]; }

    MaybeValue plus(MaybeValue p, MaybeValue q) { return p && q ? add(b, *p, *q) : p ? p : q; }
    MaybeValue minus(MaybeValue p, MaybeValue q) {
        return p && q ? sub(b, *p, *q) : q ? MaybeValue(neg(b, *q)) : p;
    }
    MaybeValue times(MaybeValue p, ValueId factor) {
        return p ? MaybeValue(mul(b, *p, factor)) : p;
    }
    MaybeValue over(MaybeValue p, ValueId divisor) {
        return p ? MaybeValue(div(b, *p, divisor)) : p;
    }
    MaybeValue choose(ValueId condition, MaybeValue p, MaybeValue q) {
        if (!p && !q)
            return std::nullopt;
        return select(b, condition, p ? *p : number(b, 0), q ? *q : number(b, 0));
    }

    MaybeValue inputSlope() {
        const int plane = i.immediate;
        if (plane == int(ShaderInput::u) || plane == int(ShaderInput::v))
            return (plane == int(ShaderInput::u)) == (direction == 0) ? MaybeValue(number(b, 1))
                                                                      : std::nullopt;
        for (const InputSlope &row : inputSlopes) {
            const bool isScalar = row.of == ShaderInput::s || row.of == ShaderInput::t;
            const int component = plane - int(row.of);
            if (component >= 0 && component < (isScalar ? 1 : 3))
                return input(b, direction == 0 ? row.byU : row.byV, component);
        }
        return std::nullopt;
    }

    MaybeValue arithmetic() {
        switch (i.op) {
        case Op::Add: return plus(slope(0), slope(1));
        case Op::Sub: return minus(slope(0), slope(1));
        case Op::Mul: return plus(times(slope(0), y()), times(slope(1), x()));
        case Op::Div: return over(minus(slope(0), times(slope(1), result())), y());
        case Op::Neg: return minus(std::nullopt, slope(0));
        case Op::Abs:
            return choose(less(b, x(), number(b, 0)), minus(std::nullopt, slope(0)), slope(0));
        case Op::Min: return choose(less(b, x(), y()), slope(0), slope(1));
        case Op::Max: return choose(less(b, y(), x()), slope(0), slope(1));
        case Op::Select: return choose(i.operands[0], slope(1), slope(2));
        case Op::Atan2: return atan2();
        case Op::Pow: return power();
        default: return slope(0) ? elementary(*slope(0)) : std::nullopt;
        }
    }

    /// Of one operand, whose derivative is `dx`.
    MaybeValue elementary(ValueId dx) {
        const ValueId one = number(b, 1);
        switch (i.op) {
        case Op::Sqrt:
            return choose(less(b, number(b, 0), x()), div(b, dx, mul(b, number(b, 2), result())),
                          {});
        case Op::Sin: return mul(b, dx, unary(b, Op::Cos, x()));
        case Op::Cos: return neg(b, mul(b, dx, unary(b, Op::Sin, x())));
        case Op::Tan: return mul(b, dx, add(b, one, mul(b, result(), result())));
        case Op::Asin: return div(b, dx, complement());
        case Op::Acos: return neg(b, div(b, dx, complement()));
        case Op::Atan: return div(b, dx, add(b, one, mul(b, x(), x())));
        case Op::Exp: return mul(b, dx, result());
        case Op::Log: return div(b, dx, x());
        default: return std::nullopt; // Steps: floor and its like.
        }
    }

    /// sqrt(1 - x^2), kept from 0 so that the ends of asin and acos give something finite.
    ValueId complement() {
        const ValueId squared = sub(b, number(b, 1), mul(b, x(), x()));
        return max(b, sqrt(b, squared), number(b, 1e-6f));
    }

    MaybeValue atan2() { // The angle of (y(), x()).
        const ValueId squared = add(b, mul(b, x(), x()), mul(b, y(), y()));
        return over(minus(times(slope(0), y()), times(slope(1), x())), squared);
    }

    MaybeValue power() {
        const MaybeValue ofBase =
            slope(0) ? times(slope(0), mul(b, y(), pow(b, x(), sub(b, y(), number(b, 1)))))
                     : std::nullopt;
        MaybeValue ofExponent;
        if (slope(1))
            ofExponent = choose(less(b, number(b, 0), x()),
                                mul(b, *slope(1), mul(b, result(), unary(b, Op::Log, x()))), {});
        return plus(ofBase, ofExponent);
    }

    /// Noise knows its slopes along the coordinates.
    void lattice() {
        const int coordinates = runtime::coordinatesOf(RuntimeFunction(i.immediate));
        const size_t components = i.results.size();
        Values values;
        for (int k = 0; k < coordinates; ++k)
            if (const MaybeValue dx = slope(k)) {
                if (values.empty())
                    values = callRuntime(b, int(*runtime::withSlopes(RuntimeFunction(i.immediate))),
                                         i.operands);
                for (size_t c = 0; c < components; ++c) {
                    MaybeValue &sum = slopes[i.results[c]][direction];
                    sum = plus(sum, times(dx, values[components + c * coordinates + k]));
                }
            }
    }

    /// Derivatives of derivatives of noise: a central difference along the coordinates' derivative,
    /// over 1/128 of a cell.
    void latticeSlopes() {
        const int coordinates = runtime::coordinatesOf(RuntimeFunction(i.immediate));
        MaybeValue size;
        for (int k = 0; k < coordinates; ++k)
            if (const MaybeValue dx = slope(k)) {
                const ValueId length = unary(b, Op::Abs, *dx);
                size = size ? max(b, *size, length) : length;
            }
        if (!size)
            return;
        const ValueId step = div(b, number(b, 0x1p-8f), max(b, *size, number(b, 1e-20f)));
        std::vector<ValueId> before = i.operands, after = i.operands;
        for (int k = 0; k < coordinates; ++k)
            if (const MaybeValue dx = slope(k)) {
                const ValueId offset = mul(b, *dx, step);
                before[size_t(k)] = sub(b, before[size_t(k)], offset);
                after[size_t(k)] = add(b, after[size_t(k)], offset);
            }
        const Values low = callRuntime(b, i.immediate, before);
        const Values high = callRuntime(b, i.immediate, after);
        const ValueId width = mul(b, number(b, 2), step);
        for (size_t k = 0; k < i.results.size(); ++k)
            slopes[i.results[k]][direction] = div(b, sub(b, high[k], low[k]), width);
    }

    Builder &b;
    const Instruction &i;
    Slopes &slopes;
    int direction;
};

} // namespace

std::vector<ValueId> differentiableOperands(const Instruction &i) {
    switch (info(i.op).slope) {
    case SlopeRule::None:
    case SlopeRule::Step:
    case SlopeRule::Source:
    case SlopeRule::Memory:
    case SlopeRule::Control: return {};
    case SlopeRule::Choice: return {i.operands[1], i.operands[2]};
    case SlopeRule::Call:
        if (i.immediate < 0)
            return {};
        return {i.operands.begin(),
                i.operands.begin() + runtime::coordinatesOf(RuntimeFunction(i.immediate))};
    default: return i.operands;
    }
}

void differentiate(Builder &b, const Instruction &i, Slopes &slopes) {
    if (i.results.empty() || b.type(i.results[0]) != Type::Float)
        return;
    const bool isKnown = i.op == Op::Input || !differentiableOperands(i).empty();
    for (int direction = 0; direction < 2 && isKnown; ++direction)
        Rule(b, i, slopes, direction).apply();
}

} // namespace candela::ir
