// SPDX-License-Identifier: Apache-2.0
// For tests: random IR operations of every kind.
#pragma once

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/test_services.h"
#include "language/runtime/runtime_functions.h"

#include <algorithm>
#include <random>
#include <vector>

namespace candela {

/// The source of all choices of a program.
class RandomChoices {
public:
    explicit RandomChoices(unsigned seed) : bits_(seed) {}

    int below(int n) { return int(bits_() % unsigned(n)); }
    /// Mostly what was made last, so that programs are deep.
    ir::ValueId pick(const ir::Values &pool) {
        const int size = int(pool.size());
        return below(2) ? pool[size - 1 - below(std::min(size, 6))] : pool[below(size)];
    }
    float constant() {
        static const float special[] = {0, -0.0f, 1, -1, 0.5f, 3, 1e-20f, 1e20f, -7.25f};
        return below(3) ? special[below(9)] : float(below(2000) - 1000) / 128;
    }

private:
    std::mt19937 bits_;
};

/// The values that are visible, by type; uniforms are floats too.
struct RandomPools {
    ir::Values floats, uniforms, bools, integers, strings;

    void keep(const ir::Values &made) { floats.insert(floats.end(), made.begin(), made.end()); }
};

/// Adds single operations, those without regions.
class RandomOperations : protected RandomChoices {
public:
    RandomOperations(ir::Builder &b, unsigned seed, bool oneLevel)
        : RandomChoices(seed), b_(b), oneLevel_(oneLevel) {
        for (int k = 0; k < 3; ++k)
            pools_.floats.push_back(number(b_, constant()));
        for (ir::ValueId v : input3(b_, ShaderInput::P))
            pools_.floats.push_back(v);
        const ir::Matrix world = currentFromSpace(b_, "world"),
                         back = spaceFromCurrent(b_, "world");
        pools_.keep({world[0], world[5], back[3]});
        pools_.uniforms = pools_.floats;
        pools_.uniforms.resize(3);
        pools_.uniforms.insert(pools_.uniforms.end(), {world[0], world[5], back[3], world[7]});
        pools_.bools = {boolean(b_, true), less(b_, pools_.floats[3], pools_.floats[4]),
                        less(b_, world[0], world[5])};
        pools_.integers = {
            integer(b_, 1), unary(b_, Op::IntegerFromFloat, world[2]),
            unary(b_, Op::IntegerFromFloat, mul(b_, pools_.floats[3], number(b_, 5)))};
        pools_.strings = {text(b_, "one"), text(b_, "two"), text(b_, "%f and %c;")};
        pools_.strings.push_back(select(b_, pools_.bools[1], pools_.strings[0], pools_.strings[1]));
        pools_.strings.push_back(unary(b_, Op::StringFromFloat, pools_.floats[3]));
        arrays_ = {addArray(b_, ir::Type::Float, 5), addArray(b_, ir::Type::Float, 3)};
        boolArray_ = addArray(b_, ir::Type::Bool, 4);
    }

protected:
    using Op = ir::Op;
    static constexpr int operationKinds = 17;

    void operation(int kind) {
        switch (kind) {
        case 0:
        case 1:
        case 2: return pools_.floats.push_back(arithmetic(pools_.floats));
        case 3: return pools_.uniforms.push_back(arithmetic(pools_.uniforms));
        case 4:
            return pools_.bools.push_back(comparison(below(3) ? pools_.floats : pools_.uniforms));
        case 5: return logic();
        case 6:
            return pools_.floats.push_back(
                select(b_, pick(pools_.bools), pick(pools_.floats),
                       pick(below(2) ? pools_.floats : pools_.uniforms)));
        case 7: return source();
        case 8: return call(below(2) ? pools_.floats : pools_.uniforms);
        case 9: return memory();
        case 10:
            return pools_.integers.push_back(
                unary(b_, Op::IntegerFromFloat, pick(below(2) ? pools_.floats : pools_.uniforms)));
        case 11: return light();
        case 12: return output(b_, "side", below(3), pick(pools_.floats));
        case 13: return frame();
        case 14: return print();
        case 15: return service(below(2) ? pools_.floats : pools_.uniforms);
        default:
            return pools_.strings.push_back(
                select(b_, pick(pools_.bools), pick(pools_.strings), pick(pools_.strings)));
        }
    }
    /// Of two of the floats.
    ir::ValueId comparison(const ir::Values &pool) {
        return binary(b_, comparisons_[below(int(comparisons_.size()))], pick(pool), pick(pool));
    }
    ir::Triple triple() { return {pick(pools_.floats), pick(pools_.floats), pick(pools_.floats)}; }

    ir::Builder &b_;
    RandomPools pools_;

private:
    ir::ValueId arithmetic(const ir::Values &pool) {
        const auto &all = oneLevel_ ? arithmetic_ : exactArithmetic_;
        const Op op = all[below(int(all.size()))];
        const bool two = ir::info(op).operands.size() == 2;
        return two ? binary(b_, op, pick(pool), pick(pool)) : unary(b_, op, pick(pool));
    }
    void logic() {
        switch (below(4)) {
        case 0: return pools_.bools.push_back(both(b_, pick(pools_.bools), pick(pools_.bools)));
        case 1: return pools_.bools.push_back(either(b_, pick(pools_.bools), pick(pools_.bools)));
        case 2: return pools_.bools.push_back(negate(b_, pick(pools_.bools)));
        default:
            return pools_.bools.push_back(
                binary(b_, Op::StringEqual, pick(pools_.strings), pick(pools_.strings)));
        }
    }
    void source() {
        switch (below(8)) {
        case 0: return pools_.floats.push_back(input(b_, ShaderInput::N, below(3)));
        case 1: return pools_.floats.push_back(parameter(b_, below(5)));
        case 2: return pools_.floats.push_back(variable(b_, below(3)));
        case 3:
            return pools_.keep(
                {currentFromObject(b_)[below(16)], objectFromCurrent(b_)[below(16)]});
        case 4: return pools_.floats.push_back(random(b_, input(b_, ShaderInput::P, below(3))));
        case 5: return pools_.bools.push_back(b_.emit(Op::AnsweredRequest, {}, below(2))[0]);
        case 6: return pools_.bools.push_back(b_.emit(Op::CategoryAccepts, {}, below(2))[0]);
        default: return pools_.floats.push_back(number(b_, constant()));
        }
    }
    void call(const ir::Values &pool) {
        constexpr int all = int(runtime::RuntimeFunction::Count);
        constexpr int exact = int(runtime::RuntimeFunction::cellnoise1);
        const int function = oneLevel_ ? below(all) : exact + below(all - exact);
        ir::Values inputs;
        for (int k = 0; k < runtime::info(runtime::RuntimeFunction(function)).inputs; ++k)
            inputs.push_back(pick(pool));
        pools_.keep(callRuntime(b_, function, inputs));
    }
    void memory() {
        const int array = arrays_[below(2)];
        switch (below(4)) {
        case 0: return pools_.floats.push_back(arrayLoad(b_, array, pick(pools_.integers)));
        case 1: return pools_.bools.push_back(arrayLoad(b_, boolArray_, pick(pools_.integers)));
        case 2: return arrayStore(b_, boolArray_, pick(pools_.integers), pick(pools_.bools));
        default:
            return arrayStore(b_, array, pick(pools_.integers),
                              pick(array == arrays_[0] ? pools_.floats : pools_.uniforms));
        }
    }
    void light() {
        switch (below(3)) {
        case 0: return pools_.keep(ambient(b_));
        case 1: return pools_.keep(irradiance(b_, triple(), triple()));
        default: {
            ir::LightRequest request;
            request.kind = ir::LightRequest::Kind::Trace;
            return pools_.keep(trace(b_, addRequest(b_, request), triple(), triple()));
        }
        }
    }
    /// Frames that lanes look up are not written to.
    void frame() {
        const ir::Function &function = b_.function();
        const int slots = function.surfaceSlots + function.viewSlots;
        const int firstOwn = function.lanes == BindingTime::Surface ? 0
                             : function.lanes == BindingTime::View  ? function.surfaceSlots
                                                                    : slots;
        if (below(2) || firstOwn == slots) {
            const bool loadsAny = function.lanes != BindingTime::View;
            const int slot = below(loadsAny ? slots : function.surfaceSlots);
            pools_.floats.push_back(b_.emit(Op::FrameLoad, {}, slot)[0]);
        } else {
            const bool isBool = below(3) == 0;
            b_.emit(Op::FrameStore, {pick(isBool ? pools_.bools : pools_.floats)},
                    firstOwn + below(slots - firstOwn));
        }
    }
    void print() {
        printValues(b_, "%s: %f %c %f",
                    {pick(pools_.strings), pick(pools_.floats), pick(pools_.floats),
                     pick(pools_.uniforms), pick(pools_.floats), pick(pools_.floats)});
    }

    void service(const ir::Values &pool) {
        const std::string name = below(2) ? "a" : "b";
        if (below(2))
            pools_.keep(query(b_, ir::testObject, {name}, {}, 2));
        else
            (&pool == &pools_.uniforms ? pools_.uniforms : pools_.floats)
                .push_back(query(b_, ir::testSample, {name}, {pick(pool), pick(pool)}, 3)[2]);
    }

    template <typename Test> static std::vector<Op> operations(Test test) {
        std::vector<Op> result;
        for (int op = 0; op < ir::opCount; ++op)
            if (test(Op(op)))
                result.push_back(Op(op));
        return result;
    }

    /// Float to float, and of those what is the same at all levels.
    const std::vector<Op> arithmetic_ = operations(ir::isFloatArithmetic);
    const std::vector<Op> exactArithmetic_ =
        operations([](Op op) { return ir::info(op).kind == ir::OpClass::Arithmetic; });
    const std::vector<Op> comparisons_ = operations(ir::isFloatComparison);
    bool oneLevel_;
    std::vector<int> arrays_;
    int boolArray_ = 0;
};

} // namespace candela
