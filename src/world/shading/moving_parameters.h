// SPDX-License-Identifier: Apache-2.0
// Parameter blocks of a batch, each at the time of its lane.
#pragma once

#include "foundation/base/shutter.h"
#include "world/shading/shader_code.h"

#include <cstdint>
#include <vector>

namespace candela {

/// The table that a batch reads its parameters from where some of them change with time. Kept by
/// whoever keeps the batch.
class MovingParameters {
public:
    /// Makes the table for lanes of the code with these blocks, at these times; `active` as in
    /// ShaderArgs, null = all. Nothing is done, and nothing kept, where none of them change.
    void take(const ShaderCode &, const Shutter &, int count, const std::int32_t *parameterOffset,
              const float *time, const std::uint16_t *active = nullptr);
    /// Lets the arguments, which ShaderCode::bind() has filled, read it.
    void bind(ShaderArgs &) const;

private:
    std::vector<float> table_;
    std::vector<std::int32_t> offsets_; ///< Empty: parameters stand where the code has them.
};

} // namespace candela
