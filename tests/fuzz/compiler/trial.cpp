// SPDX-License-Identifier: Apache-2.0
#include "trial.h"

#include "chance.h"
#include "shader_trial.h"

#include "language/semantics/front.h"

#include <functional>

namespace candela::fuzz {

namespace {

constexpr int mostMessages = 300;          ///< Errors end at 100; warnings come once a place.
constexpr std::size_t mostBytes = 100'000; ///< As the campaign of whole renders has it.

/// Counts what a user would read.
class Listener : public DiagnosticSink {
public:
    void report(const Diagnostic &diagnostic) override {
        ++messages_;
        bytes_ += format(diagnostic).size() + 1;
        if (diagnostic.severity >= Severity::Error) {
            ++errors_;
            placeless_ |= diagnostic.where.line <= 0;
        }
        if (diagnostic.message.empty())
            empty_ = true;
    }
    /// What is wrong with the messages on a stage that gave a result or gave none.
    std::string judge(bool result) const {
        if (messages_ > mostMessages || bytes_ > mostBytes)
            return "floods the terminal\n" + std::to_string(messages_) + " messages, " +
                   std::to_string(bytes_) + " bytes";
        if (result && errors_ > 0)
            return "is compiled in spite of an error";
        if (!result && errors_ == 0)
            return "is refused without an error";
        if (placeless_)
            return "has an error without a line";
        return empty_ ? "has an empty message" : "";
    }

private:
    int messages_ = 0, errors_ = 0;
    std::size_t bytes_ = 0;
    bool placeless_ = false, empty_ = false;
};

std::vector<ir::StringValue> stringsFor(const sl::TypedShader &shader, Chance &chance) {
    std::vector<ir::StringValue> values;
    const std::vector<std::string> words{"world", "", "%f %s", "hsv", "a&-b", "st"};
    for (const sl::Parameter &parameter : shader.parameters)
        if (parameter.symbol->type.base == sl::BaseType::String && chance.oneIn(2)) {
            values.push_back({parameter.symbol->name, {}});
            for (int n = 0; n < std::max(1, parameter.symbol->type.length); ++n) {
                values.back().value.push_back(chance.pick(words));
                values.back().leftToRunTime.push_back(chance.oneIn(2));
            }
        }
    return values;
}

std::vector<std::string> overriddenIn(const sl::TypedShader &shader, Chance &chance) {
    std::vector<std::string> names;
    for (const sl::Parameter &parameter : shader.parameters)
        if (parameter.symbol->type.base != sl::BaseType::String && chance.oneIn(5))
            names.push_back(parameter.symbol->name);
    return names;
}

std::string tryShader(const sl::TypedShader &shader, Listener &listener, Chance &chance,
                      const TrialSettings &settings, Monitor &monitor) {
    monitor.enter(Stage::Front, "print");
    if (sl::print(shader).empty())
        return "prints as nothing";
    monitor.enter(Stage::Lower, shader.name);
    const auto strings = stringsFor(shader, chance);
    ir::LoweringOptions options;
    if (chance.oneIn(2))
        options.colors = evenBasis(chance.pick(std::array{1, 4, 8}));
    const auto lowered =
        ir::lower(shader, strings, overriddenIn(shader, chance), listener, options);
    if (std::string problem = listener.judge(lowered.has_value()); !problem.empty())
        return problem;
    if (!lowered)
        return {};
    ++monitor.tally().compiled;
    return tryLowered(*lowered, chance, settings, monitor);
}

} // namespace

bool compiles(const std::string &text, const TrialSettings &settings) {
    Listener listener;
    return sl::analyzeSource({"fuzzed.sl", text}, {{settings.includeFolder}, {}}, listener)
        .has_value();
}

std::string tryText(const std::string &text, const TrialSettings &settings, Monitor &monitor) {
    Chance chance(std::hash<std::string>()(text));
    Listener listener;
    monitor.show(text);
    const auto front =
        sl::analyzeSource({"fuzzed.sl", text}, {{settings.includeFolder}, {}}, listener);
    if (std::string problem = listener.judge(front.has_value()); !problem.empty())
        return problem;
    if (!front)
        return {};
    for (const auto &shader : front->shaders) {
        Listener own;
        if (std::string problem = tryShader(*shader, own, chance, settings, monitor);
            !problem.empty())
            return problem;
    }
    return {};
}

} // namespace candela::fuzz
