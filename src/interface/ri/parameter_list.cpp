// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/parameter_list.h"

#include "foundation/units/color.h"

#include <algorithm>

namespace candela {

int componentsOf(ValueType type) {
    switch (type) {
    case ValueType::Float:
    case ValueType::Integer:
    case ValueType::String: return 1;
    case ValueType::Color: return colorSamples;
    case ValueType::Point:
    case ValueType::Vector:
    case ValueType::Normal: return 3;
    case ValueType::HPoint: return 4;
    case ValueType::Matrix: return 16;
    }
    return 1;
}

const Parameter *ParameterList::find(std::string_view name) const {
    auto found = std::ranges::find(all, name, &Parameter::name);
    return found == all.end() ? nullptr : &*found;
}

float ParameterList::number(std::string_view name, float fallback) const {
    const Parameter *parameter = find(name);
    return parameter && !parameter->floats.empty() ? parameter->floats.front() : fallback;
}

std::string ParameterList::string(std::string_view name, std::string fallback) const {
    const Parameter *parameter = find(name);
    return parameter && !parameter->strings.empty() ? parameter->strings.front() : fallback;
}

} // namespace candela
