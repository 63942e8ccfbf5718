// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/type.h"

namespace candela::sl {

std::string shapeOf(const Type &type) {
    std::string result = nameOf(type.base);
    return type.isArray() ? result + "[" + std::to_string(type.length) + "]" : result;
}

std::string nameOf(const Type &type) {
    return std::string(nameOf(type.detail)) + " " + shapeOf(type);
}

} // namespace candela::sl
