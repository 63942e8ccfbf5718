// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet_lattice.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"

namespace candela::ir {

using runtime::RuntimeFunction;

namespace {

/// How many of the results of a function with slopes are values.
int componentsOf(RuntimeFunction withSlopes) {
    return runtime::info(withSlopes).outputs / (1 + runtime::coordinatesOf(withSlopes));
}

Values valuesOf(const std::vector<Jet> &jets) {
    Values result;
    for (Jet jet : jets)
        result.push_back(valueOf(jet));
    return result;
}

/// How all results change with u or v, from calls on either side of the point; empty if the
/// coordinates stay.
Values differences(Jets &jets, RuntimeFunction function, const std::vector<Jet> &operands,
                   Order order) {
    Builder &b = jets.b;
    const int coordinates = runtime::coordinatesOf(function);
    MaybeValue size;
    for (int k = 0; k < coordinates; ++k)
        if (const MaybeValue dx = coefficient(operands[size_t(k)], order)) {
            const ValueId length = unary(b, Op::Abs, *dx);
            size = size ? max(b, *size, length) : length;
        }
    if (!size)
        return {};
    const ValueId step = div(b, number(b, 0x1p-8f), max(b, *size, number(b, 1e-20f)));
    Values before = valuesOf(operands), after = before;
    for (int k = 0; k < coordinates; ++k)
        if (const MaybeValue dx = coefficient(operands[size_t(k)], order)) {
            const ValueId offset = mul(b, *dx, step);
            before[size_t(k)] = sub(b, before[size_t(k)], offset);
            after[size_t(k)] = add(b, after[size_t(k)], offset);
        }
    const Values low = callRuntime(b, int(function), before);
    const Values high = callRuntime(b, int(function), after);
    const ValueId width = mul(b, number(b, 2), step);
    Values result;
    for (size_t k = 0; k < low.size(); ++k)
        result.push_back(div(b, sub(b, high[k], low[k]), width));
    return result;
}

} // namespace

RuntimeFunction latticeWithSlopes(RuntimeFunction function) {
    return runtime::withSlopes(function).value_or(function);
}

std::vector<Jet> ofLattice(Jets &jets, RuntimeFunction withSlopes, const std::vector<Jet> &operands,
                           const Values &results) {
    const size_t coordinates = size_t(runtime::coordinatesOf(withSlopes));
    const size_t components = size_t(componentsOf(withSlopes));
    std::vector<Jet> all;
    for (ValueId v : results)
        all.push_back(jets.standing(v));
    for (size_t k = components; k < all.size(); ++k)
        all[k]->rule = [&jets, withSlopes, operands, k](Order order) -> MaybeValue {
            const Values changes = differences(jets, withSlopes, operands, order);
            return changes.empty() ? std::nullopt : MaybeValue(changes[k]);
        };
    for (size_t c = 0; c < components; ++c) {
        Jet total = jets.series({});
        for (size_t k = 0; k < coordinates; ++k)
            total = sum(jets, total,
                        integral(jets, operands[k], all[components + c * coordinates + k]));
        all[c]->rule = total->rule;
    }
    return all;
}

int firstRefusedOrder(RuntimeFunction function, int result) {
    const bool isSlope = !runtime::withSlopes(function) && result >= componentsOf(function);
    return isSlope ? 2 : 3;
}

} // namespace candela::ir
