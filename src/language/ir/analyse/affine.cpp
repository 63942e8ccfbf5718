// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/affine.h"

#include "foundation/units/color.h"
#include "language/ir/core/op_info.h"

#include <algorithm>
#include <map>

namespace candela::ir {

namespace {

constexpr int noCarry = -1;

/// A value as a function of the light: offset + (carried value of a light loop) + linear part.
struct Form {
    bool known = false;  ///< Reached by the sweep.
    bool broken = false; ///< Not affine, since `line`.
    int line = 0;
    bool offset = false;   ///< May have a part that no light changes.
    unsigned channels = 0; ///< Of Cl that it is linear in.
    int carry = noCarry;   ///< The ValueId of the light loop's argument that it adds to.

    bool lit() const { return broken || channels || carry != noCarry; }
    bool zero() const { return !offset && !lit(); }
    friend bool operator==(const Form &, const Form &) = default;
};

Form brokenAt(int line) { return {true, true, line, true, 0, noCarry}; }
Form unlit() { return {true, false, 0, true, 0, noCarry}; }
Form nothing() { return {true, false, 0, false, 0, noCarry}; }
Form lightOf(int channel) { return {true, false, 0, false, 1u << channel, noCarry}; }

/// Forms only rise (zero, unlit, linear, broken), so sweeping until nothing rises ends.
class AffineSweep {
public:
    explicit AffineSweep(const Function &function)
        : forms_(function.values.size()), arrays_(function.arrays.size()) {
        do {
            changed_ = false;
            sweep(function.body);
        } while (changed_);
        for (auto [slot, v] : outputs_)
            check(function.outputs[slot], forms_[v]);
    }
    AffineProof proof_;

private:
    void check(const OutputSlot &slot, const Form &form) {
        if (slot.name != "Ci" || !proof_.affine)
            return;
        if (form.broken || (form.channels & ~(1u << slot.component)))
            proof_ = {false, form.line};
    }

    const Form &form(const Instruction &i, int operand) const {
        return forms_[i.operands[operand]];
    }

    void set(Form &known, const Form &to) {
        if (!known.broken && !(known == to)) {
            known = to;
            changed_ = true;
        }
    }
    void set(ValueId v, const Form &to) { set(forms_[v], to); }

    /// What is one or the other, by a choice that light does not make.
    static Form either(const Form &a, const Form &b, int line) {
        if (!a.known || !b.known)
            return a.known ? a : b;
        if (a.broken || b.broken)
            return a.broken ? a : b;
        if (a.carry != b.carry)
            return brokenAt(line);
        return mix(a, b, line);
    }
    static Form mix(const Form &a, const Form &b, int line) {
        Form result = a;
        result.offset |= b.offset;
        result.channels |= b.channels;
        bool mixed = result.channels != a.channels && result.channels != b.channels;
        result.line = mixed ? line : std::max(a.line, b.line);
        return result;
    }

    static Form sum(const Form &a, const Form &b, int line) {
        if (!a.known || !b.known)
            return {};
        if (a.broken || b.broken)
            return a.broken ? a : b;
        if (a.carry != noCarry && b.carry != noCarry)
            return brokenAt(line);
        Form result = mix(a, b, line);
        result.carry = std::max(a.carry, b.carry);
        return result;
    }

    /// Scaled by something that light does not change: no carried value may be.
    static Form scaled(const Form &a, int line) {
        return !a.known || a.carry == noCarry ? a : brokenAt(a.broken ? a.line : line);
    }

    static Form product(const Form &a, const Form &b, int line) {
        if (!a.known || !b.known)
            return {};
        if (a.zero() || b.zero())
            return nothing();
        if (a.lit() && b.lit())
            return a.broken ? a : b.broken ? b : brokenAt(line);
        return a.lit() ? scaled(a, line) : b.lit() ? scaled(b, line) : unlit();
    }

    void sweep(const Region &region) {
        for (const Instruction &i : region.body)
            sweep(i);
    }

    void sweep(const Instruction &i) {
        switch (i.op) {
        case Op::If: return sweepIf(i);
        case Op::Loop: return sweepLoop(i);
        case Op::LightLoop: return sweepLightLoop(i);
        case Op::Output: outputs_[i.immediate] = i.operands[0]; return;
        case Op::ArrayStore: {
            Form stored = form(i, 0).lit() ? brokenAt(i.line) : form(i, 1);
            Form &array = arrays_[i.immediate];
            return set(array, either(array, scaled(stored, i.line), i.line));
        }
        case Op::Answer:
        case Op::Ambient:
        case Op::Irradiance:
            for (std::size_t k = 0; k < i.results.size(); ++k)
                set(i.results[k], anyLit(i.operands) ? brokenAt(i.line) : lightOf(int(k)));
            return;
        default:
            for (ValueId v : i.results)
                set(v, formOf(i));
        }
    }

    bool anyLit(const std::vector<ValueId> &values) const {
        return std::any_of(values.begin(), values.end(),
                           [&](ValueId v) { return forms_[v].lit(); });
    }

    Form formOf(const Instruction &i) const {
        switch (i.op) {
        case Op::ConstFloat: return i.number == 0 ? nothing() : unlit();
        case Op::Add: return sum(form(i, 0), form(i, 1), i.line);
        case Op::Sub: {
            Form right = scaled(form(i, 1), i.line);
            return sum(form(i, 0), right, i.line);
        }
        case Op::Neg: return scaled(form(i, 0), i.line);
        case Op::Mul: return product(form(i, 0), form(i, 1), i.line);
        case Op::Div:
            if (!form(i, 0).known || form(i, 0).zero())
                return form(i, 0);
            if (form(i, 1).lit())
                return form(i, 1).broken ? form(i, 1) : brokenAt(i.line);
            return form(i, 0).lit() ? scaled(form(i, 0), i.line) : unlit();
        case Op::Select:
            if (form(i, 0).lit() && i.operands[1] != i.operands[2])
                return form(i, 0).broken ? form(i, 0) : brokenAt(i.line);
            return either(form(i, 1), form(i, 2), i.line);
        case Op::ArrayLoad: return form(i, 0).lit() ? brokenAt(i.line) : arrays_[i.immediate];
        default: break;
        }
        for (ValueId v : i.operands)
            if (forms_[v].lit())
                return forms_[v].broken ? forms_[v] : brokenAt(i.line);
        return unlit();
    }

    void sweepIf(const Instruction &i) {
        for (const Region &region : i.regions)
            sweep(region);
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            ValueId a = i.regions[0].yields[k], b = i.regions[1].yields[k];
            if (form(i, 0).lit() && a != b)
                set(i.results[k], form(i, 0).broken ? form(i, 0) : brokenAt(i.line));
            else
                set(i.results[k], either(forms_[a], forms_[b], i.line));
        }
    }

    void sweepLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            ValueId argument = region.arguments[k];
            Form joined = either(forms_[i.operands[k]], forms_[argument], i.line);
            joined = either(joined, forms_[region.yields[k]], i.line);
            if (forms_[region.arguments[0]].lit() && region.yields[k] != argument)
                joined = brokenAt(i.line);
            set(argument, joined);
            set(i.results[k], joined);
        }
        sweep(region);
    }

    void sweepLightLoop(const Instruction &i) {
        const Region &region = i.regions[0];
        std::size_t fixed = i.operands.size() - i.results.size();
        for (int k = 0; k < 3; ++k)
            set(region.arguments[k], unlit());
        for (int k = 0; k < colorSamples; ++k)
            set(region.arguments[3 + k], lightOf(k));
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            ValueId argument = region.arguments[3 + colorSamples + k];
            set(argument, Form{true, false, 0, false, 0, int(argument)});
        }
        sweep(region);
        bool conesLit = anyLit({i.operands.begin() + 3, i.operands.begin() + fixed});
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            ValueId argument = region.arguments[3 + colorSamples + k];
            Form added = forms_[region.yields[k]];
            const Form &initial = forms_[i.operands[fixed + k]];
            if (conesLit)
                added = brokenAt(i.line);
            else if (!added.broken && (added.carry != int(argument) || added.offset))
                added = brokenAt(lineOf(region, region.yields[k], i.line));
            added.carry = noCarry;
            set(i.results[k], added.broken ? added : sum(initial, added, i.line));
        }
    }

    static int lineOf(const Region &region, ValueId v, int otherwise) {
        for (const Instruction &i : region.body)
            if (std::find(i.results.begin(), i.results.end(), v) != i.results.end() && i.line)
                return i.line;
        return otherwise;
    }

    std::vector<Form> forms_, arrays_;
    std::map<int, ValueId> outputs_;
    bool changed_ = false;
};

} // namespace

AffineProof proveAffine(const Function &whole) { return AffineSweep(whole).proof_; }

} // namespace candela::ir
