// SPDX-License-Identifier: Apache-2.0
// What a file says of its size, against the bytes that it has: readers take memory for whatever a
// header claims.
#pragma once

#include <OpenImageIO/imageio.h>

#include <string>

namespace candela {

/// Before it is opened: an OpenEXR header with an entry longer than the file.
bool hasImpossibleHeader(const std::string &path);

/// More pixels than its codec packs into so many bytes.
bool claimsTooMuch(const OIIO::ImageInput &, const std::string &path);

} // namespace candela
