// SPDX-License-Identifier: Apache-2.0
// Lights that do nothing, or not what their users may expect.
#pragma once

#include "world/scene/scene.h"

namespace candela {

class LightWarnings {
public:
    explicit LightWarnings(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {}

    /// Warns of lights that are on for no shape, and of area lights around none. Notes, once, that
    /// lights cast no shadows under `classic` unless they are told to.
    void look(const Scene &);

private:
    DiagnosticSink &diagnostics_;
    bool hasSpokenOfShadows_ = false;
};

} // namespace candela
