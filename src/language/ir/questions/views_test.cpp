// SPDX-License-Identifier: Apache-2.0
// One surface frame, many views of it, many responses a view: by the interpreter, and what of the
// frames each question touches.
#include "foundation/base/campaign.h"
#include "language/ir/core/regions.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/questions/random_text.h"
#include "language/ir/questions/viewed_answers_test_support.h"

#include <gtest/gtest.h>

namespace candela::ir {
namespace {

TEST(Views, AnswerAsTheWholeTextDoes) {
    for (unsigned seed = 0; seed < 40 * campaignFactor() && !testing::Test::HasFailure(); ++seed) {
        const Function whole = RandomText(seed, seed % 4 == 0, colorSamplesOf(seed)).make();
        ViewedAnswers(whole, seed, interpret, interpret).check();
    }
}

TEST(Questions, TouchTheFramesThatTheirRowsName) {
    std::map<std::pair<Question, BindingTime>, int> loads, saves;
    for (unsigned seed = 0; seed < 60; ++seed) {
        const auto plan = makePlan(RandomText(seed, false).make());
        for (const Question question : questionsOf(sl::ShaderKind::Surface)) {
            const Function function = slice(*plan, question);
            forEachInstruction(function.body, [&](const Instruction &i) {
                const BindingTime frame = spillSlot(function, i.immediate).frame;
                if (i.op == Op::FrameLoad)
                    ++loads[{question, frame}];
                if (i.op == Op::FrameStore)
                    ++saves[{question, frame}];
            });
        }
    }
    for (const Question question : questionsOf(sl::ShaderKind::Surface))
        for (const BindingTime frame : {BindingTime::Surface, BindingTime::View}) {
            const std::pair key(question, frame);
            EXPECT_EQ(loads[key] > 0, uses(framesReadBy(question), frame)) << nameOf(question);
            EXPECT_EQ(saves[key] > 0, uses(framesWrittenBy(question), frame)) << nameOf(question);
        }
}

TEST(Questions, AreAboutPointsViewsOrResponses) {
    for (int q = 0; q < questionCount; ++q) {
        const auto expected = Question(q) == Question::Scatter ? BindingTime::Response
                              : Question(q) == Question::View  ? BindingTime::View
                                                               : BindingTime::Surface;
        EXPECT_EQ(lanesOf(Question(q)), expected) << nameOf(Question(q));
    }
}

/// What is needed at the point alone is computed there: noise is not asked for again.
TEST(Views, DoNotReadWhatTheSurfaceAloneNeeds) {
    Function whole;
    Builder b(whole);
    const Triple P = input3(b, ShaderInput::P), I = input3(b, ShaderInput::I);
    const ValueId pattern = callRuntime(b, 2, {P[0], P[1], P[2]})[0];
    for (int c = 0; c < 3; ++c) {
        output(b, "Ci", c, mul(b, pattern, unary(b, Op::Sin, I[0])));
        output(b, "Oi", c, number(b, 1));
    }
    b.finish();
    const auto plan = makePlan(whole);
    const auto reads = [&](Question question, ShaderInput plane) {
        return bool(slice(*plan, question).inputsRead[std::size_t(plane)]);
    };
    EXPECT_TRUE(reads(Question::Surface, ShaderInput::P));
    EXPECT_FALSE(reads(Question::Surface, ShaderInput::I));
    EXPECT_FALSE(reads(Question::View, ShaderInput::P));
    EXPECT_TRUE(reads(Question::View, ShaderInput::I));
    EXPECT_FALSE(reads(Question::Scatter, ShaderInput::P));
    EXPECT_FALSE(reads(Question::Scatter, ShaderInput::I));
    EXPECT_EQ(slice(*plan, Question::View).surfaceSlots, 1);
    EXPECT_EQ(slice(*plan, Question::View).viewSlots, 0);
}

} // namespace
} // namespace candela::ir
