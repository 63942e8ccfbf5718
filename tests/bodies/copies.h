// SPDX-License-Identifier: Apache-2.0
// Copies of a body in mirrored, stretched and turned places: as instances, or repeated.
#pragma once

#include "tests/bodies/bodies.h"

#include <string>

namespace candela::test {

/// RIB of four copies in the corners of a picture that is 9 wide or more at their distance, some of
/// them of an object within an object. `look`: attributes of each.
std::string copied(const Body &, bool instances, const std::string &look);

} // namespace candela::test
