// SPDX-License-Identifier: Apache-2.0
// One bad face of a mesh costs that face. Private to the room.
#pragma once

#include "interface/ri/primitive_record.h"

#include <string>

namespace candela {

/// Leaves out the polygons that have fewer than three vertices in a loop, or vertices that are not
/// there or not finite, with their values of the variables, and says which the first one is and
/// what it has. Points that are not finite become 0. Nothing is done, and nothing said, where the
/// counts do not fit each other or no good polygon would be left: then all of it is at fault.
std::string leaveOutBadFaces(PolygonsRecord &, ParameterList &variables);

} // namespace candela
