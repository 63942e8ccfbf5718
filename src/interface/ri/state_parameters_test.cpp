// SPDX-License-Identifier: Apache-2.0
// Every parameter of our own, right, misspelt in its name, and wrong in its value.
#include "interface/ri/state_parameters.h"

#include "interface/ri/graphics_state_fixture.h"

#include <fmt/format.h>

namespace candela::testing {
namespace {

using Rule = StateParameter::Rule;

class OwnParameter : public State, public ::testing::WithParamInterface<StateParameter> {
protected:
    StateParameter row = GetParam();

    TokenList value(const std::string &name, const std::string &word, float number) const {
        const Declaration type = parseDeclaration(row.type).value_or(Declaration{});
        const std::string token = textOf(type) + " " + name;
        const auto count = std::size_t(type.components());
        if (type.type == ValueType::String)
            return {{{token, {}, {}, Strings(count, word)}}};
        return numbers(token, Floats(count, number));
    }
    void give(const std::string &category, const TokenList &tokens) {
        row.request == "Option" ? state.option(at, category, tokens)
                                : state.attribute(at, category, tokens);
    }
    std::string firstValue() const {
        return std::string(row.values.substr(0, row.values.find('|')));
    }
    std::string name() const { return row.name == "*" ? "anything" : std::string(row.name); }
};

TEST_P(OwnParameter, isTakenInSilence) {
    give(std::string(row.category), value(name(), firstValue(), float(row.most)));
    EXPECT_EQ(found.text(), "");
    if (row.type == "any")
        return;
    // Declared by nobody but the table.
    TokenList tokens = value(name(), firstValue(), float(row.most));
    tokens.all.front().token = name();
    give(std::string(row.category), tokens);
    EXPECT_EQ(found.text(), "");
}

TEST_P(OwnParameter, isSuggestedWhereItIsMisspelt) {
    if (row.rule == Rule::Foreign || row.name == "*")
        return;
    const std::string wrong = name() + "x";
    give(std::string(row.category), value(wrong, firstValue(), float(row.most)));
    give(std::string(row.category), value(wrong, firstValue(), float(row.most)));
    EXPECT_EQ(warnings(), 1) << "once";
    EXPECT_TRUE(says(fmt::format("there is no \"{}\" \"{}\"; did you mean '", row.category, wrong)))
        << found.text();
    EXPECT_EQ(errors(), 0);
}

TEST_P(OwnParameter, ofAMisspeltCategoryIsWarnedAbout) {
    if (row.rule == Rule::Foreign || row.name == "*")
        return;
    const std::string wrong = std::string(row.category) + "x";
    give(wrong, value(name(), firstValue(), float(row.most)));
    EXPECT_TRUE(says(fmt::format("; did you mean '{}'?", row.category))) << found.text();
}

TEST_P(OwnParameter, isRefusedWhereItsValueIsNone) {
    if (row.rule == Rule::Choice) {
        give(std::string(row.category), value(name(), "nonsense", 0));
        EXPECT_TRUE(says(fmt::format("one of \"{}\"", firstValue()))) << found.text();
        EXPECT_TRUE(says("and not \"nonsense\"")) << found.text();
        EXPECT_EQ(errors(), 1);
        std::string loud = firstValue();
        std::ranges::transform(loud, loud.begin(), [](unsigned char c) { return std::toupper(c); });
        give(std::string(row.category), value(name(), loud, 0));
        EXPECT_EQ(errors(), 1) << "letters of any case";
    }
    if (row.rule == Rule::Number && row.most < 1e29) {
        for (const double wrong : {row.least - std::abs(row.least) - 1, row.most * 2})
            give(std::string(row.category), value(name(), "", float(wrong)));
        give(std::string(row.category), value(name(), "", std::nanf("")));
        EXPECT_GE(errors(), 2) << found.text();
        EXPECT_TRUE(says("a number from")) << found.text();
    }
}

std::vector<StateParameter> rows() {
    const auto all = stateParameters();
    return {all.begin(), all.end()};
}

INSTANTIATE_TEST_SUITE_P(Table, OwnParameter, ::testing::ValuesIn(rows()), [](const auto &info) {
    std::string name = fmt::format("{}_{}_{}", info.param.request, info.param.category,
                                   info.param.name == "*" ? "any" : info.param.name);
    return name;
});

TEST_F(State, parametersOfTheOtherRequestAreNamed) {
    state.attribute(at, "radiometry", text("string units", "si"));
    EXPECT_TRUE(says("there is no \"radiometry\" \"units\"; it belongs to Option")) << found.text();
}

TEST_F(State, parametersOfCategoriesThatNobodyKnowsAreTakenInSilence) {
    state.option(at, "studio", text("string pipeline", "v2"));
    state.attribute(at, "limits", text("string neverheardof", "x"));
    EXPECT_EQ(found.text(), "");
}

TEST_F(State, choicesAreSpeltAsTheTableHasThem) {
    state.option(at, "radiometry", text("units", "SI"));
    light("a");
    state.worldBegin(at);
    EXPECT_EQ(builder.worlds[0].lights[0]->units, LightUnits::Si);
    EXPECT_EQ(found.text(), "");
}

} // namespace
} // namespace candela::testing
