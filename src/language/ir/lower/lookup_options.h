// SPDX-License-Identifier: Apache-2.0
// What may stand behind the coordinates of texture(), environment(), shadow() and bump(): names of
// parameters, each with its value (RI 3.2, section 15.7).
#pragma once

#include "language/ir/lower/builtins.h"

namespace candela::ir {

struct LookupOptions {
    ValueId channel;        ///< The first one that is wanted, from 0.
    ValueId sWidth, tWidth; ///< Factors of the footprint; 0 = the picture as it stands.
    ValueId sBlur, tBlur;   ///< Shares of the whole picture that are averaged besides.
    ValueId fill;           ///< What channels hold that the picture has not.
    ValueId samples, bias;  ///< Of shadow(); a bias below 0 is the renderer's choice.
};

/// Where the names begin: arguments before it are the file's name and coordinates.
size_t firstOption(const BuiltinCall &);
/// Reads them; what is wrong is reported, what is unknown is warned of.
LookupOptions readLookupOptions(BuiltinCall &);

} // namespace candela::ir
