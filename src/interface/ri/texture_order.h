// SPDX-License-Identifier: Apache-2.0
// What the requests that make textures ask for (RI 3.2, section 7).
#pragma once

#include "interface/ri/attributes.h"

#include <string>
#include <vector>

namespace candela {

struct TextureOrder {
    enum class Kind { Texture, Bump, LatLongEnvironment, CubeFaceEnvironment, Shadow };

    Kind kind = Kind::Texture;
    std::string request;                          ///< Its name, for messages.
    std::vector<std::string> pictures;            ///< One; of cube faces px, nx, py, ny, pz, nz.
    std::string texture;                          ///< The file to be made.
    std::string sWrap = "black", tWrap = "black"; ///< "black", "clamp" or "periodic".
    std::string filter = "box";
    float fieldOfView = 90;   ///< Of cube faces, degrees.
    ParameterList parameters; ///< With the place of the request.
};

} // namespace candela
