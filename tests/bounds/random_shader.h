// SPDX-License-Identifier: Apache-2.0
// Random surface shaders that have to do with where they are.
#pragma once

#include <string>

namespace candela::bounds {

std::string randomShader(unsigned seed, const std::string &name);

} // namespace candela::bounds
