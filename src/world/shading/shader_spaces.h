// SPDX-License-Identifier: Apache-2.0
// The coordinate systems that a shader names, as matrices for its code.
#pragma once

#include "foundation/base/diagnostics.h"
#include "foundation/base/matrix4.h"
#include "language/ir/core/ir.h"

#include <array>
#include <map>
#include <string>
#include <vector>

namespace candela {

class ShaderSpaces {
public:
    /// One of `systems` each; those unknown are identity, with a warning that names the shader.
    void bind(const ir::Function &, const std::string &shader,
              const std::map<std::string, Matrix4> &systems, DiagnosticSink &);
    /// For ShaderArgs::spaces: 32 floats each.
    const float *const *data() const { return pointers_.data(); }

private:
    std::vector<std::array<float, 32>> matrices_;
    std::vector<const float *> pointers_;
};

} // namespace candela
