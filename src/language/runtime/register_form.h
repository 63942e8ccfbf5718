// SPDX-License-Identifier: Apache-2.0
// A runtime function in the forms in which it is called. For noise_level.h and bound_level.h, which
// are compiled once per instruction-set level.
#pragma once

#include "language/runtime/noise_lanes.h"

#include <cstddef>
#include <utility>

namespace {

/// A function as it is called: inputs come, and the first output goes, in registers. Those that
/// have more outputs write them to memory one after another.
template <typename Floats, typename Function, typename = std::make_index_sequence<Function::inputs>>
struct InRegisters;

template <typename Floats, typename Function, std::size_t... k>
struct InRegisters<Floats, Function, std::index_sequence<k...>> {
    static constexpr std::size_t lanes = sizeof(Floats) / sizeof(float);
    template <std::size_t> using Input = Floats;

    static Floats single(Input<k>... x) {
        const Floats inputs[] = {x...};
        Floats result[Function::outputs];
        Function::evaluate(inputs, result);
        return result[0];
    }
    static Floats several(Input<k>... x, float *others) {
        const Floats inputs[] = {x...};
        Floats result[Function::outputs];
        Function::evaluate(inputs, result);
        for (int n = 1; n < Function::outputs; ++n)
            Lanes<Floats>::store(others + std::size_t(n - 1) * lanes, result[n]);
        return result[0];
    }
    static const void *address() {
        if constexpr (Function::outputs == 1)
            return reinterpret_cast<const void *>(&single);
        else
            return reinterpret_cast<const void *>(&several);
    }
    static void throughMemory(const float *inputs, float *outputs) {
        const auto input = [&](std::size_t n) __attribute__((always_inline)) {
            return Lanes<Floats>::load(inputs + n * lanes);
        };
        Floats first;
        if constexpr (Function::outputs == 1)
            first = single(input(k)...);
        else
            first = several(input(k)..., outputs + lanes);
        Lanes<Floats>::store(outputs, first);
    }
};

} // namespace
