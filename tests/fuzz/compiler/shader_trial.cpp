// SPDX-License-Identifier: Apache-2.0
#include "shader_trial.h"

#include "code_trial.h"
#include "filter_trial.h"
#include "runs.h"

#include "language/ir/analyse/control_relevance.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"
#include "language/ir/transform/light_rule.h"

#include <array>
#include <cmath>
#include <map>

namespace candela::fuzz {

namespace {

using ir::Question;

/// A whole text after folding and the light rule, its slices and a batch of points.
class ShaderTrial {
public:
    ShaderTrial(ir::Function whole, Batch batch, sl::ShaderKind kind, Monitor &monitor)
        : whole_(std::move(whole)), batch_(std::move(batch)), kind_(kind),
          isSurface_(kind == sl::ShaderKind::Surface), monitor_(monitor) {}

    std::string slice() {
        if (isSurface_) {
            monitor_.enter(Stage::Facts, "surfaceFacts");
            ir::surfaceFacts(whole_);
        }
        for (const Question question : ir::questionsOf(kind_)) {
            monitor_.enter(Stage::Slice, nameOf(question));
            const ir::Function &function =
                slices_.emplace(question, ir::slice(whole_, question)).first->second;
            if (const std::string problem = ir::verify(function); !problem.empty())
                return "makes an invalid function\n" + problem + "\n" + ir::print(function);
        }
        return {};
    }

    /// The slices answer as the whole text does.
    std::string interpret() {
        monitor_.enter(Stage::Interpret, "whole");
        // Volumes ask for their light, and here nobody answers.
        const Light light = kind_ == sl::ShaderKind::Volume ? Light::None : Light::Given;
        const RunResult lit = batch_.run(whole_, ir::interpret, light);
        countNumbers(lit);
        ++monitor_.tally().interpreted;
        if (!isSurface_)
            return expectOutputs(ir::questionsOf(kind_).front(), light, lit, ownOutputs());
        std::string problem =
            expectOutputs(Question::Shade, Light::Given, lit, {{"Ci", "Ci"}, {"Oi", "Oi"}});
        if (!problem.empty())
            return problem;
        monitor_.enter(Stage::Interpret, "whole, dark");
        const RunResult dark = batch_.run(whole_, ir::interpret, Light::None);
        for (const auto &[question, names] :
             {std::pair<Question, std::vector<Names>>{Question::Emit, {{"Ce", "Ci"}}},
              {Question::Opacity, {{"Oi", "Oi"}}},
              {Question::Prepare, {{"Ce", "Ci"}, {"Oi", "Oi"}}}})
            if (problem.empty())
                problem = expectOutputs(question, Light::None, dark, names);
        return problem;
    }

    /// Code answers as the interpreter does.
    std::string generate(Question question) {
        monitor_.enter(Stage::Interpret, nameOf(question));
        if (question == Question::View)
            batch_.run(slices_.at(Question::Surface), ir::interpret, Light::Given);
        if (question == Question::Scatter)
            batch_.run(slices_.at(Question::Prepare), ir::interpret, Light::Given);
        return compareCode(slices_.at(question), batch_, nameOf(question), monitor_);
    }

    const std::map<Question, ir::Function> &slices() const { return slices_; }

private:
    struct Names {
        const char *slice, *whole;
    };

    /// Those of the kind that the text has.
    std::vector<Names> ownOutputs() const {
        if (kind_ == sl::ShaderKind::Light)
            return {{"L", "L"}, {"Cl", "Cl"}};
        if (kind_ == sl::ShaderKind::Displacement || kind_ == sl::ShaderKind::Transformation)
            return {{"P", "P"}, {"N", "N"}};
        if (kind_ == sl::ShaderKind::Volume)
            return {{"Ci", "Ci"}, {"Oi", "Oi"}};
        return {{"Ci", "Ci"}, {"Oi", "Oi"}, {"alpha", "alpha"}};
    }

    std::string expectOutputs(Question question, Light light, const RunResult &whole,
                              const std::vector<Names> &names) {
        monitor_.enter(Stage::Interpret, nameOf(question));
        const ir::Function &function = slices_.at(question);
        const RunResult found = batch_.run(function, ir::interpret, light);
        if (whole.ended) // Slices run only the loops that they need (docs/compiler-limits.md).
            return {};
        for (const Names &name : names)
            if (const std::string difference =
                    differenceOfOutputs(whole_, whole, name.whole, function, found, name.slice);
                !difference.empty())
                return "slice does not answer as the whole text does\n" + difference;
        return {};
    }

    void countNumbers(const RunResult &run) {
        for (const auto &plane : run.outputs)
            for (const float x : plane) {
                ++monitor_.tally().numbers;
                monitor_.tally().finite += std::isfinite(x) && x != 0 && x != unreached;
            }
    }

    ir::Function whole_;
    Batch batch_;
    sl::ShaderKind kind_;
    bool isSurface_;
    Monitor &monitor_;
    std::map<Question, ir::Function> slices_;
};

std::vector<ir::FoldedValue> controlRelevantValues(const ir::Function &whole, Batch &batch) {
    std::vector<ir::FoldedValue> values;
    for (const int slot : ir::controlRelevantParameters(whole))
        values.push_back({slot, batch.makeEqual(slot)});
    return values;
}

/// Folding changes no answer. Without light: it may number requests anew.
std::string tryFolded(const ir::Function &whole, const ir::Function &folded, Batch &batch,
                      Monitor &monitor) {
    if (const std::string problem = ir::verify(folded); !problem.empty())
        return "folds to an invalid function\n" + problem;
    monitor.enter(Stage::Interpret, "fold");
    batch.fit(whole);
    const RunResult expected = batch.run(whole, ir::interpret, Light::None);
    const std::string difference =
        differenceOf(expected, batch.run(folded, ir::interpret, Light::None));
    return difference.empty() ? "" : "does not answer as before folding\n" + difference;
}

std::string tryUnder(ir::LightRule rule, const ir::LoweredShader &shader, Chance &chance,
                     const TrialSettings &settings, Monitor &monitor) {
    const bool all = settings.thoroughness == Thoroughness::All;
    const bool isSurface = shader.kind == sl::ShaderKind::Surface;
    Batch batch(shader, chance);
    monitor.enter(Stage::Facts, "fold");
    const auto values = controlRelevantValues(shader.whole, batch);
    ir::Function whole = values.empty() ? shader.whole : ir::fold(shader.whole, values);
    if (const std::string problem =
            values.empty() ? "" : tryFolded(shader.whole, whole, batch, monitor);
        !problem.empty())
        return problem;
    if (isSurface) {
        monitor.enter(Stage::Facts, "light rule");
        whole = ir::applyLightRule(whole, rule);
    }
    batch.fit(whole);
    ShaderTrial trial(std::move(whole), std::move(batch), shader.kind, monitor);
    std::string problem = trial.slice();
    if (problem.empty())
        problem = trial.interpret();
    const std::size_t chosen = chance.below(trial.slices().size());
    const bool generates = settings.thoroughness == Thoroughness::Share &&
                           chance.oneIn(std::size_t(settings.generateOneIn));
    std::size_t at = 0;
    for (const auto &slice : trial.slices())
        if (problem.empty() && (all || (generates && at++ == chosen)))
            problem = trial.generate(slice.first);
    return problem;
}

} // namespace

std::string tryLowered(const ir::LoweredShader &shader, Chance &chance,
                       const TrialSettings &settings, Monitor &monitor) {
    if (const std::string problem = ir::verify(shader.whole); !problem.empty())
        return "lowers to an invalid function\n" + problem;
    ir::print(shader.whole);
    if (shader.kind == sl::ShaderKind::Filter)
        return tryFilter(shader, monitor);
    if (settings.thoroughness == Thoroughness::Share)
        return tryUnder(chance.pick(std::array{ir::LightRule::Classic, ir::LightRule::Path}),
                        shader, chance, settings, monitor);
    for (const ir::LightRule rule : {ir::LightRule::Classic, ir::LightRule::Path})
        if (std::string problem = tryUnder(rule, shader, chance, settings, monitor);
            !problem.empty())
            return problem;
    return {};
}

} // namespace candela::fuzz
