// SPDX-License-Identifier: Apache-2.0
// Which lights a shader's loops hear: illuminance() and its like may name categories, and lights
// are in some. Known once all lights are declared.
#pragma once

#include "language/ir/core/ir.h"
#include "language/runtime/shader_abi.h"

#include <cstdint>
#include <vector>

namespace candela {

class LightCategories {
public:
    LightCategories() = default;
    explicit LightCategories(const std::vector<ir::LightRequest> &);

    /// `accepts[category][light + 1]`, row by row, in the shader's category order.
    void bind(std::vector<std::uint8_t> accepts, int lightCount);
    /// No light is heard as indirect light: shadow rays may find what other rays do not.
    void leaveLightsToSamples(int lightCount);
    /// False if every loop refuses the light (index + 1): the shader need not be asked about it.
    bool hears(std::int32_t light) const;
    /// True if all loops treat the light (index + 1, 0 = indirect) as they treat indirect light.
    /// If not, only samples that name the light can bring it.
    bool hearsAsIndirect(std::int32_t light) const {
        return hearsAsIndirect_.empty() || hearsAsIndirect_[light] != 0;
    }
    bool hearsAllAsIndirect() const { return hearsAsIndirect_.empty(); }

    /// Fills what the loops ask.
    void bind(ShaderArgs &) const;

private:
    std::vector<int> loops_;                    ///< The category of each; -1 = all.
    std::vector<std::uint8_t> accepts_;         ///< Empty: everything.
    std::vector<std::uint8_t> hearsAsIndirect_; ///< By light + 1; empty = all of them.
    int lightCount_ = 0;
};

} // namespace candela
