// SPDX-License-Identifier: Apache-2.0
// For tests: RIB text through reader and graphics state into a listener.
#pragma once

#include "interface/ri/graphics_state.h"
#include "interface/ri/listening_scene_builder.h"
#include "interface/rib/rib_reader.h"

#include <gtest/gtest.h>

namespace candela::testing {

class Reading : public ::testing::Test {
protected:
    ListeningSceneBuilder builder;
    SmallShaderLookup shaders;
    DiagnosticList found;
    GraphicsStateSettings settings;

    void read(const std::string &text) {
        ErrorPolicy policy(found);
        GraphicsState state(builder, shaders, policy, settings);
        RibReader(state, policy).readText(text, "test.rib");
        state.finish();
    }
    /// What one world block with this content holds.
    ListeningSceneBuilder::World world(const std::string &content) {
        read("WorldBegin\n" + content + "\nWorldEnd\n");
        return builder.worlds.back();
    }
    int errors() const { return found.count(Severity::Error); }
    int warnings() const { return found.count(Severity::Warning); }
    bool says(const std::string &text) const {
        return found.text().find(text) != std::string::npos;
    }
};

} // namespace candela::testing
