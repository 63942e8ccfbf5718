// SPDX-License-Identifier: Apache-2.0
// Whether a primitive can be drawn, and which of its variables fit its shape. Private to the room.
#pragma once

#include "interface/ri/primitive_record.h"
#include "interface/ri/request_diagnostics.h"

#include <memory>

namespace candela {

/// The shape with those of its variables that fit it, opacities within [0,1]. What is wrong is
/// reported; null if the primitive must be left out.
std::shared_ptr<const PrimitiveRecord> checkedPrimitive(const char *request, ShapeRecord,
                                                        ParameterList variables, const Attributes &,
                                                        RequestDiagnostics &);

} // namespace candela
