// SPDX-License-Identifier: Apache-2.0
// Whether what will be written finds room: known before the first sample, not after the last.
#pragma once

#include "image/display_plan.h"

#include <functional>

namespace candela {

/// Bytes that are free on the disk of a folder.
using FreeSpace = std::function<double(const std::string &folder)>;
double freeSpaceOf(const std::string &folder);

/// Warns of displays of so many pixels that may find no room beside those before them. They may
/// all the same, being packed.
void warnOfSmallDisks(std::span<const PlannedDisplay>, double pixels, DiagnosticSink &,
                      const FreeSpace & = freeSpaceOf);

} // namespace candela
