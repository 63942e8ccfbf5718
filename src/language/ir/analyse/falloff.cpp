// SPDX-License-Identifier: Apache-2.0
// How a light falls off: a value is homogeneous of degree p in L if stretching L by k > 0, the
// direction kept, multiplies it by k^p. Degrees follow from those of the operands.
#include "language/ir/analyse/falloff.h"

#include "foundation/units/color.h"

#include <map>
#include <set>

namespace candela::ir {
namespace {

class Degrees {
public:
    Degrees(const Function &function, const Triple &L)
        : function_(function), L_(L), degrees_(function.values.size()) {
        // Loops start from what they carry at first; a second sweep sees what they come to.
        visit(function.body);
        do {
            changed_ = false;
            visit(function.body);
        } while (changed_);
    }

    /// The common degree of output Cl.
    std::optional<float> ofCl() const {
        std::optional<Degree> all;
        collect(function_.body, all);
        if (!all || all->kind == Degree::Unknown)
            return std::nullopt;
        return all->kind == Degree::Zero ? 0 : all->power;
    }

private:
    /// Zero is the number 0, which has every degree.
    struct Degree {
        enum Kind { Undefined, Zero, Power, Unknown } kind = Undefined;
        float power = 0;
        bool operator==(const Degree &) const = default;
    };
    static Degree power(float p) { return {Degree::Power, p}; }

    static Degree merged(Degree a, Degree b) {
        if (a.kind == Degree::Undefined || (a.kind == Degree::Zero && b.kind != Degree::Undefined))
            return b;
        if (b.kind == Degree::Undefined || b.kind == Degree::Zero || a == b)
            return a;
        return {Degree::Unknown, 0};
    }

    Degree degree(ValueId v) const { return degrees_[v]; }
    void set(ValueId v, Degree d) {
        if (v == L_[0] || v == L_[1] || v == L_[2])
            d = power(1);
        if (!(degrees_[v] == d)) {
            degrees_[v] = d;
            changed_ = true;
        }
    }

    void visit(const Region &region) {
        for (const Instruction &i : region.body)
            visit(i);
    }

    /// Whether a decision cannot change when L is stretched.
    bool isSteady(ValueId condition) const {
        const Degree d = degree(condition);
        return d.kind == Degree::Zero || (d.kind == Degree::Power && d.power == 0);
    }

    void visit(const Instruction &i) {
        switch (i.op) {
        case Op::If:
            for (const Region &region : i.regions)
                visit(region);
            for (size_t k = 0; k < i.results.size(); ++k)
                set(i.results[k], isSteady(i.operands[0]) ? merged(degree(i.regions[0].yields[k]),
                                                                   degree(i.regions[1].yields[k]))
                                                          : Degree{Degree::Unknown, 0});
            break;
        case Op::Loop: visitLoop(i); break;
        default:
            for (ValueId result : i.results)
                set(result, plain(i));
        }
    }

    void visitLoop(const Instruction &i) {
        const Region &body = i.regions[0];
        const bool steady =
            isSteady(i.operands[0]) &&
            (degree(body.arguments[0]).kind == Degree::Undefined || isSteady(body.arguments[0]));
        for (size_t k = 0; k < i.results.size(); ++k) {
            const Degree d = merged(degree(i.operands[k]),
                                    body.yields.empty() ? Degree{} : degree(body.yields[k]));
            const Degree carried = steady ? d : Degree{Degree::Unknown, 0};
            set(body.arguments[k], merged(degree(body.arguments[k]), carried));
            set(i.results[k], merged(degree(i.results[k]), carried));
        }
        visit(body);
    }

    bool sideIsZero(const Instruction &i) const {
        return degree(i.operands[0]).kind == Degree::Zero ||
               degree(i.operands[1]).kind == Degree::Zero;
    }

    Degree sum(const Instruction &i) const {
        return merged(degree(i.operands[0]), degree(i.operands[1]));
    }

    /// Of a product, `sign` 1, or a quotient, -1.
    Degree product(const Instruction &i, float sign) const {
        const Degree a = degree(i.operands[0]), b = degree(i.operands[1]);
        if (a.kind == Degree::Zero || (b.kind == Degree::Zero && sign > 0))
            return {Degree::Zero, 0};
        if (a.kind == Degree::Power && b.kind == Degree::Power)
            return power(a.power + sign * b.power);
        return {Degree::Unknown, 0};
    }

    /// Of anything else: steady if its operands are.
    Degree steady(const Instruction &i) const {
        for (ValueId operand : i.operands)
            if (!isSteady(operand))
                return {Degree::Unknown, 0};
        return power(0);
    }

    Degree plain(const Instruction &i) {
        switch (i.op) {
        case Op::ConstFloat:
            constants_[i.results[0]] = i.number;
            return i.number == 0 ? Degree{Degree::Zero, 0} : power(0);
        case Op::Input: // Ps moves when L is stretched.
            if (i.immediate >= int(ShaderInput::Ps) && i.immediate < int(ShaderInput::Ps) + 3)
                return {Degree::Unknown, 0};
            return power(0);
        case Op::Add:
        case Op::Sub:
        case Op::Min:
        case Op::Max: return sum(i);
        case Op::Neg:
        case Op::Abs: return degree(i.operands[0]);
        case Op::Mul: return product(i, 1);
        case Op::Div: return product(i, -1);
        case Op::Sqrt: {
            const Degree d = degree(i.operands[0]);
            return d.kind == Degree::Power ? power(d.power / 2) : d;
        }
        case Op::Equal:
            if (sideIsZero(i))
                zeroTests_.insert(i.results[0]);
            [[fallthrough]];
        case Op::Less:
        case Op::LessEqual:
        case Op::NotEqual: // Both sides grow alike.
            return sum(i).kind == Degree::Unknown ? Degree{Degree::Unknown, 0} : power(0);
        case Op::Select:
            if (zeroTests_.contains(i.operands[0])) // Guards a division; holds almost nowhere.
                return degree(i.operands[2]);
            return isSteady(i.operands[0]) ? merged(degree(i.operands[1]), degree(i.operands[2]))
                                           : Degree{Degree::Unknown, 0};
        case Op::Pow: return raised(i);
        case Op::ArrayLoad:
        case Op::Random:
        case Op::LightLoop:
        case Op::Answer: return {Degree::Unknown, 0};
        default: return steady(i);
        }
    }

    Degree raised(const Instruction &i) const {
        const Degree base = degree(i.operands[0]);
        const auto exponent = constants_.find(i.operands[1]);
        if (base.kind == Degree::Power && exponent != constants_.end())
            return power(base.power * exponent->second);
        return steady(i);
    }

    void collect(const Region &region, std::optional<Degree> &all) const {
        for (const Instruction &i : region.body) {
            if (i.op == Op::Output && function_.outputs[size_t(i.immediate)].name == "Cl")
                all = merged(all.value_or(Degree{}), degree(i.operands[0]));
            for (const Region &inner : i.regions)
                collect(inner, all);
        }
    }

    const Function &function_;
    const Triple L_;
    std::vector<Degree> degrees_;
    std::map<ValueId, float> constants_;
    std::set<ValueId> zeroTests_; ///< Bools that say whether something is 0.
    bool changed_ = false;
};

} // namespace

std::optional<float> powerOfDistance(const Function &function, const Triple &L) {
    return Degrees(function, L).ofCl();
}

} // namespace candela::ir
