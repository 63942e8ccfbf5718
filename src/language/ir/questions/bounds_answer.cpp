// SPDX-License-Identifier: Apache-2.0
// Question::Furnace and Question::Bounds: a surface in a uniform field, and over boxes of surface.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/questions/answers.h"
#include "language/ir/transform/bounds.h"
#include "language/ir/transform/dead_code.h"

#include <algorithm>
#include <limits>

namespace candela::ir {

namespace {

constexpr float endless = std::numeric_limits<float>::infinity();
constexpr int dark = 0, lit = 1; // The assumptions.

/// The paper's section 5.3.1: what a shader says itself of its Ci.
struct GivenBounds {
    bool alongU = false, alongV = false, ofView = false; ///< It sets TCiDu, TCiDv, TCiDw.
    bool any() const { return alongU || alongV || ofView; }
};

GivenBounds givenBounds(const Function &text) {
    const auto sets = [&](const char *name) {
        return slotOf(text.outputs, OutputName::ofParameter(name)) >= 0;
    };
    return {sets("TCiDu"), sets("TCiDv"), sets("TCiDw")};
}

/// Writes what the shader says of channel `c`: of its emission as it is in the dark; of its
/// reflectance, which is a difference, both.
class GivenWriter {
public:
    GivenWriter(SpecializedText &text, Builder &b, const GivenBounds &given)
        : text_(text), b_(b), given_(given) {}

    void write(int c) {
        const auto slope = [&](const char *name) {
            return std::pair(value(lit, name, c), value(dark, name, c));
        };
        const auto u = slope("DCiDu"), v = slope("DCiDv");
        put(OutputKind::CeByU, c, u.second);
        put(OutputKind::CeByV, c, v.second);
        put(OutputKind::ReflectanceByU, c, sub(b_, u.first, u.second));
        put(OutputKind::ReflectanceByV, c, sub(b_, v.first, v.second));
        const ValueId ofEmission = tolerance(dark, c);
        put(OutputKind::CeTolerance, c, ofEmission);
        put(OutputKind::ReflectanceTolerance, c, add(b_, tolerance(lit, c), ofEmission));
    }

private:
    void put(OutputKind kind, int c, ValueId v) { output(b_, kind, c, v); }
    ValueId value(int assumption, const char *name, int c) {
        return text_.output(assumption, OutputName::ofParameter(name), c)
            .value_or(number(b_, 0));
    }
    /// What is not said is not known; without extent there is nothing to say.
    ValueId part(int assumption, const char *name, int c, bool isGiven, ValueId extent) {
        const ValueId zero = number(b_, 0);
        const ValueId said = isGiven ? value(assumption, name, c) : number(b_, endless);
        // RI_INFINITY is infinite.
        const ValueId known = select(b_, less(b_, said, number(b_, 1e37f)), max(b_, said, zero),
                                     number(b_, endless));
        return select(b_, equal(b_, extent, zero), zero, known);
    }
    ValueId tolerance(int assumption, int c) {
        const ValueId Dw = input(b_, ShaderInput::Dw);
        const ValueId u = part(assumption, "TCiDu", c, given_.alongU, input(b_, ShaderInput::Du));
        const ValueId v = part(assumption, "TCiDv", c, given_.alongV, input(b_, ShaderInput::Dv));
        const ValueId turned = unary(b_, Op::Abs, value(assumption, "DCiDw", c));
        const ValueId w = add(b_, part(assumption, "TCiDw", c, given_.ofView, Dw),
                              mul(b_, turned, Dw));
        return add(b_, add(b_, u, v), w);
    }

    SpecializedText &text_;
    Builder &b_;
    GivenBounds given_;
};

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
    GivenWriter bounds(text, b, given);
    for (int c = 0; c < plan.text.colors.samples; ++c) {
        const ValueId zero = number(b, 0);
        const ValueId Ce = text.output(dark, OutputKind::Ci, c).value_or(zero);
        const ValueId Ci = text.output(lit, OutputKind::Ci, c).value_or(zero);
        output(b, OutputKind::Reflectance, c, sub(b, Ci, Ce));
        output(b, OutputKind::Ce, c, Ce);
        output(b, OutputKind::Oi, c, text.output(dark, OutputKind::Oi, c).value_or(zero));
        if (given.any())
            bounds.write(c);
    }
    b.finish();
    removeDeadCode(result);
    return result;
}

} // namespace

Function answerFurnace(const Plan &plan) { return furnace(plan, {}); }

static Function boundsOf(const Plan &plan, BoundReport &report) {
    const GivenBounds given = givenBounds(plan.text);
    const Function text = furnace(plan, given);
    std::vector<BoundOutputs> wanted{
        {OutputKind::Oi, OutputKind::OiByU, OutputKind::OiByV, OutputKind::OiTolerance}};
    const BoundOutputs ofCe{OutputKind::Ce, OutputKind::CeByU, OutputKind::CeByV,
                            OutputKind::CeTolerance};
    const BoundOutputs ofReflectance{OutputKind::Reflectance, OutputKind::ReflectanceByU,
                                     OutputKind::ReflectanceByV,
                                     OutputKind::ReflectanceTolerance};
    if (!given.any())
        wanted.insert(wanted.end(), {ofReflectance, ofCe});
    return withBounds(text, wanted, report);
}

Function answerBounds(const Plan &plan) {
    BoundReport report;
    return boundsOf(plan, report);
}

BoundFacts boundFacts(const Plan &plan) {
    BoundReport report;
    BoundFacts facts;
    boundsOf(plan, report);
    facts.givenByShader = givenBounds(plan.text).any();
    if (report.isTooLarge)
        facts.boundless = {{0, "more code than bounds may have"}};
    else
        for (const BoundlessNote &note : report.boundless)
            facts.boundless.push_back({note.line, note.what});
    return facts;
}

BoundFacts boundFacts(const Function &whole) { return boundFacts(*makePlan(whole)); }

} // namespace candela::ir
