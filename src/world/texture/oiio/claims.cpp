// SPDX-License-Identifier: Apache-2.0
#include "world/texture/oiio/claims.h"

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace candela {

/// Name, type, length and value each, until an empty name.
bool hasImpossibleHeader(const std::string &path) {
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    std::ifstream file(path, std::ios::binary);
    char start[8];
    if (error || !file.read(start, sizeof start) || std::memcmp(start, "v/1\x01", 4) != 0)
        return false;
    constexpr int mostEntries = 10000;
    for (int entry = 0; entry < mostEntries; ++entry) {
        std::string name, type;
        std::uint32_t length = 0;
        if (!std::getline(file, name, '\0') || name.empty() || !std::getline(file, type, '\0') ||
            !file.read(reinterpret_cast<char *>(&length), sizeof length))
            return false; // The reader will say what is wrong.
        const auto here = std::uintmax_t(file.tellg());
        if (length > bytes - here)
            return true;
        file.seekg(std::streamoff(length), std::ios::cur);
    }
    return true;
}

/// How many bytes of pixels one byte of the file can stand for, of one color alike.
static double mostPacked(const OIIO::ImageInput &file) {
    if (file.format_name() != std::string("tiff"))
        return 1 << 14;
    const std::string codec = file.spec().get_string_attribute("compression");
    return codec == "none"       ? 1
           : codec == "packbits" ? 64
           : codec == "zip"      ? 1032
           : codec == "lzw"      ? 3000
                                 : 1 << 14;
}

bool claimsTooMuch(const OIIO::ImageInput &file, const std::string &path) {
    constexpr double always = 1 << 20;
    std::error_code error;
    const auto bytes = std::filesystem::file_size(path, error);
    return !error &&
           double(file.spec().image_bytes(true)) > mostPacked(file) * double(bytes) + always;
}

} // namespace candela
