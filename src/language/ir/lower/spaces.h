// SPDX-License-Identifier: Apache-2.0
// Named coordinate systems.
#pragma once

#include "language/ir/core/builder.h"
#include "language/ir/lower/messages.h"
#include "language/syntax/base_type.h"

#include <optional>
#include <string>

namespace candela::ir {

struct SpaceMatrices {
    Matrix toCurrent, fromCurrent; ///< currentFromSpace and spaceFromCurrent.
};

class Spaces {
public:
    /// Filters and imagers run on pictures, where spaces are taken for "current"; that of imagers
    /// is "raster", and they know "NDC".
    Spaces(Builder &b, Messages &messages, sl::ShaderKind kind)
        : b_(b), messages_(messages),
          onPicture_(kind == sl::ShaderKind::Filter || kind == sl::ShaderKind::Imager),
          inImager_(kind == sl::ShaderKind::Imager) {}

    /// For default values, which are evaluated where "current" is unknown: from now on "shader" is
    /// the identity and other spaces are refused.
    void allowShaderOnly() { onlyShader_ = true; }
    bool isShaderOnly() const { return onlyShader_; }
    void refuse(const std::string &name, const sl::Place &);

    /// Nothing for the identity. The space "depth" is camera space with z from 0 at the near to 1
    /// at the far clipping plane.
    std::optional<SpaceMatrices> find(const std::string &name, const sl::Place &);

private:
    SpaceMatrices frame();

    Builder &b_;
    Messages &messages_;
    bool onPicture_, inImager_;
    bool onlyShader_ = false;
    int shaderSlot_ = -1; ///< Of the hidden parameter; -1 as long as none asks.
};

} // namespace candela::ir
