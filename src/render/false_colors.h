// SPDX-License-Identifier: Apache-2.0
// Measured light as colours with a legend: the library's filter "falsecolor".
#pragma once

#include "image/picture.h"
#include "light/probe/probe.h"
#include "render/frame.h"

#include <string>
#include <vector>

namespace candela {

/// Shows R, G and B of the picture, W m^-2 (W m^-2 sr^-1), as colours of lx (cd m^-2).
/// `parameters` are the filter's, NAME=VALUE. False, and the picture stays, if that cannot be done,
/// which is reported.
bool showInFalseColors(Picture &, ProbeQuantity, const std::vector<std::string> &parameters,
                       ShaderLibrary &, const Options &, const FrameListeners &);

} // namespace candela
