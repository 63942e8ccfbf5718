// SPDX-License-Identifier: Apache-2.0
// The requests of a RIB that make textures, and the verb that does what they do.
#pragma once

#include "foundation/base/diagnostics.h"
#include "image/output_path.h"
#include "interface/ri/options.h"
#include "interface/ri/texture_order.h"

#include <string>
#include <vector>

namespace candela {

struct TextureOrderSettings {
    std::vector<std::string> folders; ///< Where pictures are, behind the RIB's search path.
    OutputFolder output;              ///< Where textures are made.
};

/// Does what a request asks for, or reports why not. Textures are made where pictures
/// are, under the same rules.
void makeOrderedTexture(TextureOrder, const Options &, const TextureOrderSettings &,
                        DiagnosticSink &);

} // namespace candela
