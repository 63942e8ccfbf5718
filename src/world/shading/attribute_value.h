// SPDX-License-Identifier: Apache-2.0
// Attributes of primitives as shaders ask for them: attribute("user:wear", x).
#pragma once

#include "interface/ri/attributes.h"
#include "interface/ri/declarations.h"

#include <string>
#include <string_view>
#include <vector>

namespace candela {

/// The numbers of a parameter of RiOption or RiAttribute, if it has the wanted type (whole numbers
/// are floats too); empty if there is none.
std::vector<float> namedValue(const NamedParameters &, const std::string &name,
                              const Declaration &wanted);

/// The numbers of an attribute as attribute() names it, "Ri:" before it or not: ShadingRate, Sides,
/// Matte, Color, Opacity, TextureCoordinates, and "category:name" of RiAttribute, if it has this
/// type ("float[8]"). Empty if there is none.
std::vector<float> attributeValue(const Attributes &, std::string_view name, std::string_view type);

} // namespace candela
