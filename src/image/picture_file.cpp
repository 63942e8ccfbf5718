// SPDX-License-Identifier: Apache-2.0
#include "image/picture_file.h"

#include "foundation/base/whole_file.h"
#include "image/exr_file.h"
#include "image/png_file.h"

namespace candela {

std::optional<Picture> readPicture(const std::string &path, std::string &problem) {
    const auto bytes = readWholeFile(path, problem);
    if (!bytes)
        return std::nullopt;
    std::optional<Picture> picture;
    if (looksLikeExr(*bytes))
        picture = decodeExr(*bytes, problem);
    else if (looksLikePng(*bytes))
        picture = decodePng(*bytes, problem);
    else
        problem = "neither an OpenEXR nor a PNG picture";
    if (!picture)
        problem = path + ": " + problem;
    return picture;
}

} // namespace candela
