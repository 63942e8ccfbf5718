// SPDX-License-Identifier: Apache-2.0
// Who asks services when a text is sliced: what costs is asked once a point and saved, what has
// effects happens once, and conditions of every binding time are waited for.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_services.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/questions/questions.h"

#include <gtest/gtest.h>

#include <map>

namespace candela::ir {
namespace {

constexpr int points = 21;

/// Asks and notes in all places; see Expected.
Function text() {
    Function function;
    function.name = "asking";
    Builder b(function);
    const Triple N = input3(b, ShaderInput::N), I = input3(b, ShaderInput::I);
    const auto negative = [&](ValueId v) { return less(b, v, number(b, 0)); };
    const auto ask = [&](const char *name, ValueId with) {
        return query(b, testSample, {name}, {with, N[1]}, 2)[1];
    };
    const auto note = [&](const char *name) { command(b, testNote, {name}, {N[0], I[2]}); };
    const auto where = [&](ValueId condition, const auto &then) {
        return ifElse(
            b, condition, [&] { return Values{then()}; }, [&] { return Values{number(b, 1)}; })[0];
    };
    ValueId factor = ask("top", N[0]);
    note("top note");
    const auto times = [&](ValueId more) { factor = mul(b, factor, more); };
    times(where(negative(N[0]), [&] { return ask("surface if", N[2]); }));
    times(where(negative(I[0]), [&] {
        note("view if note");
        const ValueId outer = ask("view if", N[2]);
        return mul(b, outer, where(negative(N[0]), [&] { return ask("surface in view", N[1]); }));
    }));
    const ValueId zero = number(b, 0);
    times(loop(b, {boolean(b, true), zero, zero}, [&](const Values &carried) {
        note("turn note");
        const ValueId next = add(b, carried[1], number(b, 1));
        return Values{less(b, next, number(b, 2)), next,
                      add(b, carried[2], ask("turn", add(b, carried[1], N[0])))};
    })[2]);
    const Values lit =
        lightLoop(b, addRequest(b, {}), input3(b, ShaderInput::P), {}, {zero, zero, zero},
                  [&](const LoopLight &light, const Values &carried) {
                      note("light note");
                      const ValueId weight =
                          mul(b, ask("light", light.L[0]), ask("in the light", N[2]));
                      Values sums;
                      for (std::size_t k = 0; k < 3; ++k)
                          sums.push_back(add(b, carried[k], mul(b, light.Cl[k], weight)));
                      return sums;
                  });
    for (int k = 0; k < 3; ++k) {
        output(b, "Ci", k, mul(b, lit[std::size_t(k)], factor));
        output(b, "Oi", k, input(b, ShaderInput::Os, k));
    }
    b.finish();
    EXPECT_EQ(verify(function), "") << print(function);
    return function;
}

struct Subject {
    Subject() : whole(text()), batch(whole, points, 3) {
        batch.active = {0xbff5, 0xfffd};
        batch.setSamples(1, 4);
        for (int c = 0; c < 3; ++c)
            batch.inputs[std::size_t(ShaderInput::sampleL) + std::size_t(c)] =
                batch.samples.L[std::size_t(c)];
    }
    bool runs(int lane) const {
        return lane < points && batch.active[std::size_t(lane / 16)] >> lane % 16 & 1;
    }
    bool negative(ShaderInput input, int lane) const {
        return batch.inputs[std::size_t(input)][std::size_t(lane)] < 0;
    }
    /// How often a lane comes there in a text that is run in order.
    int comes(const std::string &where, int lane) const {
        const bool N = negative(ShaderInput::N, lane), I = negative(ShaderInput::I, lane);
        if (where == "surface if")
            return N;
        if (where == "view if" || where == "view if note")
            return I;
        if (where == "surface in view")
            return I && N;
        return where == "turn" || where == "turn note" ? 2 : 1;
    }
    ServiceLog ask(Question question) {
        const Function function = slice(whole, question);
        EXPECT_EQ(verify(function), "") << print(function);
        ServiceLog log;
        batch.services = testServices(&log);
        batch.run(function, interpret);
        return log;
    }
    /// What is `asked`, as often as lanes come there, and nothing else.
    void expect(const ServiceLog &log, const std::set<std::string> &asked, const char *what) {
        std::size_t sum = 0;
        for (const std::string &where : asked)
            for (int lane = 0; lane < batch.padded(); ++lane) {
                const int expected = runs(lane) ? comes(where, lane) : 0;
                EXPECT_EQ(log.count(where, lane), expected)
                    << what << ": " << where << ", lane " << lane;
                sum += std::size_t(expected);
            }
        EXPECT_EQ(log.lanes.size(), sum) << what;
    }

    Function whole;
    TestBatch batch;
};

const std::set<std::string> surfaceQueries{"top", "surface if", "turn"},
    viewQueries{"view if", "surface in view"}, lightQueries{"light", "in the light"},
    notes{"top note", "view if note", "turn note"};

std::set<std::string> together(const std::vector<std::set<std::string>> &sets) {
    std::set<std::string> all;
    for (const auto &set : sets)
        all.insert(set.begin(), set.end());
    return all;
}

TEST(ServiceSlices, PrepareAsksOnceAndScatterForItsDirectionAlone) {
    Subject subject;
    subject.expect(subject.ask(Question::Prepare), together({surfaceQueries, viewQueries, notes}),
                   "Prepare");
    for (int direction = 0; direction < 2; ++direction)
        subject.expect(subject.ask(Question::Scatter), lightQueries, "Scatter");
}

TEST(ServiceSlices, SurfaceAsksWhatNoViewChangesAndViewTheRest) {
    Subject subject;
    subject.expect(subject.ask(Question::Surface), surfaceQueries, "Surface");
    for (int view = 0; view < 2; ++view)
        subject.expect(subject.ask(Question::View), together({viewQueries, notes}), "View");
    subject.expect(subject.ask(Question::Scatter), lightQueries, "Scatter");
}

TEST(ServiceSlices, WholeTextsAskInOrder) {
    Subject subject;
    const auto queries = together({surfaceQueries, viewQueries, lightQueries});
    const auto all = together({queries, notes, {"light note"}});
    subject.expect(subject.ask(Question::Shade), all, "Shade");
    subject.expect(subject.ask(Question::Opacity), {}, "Opacity");
    ServiceLog log;
    subject.batch.services = testServices(&log);
    subject.batch.run(subject.whole, interpret);
    subject.expect(log, all, "whole");
    log = {};
    subject.batch.run(silenced(slice(subject.whole, Question::Shade)), interpret);
    subject.expect(log, queries, "Shade, silenced");
}

} // namespace
} // namespace candela::ir
