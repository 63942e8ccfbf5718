// SPDX-License-Identifier: Apache-2.0
// What is proved of small surfaces written by hand: affinity, emission, importance, light rules.
#include "language/ir/analyse/affine.h"
#include "language/ir/analyse/control_relevance.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/regions.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"
#include "language/ir/transform/light_rule.h"

#include "foundation/units/color.h"
#include "language/ir/core/builder.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>

namespace candela::ir {
namespace {

constexpr int loopLine = 10, trickLine = 20;

/// The sum over light of what `term` gives for each channel, over the hemisphere about a vector.
Values gatherAbout(Builder &b, const Triple &along,
                   const std::function<ValueId(const Triple &L, ValueId Cl)> &term) {
    const Triple axis = normalize(b, along);
    LightRequest request;
    request.form = ConeForm::Classic;
    request.coneCount = 1;
    b.setLine(loopLine);
    return lightLoop(b, addRequest(b, request), input3(b, ShaderInput::P),
                     {axis[0], axis[1], axis[2], number(b, std::numbers::pi_v<float> / 2)},
                     Values(colorSamples, number(b, 0)),
                     [&](const LoopLight &light, const Values &carried) {
                         Values sum;
                         for (int k = 0; k < colorSamples; ++k)
                             sum.push_back(add(b, carried[k], term(light.L, light.Cl[k])));
                         return sum;
                     });
}

Values gather(Builder &b, const std::function<ValueId(const Triple &L, ValueId Cl)> &term) {
    return gatherAbout(b, input3(b, ShaderInput::N), term);
}

ValueId cosineNL(Builder &b, const Triple &L) {
    return dot(b, normalize(b, input3(b, ShaderInput::N)), normalize(b, L));
}

Values diffuse(Builder &b) {
    return gather(b, [&](const Triple &L, ValueId Cl) { return mul(b, Cl, cosineNL(b, L)); });
}

/// RI 3.1 specular(): pow(N.H, 1/roughness) with H between L and the viewer.
Values specular(Builder &b, ValueId roughness) {
    Triple N = normalize(b, input3(b, ShaderInput::N));
    Triple V = normalize(b, neg(b, input3(b, ShaderInput::I)));
    return gather(b, [&](const Triple &L, ValueId Cl) {
        Triple H = normalize(b, add(b, normalize(b, L), V));
        ValueId cosine = max(b, dot(b, N, H), number(b, 0));
        return mul(b, Cl, pow(b, cosine, div(b, number(b, 1), roughness)));
    });
}

Function surface(const std::function<Values(Builder &)> &Ci) {
    Function function;
    function.parameters = {{"Ka", 0}, {"Kd", 0}, {"Ks", 0}, {"roughness", 0}};
    Builder b(function);
    Values color = Ci(b);
    for (int k = 0; k < colorSamples; ++k) {
        output(b, "Ci", k, mul(b, color[k], input(b, ShaderInput::Os, k)));
        output(b, "Oi", k, input(b, ShaderInput::Os, k));
    }
    b.finish();
    EXPECT_EQ(verify(function), "");
    return function;
}

/// Applies to each channel.
Values each(const Values &color, const std::function<ValueId(ValueId)> &apply) {
    Values result;
    for (ValueId v : color)
        result.push_back(apply(v));
    return result;
}

Values matte(Builder &b) {
    Values lit = diffuse(b), everywhere = ambient(b), sum;
    for (int k = 0; k < colorSamples; ++k)
        sum.push_back(
            add(b, mul(b, parameter(b, 0), everywhere[k]), mul(b, parameter(b, 1), lit[k])));
    return sum;
}

Values plastic(Builder &b) {
    Values base = matte(b), shine = specular(b, parameter(b, 3)), sum;
    for (int k = 0; k < colorSamples; ++k)
        sum.push_back(add(b, mul(b, base[k], input(b, ShaderInput::Cs, k)),
                          mul(b, parameter(b, 2), shine[k])));
    return sum;
}

TEST(Affine, Table) {
    struct Case {
        const char *name;
        bool affine;
        std::function<Values(Builder &)> Ci;
    };
    auto trick = [](Builder &b, const std::function<ValueId(Builder &, ValueId)> &apply) {
        Values lit = diffuse(b);
        b.setLine(trickLine);
        return each(lit, [&](ValueId v) { return apply(b, v); });
    };
    const std::vector<Case> cases = {
        {"matte", true, matte},
        {"plastic", true, plastic},
        {"choice by something else", true,
         [&](Builder &b) {
             return trick(b, [](Builder &b, ValueId v) {
                 return select(b, less(b, input(b, ShaderInput::u), number(b, 0)), v, number(b, 1));
             });
         }},
        {"0 times a square", true,
         [&](Builder &b) {
             return trick(b,
                          [](Builder &b, ValueId v) { return mul(b, number(b, 0), mul(b, v, v)); });
         }},
        {"product of two light terms", false,
         [&](Builder &b) {
             Values shine = specular(b, parameter(b, 3));
             return trick(b, [&](Builder &b, ValueId v) { return mul(b, v, shine[0]); });
         }},
        {"step", false,
         [&](Builder &b) {
             return trick(b, [](Builder &b, ValueId v) {
                 return select(b, less(b, v, number(b, 0.5f)), number(b, 0), number(b, 1));
             });
         }},
        {"pow", false,
         [&](Builder &b) {
             return trick(b, [](Builder &b, ValueId v) { return pow(b, v, number(b, 2)); });
         }},
        {"division by light", false,
         [&](Builder &b) {
             return trick(b, [](Builder &b, ValueId v) { return div(b, number(b, 1), v); });
         }},
        {"if on light", false,
         [&](Builder &b) {
             return trick(b, [](Builder &b, ValueId v) {
                 return ifElse(
                     b, less(b, v, number(b, 1)),
                     [&] { return Values{unary(b, Op::Sin, input(b, ShaderInput::u))}; },
                     [&] { return Values{v}; })[0];
             });
         }},
        {"luminance", false,
         [&](Builder &b) {
             Values lit = diffuse(b);
             b.setLine(trickLine);
             return Values(colorSamples, add(b, lit[0], add(b, lit[1], lit[2])));
         }},
        {"light scaled from turn to turn", false,
         [](Builder &b) {
             LightRequest request;
             return lightLoop(b, addRequest(b, request), input3(b, ShaderInput::P), {},
                              Values(colorSamples, number(b, 0)),
                              [&](const LoopLight &light, const Values &carried) {
                                  b.setLine(trickLine);
                                  Values next;
                                  for (int k = 0; k < colorSamples; ++k)
                                      next.push_back(
                                          add(b, mul(b, carried[k], number(b, 0.5f)), light.Cl[k]));
                                  return next;
                              });
         }},
        {"lights counted", false,
         [](Builder &b) {
             Values count = gather(b, [&](const Triple &, ValueId) {
                 b.setLine(trickLine);
                 return number(b, 1);
             });
             return count;
         }},
    };
    for (const Case &test : cases) {
        AffineProof proof = proveAffine(surface(test.Ci));
        EXPECT_EQ(proof.affine, test.affine) << test.name;
        EXPECT_EQ(proof.line, test.affine ? 0 : trickLine) << test.name;
    }
}

TEST(Facts, MatteAndGlow) {
    SurfaceFacts facts = surfaceFacts(surface(matte));
    EXPECT_TRUE(facts.hasLoops && facts.readsAmbient && facts.affine && facts.staticRequests);
    EXPECT_TRUE(facts.opaqueIfOsIs1);
    EXPECT_FALSE(facts.emits);
    EXPECT_EQ(facts.cones.size(), 1u);
    SurfaceFacts glow = surfaceFacts(surface([](Builder &b) {
        return each(matte(b), [&](ValueId v) { return add(b, v, number(b, 1)); });
    }));
    EXPECT_TRUE(glow.emits);
}

/// One output plane of Prepare.
struct Prepared {
    explicit Prepared(const Function &whole)
        : function(slice(whole, Question::Prepare)), batch(function, 16, 1) {
        EXPECT_EQ(verify(function), "") << print(function);
        for (int i = 0; i < 16; ++i)
            for (int p = 0; p < 4; ++p) // Ka, Kd, Ks, roughness
                batch.parameters[4 * i + p] = 0.1f * float(p + 1) + 0.01f * float(i);
        planes = batch.run(function, interpret);
    }
    float at(const std::string &name, int component, int lane) const {
        for (std::size_t s = 0; s < function.outputs.size(); ++s)
            if (function.outputs[s].name == name && function.outputs[s].component == component)
                return planes[s][lane];
        ADD_FAILURE() << name;
        return 0;
    }
    float input(ShaderInput plane, int component, int lane) const {
        return batch.inputs[int(plane) + component][lane];
    }
    float parameter(int slot, int lane) const { return batch.parameters[4 * lane + slot]; }

    Function function;
    TestBatch batch;
    std::vector<TestBatch::Plane> planes;
};

TEST(Importance, OfMatteIsItsAlbedoInACosineLobe) {
    Prepared prepared(surface(matte));
    for (int i = 0; i < 16; ++i) {
        float opacity = 0;
        for (int k = 0; k < colorSamples; ++k)
            opacity += luminanceWeights[k] * prepared.input(ShaderInput::Os, k, i);
        float expected = std::max(prepared.parameter(1, i) * opacity, 0.0f);
        EXPECT_NEAR(prepared.at("cone 0 importance", 0, i), expected, 1e-6);
        EXPECT_EQ(prepared.at("cone 0 angle", 0, i), 180);
        EXPECT_EQ(prepared.at("cone 0 exponent", 0, i), 1);
        float cosine = 0, NN = 0;
        for (int c = 0; c < 3; ++c) {
            float N = prepared.input(ShaderInput::N, c, i);
            cosine += prepared.at("cone 0 axis", c, i) * N;
            NN += N * N;
        }
        EXPECT_NEAR(cosine, std::sqrt(NN), 1e-5) << "the axis is N";
        for (int k = 0; k < colorSamples; ++k)
            EXPECT_EQ(prepared.at("Ce", k, i), 0);
    }
}

/// Of a power of the cosine, beside that of the cosine.
float energyOf(float exponent) { return 2 / (std::max(exponent, 0.0f) + 1); }

TEST(Importance, OfPlasticHasAMirroredLobe) {
    Prepared prepared(surface(plastic));
    for (int i = 0; i < 16; ++i) {
        float opacity = 0, colored = 0;
        for (int k = 0; k < colorSamples; ++k) {
            float weighted = luminanceWeights[k] * prepared.input(ShaderInput::Os, k, i);
            opacity += weighted;
            colored += weighted * prepared.input(ShaderInput::Cs, k, i);
        }
        auto clamped = [](float x) { return std::max(x, 0.0f); };
        const float exponent = 0.25f / prepared.parameter(3, i);
        EXPECT_NEAR(prepared.at("cone 0 importance", 0, i),
                    clamped(prepared.parameter(1, i) * colored), 1e-6);
        EXPECT_NEAR(prepared.at("cone 1 importance", 0, i),
                    clamped(prepared.parameter(2, i) * opacity) * energyOf(exponent), 1e-6);
        EXPECT_FLOAT_EQ(prepared.at("cone 1 exponent", 0, i), exponent);
        float NN = 0, NI = 0, II = 0;
        for (int c = 0; c < 3; ++c) {
            float N = prepared.input(ShaderInput::N, c, i),
                  I = prepared.input(ShaderInput::I, c, i);
            NN += N * N, NI += N * I, II += I * I;
        }
        for (int c = 0; c < 3; ++c) {
            float N = prepared.input(ShaderInput::N, c, i),
                  I = prepared.input(ShaderInput::I, c, i);
            float mirrored = (I - 2 * NI / NN * N) / std::sqrt(II);
            EXPECT_NEAR(prepared.at("cone 1 axis", c, i), mirrored, 1e-4);
        }
    }
}

TEST(Importance, FactorsInsideTheLoopCount) {
    Function whole = surface([](Builder &b) {
        return gather(b, [&](const Triple &L, ValueId Cl) {
            ValueId diffuse = mul(b, parameter(b, 1), mul(b, Cl, cosineNL(b, L)));
            ValueId shine = pow(b, cosineNL(b, L), number(b, 20));
            return add(b, diffuse, mul(b, parameter(b, 2), mul(b, Cl, shine)));
        });
    });
    EXPECT_EQ(surfaceFacts(whole).cones.size(), 2u);
    Prepared prepared(whole);
    for (int i = 0; i < 16; ++i) {
        float a = prepared.at("cone 0 importance", 0, i),
              b = prepared.at("cone 1 importance", 0, i);
        EXPECT_NEAR(a * prepared.parameter(2, i) * energyOf(20), b * prepared.parameter(1, i),
                    1e-6);
        EXPECT_EQ(prepared.at("cone 0 exponent", 0, i), 1);
        EXPECT_EQ(prepared.at("cone 1 exponent", 0, i), 20);
    }
}

/// A lobe is exact where no defence is needed: one cosine or power of it that is never negative,
/// and nothing else that depends on the direction.
TEST(Importance, ExactLobesAreTheWholeAnswer) {
    using Term = std::function<ValueId(Builder &, const Triple &, ValueId)>;
    struct Case {
        const char *name;
        bool exact;
        Term term;
    };
    const auto tilted = [](Builder &b, const Triple &L) {
        return dot(b, normalize(b, input3(b, ShaderInput::P)), normalize(b, L));
    };
    const Case cases[] = {
        {"diffuse", true,
         [](Builder &b, const Triple &L, ValueId Cl) { return mul(b, Cl, cosineNL(b, L)); }},
        {"albedo", true,
         [](Builder &b, const Triple &L, ValueId Cl) {
             return mul(b, parameter(b, 1), mul(b, Cl, cosineNL(b, L)));
         }},
        {"another axis, clamped", true,
         [&](Builder &b, const Triple &L, ValueId Cl) {
             return mul(b, Cl, max(b, tilted(b, L), number(b, 0)));
         }},
        {"another axis", false,
         [&](Builder &b, const Triple &L, ValueId Cl) { return mul(b, Cl, tilted(b, L)); }},
        {"a power", true,
         [](Builder &b, const Triple &L, ValueId Cl) {
             return mul(b, Cl, pow(b, max(b, cosineNL(b, L), number(b, 0)), parameter(b, 3)));
         }},
        {"a product of cosines", false,
         [&](Builder &b, const Triple &L, ValueId Cl) {
             return mul(b, Cl, mul(b, cosineNL(b, L), max(b, tilted(b, L), number(b, 0))));
         }},
        {"divided by a cosine", false,
         [](Builder &b, const Triple &L, ValueId Cl) {
             return div(b, mul(b, Cl, cosineNL(b, L)), add(b, number(b, 1), cosineNL(b, L)));
         }},
        {"a step", false,
         [](Builder &b, const Triple &L, ValueId Cl) {
             return mul(b, Cl, mul(b, cosineNL(b, L), sqrt(b, cosineNL(b, L))));
         }},
        {"L stretched", false,
         [](Builder &b, const Triple &L, ValueId Cl) {
             const Triple N = normalize(b, input3(b, ShaderInput::N));
             return mul(b, Cl, dot(b, N, scale(b, normalize(b, L), sub(b, number(b, 0.5f), L[0]))));
         }},
    };
    for (const Case &test : cases) {
        const SurfaceFacts facts = surfaceFacts(surface([&](Builder &b) {
            return gatherAbout(b, normalize(b, input3(b, ShaderInput::N)),
                               [&](const Triple &L, ValueId Cl) { return test.term(b, L, Cl); });
        }));
        ASSERT_EQ(facts.cones.size(), 1u) << test.name;
        EXPECT_EQ(facts.cones[0].exact, test.exact) << test.name;
    }
    EXPECT_FALSE(surfaceFacts(surface([](Builder &b) { return specular(b, parameter(b, 3)); }))
                     .cones[0]
                     .exact);
}

TEST(LightRule, GivesLoopsOnlyToThoseWithout) {
    Function flat = surface([](Builder &b) {
        return each(ambient(b), [&](ValueId v) { return mul(b, parameter(b, 0), v); });
    });
    EXPECT_FALSE(surfaceFacts(applyLightRule(flat, LightRule::Classic)).hasLoops);
    Function gathering = applyLightRule(flat, LightRule::Path);
    EXPECT_EQ(verify(gathering), "") << print(gathering);
    SurfaceFacts facts = surfaceFacts(gathering);
    EXPECT_TRUE(facts.hasLoops && facts.affine && facts.readsAmbient);
    EXPECT_EQ(facts.cones.size(), 1u);
    Function own = surface(matte);
    EXPECT_EQ(print(applyLightRule(own, LightRule::Path)), print(own));
}

TEST(Fold, ControlRelevantParametersVanish) {
    Function whole = surface([](Builder &b) {
        Values shine = ifElse(
            b, less(b, number(b, 0), parameter(b, 2)), [&] { return specular(b, parameter(b, 3)); },
            [&] { return Values(colorSamples, number(b, 0)); });
        return shine;
    });
    EXPECT_EQ(controlRelevantParameters(whole), std::vector<int>{2});
    EXPECT_FALSE(surfaceFacts(fold(whole, {{2, 0.0f}})).hasLoops);
    Function shiny = fold(whole, {{2, 0.5f}});
    EXPECT_TRUE(surfaceFacts(shiny).hasLoops);
    EXPECT_TRUE(controlRelevantParameters(shiny).empty());
}

TEST(Fold, UnrollsShortLoopsThatNoParameterDecides) {
    const auto turning = [](int turns) {
        return surface([&](Builder &b) {
            const Values end =
                loop(b, {boolean(b, true), number(b, 0), number(b, 1)}, [&](const Values &carried) {
                    const ValueId next = add(b, carried[1], number(b, 1));
                    return Values{less(b, next, number(b, float(turns))), next,
                                  mul(b, carried[2], parameter(b, 0))};
                });
            return Values(colorSamples, end[2]);
        });
    };
    const auto hasLoop = [](const Function &f) {
        return anyInstruction(f.body, [](const Instruction &i) { return i.op == Op::Loop; });
    };
    EXPECT_TRUE(hasLoop(turning(6)));
    EXPECT_FALSE(hasLoop(fold(turning(6), {})));
    EXPECT_TRUE(hasLoop(fold(turning(60), {}))) << "long";
}

TEST(Fold, UnrollsLoopsThatAskForLight) {
    Function whole = surface([](Builder &b) {
        Values initial{boolean(b, true), number(b, 0)};
        for (int k = 0; k < colorSamples; ++k)
            initial.push_back(number(b, 0));
        Values end = loop(b, initial, [&](const Values &carried) {
            Values lit = diffuse(b);
            ValueId next = add(b, carried[1], number(b, 1));
            Values yields{less(b, next, parameter(b, 0)), next};
            for (int k = 0; k < colorSamples; ++k)
                yields.push_back(add(b, carried[2 + k], lit[k]));
            return yields;
        });
        return Values(end.begin() + 2, end.end());
    });
    SurfaceFacts before = surfaceFacts(whole);
    EXPECT_FALSE(before.staticRequests);
    EXPECT_EQ(before.notStaticLine, loopLine);
    SurfaceFacts after = surfaceFacts(fold(whole, {{0, 3.0f}}));
    EXPECT_TRUE(after.staticRequests);
    EXPECT_EQ(after.cones.size(), 3u);
}

} // namespace
} // namespace candela::ir
