// SPDX-License-Identifier: Apache-2.0
// For tests: whether the answers to views and responses are those of the whole text, which is asked
// anew for each of them.
#pragma once

#include "language/ir/questions/viewed_batch_test_support.h"

#include <cmath>
#include <gtest/gtest.h>
#include <map>

namespace candela::ir {

class ViewedAnswers {
public:
    using Planes = ViewedBatch::Planes;
    using Run = ViewedBatch::Run;

    /// `ask` answers through the frames, `oracle` what is copied.
    ViewedAnswers(const Function &whole, unsigned seed, Run ask, Run oracle)
        : whole_(whole), seed_(seed), ask_(std::move(ask)), oracle_(std::move(oracle)),
          batch_(whole, seed) {
        const auto plan = makePlan(whole);
        for (const Question question :
             {Question::Surface, Question::View, Question::Prepare, Question::Scatter})
            slices_[question] = slice(*plan, question);
    }

    TestBatch &points() { return batch_.points; }

    void check() {
        batch_.askPoints(slices_[Question::Surface], ask_);
        checkViews(batch_.askViews(slices_[Question::View], ask_));
        checkResponses();
    }

private:
    /// Emission and opacity are the whole text's; all else is Prepare's of each view alone.
    void checkViews(const Planes &viewed) {
        TestBatch copy = batch_.copiedViews();
        const Function &prepare = slices_[Question::Prepare], &view = slices_[Question::View];
        const Planes prepared = copy.run(prepare, oracle_);
        for (std::size_t plane = 0; plane < prepared.size(); ++plane)
            expectSame(batch_.views, viewed[plane], prepared[plane], view.outputs[plane].name);
        copy.answers.givesAmbient = false;
        const Planes dark = copy.run(whole_, oracle_);
        for (int c = 0; c < whole_.colors.samples; ++c) {
            expectSame(batch_.views, plane(view, viewed, OutputKind::Ce, c),
                       plane(whole_, dark, OutputKind::Ci, c), OutputKind::Ce, true);
            expectSame(batch_.views, plane(view, viewed, OutputKind::Oi, c),
                       plane(whole_, dark, OutputKind::Oi, c), OutputKind::Oi, true);
        }
    }

    void checkResponses() {
        const Function &scatter = slices_[Question::Scatter];
        const std::vector<std::int32_t> finite = batch_.responses.answeredRequest;
        expectWholes(batch_.askResponses(scatter, ask_));
        if (whole_.requests.empty())
            return;
        for (std::size_t i = 0; i < finite.size(); ++i)
            batch_.responses.answeredRequest[i] = int(i % whole_.requests.size());
        TestBatch copy = batch_.copiedResponses();
        copy.run(slices_[Question::Prepare], oracle_);
        const Planes expected = copy.run(scatter, oracle_);
        const Planes answered = batch_.askResponses(scatter, ask_);
        for (std::size_t plane = 0; plane < expected.size(); ++plane)
            expectSame(batch_.responses, answered[plane], expected[plane], OutputKind::G);
    }

    /// To the light of one direction, less what there is without.
    void expectWholes(const Planes &answered) {
        TestBatch copy = batch_.copiedResponses();
        const Planes dark = copy.run(whole_, oracle_);
        copy.setSamples(1, seed_);
        for (int c = 0; c < 3; ++c)
            copy.samples.L[std::size_t(c)] =
                copy.inputs[std::size_t(ShaderInput::sampleL) + std::size_t(c)];
        for (TestPlane &Cl : copy.samples.Cl)
            Cl.assign(Cl.size(), 1.0f);
        const Planes lit = copy.run(whole_, oracle_);
        for (int c = 0; c < whole_.colors.samples; ++c) {
            TestPlane gained = plane(whole_, lit, OutputKind::Ci, c);
            const TestPlane &without = plane(whole_, dark, OutputKind::Ci, c);
            for (std::size_t i = 0; i < gained.size(); ++i)
                gained[i] -= without[i];
            expectSame(batch_.responses,
                       plane(slices_[Question::Scatter], answered, OutputKind::G, c), gained,
                       OutputKind::G, true);
        }
    }

    static const TestPlane &plane(const Function &function, const Planes &planes, OutputKind kind,
                                  int component) {
        return planes[std::size_t(slotOf(function.outputs, kind, component))];
    }

    /// Of a whole text numbers alone are compared: what is without light need not be multiplied by
    /// none.
    void expectSame(const TestBatch &lanes, const TestPlane &found, const TestPlane &expected,
                    const OutputName &name, bool ofWhole = false) const {
        for (int lane = 0; lane < lanes.count; ++lane) {
            const float a = found[std::size_t(lane)], b = expected[std::size_t(lane)];
            if (!ViewedBatch::isActive(lanes, lane) || (ofWhole && !std::isfinite(b)))
                continue;
            ASSERT_TRUE(a == b || (std::isnan(a) && std::isnan(b)))
                << whole_.name << ", seed " << seed_ << ": " << name.text() << " of lane " << lane
                << ": " << a << " instead of " << b;
        }
    }

    const Function &whole_;
    unsigned seed_;
    Run ask_, oracle_;
    ViewedBatch batch_;
    std::map<Question, Function> slices_;
};

} // namespace candela::ir
