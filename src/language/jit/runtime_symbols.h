// SPDX-License-Identifier: Apache-2.0
// The symbols under which generated code calls what the renderer has for it.
#pragma once

#include "language/runtime/register_code.h"

#include <string>

namespace candela {

/// A runtime function, by its number, that takes `width` lanes.
inline std::string runtimeSymbol(int runtimeFunction, int width) {
    const auto facts = runtime::info(runtime::RuntimeFunction(runtimeFunction));
    return std::string("candela_") + facts.name + "_w" + std::to_string(width);
}
/// askFromCode(), reportIndexOutside() and reportLoopEnded().
inline constexpr const char *serviceSymbol = "candela_service";
inline constexpr const char *indexOutsideSymbol = "candela_index_outside";
inline constexpr const char *loopEndedSymbol = "candela_loop_ended";
/// Filters: runtime/image_access.h.
inline constexpr const char *lookUpSymbol = "candela_image";
inline constexpr const char *setImageSymbol = "candela_setimage";
inline constexpr const char *pixelLoopSymbol = "candela_pixel_loop";
inline constexpr const char *goesOnSymbol = "candela_goes_on";

} // namespace candela
