// SPDX-License-Identifier: Apache-2.0
// The requests of a RIB that make textures, and the verb that does what they do.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/options.h"
#include "interface/ri/texture_order.h"

#include <string>
#include <vector>

namespace candela {

struct TextureOrderSettings {
    std::vector<std::string> folders; ///< Where pictures are, behind the RIB's search path.
    std::string outputDirectory = ".";
    bool allowOutside = false; ///< Textures may be made outside of the output folder.
};

/// Does what a request asks for, or reports why not. Textures are made in the output folder, as
/// pictures are.
void makeOrderedTexture(TextureOrder, const Options &, const TextureOrderSettings &,
                        DiagnosticSink &);

} // namespace candela
