// SPDX-License-Identifier: Apache-2.0
// For tests: random surface texts with light in all its forms, from a seed.
#pragma once

#include "foundation/units/color.h"
#include "language/ir/core/builder.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/test_services.h"

#include <random>

namespace candela::ir {

/// Writes a text whose numbers stay small, so that exact comparison makes sense. Outputs "Ci" and
/// "Oi". Requests stand in loops only if `dynamic`.
class RandomText {
public:
    RandomText(unsigned seed, bool dynamic, int colorSamples = 3)
        : colorSamples_(colorSamples), bits_(seed), dynamic_(dynamic) {
        function_.colors = evenBasis(colorSamples);
        function_.name = "random";
        function_.parameters = {{"a", 0}, {"b", 0}, {"c", 0}};
        function_.categories = {"key"};
    }

    Function make() {
        for (int k = 0; k < 3; ++k) {
            pool_.push_back(parameter(b_, k));
            pool_.push_back(input(b_, ShaderInput::N, k));
            pool_.push_back(input(b_, ShaderInput::I, k));
            pool_.push_back(number(b_, 0.25f * float(k)));
        }
        array_ = addArray(b_, Type::Float, 3);
        Values sums(colorSamples_, number(b_, 0));
        for (int n = 0, count = 2 + below(4); n < count; ++n)
            sums = statement(sums, 0);
        bool emits = below(2) == 0;
        for (int k = 0; k < colorSamples_; ++k) {
            ValueId Ci = mul(b_, sums[k], any());
            output(b_, "Ci", k, emits ? add(b_, Ci, any()) : Ci);
            output(b_, "Oi", k, below(2) ? input(b_, ShaderInput::Os, k) : any());
        }
        b_.finish();
        return function_;
    }

private:
    int below(int n) { return int(bits_() % unsigned(n)); }
    ValueId any() { return pool_[below(int(pool_.size()))]; }
    Triple any3() { return {any(), any(), any()}; }
    ValueId condition() { return less(b_, any(), any()); }

    void arithmetic() {
        ValueId x = any(), y = any();
        switch (below(10)) {
        case 0: pool_.push_back(unary(b_, Op::Sin, add(b_, x, y))); break;
        case 1: pool_.push_back(unary(b_, Op::Cos, mul(b_, x, y))); break;
        case 2: pool_.push_back(min(b_, x, neg(b_, y))); break;
        case 3: pool_.push_back(select(b_, condition(), x, y)); break;
        case 4: pool_.push_back(callRuntime(b_, 2, {x, y, any()})[0]); break;
        case 5: arrayStore(b_, array_, unary(b_, Op::IntegerFromFloat, x), y); break;
        case 6: pool_.push_back(arrayLoad(b_, array_, unary(b_, Op::IntegerFromFloat, y))); break;
        case 7: pool_.push_back(query(b_, testSample, {"map"}, {x, y}, 2)[1]); break;
        case 8: command(b_, testNote, {"note"}, {x}); break;
        default: pool_.push_back(unary(b_, Op::Sin, sub(b_, x, y))); break;
        }
    }

    /// Runs `body` on the sums with a pool of its own.
    template <typename Body> Values scoped(const Values &sums, Body &&body) {
        std::vector<ValueId> kept = pool_;
        Values result = body(sums);
        pool_ = std::move(kept);
        return result;
    }

    Values block(Values sums, int depth) {
        for (int n = 0, count = 1 + below(3); n < count; ++n)
            sums = statement(sums, depth);
        return sums;
    }

    Values statement(const Values &sums, int depth) {
        for (int n = 0, count = 1 + below(4); n < count; ++n)
            arithmetic();
        bool mayAsk = !inLight_ && (dynamic_ || !inLoop_);
        switch (depth > 2 ? 7 : below(8)) {
        case 0:
        case 1: return branch(sums, depth);
        case 2: return loop(sums, depth);
        case 3:
        case 4:
        case 5: return mayAsk ? light(sums, depth) : mixed(sums);
        case 6: return mayAsk ? trace(sums) : mixed(sums);
        default: return mixed(sums);
        }
    }

    Values mixed(Values sums) {
        for (ValueId &v : sums)
            v = below(3) ? mul(b_, v, any()) : unary(b_, Op::Sin, add(b_, v, mul(b_, v, any())));
        if (below(6) == 0)
            sums[0] = add(b_, sums[0], ambient(b_)[0]);
        return sums;
    }

    Values branch(const Values &sums, int depth) {
        ValueId choice = condition();
        Values initial = sums;
        initial.push_back(any());
        auto side = [&] {
            return scoped(initial, [&](const Values &) {
                Values result = block(sums, depth + 1);
                result.push_back(any());
                return result;
            });
        };
        Values result = ifElse(b_, choice, side, side);
        pool_.push_back(result.back());
        result.pop_back();
        return result;
    }

    Values loop(const Values &sums, int depth) {
        ValueId limit = below(2) ? mul(b_, number(b_, 3), any()) : number(b_, float(below(4)));
        Values initial{less(b_, number(b_, 0), limit), number(b_, 0), any()};
        initial.insert(initial.end(), sums.begin(), sums.end());
        bool outer = inLoop_;
        inLoop_ = true;
        Values result = ir::loop(b_, initial, [&](const Values &carried) {
            return scoped(carried, [&](const Values &) {
                pool_.push_back(carried[1]);
                pool_.push_back(carried[2]);
                Values inner = block({carried.begin() + 3, carried.end()}, depth + 1);
                ValueId next = add(b_, carried[1], number(b_, 1));
                Values yields{both(b_, less(b_, next, limit), less(b_, next, number(b_, 4))), next,
                              unary(b_, Op::Sin, any())};
                yields.insert(yields.end(), inner.begin(), inner.end());
                return yields;
            });
        });
        inLoop_ = outer;
        pool_.push_back(result[2]);
        return {result.begin() + 3, result.end()};
    }

    /// Extended loops have N for their first axis, so that tests know where delta requests look.
    Values light(const Values &sums, int depth) {
        LightRequest request;
        request.form = ConeForm(below(3));
        request.coneCount = request.form == ConeForm::Everywhere ? 0
                            : request.form == ConeForm::Classic  ? 1
                                                                 : 1 + below(2);
        request.category = below(3) == 0 ? 0 : -1;
        Values cones;
        for (int n = 0; n < request.coneCount; ++n) {
            Triple axis = input3(b_, ShaderInput::N);
            cones.insert(cones.end(), axis.begin(), axis.end());
            if (request.form == ConeForm::Classic) {
                cones.push_back(number(b_, 1.5f));
            } else {
                ValueId angle = below(2)
                                    ? number(b_, float(below(2)) * 90)
                                    : select(b_, less(b_, parameter(b_, below(3)), number(b_, 0)),
                                             number(b_, 0), number(b_, 60));
                cones.insert(cones.end(), {angle, number(b_, 2), parameter(b_, below(3))});
            }
        }
        Values initial = sums;
        initial.push_back(any());
        inLight_ = true;
        Values result = lightLoop(
            b_, addRequest(b_, request), input3(b_, ShaderInput::P), cones, initial,
            [&](const LoopLight &light, const Values &carried) {
                return scoped(carried, [&](const Values &) {
                    pool_.insert(pool_.end(), light.L.begin(), light.L.end());
                    pool_.push_back(light.number);
                    ValueId weight = any();
                    if (below(2))
                        weight = dot(b_, input3(b_, ShaderInput::N), light.L);
                    Values inner = {carried.begin(), carried.end() - 1};
                    if (below(2))
                        inner = block(inner, depth + 2);
                    for (int k = 0; k < colorSamples_; ++k)
                        inner[k] = add(b_, inner[k], mul(b_, light.Cl[k], mul(b_, weight, any())));
                    inner.push_back(below(2) ? any() : carried.back());
                    return inner;
                });
            });
        inLight_ = false;
        pool_.push_back(result.back());
        result.pop_back();
        if (!dynamic_)
            pool_.pop_back();
        return result;
    }

    Values trace(Values sums) {
        LightRequest request;
        request.kind = LightRequest::Kind::Trace;
        ValueId weight = any();
        Triple N = input3(b_, ShaderInput::N);
        Values answer = ir::trace(b_, addRequest(b_, request), input3(b_, ShaderInput::P), N);
        for (int k = 0; k < colorSamples_; ++k)
            sums[k] = add(b_, sums[k], mul(b_, weight, answer[k]));
        return sums;
    }

    int colorSamples_;
    std::mt19937 bits_;
    bool dynamic_;
    Function function_;
    Builder b_{function_};
    std::vector<ValueId> pool_;
    int array_ = 0;
    bool inLoop_ = false, inLight_ = false;
};

} // namespace candela::ir
