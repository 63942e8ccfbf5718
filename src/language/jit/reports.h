// SPDX-License-Identifier: Apache-2.0
// What compiled code calls to speak and to ask: services, indices outside arrays, loops that do not
// end.
#pragma once

#include "language/runtime/shader_abi.h"

namespace candela {

/// askService() for lanes from `firstLane` on; rows and mask as ServiceCall has them.
void askFromCode(const ShaderArgs *, const ServiceSite *, const ServiceCell *operands,
                 float *results, std::int32_t firstLane, std::int32_t laneCount,
                 std::uint32_t mask);

/// Passes the place of an index outside its array on to ShaderCallbacks::indexOutside, if any.
void reportIndexOutside(const ShaderArgs *, const char *file, std::int32_t line);
/// The same of a loop that has been ended: ShaderCallbacks::loopEnded.
void reportLoopEnded(const ShaderArgs *, const char *file, std::int32_t line);

} // namespace candela
