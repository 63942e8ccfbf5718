// SPDX-License-Identifier: Apache-2.0
#include "language/jit/reports.h"

namespace candela {

void askFromCode(const ShaderArgs *args, const ServiceSite *site, const ServiceCell *operands,
                 float *results, std::int32_t firstLane, std::int32_t laneCount,
                 std::uint32_t mask) {
    askService({args, site, firstLane, laneCount, mask, operands, results});
}

void reportIndexOutside(const ShaderArgs *args, const char *file, std::int32_t line) {
    if (args->callbacks && args->callbacks->indexOutside)
        args->callbacks->indexOutside(args->callbacks->context, file, line);
}

void reportLoopEnded(const ShaderArgs *args, const char *file, std::int32_t line) {
    if (args->callbacks && args->callbacks->loopEnded)
        args->callbacks->loopEnded(args->callbacks->context, file, line);
}

} // namespace candela
