// SPDX-License-Identifier: Apache-2.0
#include "language/jit/print_lanes.h"

#include "language/ir/core/print_format.h"

#include <bit>

namespace candela {

static void printLane(const ShaderCallbacks &callbacks, const char *strings, const char *types,
                      int operandCount, const std::int32_t *cells, int width) {
    std::vector<std::string> texts(operandCount);
    std::vector<ir::PrintArgument> values;
    for (int k = 1; k < operandCount; ++k) {
        const std::int32_t cell = cells[k * width];
        if (types[k] == 's') {
            texts[k] = strings + cell;
            values.push_back({0, &texts[k]});
        } else {
            values.push_back({types[k] == 'f' ? std::bit_cast<float>(cell) : float(cell), nullptr});
        }
    }
    const std::string line = ir::formatPrint(strings + cells[0], values);
    callbacks.print(callbacks.context, line.c_str());
}

void printLanes(const ShaderArgs *args, const char *strings, const char *types,
                std::int32_t operandCount, const std::int32_t *cells, std::int32_t width,
                std::uint32_t activeLanes) {
    if (!args->callbacks || !args->callbacks->print)
        return;
    for (int lane = 0; lane < width; ++lane)
        if (activeLanes >> lane & 1)
            printLane(*args->callbacks, strings, types, operandCount, cells + lane, width);
}

void reportIndexOutside(const ShaderArgs *args, const char *file, std::int32_t line) {
    if (args->callbacks && args->callbacks->indexOutside)
        args->callbacks->indexOutside(args->callbacks->context, file, line);
}

} // namespace candela
