// SPDX-License-Identifier: Apache-2.0
#include "language/semantics/spellings.h"

#include <span>

namespace candela::sl {
namespace {

struct Spelling {
    std::string_view written, standard;
};

constexpr Spelling colorSpaces[] = {{"rgb", "rgb"}, {"RGB", "rgb"}, {"hsv", "hsv"}, {"HSV", "hsv"},
                                    {"hsl", "hsl"}, {"HSL", "hsl"}, {"XYZ", "XYZ"}, {"xyz", "XYZ"},
                                    {"xyY", "xyY"}, {"YIQ", "YIQ"}, {"yiq", "YIQ"}};

constexpr Spelling splineBases[] = {{"catmull-rom", "catmull-rom"}, {"catmullrom", "catmull-rom"},
                                    {"bezier", "bezier"},           {"bspline", "bspline"},
                                    {"b-spline", "bspline"},        {"hermite", "hermite"},
                                    {"linear", "linear"},           {"power", "power"}};

std::string_view standardOf(std::span<const Spelling> table, std::string_view name) {
    for (const Spelling &spelling : table)
        if (spelling.written == name)
            return spelling.standard;
    return {};
}

} // namespace

std::string_view colorSpaceSpelled(std::string_view name) { return standardOf(colorSpaces, name); }
std::string_view splineBasisSpelled(std::string_view name) { return standardOf(splineBases, name); }

} // namespace candela::sl
