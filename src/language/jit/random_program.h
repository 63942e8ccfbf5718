// SPDX-License-Identifier: Apache-2.0
// For tests: random IR functions that use every operation, with nested control flow.
#pragma once

#include "language/ir/core/builder_control.h"
#include "language/jit/random_operations.h"

#include <string>

namespace candela {

/// Adds control flow, to make whole functions.
class RandomProgram : RandomOperations {
public:
    using RandomOperations::RandomOperations;

    void write(const std::string &name, BindingTime lanes) {
        ir::Function &function = b_.function();
        function.lanes = lanes;
        function.name = name;
        function.parameters.resize(5);
        function.variables.resize(3);
        function.categories = {"key", "-key"};
        function.surfaceSlots = 2, function.viewSlots = 2;
        for (int k = 0; k < 2; ++k) // For AnsweredRequest.
            addRequest(b_, {ir::LightRequest::Kind::Trace, ir::ConeForm::Everywhere, 0, -1, 0});
        statements(14, 3);
        for (int k = 0; k < 4; ++k)
            output(b_, "result", k, pick(pools_.floats));
        output(b_, "result", 4, unary(b_, Op::FloatFromBool, pick(pools_.bools)));
        b_.finish();
    }

private:
    /// Statements of a region; what they make is forgotten at its end.
    template <typename Yield> ir::Values scoped(int count, int depth, Yield &&yield) {
        const RandomPools before = pools_;
        statements(count, depth);
        const ir::Values result = yield();
        pools_ = before;
        return result;
    }

    void statements(int count, int depth) {
        for (int k = 0; k < count; ++k)
            statement(depth);
    }

    void statement(int depth) {
        const int kind = below(depth > 0 ? operationKinds + 6 : operationKinds);
        if (kind < operationKinds)
            return operation(kind);
        switch (kind - operationKinds) {
        case 0:
        case 1:
        case 2: return branch(depth);
        case 3:
        case 4: return loop(depth);
        default: return lightLoop(depth);
        }
    }

    void branch(int depth) {
        const ir::ValueId condition = below(3) ? pick(pools_.bools) : comparison(pools_.uniforms);
        const auto side = [&] {
            return scoped(1 + below(6), depth - 1, [&] {
                return ir::Values{pick(pools_.floats), pick(pools_.floats), pick(pools_.bools),
                                  pick(pools_.integers), pick(pools_.strings)};
            });
        };
        const ir::Values made = ifElse(b_, condition, side, side);
        pools_.keep({made[0], made[1]});
        pools_.bools.push_back(made[2]);
        pools_.integers.push_back(made[3]);
        pools_.strings.push_back(made[4]);
    }
    void loop(int depth) {
        const ir::ValueId asked = unary(
            b_, Op::Abs, mul(b_, pick(below(2) ? pools_.floats : pools_.uniforms), number(b_, 4)));
        const ir::ValueId limit = min(b_, asked, number(b_, 5));
        const ir::ValueId zero = number(b_, 0);
        const ir::Values initial{less(b_, zero, limit), zero, pick(pools_.floats),
                                 pick(pools_.bools), pick(pools_.uniforms)};
        const ir::Values made = ir::loop(b_, initial, [&](const ir::Values &carried) {
            pools_.floats.push_back(carried[2]);
            pools_.floats.push_back(carried[4]);
            pools_.bools.push_back(carried[3]);
            return scoped(1 + below(5), depth - 1, [&] {
                const ir::ValueId count = add(b_, carried[1], number(b_, 1));
                return ir::Values{less(b_, count, limit), count, pick(pools_.floats),
                                  pick(pools_.bools), add(b_, carried[4], number(b_, 1))};
            });
        });
        // The body's carried values are not visible out here.
        pools_.floats.resize(pools_.floats.size() - 2);
        pools_.bools.pop_back();
        pools_.keep({made[1], made[2], made[4]});
        pools_.bools.push_back(made[3]);
    }
    void lightLoop(int depth) {
        ir::LightRequest request;
        request.form = ir::ConeForm(below(3));
        request.coneCount = request.form == ir::ConeForm::Everywhere ? 0 : 1;
        request.category = below(3) - 1;
        ir::Values cones;
        if (request.form == ir::ConeForm::Extended)
            request.coneCount += below(2);
        for (int k = 0; k < request.coneCount; ++k) {
            for (ir::ValueId axis : triple())
                cones.push_back(axis);
            cones.push_back(below(2) ? pick(pools_.floats) : number(b_, 1.2f));
            if (request.form == ir::ConeForm::Extended)
                for (int parameter = 0; parameter < 2; ++parameter)
                    cones.push_back(pick(pools_.floats));
        }
        const ir::Values initial{pick(pools_.floats), pick(pools_.bools)};
        const ir::Values made = ir::lightLoop(
            b_, addRequest(b_, request), triple(), cones, initial,
            [&](const ir::LoopLight &light, const ir::Values &carried) {
                const RandomPools before = pools_;
                pools_.keep({light.L[0], light.L[1], light.L[2], light.number, carried[0]});
                pools_.keep(light.Cl);
                pools_.bools.push_back(carried[1]);
                const ir::Values yields = scoped(1 + below(5), depth - 1, [&] {
                    return ir::Values{add(b_, carried[0], pick(pools_.floats)), pick(pools_.bools)};
                });
                pools_ = before;
                return yields;
            });
        pools_.floats.push_back(made[0]);
        pools_.bools.push_back(made[1]);
    }
};

/// Unless it is for one instruction-set level alone, all of them give the same bits: there are no
/// transcendentals then, and no gradient noise.
inline ir::Function randomProgram(unsigned seed, bool oneLevel, int colorSamples = 3) {
    ir::Function function;
    function.colors = evenBasis(colorSamples);
    ir::Builder b(function);
    RandomProgram(b, seed, oneLevel).write("random" + std::to_string(seed), BindingTime(seed % 3));
    return function;
}

} // namespace candela
