// SPDX-License-Identifier: Apache-2.0
// For tests: random IR functions that use every operation, with nested control flow.
#pragma once

#include "language/ir/builder.h"
#include "language/ir/builder_arithmetic.h"
#include "language/ir/builder_control.h"
#include "language/ir/builder_effects.h"
#include "language/ir/builder_light.h"
#include "language/ir/builder_sources.h"
#include "language/runtime/runtime_functions.h"

#include <random>
#include <string>
#include <vector>

namespace candela {

class RandomProgram {
public:
    /// Without transcendentals all instruction sets give the same bits.
    RandomProgram(ir::Function &function, unsigned seed, bool transcendentals)
        : function_(function), b_(function), bits_(seed), transcendentals_(transcendentals) {
        function.name = "random" + std::to_string(seed);
        function.parameters.resize(5);
        function.variables.resize(3);
        function.categories = {"key", "-key"};
        function.frameSlots = 4;
        for (int k = 0; k < 2; ++k) // For AnsweredRequest.
            addRequest(b_, {ir::LightRequest::Kind::Trace, ir::ConeForm::Everywhere, 0, -1, 0});
        seedPools();
        statements(14, 3);
        for (int k = 0; k < 4; ++k)
            output(b_, "result", k, pick(floats_));
        output(b_, "result", 4, unary(b_, ir::Op::FloatFromBool, pick(bools_)));
        b_.finish();
    }

private:
    using Id = ir::ValueId;
    using Ids = std::vector<Id>;
    using Op = ir::Op;

    int below(int n) { return int(bits_() % unsigned(n)); }
    Id pick(const Ids &pool) {
        // Mostly what was made last, so that programs are deep.
        const int size = int(pool.size());
        return below(2) ? pool[size - 1 - below(std::min(size, 6))] : pool[below(size)];
    }
    float constant() {
        static const float special[] = {0, -0.0f, 1, -1, 0.5f, 3, 1e-20f, 1e20f, -7.25f};
        return below(3) ? special[below(9)] : float(below(2000) - 1000) / 128;
    }
    ir::Triple triple() { return {pick(floats_), pick(floats_), pick(floats_)}; }
    void keep(const Ids &made) { floats_.insert(floats_.end(), made.begin(), made.end()); }

    void seedPools() {
        for (int k = 0; k < 3; ++k)
            floats_.push_back(number(b_, constant()));
        for (Id v : input3(b_, ShaderInput::P))
            floats_.push_back(v);
        const ir::Matrix world = currentFromSpace(b_, "world"),
                         back = spaceFromCurrent(b_, "world");
        keep({world[0], world[5], back[3]});
        uniforms_ = floats_;
        uniforms_.resize(3);
        uniforms_.insert(uniforms_.end(), {world[0], world[5], back[3], world[7]});
        bools_ = {boolean(b_, true), less(b_, floats_[3], floats_[4]),
                  less(b_, world[0], world[5])};
        integers_ = {integer(b_, 1), unary(b_, Op::IntegerFromFloat, world[2]),
                     unary(b_, Op::IntegerFromFloat, mul(b_, floats_[3], number(b_, 5)))};
        strings_ = {text(b_, "one"), text(b_, "two"), text(b_, "%f and %c;")};
        strings_.push_back(select(b_, bools_[1], strings_[0], strings_[1]));
        arrays_ = {addArray(b_, ir::Type::Float, 5), addArray(b_, ir::Type::Float, 3)};
        boolArray_ = addArray(b_, ir::Type::Bool, 4);
    }

    /// Statements of a region; what they make is forgotten at its end.
    template <typename Yield> Ids scoped(int count, int depth, Yield &&yield) {
        const Ids floats = floats_, uniforms = uniforms_, bools = bools_, integers = integers_,
                  strings = strings_;
        statements(count, depth);
        const Ids result = yield();
        floats_ = floats;
        uniforms_ = uniforms;
        bools_ = bools;
        integers_ = integers;
        strings_ = strings;
        return result;
    }

    void statements(int count, int depth) {
        for (int k = 0; k < count; ++k)
            statement(depth);
    }

    void statement(int depth) {
        switch (below(depth > 0 ? 22 : 16)) {
        case 0:
        case 1:
        case 2: return floats_.push_back(arithmetic(floats_));
        case 3: return uniforms_.push_back(arithmetic(uniforms_));
        case 4: return bools_.push_back(comparison(below(3) ? floats_ : uniforms_));
        case 5: return logic();
        case 6:
            return floats_.push_back(
                select(b_, pick(bools_), pick(floats_), pick(below(2) ? floats_ : uniforms_)));
        case 7: return source();
        case 8: return call(below(2) ? floats_ : uniforms_);
        case 9: return memory();
        case 10:
            return integers_.push_back(
                unary(b_, Op::IntegerFromFloat, pick(below(2) ? floats_ : uniforms_)));
        case 11: return light();
        case 12: return output(b_, "side", below(3), pick(floats_));
        case 13: return frame();
        case 14: return print();
        case 15:
            return strings_.push_back(select(b_, pick(bools_), pick(strings_), pick(strings_)));
        case 16:
        case 17:
        case 18: return branch(depth);
        case 19:
        case 20: return loop(depth);
        default: return lightLoop(depth);
        }
    }

    Id arithmetic(const Ids &pool) {
        const int first = int(Op::Add);
        const int last = int(transcendentals_ ? Op::Pow : Op::Sqrt);
        const Op op = Op(first + below(last - first + 1));
        const bool two =
            op <= Op::Div || op == Op::Min || op == Op::Max || op == Op::Atan2 || op == Op::Pow;
        return two ? binary(b_, op, pick(pool), pick(pool)) : unary(b_, op, pick(pool));
    }
    Id comparison(const Ids &pool) {
        return binary(b_, Op(int(Op::Less) + below(4)), pick(pool), pick(pool));
    }
    void logic() {
        switch (below(4)) {
        case 0: return bools_.push_back(both(b_, pick(bools_), pick(bools_)));
        case 1: return bools_.push_back(either(b_, pick(bools_), pick(bools_)));
        case 2: return bools_.push_back(negate(b_, pick(bools_)));
        default:
            return bools_.push_back(binary(b_, Op::StringEqual, pick(strings_), pick(strings_)));
        }
    }
    void source() {
        switch (below(8)) {
        case 0: return floats_.push_back(input(b_, ShaderInput::N, below(3)));
        case 1: return floats_.push_back(parameter(b_, below(5)));
        case 2: return floats_.push_back(variable(b_, below(3)));
        case 3: return keep({currentFromObject(b_)[below(16)], objectFromCurrent(b_)[below(16)]});
        case 4: return floats_.push_back(random(b_));
        case 5: return bools_.push_back(b_.emit(Op::AnsweredRequest, {}, below(2))[0]);
        case 6: return bools_.push_back(b_.emit(Op::CategoryAccepts, {}, below(2))[0]);
        default: return floats_.push_back(number(b_, constant()));
        }
    }
    void call(const Ids &pool) {
        const int function = below(int(runtime::RuntimeFunction::Count));
        Ids inputs;
        for (int k = 0; k < runtime::info(runtime::RuntimeFunction(function)).inputs; ++k)
            inputs.push_back(pick(pool));
        keep(callRuntime(b_, function, inputs));
    }
    void memory() {
        const int array = arrays_[below(2)];
        switch (below(4)) {
        case 0: return floats_.push_back(arrayLoad(b_, array, pick(integers_)));
        case 1: return bools_.push_back(arrayLoad(b_, boolArray_, pick(integers_)));
        case 2: return arrayStore(b_, boolArray_, pick(integers_), pick(bools_));
        default:
            return arrayStore(b_, array, pick(integers_),
                              pick(array == arrays_[0] ? floats_ : uniforms_));
        }
    }
    void light() {
        switch (below(3)) {
        case 0: return keep(ambient(b_));
        case 1: return keep(irradiance(b_, triple(), triple()));
        default: {
            ir::LightRequest request;
            request.kind = ir::LightRequest::Kind::Trace;
            return keep(trace(b_, addRequest(b_, request), triple(), triple()));
        }
        }
    }
    void frame() {
        if (below(2)) {
            floats_.push_back(b_.emit(Op::FrameLoad, {}, below(4))[0]);
        } else {
            const bool isBool = below(3) == 0;
            b_.emit(Op::FrameStore, {pick(isBool ? bools_ : floats_)}, below(4));
        }
    }
    void print() {
        printValues(b_, "%s: %f %c %f",
                    {pick(strings_), pick(floats_), pick(floats_), pick(uniforms_), pick(floats_),
                     pick(floats_)});
    }

    void branch(int depth) {
        const Id condition = below(3) ? pick(bools_) : comparison(uniforms_);
        const auto side = [&] {
            return scoped(1 + below(6), depth - 1, [&] {
                return Ids{pick(floats_), pick(floats_), pick(bools_), pick(integers_),
                           pick(strings_)};
            });
        };
        const Ids made = ifElse(b_, condition, side, side);
        keep({made[0], made[1]});
        bools_.push_back(made[2]);
        integers_.push_back(made[3]);
        strings_.push_back(made[4]);
    }
    void loop(int depth) {
        const Id asked =
            unary(b_, Op::Abs, mul(b_, pick(below(2) ? floats_ : uniforms_), number(b_, 4)));
        const Id limit = min(b_, asked, number(b_, 5));
        const Id zero = number(b_, 0);
        const Ids initial{less(b_, zero, limit), zero, pick(floats_), pick(bools_),
                          pick(uniforms_)};
        const Ids made = ir::loop(b_, initial, [&](const Ids &carried) {
            floats_.push_back(carried[2]);
            floats_.push_back(carried[4]);
            bools_.push_back(carried[3]);
            return scoped(1 + below(5), depth - 1, [&] {
                const Id count = add(b_, carried[1], number(b_, 1));
                return Ids{less(b_, count, limit), count, pick(floats_), pick(bools_),
                           add(b_, carried[4], number(b_, 1))};
            });
        });
        // The body's carried values are not visible out here.
        floats_.resize(floats_.size() - 2);
        bools_.pop_back();
        keep({made[1], made[2], made[4]});
        bools_.push_back(made[3]);
    }
    void lightLoop(int depth) {
        ir::LightRequest request;
        request.form = ir::ConeForm(below(3));
        request.coneCount = request.form == ir::ConeForm::Everywhere ? 0 : 1;
        request.category = below(3) - 1;
        Ids cones;
        if (request.form == ir::ConeForm::Extended)
            request.coneCount += below(2);
        for (int k = 0; k < request.coneCount; ++k) {
            for (Id axis : triple())
                cones.push_back(axis);
            cones.push_back(below(2) ? pick(floats_) : number(b_, 1.2f));
            if (request.form == ir::ConeForm::Extended)
                for (int parameter = 0; parameter < 2; ++parameter)
                    cones.push_back(pick(floats_));
        }
        const Ids initial{pick(floats_), pick(bools_)};
        const Ids made =
            ir::lightLoop(b_, addRequest(b_, request), triple(), cones, initial,
                          [&](const ir::Triple &L, const Ids &Cl, const Ids &carried) {
                              const Ids floats = floats_, bools = bools_;
                              keep({L[0], L[1], L[2], Cl[0], Cl[1], Cl[2], carried[0]});
                              bools_.push_back(carried[1]);
                              const Ids yields = scoped(1 + below(5), depth - 1, [&] {
                                  return Ids{add(b_, carried[0], pick(floats_)), pick(bools_)};
                              });
                              floats_ = floats;
                              bools_ = bools;
                              return yields;
                          });
        floats_.push_back(made[0]);
        bools_.push_back(made[1]);
    }

    ir::Function &function_;
    ir::Builder b_;
    std::mt19937 bits_;
    bool transcendentals_;
    Ids floats_, uniforms_, bools_, integers_, strings_;
    std::vector<int> arrays_;
    int boolArray_ = 0;
};

} // namespace candela
