// SPDX-License-Identifier: Apache-2.0
// spline([basis,] x, knots): a cubic through or near values at even steps (RI 3.2 section 15.1);
// spline("solve" basis, value, knots): where it has that value.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/lower/builtins.h"
#include "language/semantics/spellings.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

/// A spline with its knots, by component.
struct Spline {
    const Basis *basis = nullptr;
    std::vector<Components> knots;
    int segments = 1;

    /// At x in [0, 1].
    Components at(Builder &b, ValueId x) const {
        const ValueId scaled = mul(b, x, number(b, float(segments)));
        const ValueId segment = min(b, unary(b, Op::Floor, scaled), number(b, float(segments - 1)));
        const ValueId t = sub(b, scaled, segment);
        Components result;
        for (const Components &ofComponent : knots)
            result.push_back(curve(b, *basis, ofComponent, segment, t));
        return result;
    }
};

/// Where the curve, which rises or falls all the way, has the value; by halving, to the last bit
/// that x has near 1.
ValueId solve(Builder &b, const Spline &spline, ValueId value) {
    constexpr float halvings = 26;
    const ValueId zero = number(b, 0), one = number(b, 1), half = number(b, 0.5f);
    const ValueId rises = lessEqual(b, spline.at(b, zero)[0], spline.at(b, one)[0]);
    const Values found = loop(b, {boolean(b, true), zero, one, zero}, [&](const Values &carried) {
        const ValueId low = carried[1], high = carried[2];
        const ValueId middle = mul(b, half, add(b, low, high));
        const ValueId there = spline.at(b, middle)[0];
        const ValueId before = select(b, rises, less(b, there, value), less(b, value, there));
        const ValueId turns = add(b, carried[3], one);
        return Values{less(b, turns, number(b, halvings)), select(b, before, middle, low),
                      select(b, before, high, middle), turns};
    });
    const ValueId x = mul(b, half, add(b, found[1], found[2]));
    const ValueId end = number(b, 0x1p-25f);
    return select(b, less(b, x, end), zero, select(b, less(b, sub(b, one, end), x), one, x));
}

/// The knots behind operand `first`; nothing, with a report, if there are too few or too many.
std::optional<Spline> splineOf(BuiltinCall &call, const std::string &name, size_t first) {
    const size_t width = size_t(componentCount(call.b, call.result()));
    Spline result;
    result.basis = findBasis(name);
    if (!result.basis) {
        call.lowering.messages.error(call.expr.operands[0]->where, "there is no spline basis \"" +
                                                                       name + "\"; expected " +
                                                                       sl::splineBasisNames);
        return std::nullopt;
    }
    Components values;
    for (size_t i = first; i < call.count(); ++i)
        values.insert(values.end(), call.arguments[i].begin(), call.arguments[i].end());
    const int knots = int(values.size() / width), step = result.basis->step;
    if (knots < 4 || (knots - 4) % step != 0) {
        call.lowering.messages.error(call.expr.where, "a " + name + " spline takes 4 knots, or " +
                                                          std::to_string(step) +
                                                          " more for each further segment; " +
                                                          std::to_string(knots) + " are given");
        return std::nullopt;
    }
    result.segments = (knots - 4) / step + 1;
    result.knots.resize(width);
    for (size_t k = 0; k < values.size(); ++k)
        result.knots[k % width].push_back(values[k]);
    return result;
}

Components spline(BuiltinCall &call) {
    Builder &b = call.b;
    const size_t first = call.isText(0) ? 1 : 0;
    std::string name = first ? call.text(0, "the basis of a spline") : "catmull-rom";
    const bool solves = name.starts_with(sl::inverseSpline);
    if (solves)
        name = name.substr(sl::inverseSpline.size());
    const auto spline = splineOf(call, name, first + 1);
    if (!spline)
        return zero(b, call.result());
    if (!solves)
        return spline->at(b, min(b, max(b, call.number(first), number(b, 0)), number(b, 1)));
    if (call.result() == sl::BaseType::Float)
        return {solve(b, *spline, call.number(first))};
    call.lowering.messages.error(call.expr.where, "an inverse spline (solve...) goes from a float "
                                                  "to a float");
    return zero(b, call.result());
}

} // namespace

BuiltinLowering splineBuiltin(sl::BuiltinId id) {
    return id == sl::BuiltinId::spline ? spline : nullptr;
}

} // namespace candela::ir
