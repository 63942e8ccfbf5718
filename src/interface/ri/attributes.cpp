// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/attributes.h"

namespace candela {

float Attributes::number(const std::string &qualifiedName, float fallback) const {
    auto found = named.find(qualifiedName);
    return found != named.end() && !found->second.floats.empty() ? found->second.floats.front()
                                                                 : fallback;
}

std::string Attributes::string(const std::string &qualifiedName, std::string fallback) const {
    auto found = named.find(qualifiedName);
    return found != named.end() && !found->second.strings.empty() ? found->second.strings.front()
                                                                  : fallback;
}

} // namespace candela
