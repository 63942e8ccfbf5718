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
    take(own::Detail, &Attributes::detail);
    take(own::DetailRange, &Attributes::detailRange);
    for (const std::string &name : part.ownNames) {
        if (const Parameter *parameter = part.named.find(name))
            result.named[name] = *parameter;
        if (name == "identifier:name")
            result.name = part.name;
    }
    return result;
}

Visibility visibilityOf(const Attributes &attributes) {
    const auto isOn = [&](const char *name, bool otherwise) {
        const std::string qualified = std::string("visibility:") + name;
        const std::string word = attributes.named.string(qualified, "");
        if (!word.empty())
            return word != "transparent" && word != "none" && word != "off";
        return attributes.named.number(qualified, otherwise ? 1 : 0) != 0;
    };
    const bool traced = isOn("trace", true);
    return {isOn("camera", true), isOn("diffuse", isOn("indirect", traced)),
            isOn("specular", isOn("reflection", traced)),
            isOn("shadow", isOn("transmission", true))};
}

} // namespace candela
