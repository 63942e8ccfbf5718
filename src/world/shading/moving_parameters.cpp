// SPDX-License-Identifier: Apache-2.0
#include "world/shading/moving_parameters.h"

#include "language/runtime/shader_abi.h"

#include <algorithm>

namespace candela {

void MovingParameters::take(const ShaderCode &code, const Shutter &shutter, int count,
                            const std::int32_t *parameterOffset, const float *time,
                            const std::uint16_t *active) {
    offsets_.clear();
    if (!code.hasMotion())
        return;
    const auto isActive = [active](int i) {
        return !active || active[i / laneBlock] >> i % laneBlock & 1;
    };
    bool moves = false;
    for (int i = 0; i < count && !moves; ++i)
        moves = isActive(i) && code.stepsOf(parameterOffset[i]) > 1;
    if (!moves)
        return;
    const std::size_t slots = code.shader().whole.parameters.size();
    offsets_.assign(std::size_t(paddedLanes(count)), 0);
    table_.resize(slots * std::size_t(count));
    for (int i = 0; i < count; ++i) {
        if (!isActive(i))
            continue;
        const auto lane = std::size_t(i);
        offsets_[lane] = std::int32_t(slots * lane);
        float *to = table_.data() + slots * lane;
        const int steps = code.stepsOf(parameterOffset[i]);
        const auto block = [&](int step) {
            return code.block(parameterOffset[i] + std::int32_t(slots) * step);
        };
        if (steps == 1) {
            std::ranges::copy(block(0), to);
            continue;
        }
        const float place = shutter.share(time[i]) * float(steps - 1);
        const int step = std::min(int(place), steps - 2);
        const std::span<const float> before = block(step), after = block(step + 1);
        const float share = place - float(step), rest = 1 - share;
        for (std::size_t slot = 0; slot < slots; ++slot)
            to[slot] = before[slot] == after[slot] ? before[slot]
                                                   : before[slot] * rest + after[slot] * share;
    }
}

void MovingParameters::bind(ShaderArgs &args) const {
    if (offsets_.empty())
        return;
    args.parameters = table_.data();
    args.parameterOffset = offsets_.data();
}

} // namespace candela
