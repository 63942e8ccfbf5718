// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/print_format.h"
#include "language/ir/interpret/interpreter.h"

#include "language/ir/core/builder.h"
#include "language/ir/interpret/test_batch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela::ir {
namespace {

/// Sum over light of Cl (N.L), unnormalised.
Function lightSum(ConeForm form, const Values &extra, int category = -1) {
    Function function;
    function.categories = {"key"};
    Builder b(function);
    LightRequest request;
    request.form = form;
    request.coneCount = form == ConeForm::Everywhere ? 0 : 1;
    request.category = category;
    int index = addRequest(b, request);
    Values cones;
    const Triple N = input3(b, ShaderInput::N);
    const Triple axis = form == ConeForm::Classic ? normalize(b, N) : N;
    if (form != ConeForm::Everywhere)
        cones.insert(cones.end(), axis.begin(), axis.end());
    for (ValueId v : extra)
        cones.push_back(number(b, float(v)));
    auto sum = lightLoop(b, index, input3(b, ShaderInput::P), cones, {number(b, 0)},
                         [&](const LoopLight &light, const Values &carried) {
                             ValueId cosine = dot(b, input3(b, ShaderInput::N), light.L);
                             return Values{add(b, carried[0], mul(b, light.Cl[0], cosine))};
                         });
    output(b, "Ci", 0, sum[0]);
    b.finish();
    EXPECT_EQ(verify(function), "");
    return function;
}

float cosineNL(const TestBatch &batch, int lane, int row) {
    float sum = 0;
    for (int c = 0; c < 3; ++c)
        sum += batch.inputs[int(ShaderInput::N) + c][lane] *
               batch.samples.L[c][row * batch.padded() + lane];
    return sum;
}

TEST(Interpreter, SumsLightOverSamples) {
    Function function = lightSum(ConeForm::Everywhere, {});
    TestBatch batch(function, 21, 1);
    batch.setSamples(3, 2);
    auto out = batch.run(function, interpret);
    for (int i = 0; i < batch.count; ++i) {
        float expected = 0;
        for (int s = 0; s < 3; ++s)
            expected += batch.samples.Cl[0][s * batch.padded() + i] * cosineNL(batch, i, s);
        EXPECT_FLOAT_EQ(out[0][i], expected);
    }
    EXPECT_EQ(out[0][21], 0) << "padding is left alone";
}

TEST(Interpreter, ClassicLoopsCullOutsideTheirCone) {
    Function function = lightSum(ConeForm::Classic, {1}); // Half angle 1 radian.
    TestBatch batch(function, 64, 3);
    batch.setSamples(1, 4);
    auto out = batch.run(function, interpret);
    int inside = 0;
    for (int i = 0; i < 64; ++i) {
        float NN = 0, LL = 0;
        for (int c = 0; c < 3; ++c) {
            NN += std::pow(batch.inputs[int(ShaderInput::N) + c][i], 2.0f);
            LL += std::pow(batch.samples.L[c][i], 2.0f);
        }
        bool accepted = cosineNL(batch, i, 0) / std::sqrt(NN * LL) >= std::cos(1.0f);
        inside += accepted;
        EXPECT_EQ(out[0][i] != 0, accepted);
    }
    EXPECT_GT(inside, 4);
    EXPECT_LT(inside, 60);
}

TEST(Interpreter, CategoriesAndMasks) {
    Function function = lightSum(ConeForm::Everywhere, {}, 0);
    TestBatch batch(function, 32, 5);
    batch.setSamples(1, 6);
    batch.samples.lightCount = 1;
    batch.samples.categoryAccepts = {0, 1}; // Light 1 speaks, indirect light does not.
    batch.samples.light.assign(batch.padded(), 0);
    for (int i = 0; i < 32; i += 2)
        batch.samples.light[i] = 1;
    batch.active = {0xffff, 0x00ff};
    auto out = batch.run(function, interpret, 7);
    for (int i = 0; i < 32; ++i) {
        if (i >= 24)
            EXPECT_EQ(out[0][i], 7) << "inactive lanes keep their outputs";
        else
            EXPECT_EQ(out[0][i] != 0, i % 2 == 0);
    }
}

TEST(Interpreter, DeltaRequestsTakeTheirAnswer) {
    Function function = lightSum(ConeForm::Extended, {0, 1, 1}); // Angle 0.
    TestBatch batch(function, 16, 7);
    batch.setSamples(2, 8);
    batch.answers.givesTraced = true;
    auto out = batch.run(function, interpret);
    for (int i = 0; i < 16; ++i) {
        float NN = 0;
        for (int c = 0; c < 3; ++c)
            NN += std::pow(batch.inputs[int(ShaderInput::N) + c][i], 2.0f);
        EXPECT_FLOAT_EQ(out[0][i], batch.answers.traced[0][i] * NN);
    }
}

TEST(Interpreter, LoopsArraysFramesAndPrinting) {
    Function function;
    function.surfaceSlots = 1, function.viewSlots = 2;
    Builder b(function);
    int array = addArray(b, Type::Float, 4);
    auto truth = boolean(b, true);
    auto result = loop(b, {truth, number(b, 0)}, [&](const Values &carried) {
        ValueId index = unary(b, Op::IntegerFromFloat, carried[1]);
        arrayStore(b, array, index, mul(b, carried[1], carried[1]));
        ValueId next = add(b, carried[1], number(b, 1));
        return Values{less(b, next, number(b, 6)), next};
    });
    b.emit(Op::FrameStore, {less(b, number(b, 0), input(b, ShaderInput::u))}, 2);
    output(b, "a", 0, arrayLoad(b, array, integer(b, 2)));
    output(b, "last", 0, arrayLoad(b, array, integer(b, 99)));
    output(b, "n", 0, result[1]);
    printValues(b, "n = %f, %c!", {result[1], number(b, 1), number(b, 2), number(b, 3)});
    b.finish();
    ASSERT_EQ(verify(function), "") << print(function);
    TestBatch batch(function, 17, 9);
    std::vector<std::string> lines;
    batch.services.context = &lines;
    batch.services[Service::print] = [](void *context, const ServiceCall &call) {
        static_cast<std::vector<std::string> *>(context)->push_back(printedText(call, 0));
    };
    auto out = batch.run(function, interpret);
    for (int i = 0; i < 17; ++i) {
        EXPECT_EQ(out[0][i], 4);
        EXPECT_EQ(out[1][i], 25) << "indices outside are clamped";
        EXPECT_EQ(out[2][i], 6);
        float u = batch.inputs[int(ShaderInput::u)][i];
        EXPECT_EQ(batch.frames.view[frameIndex(i, 1, 2)], u > 0 ? 1.0f : 0.0f);
    }
    ASSERT_EQ(lines.size(), 17u);
    EXPECT_EQ(lines[0], "n = 6.000000, 1.000000 2.000000 3.000000!");
}

TEST(Interpreter, RandomNumbersDifferByCallAndSeed) {
    Function function;
    Builder b(function);
    output(b, "r", 0, random(b, number(b, 0)));
    output(b, "r", 1, random(b, number(b, 0)));
    b.finish();
    TestBatch batch(function, 1000, 10);
    auto out = batch.run(function, interpret);
    double mean = 0;
    for (int i = 0; i < 1000; ++i) {
        ASSERT_GE(out[0][i], 0);
        ASSERT_LT(out[0][i], 1);
        EXPECT_NE(out[0][i], out[1][i]);
        mean += out[0][i] / 1000;
    }
    EXPECT_NEAR(mean, 0.5, 0.05);
}

} // namespace
} // namespace candela::ir
