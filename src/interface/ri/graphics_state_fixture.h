// SPDX-License-Identifier: Apache-2.0
// For tests: a graphics state that is told requests by hand.
#pragma once

#include "interface/ri/graphics_state.h"
#include "interface/ri/listening_scene_builder.h"

#include <gtest/gtest.h>

namespace candela::testing {

class State : public ::testing::Test {
protected:
    ListeningSceneBuilder builder;
    SmallShaderLookup shaders;
    DiagnosticList found;
    ErrorPolicy policy{found};
    GraphicsState state{builder, shaders, policy};
    SourceLocation at;

    static TokenList numbers(const std::string &token, Floats values) {
        return {{{token, {}, std::move(values), {}}}};
    }
    static TokenList text(const std::string &token, const std::string &value) {
        return {{{token, {}, {}, {value}}}};
    }
    void sphere(const TokenList &tokens = {}) { state.sphere(at, 1, -1, 1, 360, tokens); }
    void triangle(Floats points = {0, 0, 0, 1, 0, 0, 0, 1, 0}) {
        state.polygon(at, numbers("P", std::move(points)));
    }
    void light(const std::string &handle) { state.lightSource(at, "pointlight", {handle}, {}); }

    const auto &primitives() const { return builder.worlds.back().primitives; }
    const Attributes &last() const { return *primitives().back().attributes; }
    int errors() const { return found.count(Severity::Error); }
    int warnings() const { return found.count(Severity::Warning); }
    bool says(const std::string &words) const {
        return found.text().find(words) != std::string::npos;
    }
};

} // namespace candela::testing
