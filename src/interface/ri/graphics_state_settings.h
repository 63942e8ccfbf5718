// SPDX-License-Identifier: Apache-2.0
// What the command line has to say to the graphics state.
#pragma once

#include "interface/ri/options.h"
#include "interface/ri/texture_order.h"

#include <functional>
#include <string>

namespace candela {

struct GraphicsStateSettings {
    /// Where files are looked for unless Option "searchpath" says otherwise, and what '@' stands
    /// for there: folders joined by ':'.
    struct SearchPaths {
        std::string shader, texture, archive;
    } searchPaths;
    /// Has the last word on the options, just before each SceneBuilder::worldBegin.
    std::function<void(Options &)> overrideOptions;
    /// Makes a texture, now; empty = none is made.
    std::function<void(const TextureOrder &, const Options &)> makeTexture;
};

} // namespace candela
