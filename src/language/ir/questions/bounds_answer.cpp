// SPDX-License-Identifier: Apache-2.0
// Question::Furnace, Bounds and LightBounds: a surface in a uniform field, and surfaces and lights
// over boxes of surface.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/questions/answers.h"
#include "language/ir/transform/bounds.h"
#include "language/ir/transform/dead_code.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <limits>
#include <map>
#include <string>
#include <utility>

namespace candela::ir {

namespace {

constexpr float endless = std::numeric_limits<float>::infinity();
constexpr int dark = 0, lit = 1; // The assumptions.

/// The paper's section 5.3.1: what a shader says itself of its Ci, or a light of its Cl.
struct GivenBounds {
    bool alongU = false, alongV = false, ofView = false; ///< It sets TCiDu, TCiDv, TCiDw.
    bool any() const { return alongU || alongV || ofView; }
};

std::string boundName(char letter, const std::string &of, char along) {
    return std::string(1, letter) + of + "D" + along;
}

GivenBounds givenBounds(const Function &text, const std::string &of) {
    const auto sets = [&](char along) {
        return slotOf(text.outputs, OutputName::ofParameter(boundName('T', of, along))) >= 0;
    };
    return {sets('u'), sets('v'), sets('w')};
}

/// Reads what a shader says of a channel. `output`: its outputs; 0 of those that it has not.
class GivenReader {
public:
    using Output = std::function<ValueId(const std::string &name)>;
    GivenReader(Builder &b, std::string of, const GivenBounds &given, Output output)
        : b_(b), of_(std::move(of)), given_(given), output_(std::move(output)) {}

    ValueId slope(char along) { return output_(boundName('D', of_, along)); }
    ValueId tolerance() {
        const ValueId Dw = input(b_, ShaderInput::Dw);
        const ValueId turned = mul(b_, unary(b_, Op::Abs, slope('w')), Dw);
        const ValueId u = part('u', given_.alongU, input(b_, ShaderInput::Du));
        const ValueId v = part('v', given_.alongV, input(b_, ShaderInput::Dv));
        return add(b_, add(b_, u, v), add(b_, part('w', given_.ofView, Dw), turned));
    }

private:
    /// What is not said is not known; without extent there is nothing to say.
    ValueId part(char along, bool isGiven, ValueId extent) {
        const ValueId zero = number(b_, 0), all = number(b_, endless);
        const ValueId said = isGiven ? output_(boundName('T', of_, along)) : all;
        // RI_INFINITY is infinite, and so is what is no number.
        const ValueId known =
            select(b_, less(b_, said, number(b_, 1e37f)), max(b_, said, zero), all);
        return select(b_, equal(b_, extent, zero), zero, known);
    }

    Builder &b_;
    std::string of_;
    GivenBounds given_;
    Output output_;
};

/// Of channel `c`: of the emission what the shader says in the dark; of the reflectance, which is a
/// difference, both.
void writeGiven(SpecializedText &text, Builder &b, const GivenBounds &given, int c) {
    const auto under = [&](int assumption) {
        return GivenReader(b, "Ci", given, [&, assumption](const std::string &name) {
            return text.output(assumption, OutputName::ofParameter(name), c).value_or(number(b, 0));
        });
    };
    GivenReader inField = under(lit), without = under(dark);
    output(b, OutputKind::CeByU, c, without.slope('u'));
    output(b, OutputKind::CeByV, c, without.slope('v'));
    output(b, OutputKind::ReflectanceByU, c, sub(b, inField.slope('u'), without.slope('u')));
    output(b, OutputKind::ReflectanceByV, c, sub(b, inField.slope('v'), without.slope('v')));
    const ValueId ofEmission = without.tolerance();
    output(b, OutputKind::CeTolerance, c, ofEmission);
    output(b, OutputKind::ReflectanceTolerance, c, add(b, inField.tolerance(), ofEmission));
}

/// Ci in a uniform field without what it is in the dark, that, and Oi; and the bounds that the
/// shader gives.
Function furnace(const Plan &plan, const GivenBounds &given) {
    Function result = emptyLike(plan.text);
    Builder b(result);
    SpecializationOptions options;
    options.coneTests = &plan.coneTests;
    options.lobes = &plan.cones;
    SpecializedText text =
        specialize(plan.text, plan.dependence, b, {{}, {Assumption::Light::Field}}, options);
    for (int c = 0; c < plan.text.colors.samples; ++c) {
        const ValueId zero = number(b, 0);
        const ValueId Ce = text.output(dark, OutputKind::Ci, c).value_or(zero);
        const ValueId Ci = text.output(lit, OutputKind::Ci, c).value_or(zero);
        output(b, OutputKind::Reflectance, c, sub(b, Ci, Ce));
        output(b, OutputKind::Ce, c, Ce);
        output(b, OutputKind::Oi, c, text.output(dark, OutputKind::Oi, c).value_or(zero));
        if (given.any())
            writeGiven(text, b, given, c);
    }
    b.finish();
    removeDeadCode(result);
    return result;
}

} // namespace

Function answerFurnace(const Plan &plan) { return furnace(plan, {}); }

static Function boundsOf(const Plan &plan, BoundReport &report) {
    const GivenBounds given = givenBounds(plan.text, "Ci");
    const Function text = furnace(plan, given);
    std::vector<BoundOutputs> wanted{
        {OutputKind::Oi, OutputKind::OiByU, OutputKind::OiByV, OutputKind::OiTolerance}};
    const BoundOutputs ofCe{OutputKind::Ce, OutputKind::CeByU, OutputKind::CeByV,
                            OutputKind::CeTolerance};
    const BoundOutputs ofReflectance{OutputKind::Reflectance, OutputKind::ReflectanceByU,
                                     OutputKind::ReflectanceByV, OutputKind::ReflectanceTolerance};
    if (!given.any())
        wanted.insert(wanted.end(), {ofReflectance, ofCe});
    return withBounds(text, wanted, report);
}

Function answerBounds(const Plan &plan) {
    BoundReport report;
    return boundsOf(plan, report);
}

namespace {

constexpr BoundOutputs boundsOfCl{OutputKind::Cl, OutputKind::ClByU, OutputKind::ClByV,
                                  OutputKind::ClTolerance};

/// Cl alone, without a word; with the bounds that the light gives, if it does.
Function emission(const Function &whole, const GivenBounds &given) {
    Function text = answerLight(silenced(whole));
    if (given.any()) {
        // Outputs stand at the top level, the last one to a slot counts.
        std::map<std::pair<OutputName, int>, ValueId> last;
        for (const Instruction &i : text.body.body)
            if (i.op == Op::Output) {
                const OutputSlot &slot = text.outputs[std::size_t(i.immediate)];
                last[{slot.name, slot.component}] = i.operands[0];
            }
        Region body = std::move(text.body);
        text.body = {};
        Builder b(text);
        for (int c = 0; c < text.colors.samples; ++c) {
            GivenReader reader(b, "Cl", given, [&](const std::string &name) {
                const auto found = last.find({OutputName::ofParameter(name), c});
                return found == last.end() ? number(b, 0) : found->second;
            });
            output(b, OutputKind::ClByU, c, reader.slope('u'));
            output(b, OutputKind::ClByV, c, reader.slope('v'));
            output(b, OutputKind::ClTolerance, c, reader.tolerance());
        }
        Region said = std::move(text.body);
        text.body = std::move(body);
        std::ranges::move(said.body, std::back_inserter(text.body.body));
        b.finish();
    }
    keepOutputs(text, [](const OutputName &name) {
        return name.kind != OutputKind::Parameter && name.kind != OutputKind::L;
    });
    removeDeadCode(text);
    return text;
}

Function lightBoundsOf(const Function &whole, BoundReport &report) {
    const GivenBounds given = givenBounds(whole, "Cl");
    const Function text = emission(whole, given);
    return given.any() ? text : withBounds(text, {boundsOfCl}, report);
}

BoundFacts factsOf(const BoundReport &report, bool isGiven) {
    BoundFacts facts;
    facts.givenByShader = isGiven;
    if (report.isTooLarge)
        facts.boundless = {{0, "more code than bounds may have"}};
    else
        for (const BoundlessNote &note : report.boundless)
            facts.boundless.push_back({note.line, note.what});
    return facts;
}

} // namespace

Function answerLightBounds(const Function &whole) {
    BoundReport report;
    return lightBoundsOf(whole, report);
}

BoundFacts lightBoundFacts(const Function &whole) {
    BoundReport report;
    lightBoundsOf(whole, report);
    return factsOf(report, givenBounds(whole, "Cl").any());
}

BoundFacts boundFacts(const Plan &plan) {
    BoundReport report;
    boundsOf(plan, report);
    return factsOf(report, givenBounds(plan.text, "Ci").any());
}

BoundFacts boundFacts(const Function &whole) { return boundFacts(*makePlan(whole)); }

} // namespace candela::ir
