// SPDX-License-Identifier: Apache-2.0
// From the blobby of the interface to a surface.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/surface.h"

namespace candela {

/// A mesh with smooth normals. Values of class vertex and varying, one a blob, blend as their
/// fields do.
std::vector<std::shared_ptr<const Surface>> makeBlobby(const BlobbyRecord &,
                                                       const PrimitiveRecord &, DiagnosticSink &);

} // namespace candela
