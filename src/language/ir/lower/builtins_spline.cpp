// SPDX-License-Identifier: Apache-2.0
// spline([basis,] x, knots): a cubic through or near values at even steps (RI 3.2 section 15.1).
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"
#include "language/semantics/spellings.h"

#include <algorithm>
#include <cmath>

namespace candela::ir {
namespace {

/// Weights of a segment's four knots are polynomials in its parameter: rows are the knots,
/// columns the coefficients of t^3, t^2, t and 1.
struct Basis {
    const char *name;
    int step; ///< Knots from one segment to the next.
    float weights[4][4];
};

constexpr float sixth = 1.0f / 6;

const Basis bases[] = {
    {"catmull-rom",
     1,
     {{-0.5f, 1, -0.5f, 0}, {1.5f, -2.5f, 0, 1}, {-1.5f, 2, 0.5f, 0}, {0.5f, -0.5f, 0, 0}}},
    {"bezier", 3, {{-1, 3, -3, 1}, {3, -6, 3, 0}, {-3, 3, 0, 0}, {1, 0, 0, 0}}},
    {"bspline",
     1,
     {{-sixth, 0.5f, -0.5f, sixth},
      {0.5f, -1, 0, 4 * sixth},
      {-0.5f, 0.5f, 0.5f, sixth},
      {sixth, 0, 0, 0}}},
    {"hermite", 2, {{2, -3, 0, 1}, {1, -2, 1, 0}, {-2, 3, 0, 0}, {1, -1, 0, 0}}},
    // The first and the last knot do not count, so that linear can stand for catmull-rom.
    {"linear", 1, {{0, 0, 0, 0}, {0, 0, -1, 1}, {0, 0, 1, 0}, {0, 0, 0, 0}}},
    {"power", 4, {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}}},
};

const Basis *findBasis(const std::string &name) {
    const std::string_view standard = sl::splineBasisSpelled(name);
    const auto found = std::find_if(std::begin(bases), std::end(bases),
                                    [&](const Basis &basis) { return standard == basis.name; });
    return found == std::end(bases) ? nullptr : found;
}

/// values[index], index a whole number from 0 to values.size() - 1.
ValueId pickOf(Builder &b, const Components &values, ValueId index) {
    ValueId result = values.back();
    for (int i = int(values.size()) - 2; i >= 0; --i)
        result = select(b, less(b, index, number(b, float(i) + 0.5f)), values[i], result);
    return result;
}

/// More knots than this wait in memory: choosing among so many values is more code than storing
/// them all.
constexpr int mostChosenKnots = 48;

/// Picks knot segment * step + k, for k from 0 to 3, of one component of the curve.
class Knots {
public:
    Knots(Builder &b, const Components &knots, int step) : b_(b), knots_(knots), step_(step) {
        if (int(knots.size()) <= mostChosenKnots)
            return;
        memory_ = addArray(b, Type::Float, int(knots.size()));
        for (int k = 0; k < int(knots.size()); ++k)
            arrayStore(b, memory_, integer(b, k), knots[size_t(k)]);
    }

    ValueId pick(ValueId segment, int k) const {
        if (memory_ >= 0) {
            const ValueId place =
                add(b_, mul(b_, segment, number(b_, float(step_))), number(b_, float(k)));
            return arrayLoad(b_, memory_, unary(b_, Op::IntegerFromFloat, place));
        }
        Components choices;
        for (size_t at = size_t(k); at + 3 - size_t(k) < knots_.size(); at += size_t(step_))
            choices.push_back(knots_[at]);
        return pickOf(b_, choices, segment);
    }

private:
    Builder &b_;
    const Components &knots_;
    int step_;
    int memory_ = -1;
};

ValueId polynomial(Builder &b, const float (&coefficients)[4], ValueId t) {
    ValueId sum = number(b, coefficients[0]);
    bool started = coefficients[0] != 0;
    for (int i = 1; i < 4; ++i) {
        if (started)
            sum = mul(b, sum, t);
        if (coefficients[i] != 0) {
            sum = started ? add(b, sum, number(b, coefficients[i])) : number(b, coefficients[i]);
            started = true;
        }
    }
    return sum;
}

/// One component of the curve; `knots` are that component of all knots.
ValueId curve(Builder &b, const Basis &basis, const Components &knots, ValueId segment, ValueId t) {
    const Knots choice(b, knots, basis.step);
    std::optional<ValueId> sum;
    for (int k = 0; k < 4; ++k) {
        const auto &weights = basis.weights[k];
        if (std::all_of(std::begin(weights), std::end(weights), [](float w) { return w == 0; }))
            continue;
        const ValueId term = mul(b, polynomial(b, weights, t), choice.pick(segment, k));
        sum = sum ? add(b, *sum, term) : term;
    }
    return *sum;
}

Components spline(BuiltinCall &call) {
    Builder &b = call.b;
    const int first = call.isText(0) ? 1 : 0;
    const std::string name = first ? call.text(0, "the basis of a spline") : "catmull-rom";
    const size_t width = size_t(componentCount(b, call.result()));
    const Components none(width, number(b, 0));
    const Basis *basis = findBasis(name);
    if (!basis) {
        call.lowering.messages.error(call.expr.operands[0]->where, "there is no spline basis \"" +
                                                                       name + "\"; expected " +
                                                                       sl::splineBasisNames);
        return none;
    }
    Components values;
    for (size_t i = size_t(first) + 1; i < call.count(); ++i)
        values.insert(values.end(), call.arguments[i].begin(), call.arguments[i].end());
    const int knots = int(values.size() / width);
    if (knots < 4 || (knots - 4) % basis->step != 0) {
        call.lowering.messages.error(call.expr.where, "a " + name + " spline takes 4 knots, or " +
                                                          std::to_string(basis->step) +
                                                          " more for each further segment; " +
                                                          std::to_string(knots) + " are given");
        return none;
    }
    const int segments = (knots - 4) / basis->step + 1;
    const ValueId x = min(b, max(b, call.number(size_t(first)), number(b, 0)), number(b, 1));
    const ValueId scaled = mul(b, x, number(b, float(segments)));
    const ValueId segment = min(b, unary(b, Op::Floor, scaled), number(b, float(segments - 1)));
    const ValueId t = sub(b, scaled, segment);
    Components result;
    for (size_t c = 0; c < width; ++c) {
        Components ofComponent;
        for (int k = 0; k < knots; ++k)
            ofComponent.push_back(values[size_t(k) * width + c]);
        result.push_back(curve(b, *basis, ofComponent, segment, t));
    }
    return result;
}

} // namespace

BuiltinLowering splineBuiltin(sl::BuiltinId id) {
    return id == sl::BuiltinId::spline ? spline : nullptr;
}

} // namespace candela::ir
