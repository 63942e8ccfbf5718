// SPDX-License-Identifier: Apache-2.0
// Scenes for tests, without the program around them.
#pragma once

#include "interface/ri/graphics_state.h"
#include "interface/rib/rib_reader.h"
#include "render/shader_folders.h"

#include <functional>
#include <gtest/gtest.h>
#include <string>

namespace candela {

/// look(scene) of the world in `file`, behind requests of the test's own. If there is no file the
/// requests are all.
inline void forScene(const std::string &requests, const std::string &file,
                     const std::function<void(const Scene &)> &look) {
    DiagnosticList diagnostics;
    ErrorPolicy policy(diagnostics);
    ShaderFolders folders =
        shaderFolders(file, {CANDELA_SOURCE_DIR "/tests/determinism/shaders"}, policy);
    ShaderLibrary shaders({folders.all, folders.library, {}}, policy);
    bool seen = false;
    SceneCompiler world(shaders, policy, [&](const Scene &scene) { seen = true, look(scene); });
    GraphicsState state(world, shaders, policy, {});
    RibReader reader(state, policy);
    reader.readText(requests, "requests");
    if (!file.empty())
        reader.readFile(file);
    state.finish();
    EXPECT_TRUE(seen);
}

} // namespace candela
