// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/attributes.h"

namespace candela {

Attributes attributesOfPart(const Attributes &instance, const Attributes &part) {
    Attributes result = instance;
    const auto take = [&](std::uint32_t bit, auto member) {
        if (part.ownSet & bit)
            result.*member = part.*member;
    };
    take(own::Color, &Attributes::color), take(own::Color, &Attributes::colorMotion);
    take(own::Opacity, &Attributes::opacity), take(own::Opacity, &Attributes::opacityMotion);
    take(own::Surface, &Attributes::surface);
    take(own::Displacement, &Attributes::displacement);
    take(own::Atmosphere, &Attributes::atmosphere);
    take(own::Interior, &Attributes::interior);
    take(own::Exterior, &Attributes::exterior);
    take(own::Deformation, &Attributes::deformation);
    take(own::ShadingRate, &Attributes::shadingRate);
    take(own::Interpolation, &Attributes::smoothInterpolation);
    take(own::Matte, &Attributes::matte);
    take(own::Sides, &Attributes::sides);
    for (const std::string &name : part.ownNames) {
        if (const Parameter *parameter = part.named.find(name))
            result.named[name] = *parameter;
        if (name == "identifier:name")
            result.name = part.name;
    }
    return result;
}

} // namespace candela
