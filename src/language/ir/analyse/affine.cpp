// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/affine.h"

#include "language/ir/core/dataflow.h"

#include <algorithm>
#include <map>
#include <optional>

namespace candela::ir {

namespace {

constexpr int noCarry = -1;

/// Of what a form is a function.
enum class Of {
    Light,   ///< What light loops and answers bring.
    Arrival, ///< A volume's Ci and Oi as they are at the segment's end.
};

/// A value as a function of the light: offset + (carried value of a light loop) + linear part.
struct Form {
    bool known = false;  ///< Reached by the sweep.
    bool broken = false; ///< Not affine, since `line`.
    int line = 0;
    bool offset = false;   ///< May have a part that no light changes.
    unsigned channels = 0; ///< Of Cl that it is linear in; of Ci, and then of Oi.
    int carry = noCarry;   ///< The ValueId of the light loop's argument that it adds to.

    bool lit() const { return broken || channels || carry != noCarry; }
    bool zero() const { return !offset && !lit(); }
    friend bool operator==(const Form &, const Form &) = default;
};

Form brokenAt(int line) { return {true, true, line, true, 0, noCarry}; }
Form unlit() { return {true, false, 0, true, 0, noCarry}; }
Form nothing() { return {true, false, 0, false, 0, noCarry}; }
Form lightOf(int channel) { return {true, false, 0, false, 1u << channel, noCarry}; }

/// Forms only rise: zero, unlit, linear, broken; what is broken stays so, with its first line.
struct AffineAnalysis : ForwardAnalysis<Form> {
    explicit AffineAnalysis(const Function &function, Of of) : ForwardAnalysis(function), of(of) {}

    const Of of;

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

    bool anyLit(std::span<const ValueId> values) const {
        return std::any_of(values.begin(), values.end(), [&](ValueId v) { return at(v).lit(); });
    }

    Form result(const Instruction &i, std::size_t k, const Enclosing *) const {
        if (at(i.results[k]).broken)
            return at(i.results[k]);
        if (of == Of::Arrival && i.op == Op::Input)
            if (const auto channel = arrivalChannel(function, i.immediate))
                return lightOf(*channel);
        if (of == Of::Light && isAnswer(i.op))
            return anyLit(i.operands) ? brokenAt(i.line) : lightOf(int(k));
        return formOf(i);
    }

    Form array(const Instruction &i, const Enclosing *) const {
        if (!hasEffect(i.op))
            return arrayOf(i);
        const Form stored = at(i, 0).lit() ? brokenAt(i.line) : at(i, 1);
        return either(arrayOf(i), scaled(stored, i.line), i.line);
    }

    Form formOf(const Instruction &i) const {
        if (i.op == Op::ConstFloat)
            return i.number == 0 ? nothing() : unlit();
        if (i.op == Op::ArrayLoad)
            return at(i, 0).lit() ? brokenAt(i.line) : arrayOf(i);
        switch (info(i.op).slope) {
        case SlopeRule::Sum: return sum(at(i, 0), at(i, 1), i.line);
        case SlopeRule::Difference: return sum(at(i, 0), scaled(at(i, 1), i.line), i.line);
        case SlopeRule::Negation: return scaled(at(i, 0), i.line);
        case SlopeRule::Product: return product(at(i, 0), at(i, 1), i.line);
        case SlopeRule::Quotient: return quotient(at(i, 0), at(i, 1), i.line);
        case SlopeRule::Choice:
            return i.operands[1] == i.operands[2] ? at(i, 1)
                                                  : choice(at(i, 0), at(i, 1), at(i, 2), i.line);
        default: break;
        }
        for (ValueId v : i.operands)
            if (at(v).lit())
                return at(v).broken ? at(v) : brokenAt(i.line);
        return unlit();
    }

    static Form quotient(const Form &a, const Form &b, int line) {
        if (!a.known || a.zero())
            return a;
        if (b.lit())
            return b.broken ? b : brokenAt(line);
        return a.lit() ? scaled(a, line) : unlit();
    }

    static Form choice(const Form &condition, const Form &a, const Form &b, int line) {
        if (condition.lit())
            return condition.broken ? condition : brokenAt(line);
        return either(a, b, line);
    }

    Form flow(const ValueFlow &flow, const Enclosing *) const {
        const Form &known = at(flow.to);
        const Instruction &i = flow.owner;
        if (known.broken)
            return known;
        const bool goesIn = flow.to != i.results[flow.index];
        if (i.op == Op::LightLoop && of == Of::Light)
            return goesIn ? Form{true, false, 0, false, 0, int(flow.to)} : gathered(flow);
        if (flow.from.size() == 1)
            return at(flow.from[0]);
        const Form &a = at(flow.from[0]), &b = at(flow.from[1]);
        if (i.op == Op::If)
            return flow.from[0] == flow.from[1] ? a : choice(at(i, 0), a, b, i.line);
        // A carried value that no turn changes does not depend on how many there are.
        if (flow.from[1] != flow.to && i.op == Op::Loop && at(*conditionOf(i)).lit())
            return brokenAt(i.line);
        return either(either(a, known, i.line), b, i.line);
    }

    /// What a light loop adds to what it starts from.
    Form gathered(const ValueFlow &flow) const {
        const Instruction &i = flow.owner;
        const auto carry = int(argumentOf(i, flow.index));
        Form added = at(flow.from[1]);
        if (anyLit({i.operands.begin() + 3, fixedOperands(i) - 3}))
            added = brokenAt(i.line);
        else if (!added.broken && (added.carry != carry || added.offset))
            added = brokenAt(lineOf(i.regions[0], flow.from[1], i.line));
        added.carry = noCarry;
        return added.broken ? added : sum(at(flow.from[0]), added, i.line);
    }

    Form given(const Instruction &, std::size_t k) const {
        const auto sample = sampleOfCl(function, k);
        return sample && of == Of::Light ? lightOf(*sample) : unlit();
    }

    static int lineOf(const Region &region, ValueId v, int otherwise) {
        for (const Instruction &i : region.body)
            if (std::find(i.results.begin(), i.results.end(), v) != i.results.end() && i.line)
                return i.line;
        return otherwise;
    }
};

} // namespace

std::optional<int> arrivalChannel(const Function &function, int input) {
    const int samples = function.colors.samples;
    const int Ci = input - int(ShaderInput::pixelCi), Oi = input - int(ShaderInput::pixelOi);
    if (Ci >= 0 && Ci < samples)
        return Ci;
    if (Oi >= 0 && Oi < samples)
        return samples + Oi;
    return std::nullopt;
}

namespace {

/// The values of the outputs: the last one to a slot counts.
std::map<int, ValueId> outputsOf(const Function &whole) {
    std::map<int, ValueId> outputs;
    forEachInstruction(whole.body, [&](const Instruction &i) {
        if (i.op == Op::Output)
            outputs[i.immediate] = i.operands[0];
    });
    return outputs;
}

} // namespace

AffineProof proveAffine(const Function &whole) {
    AffineAnalysis analysis(whole, Of::Light);
    solve(analysis);
    for (auto [slot, v] : outputsOf(whole)) {
        const OutputSlot &output = whole.outputs[slot];
        const Form &form = analysis.at(v);
        if (output.name == OutputKind::Ci &&
            (form.broken || (form.channels & ~(1u << output.component))))
            return {false, form.line};
    }
    return {};
}

ArrivalProof proveAffineInArrival(const Function &whole) {
    AffineAnalysis analysis(whole, Of::Arrival);
    solve(analysis);
    const int samples = whole.colors.samples;
    ArrivalProof proof;
    for (auto [slot, v] : outputsOf(whole)) {
        const OutputSlot &output = whole.outputs[slot];
        const Form &form = analysis.at(v);
        const unsigned byCi = 1u << output.component, byOi = byCi << samples;
        const bool isCi = output.name == OutputKind::Ci, isOi = output.name == OutputKind::Oi;
        const unsigned allowed = isCi ? byCi | byOi : byOi;
        if (proof.affine && (isCi || isOi) && (form.broken || (form.channels & ~allowed)))
            proof.affine = false, proof.line = form.line;
    }
    const unsigned ofCi = (1u << samples) - 1;
    const auto changes = [&](const Form &form) {
        return ArrivalProof::Changes{(form.channels & ofCi) != 0, (form.channels & ~ofCi) != 0};
    };
    for (const auto &cell : analysis.values)
        proof.ofValue.push_back(changes(cell.fact));
    for (const auto &cell : analysis.arrays)
        proof.ofArray.push_back(changes(cell.fact));
    return proof;
}

} // namespace candela::ir
