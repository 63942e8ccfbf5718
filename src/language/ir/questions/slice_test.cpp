// SPDX-License-Identifier: Apache-2.0
// The slices of random texts against the whole text: every answer must be the same, bit by bit.
#include "foundation/base/campaign.h"
#include "language/ir/analyse/control_relevance.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/questions/questions.h"
#include "language/ir/questions/random_text.h"
#include "language/ir/transform/fold.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace candela::ir {
namespace {

constexpr int points = 21;

void expectSame(float got, float expected, const char *what, unsigned seed, int lane) {
    bool same = got == expected || (std::isnan(got) && std::isnan(expected));
    EXPECT_TRUE(same) << what << " of seed " << seed << ", lane " << lane << ": " << got
                      << " instead of " << expected;
}

/// A text with its batch; the whole text's Ci comes out by output name.
struct Subject {
    Subject(unsigned seed, bool dynamic)
        : seed(seed), whole(RandomText(seed, dynamic, colorSamplesOf(seed)).make()),
          batch(whole, points, seed) {
        EXPECT_EQ(verify(whole), "") << seed;
        batch.setSamples(1, seed + 1);
        for (auto &plane : batch.samples.Cl)
            plane.assign(plane.size(), 1.0f);
        for (int c = 0; c < 3; ++c)
            batch.inputs[int(ShaderInput::sampleL) + c] = batch.samples.L[c];
        batch.active = {0xbfff, 0xffff};
        batch.services = testServices(&log);
    }

    std::vector<TestBatch::Plane> shade(const Function &text, int samples, int answered = -1,
                                        bool ambient = false) {
        batch.samples.rows = samples;
        batch.answers.givesTraced = true;
        for (std::size_t p = 0; p < batch.answers.traced.size(); ++p)
            batch.answers.traced[p].assign(batch.padded(),
                                           int(p) / whole.colors.samples == answered ? 1.0f : 0);
        batch.answers.givesAmbient = ambient;
        auto result = batch.run(text, interpret);
        batch.answers.givesAmbient = false;
        return result;
    }

    const Function &slice(Question question) {
        auto [it, isNew] = slices.try_emplace(int(question));
        if (isNew) {
            it->second = ir::slice(whole, question);
            EXPECT_EQ(verify(it->second), "") << seed << "\n" << print(it->second);
        }
        return it->second;
    }

    static int find(const Function &function, const std::string &name, int component) {
        for (std::size_t i = 0; i < function.outputs.size(); ++i)
            if (function.outputs[i].name == name && function.outputs[i].component == component)
                return int(i);
        ADD_FAILURE() << "no output " << name;
        return 0;
    }

    bool isActive(int lane) const { return batch.active[lane / 16] >> (lane % 16) & 1; }

    void expectOutput(const Function &got, const std::vector<TestBatch::Plane> &gotPlanes,
                      const std::string &gotName, const std::vector<TestBatch::Plane> &a,
                      const std::vector<TestBatch::Plane> *minus, const std::string &name) {
        for (int k = 0; k < whole.colors.samples; ++k) {
            auto &plane = gotPlanes[find(got, gotName, k)];
            int from = find(whole, name, k);
            for (int i = 0; i < points; ++i)
                if (isActive(i))
                    expectSame(plane[i], minus ? a[from][i] - (*minus)[from][i] : a[from][i],
                               gotName.c_str(), seed, i);
        }
    }

    void forgetFrame() {
        const Function &prepare = slice(Question::Prepare);
        batch.frames.clear(prepare, batch.padded(), std::numeric_limits<float>::quiet_NaN());
    }

    void checkScatter() {
        auto none = shade(whole, 0);
        const Function &scatter = slice(Question::Scatter);
        batch.answeredRequest.assign(batch.padded(), finiteRequests);
        batch.samples.lightCount = 2;
        batch.samples.categoryAccepts = {0, 1, 0}; // Of the light in each lane.
        for (int i = 0; i < batch.padded(); ++i)
            batch.samples.light.push_back((i + int(seed)) % 3);
        auto lit = shade(whole, 1);
        told();
        expectOutput(scatter, batch.run(scatter, interpret), "g", lit, &none, "Ci");
        EXPECT_TRUE(told().empty()) << "Scatter of seed " << seed;
        batch.samples.light.clear(), batch.samples.categoryAccepts.clear();
        for (int request = 0; request < int(whole.requests.size()); ++request) {
            auto kept = batch.inputs;
            for (int c = 0; c < 3; ++c)
                batch.inputs[int(ShaderInput::sampleL) + c] = batch.inputs[int(ShaderInput::N) + c];
            batch.answeredRequest.assign(batch.padded(), request);
            auto answered = shade(whole, 0, request);
            expectOutput(scatter, batch.run(scatter, interpret), "g", answered, &none, "Ci");
            batch.inputs = kept;
        }
    }

    void checkPrepared(const Function &function, const std::vector<TestBatch::Plane> &planes) {
        auto none = shade(whole, 0);
        expectOutput(function, planes, "Ce", none, nullptr, "Ci");
        expectOutput(function, planes, "Oi", none, nullptr, "Oi");
        if (surfaceFacts(whole).readsAmbient) {
            auto ambient = shade(whole, 0, -1, true);
            expectOutput(function, planes, "Ca", ambient, &none, "Ci");
        }
    }

    /// What has been told since the last time, of the services with effects; only active lanes ask
    /// any.
    std::multiset<LaneAsked> told() {
        std::multiset<LaneAsked> commands;
        for (const LaneAsked &asked : log.lanes) {
            EXPECT_TRUE(isActive(asked.lane)) << "seed " << seed << ", lane " << asked.lane;
            if (asked.service == testNote.name)
                commands.insert(asked);
        }
        log = {};
        return commands;
    }

    unsigned seed;
    Function whole;
    TestBatch batch;
    ServiceLog log;
    std::map<int, Function> slices;
};

void checkQuestions(unsigned seed, bool dynamic) {
    Subject subject(seed, dynamic);
    subject.forgetFrame();
    subject.batch.answers.givesAmbient = true;
    subject.told();
    auto prepared = subject.batch.run(subject.slice(Question::Prepare), interpret);
    const auto said = subject.told();
    subject.batch.answers.givesAmbient = false;
    subject.shade(subject.whole, 0);
    EXPECT_EQ(said, subject.told()) << "Prepare speaks as the text without light, seed " << seed;
    subject.checkPrepared(subject.slice(Question::Prepare), prepared);
    subject.checkScatter();

    subject.forgetFrame();
    subject.told();
    subject.batch.run(subject.slice(Question::Surface), interpret);
    EXPECT_TRUE(subject.told().empty()) << seed;
    subject.batch.answers.givesAmbient = true;
    auto viewed = subject.batch.run(subject.slice(Question::View), interpret);
    EXPECT_EQ(subject.told(), said) << "View speaks for Prepare, seed " << seed;
    subject.batch.answers.givesAmbient = false;
    for (std::size_t p = 0; p < prepared.size(); ++p)
        for (int i = 0; i < points; ++i)
            expectSame(viewed[p][i], prepared[p][i], "View", seed, i);
    subject.checkScatter();

    auto none = subject.shade(subject.whole, 0);
    const Function &emit = subject.slice(Question::Emit);
    subject.expectOutput(emit, subject.batch.run(emit, interpret), "Ce", none, nullptr, "Ci");
    const Function &opacity = subject.slice(Question::Opacity);
    subject.expectOutput(opacity, subject.batch.run(opacity, interpret), "Oi", none, nullptr, "Oi");
    subject.told();
    auto lit = subject.shade(subject.whole, 1);
    const auto saidLit = subject.told();
    const Function &shade = subject.slice(Question::Shade);
    subject.expectOutput(shade, subject.shade(shade, 1), "Ci", lit, nullptr, "Ci");
    EXPECT_EQ(subject.told(), saidLit) << "Shade speaks as the text, seed " << seed;
    const Function silent = silenced(shade);
    subject.expectOutput(silent, subject.shade(silent, 1), "Ci", lit, nullptr, "Ci");
    EXPECT_TRUE(subject.told().empty()) << seed;
}

TEST(Slice, AnswersAsTheWholeTextDoes) {
    for (unsigned seed = 0; seed < 70 * campaignFactor() && !testing::Test::HasFailure(); ++seed)
        checkQuestions(seed, false);
}

TEST(Slice, AnswersWithRequestsInLoops) {
    for (unsigned k = 0; k < 50 * campaignFactor() && !testing::Test::HasFailure(); ++k)
        checkQuestions(1000 + k, true);
}

TEST(Slice, FramesAreUsed) {
    int framed = 0, statics = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        Function whole = RandomText(seed, false).make();
        const Function scatter = slice(whole, Question::Scatter);
        framed += scatter.surfaceSlots > 0 && scatter.viewSlots > 0;
        statics += surfaceFacts(whole).staticRequests;
    }
    EXPECT_GT(statics, 12);
    EXPECT_GT(framed, 12);
}

TEST(Fold, KeepsEveryAnswer) {
    for (unsigned seed = 2000; seed < 2200 && !testing::Test::HasFailure(); ++seed) {
        Subject subject(seed, true);
        std::vector<FoldedValue> values;
        for (int slot : {0, 2}) {
            float value = slot == 0 ? -0.5f : 0.75f;
            values.push_back({slot, value});
            for (int i = 0; i < subject.batch.padded(); ++i)
                subject.batch.parameters[3 * i + slot] = value;
        }
        Function folded = fold(subject.whole, values);
        ASSERT_EQ(verify(folded), "") << seed << print(folded);
        // Unrolling makes new requests.
        while (subject.batch.answers.traced.size() <
               folded.requests.size() * std::size_t(folded.colors.samples))
            subject.batch.answers.traced.push_back(TestBatch::Plane(subject.batch.padded()));
        EXPECT_TRUE(controlRelevantParameters(folded).empty() ||
                    controlRelevantParameters(folded) == std::vector<int>{1});
        auto expected = subject.shade(subject.whole, 1);
        subject.expectOutput(folded, subject.shade(folded, 1), "Ci", expected, nullptr, "Ci");
    }
}

TEST(Slice, OnePlanServesAllQuestions) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        const Function whole = RandomText(seed, seed % 3 == 0).make();
        const auto plan = makePlan(whole);
        for (int question = 0; question < int(Question::Light); ++question)
            EXPECT_EQ(print(slice(*plan, Question(question))),
                      print(slice(whole, Question(question))))
                << seed;
    }
}

} // namespace
} // namespace candela::ir
