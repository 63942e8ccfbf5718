// SPDX-License-Identifier: Apache-2.0
#include "image/picture_marks.h"

#include <algorithm>
#include <iterator>

namespace candela {

using namespace std::string_view_literals;

bool looksLikePicture(std::string_view beginning) {
    constexpr std::string_view marks[] = {
        "v/1\x01"sv,           // OpenEXR
        "\x89PNG\r\n\x1a\n"sv, //
        "II*\0"sv,             // TIFF, textures of most renderers
        "MM\0*"sv,             //
        "II+\0"sv,             // BigTIFF
        "MM\0+"sv,             //
        "#?RADIANCE"sv,        //
        "#?RGBE"sv,            //
        "\xff\xd8\xff"sv,      // JPEG
        "GIF8"sv,              //
        "SDPX"sv,              // DPX
        "XPDS"sv,              //
        "\x80\x2a\x5f\xd7"sv,  // Cineon
        "\x01\xda\x00"sv,      // SGI
        "\x01\xda\x01"sv,      //
        "8BPS"sv,              // PSD
        "\0\0\0\x0cjP"sv,      // JPEG 2000
        "\x2f\x08\x67\xab"sv,  // Depths as other renderers write them
        "\xab\x67\x08\x2f"sv,  //
    };
    const auto begins = [&](std::string_view mark) { return beginning.starts_with(mark); };
    if (std::any_of(std::begin(marks), std::end(marks), begins))
        return true;
    if (beginning.starts_with("BM"sv)) // BMP: four bytes of reserve are zero.
        return beginning.size() >= 10 && beginning.substr(6, 4) == "\0\0\0\0"sv;
    if (beginning.starts_with("FOR4"sv) || beginning.starts_with("FORM"sv)) // IFF
        return beginning.substr(8, 4) == "CIMG"sv || beginning.substr(8, 4) == "ILBM"sv;
    const bool isPortable = beginning.size() > 2 && beginning[0] == 'P' && // PNM and PFM
                            "123456Ff"sv.find(beginning[1]) != std::string_view::npos;
    return isPortable && " \t\r\n#"sv.find(beginning[2]) != std::string_view::npos;
}

} // namespace candela
