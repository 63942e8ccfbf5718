// SPDX-License-Identifier: Apache-2.0
// For tests: random IR functions that use every operation, with nested control flow.
#pragma once

#include "language/ir/builder.h"
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
            b_.addRequest({ir::LightRequest::Kind::Trace, ir::ConeForm::Everywhere, 0, -1, 0});
        seedPools();
        statements(14, 3);
        for (int k = 0; k < 4; ++k)
            b_.output("result", k, pick(floats_));
        b_.output("result", 4, b_.unary(ir::Op::FloatFromBool, pick(bools_)));
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
            floats_.push_back(b_.number(constant()));
        for (Id v : b_.input3(ShaderInput::P))
            floats_.push_back(v);
        const ir::Matrix world = b_.space("world"), back = b_.spaceInverse("world");
        keep({world[0], world[5], back[3]});
        uniforms_ = floats_;
        uniforms_.resize(3);
        uniforms_.insert(uniforms_.end(), {world[0], world[5], back[3], world[7]});
        bools_ = {b_.boolean(true), b_.less(floats_[3], floats_[4]), b_.less(world[0], world[5])};
        integers_ = {b_.integer(1), b_.unary(Op::IntegerFromFloat, world[2]),
                     b_.unary(Op::IntegerFromFloat, b_.mul(floats_[3], b_.number(5)))};
        strings_ = {b_.text("one"), b_.text("two"), b_.text("%f and %c;")};
        strings_.push_back(b_.select(bools_[1], strings_[0], strings_[1]));
        arrays_ = {b_.addArray(ir::Type::Float, 5), b_.addArray(ir::Type::Float, 3)};
        boolArray_ = b_.addArray(ir::Type::Bool, 4);
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
                b_.select(pick(bools_), pick(floats_), pick(below(2) ? floats_ : uniforms_)));
        case 7: return source();
        case 8: return call(below(2) ? floats_ : uniforms_);
        case 9: return memory();
        case 10:
            return integers_.push_back(
                b_.unary(Op::IntegerFromFloat, pick(below(2) ? floats_ : uniforms_)));
        case 11: return light();
        case 12: return b_.output("side", below(3), pick(floats_));
        case 13: return frame();
        case 14: return print();
        case 15: return strings_.push_back(b_.select(pick(bools_), pick(strings_), pick(strings_)));
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
        return two ? b_.binary(op, pick(pool), pick(pool)) : b_.unary(op, pick(pool));
    }
    Id comparison(const Ids &pool) {
        return b_.binary(Op(int(Op::Less) + below(4)), pick(pool), pick(pool));
    }
    void logic() {
        switch (below(4)) {
        case 0: return bools_.push_back(b_.both(pick(bools_), pick(bools_)));
        case 1: return bools_.push_back(b_.either(pick(bools_), pick(bools_)));
        case 2: return bools_.push_back(b_.negate(pick(bools_)));
        default:
            return bools_.push_back(b_.binary(Op::StringEqual, pick(strings_), pick(strings_)));
        }
    }
    void source() {
        switch (below(8)) {
        case 0: return floats_.push_back(b_.input(ShaderInput::N, below(3)));
        case 1: return floats_.push_back(b_.parameter(below(5)));
        case 2: return floats_.push_back(b_.variable(below(3)));
        case 3: return keep({b_.object()[below(16)], b_.objectInverse()[below(16)]});
        case 4: return floats_.push_back(b_.random());
        case 5: return bools_.push_back(b_.emit(Op::AnsweredRequest, {}, below(2))[0]);
        case 6: return bools_.push_back(b_.emit(Op::CategoryAccepts, {}, below(2))[0]);
        default: return floats_.push_back(b_.number(constant()));
        }
    }
    void call(const Ids &pool) {
        const int function = below(int(runtime::RuntimeFunction::Count));
        Ids inputs;
        for (int k = 0; k < runtime::info(runtime::RuntimeFunction(function)).inputs; ++k)
            inputs.push_back(pick(pool));
        keep(b_.call(function, inputs));
    }
    void memory() {
        const int array = arrays_[below(2)];
        switch (below(4)) {
        case 0: return floats_.push_back(b_.arrayLoad(array, pick(integers_)));
        case 1: return bools_.push_back(b_.arrayLoad(boolArray_, pick(integers_)));
        case 2: return b_.arrayStore(boolArray_, pick(integers_), pick(bools_));
        default:
            return b_.arrayStore(array, pick(integers_),
                                 pick(array == arrays_[0] ? floats_ : uniforms_));
        }
    }
    void light() {
        switch (below(3)) {
        case 0: return keep(b_.ambient());
        case 1: return keep(b_.irradiance(triple(), triple()));
        default: {
            ir::LightRequest request;
            request.kind = ir::LightRequest::Kind::Trace;
            return keep(b_.trace(b_.addRequest(request), triple(), triple()));
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
        b_.printValues("%s: %f %c %f", {pick(strings_), pick(floats_), pick(floats_),
                                        pick(uniforms_), pick(floats_), pick(floats_)});
    }

    void branch(int depth) {
        const Id condition = below(3) ? pick(bools_) : comparison(uniforms_);
        const auto side = [&] {
            return scoped(1 + below(6), depth - 1, [&] {
                return Ids{pick(floats_), pick(floats_), pick(bools_), pick(integers_),
                           pick(strings_)};
            });
        };
        const Ids made = b_.ifElse(condition, side, side);
        keep({made[0], made[1]});
        bools_.push_back(made[2]);
        integers_.push_back(made[3]);
        strings_.push_back(made[4]);
    }
    void loop(int depth) {
        const Id asked =
            b_.unary(Op::Abs, b_.mul(pick(below(2) ? floats_ : uniforms_), b_.number(4)));
        const Id limit = b_.min(asked, b_.number(5));
        const Id zero = b_.number(0);
        const Ids initial{b_.less(zero, limit), zero, pick(floats_), pick(bools_), pick(uniforms_)};
        const Ids made = b_.loop(initial, [&](const Ids &carried) {
            floats_.push_back(carried[2]);
            floats_.push_back(carried[4]);
            bools_.push_back(carried[3]);
            return scoped(1 + below(5), depth - 1, [&] {
                const Id count = b_.add(carried[1], b_.number(1));
                return Ids{b_.less(count, limit), count, pick(floats_), pick(bools_),
                           b_.add(carried[4], b_.number(1))};
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
            cones.push_back(below(2) ? pick(floats_) : b_.number(1.2f));
            if (request.form == ir::ConeForm::Extended)
                for (int parameter = 0; parameter < 2; ++parameter)
                    cones.push_back(pick(floats_));
        }
        const Ids initial{pick(floats_), pick(bools_)};
        const Ids made =
            b_.lightLoop(b_.addRequest(request), triple(), cones, initial,
                         [&](const ir::Triple &L, const Ids &Cl, const Ids &carried) {
                             const Ids floats = floats_, bools = bools_;
                             keep({L[0], L[1], L[2], Cl[0], Cl[1], Cl[2], carried[0]});
                             bools_.push_back(carried[1]);
                             const Ids yields = scoped(1 + below(5), depth - 1, [&] {
                                 return Ids{b_.add(carried[0], pick(floats_)), pick(bools_)};
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
