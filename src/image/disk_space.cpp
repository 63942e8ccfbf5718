// SPDX-License-Identifier: Apache-2.0
#include "image/disk_space.h"

#include <filesystem>
#include <fmt/format.h>
#include <limits>
#include <map>

namespace candela {

double freeSpaceOf(const std::string &folder) {
    std::error_code error;
    const std::filesystem::space_info space = std::filesystem::space(folder, error);
    return error ? std::numeric_limits<double>::infinity() : double(space.available);
}

void warnOfSmallDisks(std::span<const PlannedDisplay> displays, double pixels,
                      DiagnosticSink &diagnostics, const FreeSpace &freeSpace) {
    std::map<std::string, double> wanted; // By folder.
    for (const PlannedDisplay &display : displays) {
        if (!display.isFile)
            continue;
        const std::string folder = std::filesystem::path(display.path).parent_path().string();
        const double bytesOfPixel =
            double(display.planes.size()) * (display.format == FileFormat::Png ? 1 : sizeof(float));
        const double needed = wanted[folder] += pixels * bytesOfPixel, there = freeSpace(folder);
        if (needed > there)
            diagnostics.warning(display.record.parameters.where,
                                fmt::format("Display \"{}\": {} has {:.3g} MB left, and up to "
                                            "{:.3g} MB will be written there: make room while "
                                            "there is time",
                                            display.record.name, folder, there / 1e6,
                                            needed / 1e6));
    }
}

} // namespace candela
