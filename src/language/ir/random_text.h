// SPDX-License-Identifier: Apache-2.0
// For tests: random surface texts with light in all its forms, from a seed.
#pragma once

#include "foundation/units/color.h"
#include "language/ir/builder.h"

#include <random>

namespace candela::ir {

/// Writes a text whose numbers stay small, so that exact comparison makes sense. Outputs "Ci" and
/// "Oi". Requests stand in loops only if `dynamic`.
class RandomText {
public:
    RandomText(unsigned seed, bool dynamic) : bits_(seed), dynamic_(dynamic) {
        function_.name = "random";
        function_.parameters = {{"a", 0}, {"b", 0}, {"c", 0}};
        function_.categories = {"key"};
    }

    Function make() {
        Builder b(function_);
        b_ = &b;
        for (int k = 0; k < 3; ++k) {
            pool_.push_back(b.parameter(k));
            pool_.push_back(b.input(ShaderInput::N, k));
            pool_.push_back(b.input(ShaderInput::I, k));
            pool_.push_back(b.number(0.25f * float(k)));
        }
        array_ = b.addArray(Type::Float, 3);
        Values sums(colorSamples, b.number(0));
        for (int n = 0, count = 2 + below(4); n < count; ++n)
            sums = statement(sums, 0);
        bool emits = below(2) == 0;
        for (int k = 0; k < colorSamples; ++k) {
            ValueId Ci = b.mul(sums[k], any());
            b.output("Ci", k, emits ? b.add(Ci, any()) : Ci);
            b.output("Oi", k, below(2) ? b.input(ShaderInput::Os, k) : any());
        }
        b.finish();
        return function_;
    }

private:
    using Values = Builder::Values;

    int below(int n) { return int(bits_() % unsigned(n)); }
    ValueId any() { return pool_[below(int(pool_.size()))]; }
    Triple any3() { return {any(), any(), any()}; }
    ValueId condition() { return b_->less(any(), any()); }

    void arithmetic() {
        ValueId x = any(), y = any();
        switch (below(8)) {
        case 0: pool_.push_back(b_->unary(Op::Sin, b_->add(x, y))); break;
        case 1: pool_.push_back(b_->unary(Op::Cos, b_->mul(x, y))); break;
        case 2: pool_.push_back(b_->min(x, b_->neg(y))); break;
        case 3: pool_.push_back(b_->select(condition(), x, y)); break;
        case 4: pool_.push_back(b_->call(2, {x, y, any()})[0]); break;
        case 5: b_->arrayStore(array_, b_->unary(Op::IntegerFromFloat, x), y); break;
        case 6: pool_.push_back(b_->arrayLoad(array_, b_->unary(Op::IntegerFromFloat, y))); break;
        default: pool_.push_back(b_->unary(Op::Sin, b_->sub(x, y))); break;
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
            v = below(3) ? b_->mul(v, any()) : b_->unary(Op::Sin, b_->add(v, b_->mul(v, any())));
        if (below(6) == 0)
            sums[0] = b_->add(sums[0], b_->ambient()[0]);
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
        Values result = b_->ifElse(choice, side, side);
        pool_.push_back(result.back());
        result.pop_back();
        return result;
    }

    Values loop(const Values &sums, int depth) {
        ValueId limit = below(2) ? b_->mul(b_->number(3), any()) : b_->number(float(below(4)));
        Values initial{b_->less(b_->number(0), limit), b_->number(0), any()};
        initial.insert(initial.end(), sums.begin(), sums.end());
        bool outer = inLoop_;
        inLoop_ = true;
        Values result = b_->loop(initial, [&](const Values &carried) {
            return scoped(carried, [&](const Values &) {
                pool_.push_back(carried[1]);
                pool_.push_back(carried[2]);
                Values inner = block({carried.begin() + 3, carried.end()}, depth + 1);
                ValueId next = b_->add(carried[1], b_->number(1));
                Values yields{b_->both(b_->less(next, limit), b_->less(next, b_->number(4))), next,
                              b_->unary(Op::Sin, any())};
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
            Triple axis = b_->input3(ShaderInput::N);
            cones.insert(cones.end(), axis.begin(), axis.end());
            if (request.form == ConeForm::Classic) {
                cones.push_back(b_->number(1.5f));
            } else {
                ValueId angle = below(2)
                                    ? b_->number(float(below(2)) * 90)
                                    : b_->select(b_->less(b_->parameter(below(3)), b_->number(0)),
                                                 b_->number(0), b_->number(60));
                cones.insert(cones.end(), {angle, b_->number(2), b_->parameter(below(3))});
            }
        }
        Values initial = sums;
        initial.push_back(any());
        inLight_ = true;
        Values result =
            b_->lightLoop(b_->addRequest(request), b_->input3(ShaderInput::P), cones, initial,
                          [&](const Triple &L, const Values &Cl, const Values &carried) {
                              return scoped(carried, [&](const Values &) {
                                  pool_.insert(pool_.end(), L.begin(), L.end());
                                  ValueId weight = any();
                                  if (below(2))
                                      weight = b_->dot(b_->input3(ShaderInput::N), L);
                                  Values inner = {carried.begin(), carried.end() - 1};
                                  if (below(2))
                                      inner = block(inner, depth + 2);
                                  for (int k = 0; k < colorSamples; ++k)
                                      inner[k] =
                                          b_->add(inner[k], b_->mul(Cl[k], b_->mul(weight, any())));
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
        Triple N = b_->input3(ShaderInput::N);
        Values answer = b_->trace(b_->addRequest(request), b_->input3(ShaderInput::P), N);
        for (int k = 0; k < colorSamples; ++k)
            sums[k] = b_->add(sums[k], b_->mul(weight, answer[k]));
        return sums;
    }

    std::mt19937 bits_;
    bool dynamic_;
    Function function_;
    Builder *b_ = nullptr;
    std::vector<ValueId> pool_;
    int array_ = 0;
    bool inLoop_ = false, inLight_ = false;
};

} // namespace candela::ir
