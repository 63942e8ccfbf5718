// SPDX-License-Identifier: Apache-2.0
// Named coordinate systems.
#pragma once

#include "language/ir/core/builder.h"
#include "language/ir/lower/messages.h"

#include <optional>
#include <string>

namespace candela::ir {

struct SpaceMatrices {
    Matrix toCurrent, fromCurrent; ///< currentFromSpace and spaceFromCurrent.
};

class Spaces {
public:
    Spaces(Builder &b, Messages &messages) : b_(b), messages_(messages) {}

    /// For default values, which are evaluated where "current" is unknown: from now on "shader" is
    /// the identity and other spaces are refused.
    void allowShaderOnly() { onlyShader_ = true; }
    bool isShaderOnly() const { return onlyShader_; }
    void refuse(const std::string &name, const sl::Place &);

    /// Nothing for the identity.
    std::optional<SpaceMatrices> find(const std::string &name, const sl::Place &);

private:
    Builder &b_;
    Messages &messages_;
    bool onlyShader_ = false;
    int shaderSlot_ = -1; ///< Of the hidden parameter; -1 as long as none asks.
};

} // namespace candela::ir
