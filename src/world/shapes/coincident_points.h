// SPDX-License-Identifier: Apache-2.0
// Which points stand in one place.
#pragma once

#include "foundation/base/vec3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// For each point the number of its place; places are numbered by their first points. Points within
/// some units of rounding of a place are there.
std::vector<std::uint32_t> placesOf(std::span<const Vec3>);

} // namespace candela
