// SPDX-License-Identifier: Apache-2.0
// The solution that paths end on.
#pragma once

#include "light/path/settings.h"
#include "light/radiosity/solution.h"

#include <memory>

namespace candela {

/// The one that the settings bring, or else one that is made now; null if they ask for none
/// (IntegratorKind::Radiosity alone does). Statistics are told of it.
std::unique_ptr<radiosity::Solution> solve(const Scene &, const IntegratorSettings &,
                                           TransportStatistics &, DiagnosticSink &);

} // namespace candela
