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

static float firstFloat(const Parameter *parameter, float fallback) {
    return parameter && !parameter->floats.empty() ? parameter->floats.front() : fallback;
}

static std::string firstString(const Parameter *parameter, std::string fallback) {
    return parameter && !parameter->strings.empty() ? parameter->strings.front() : fallback;
}

float ParameterList::number(std::string_view name, float fallback) const {
    return firstFloat(find(name), fallback);
}

std::string ParameterList::string(std::string_view name, std::string fallback) const {
    return firstString(find(name), std::move(fallback));
}

const Parameter *NamedParameters::find(const std::string &qualifiedName) const {
    auto found = all_.find(qualifiedName);
    return found == all_.end() ? nullptr : &found->second;
}

float NamedParameters::number(const std::string &qualifiedName, float fallback) const {
    return firstFloat(find(qualifiedName), fallback);
}

std::string NamedParameters::string(const std::string &qualifiedName, std::string fallback) const {
    return firstString(find(qualifiedName), std::move(fallback));
}

ParameterList between(const ParameterList &a, const ParameterList &b, double share) {
    ParameterList result = a;
    for (Parameter &parameter : result.all) {
        const Parameter *later = b.find(parameter.name);
        if (!later || !(later->declaration == parameter.declaration) ||
            later->floats.size() != parameter.floats.size())
            continue;
        for (std::size_t k = 0; k < parameter.floats.size(); ++k) {
            const double from = parameter.floats[k], to = later->floats[k];
            parameter.floats[k] = float(from + share * (to - from));
        }
    }
    return result;
}

} // namespace candela
