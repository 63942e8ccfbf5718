// SPDX-License-Identifier: Apache-2.0
// For this room's tests: compiles a text and keeps all that came of it.
#pragma once

#include <string>

#include "language/semantics/front.h"

namespace candela::sl::test {

struct Compiled {
    DiagnosticList diagnostics;
    std::optional<CompiledFront> front;

    explicit Compiled(const std::string &text, const FrontOptions &options = {}) {
        front = analyzeSource({"test.sl", text}, options, diagnostics);
    }

    bool good() const { return front.has_value(); }
    const TypedShader &shader() const { return *front->shaders.at(0); }
    /// The first message, without its source line; "" if there is none.
    std::string firstMessage() const {
        std::string all = diagnostics.text();
        return all.substr(0, all.find('\n'));
    }
    std::string tree() const { return good() ? print(shader()) : diagnostics.text(); }
};

/// The statements in the body of a surface shader with some variables to work with.
inline std::string surfaceWith(const std::string &statements) {
    return "surface s(float p = 1; string name = \"\") {"
           " float f = u; color c = Cs; point q = P; vector w = I; normal n = N; matrix m = 1;"
           " float a[3] = {1, 2, 3};\n" +
           statements + "\n}\n";
}

} // namespace candela::sl::test
