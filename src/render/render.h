// SPDX-License-Identifier: Apache-2.0
// The whole flow, from the name of a RIB file to pictures on disk.
#pragma once

#include "light/frame/integrate.h"
#include "world/shading/shader_library.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace candela {

/// What the command line says; unset = as the RIB has it.
struct RenderSettings {
    std::optional<int> samplesPerPixel;
    std::optional<std::string> integrator;    ///< "path", "bidir", "vcm", "radiosity" or "classic".
    std::optional<std::array<float, 4>> crop; ///< NDC: x0, x1, y0, y1.
    std::optional<std::array<int, 2>> resolution;
    std::uint32_t seed = 0;
    int threads = 0; ///< 0 = all cores.
    std::string outputDirectory = ".";
    bool trust = false; ///< The RIB may run programs and write outside the output directory.
    std::vector<std::string> shaderPath, archivePath, texturePath;
    bool quiet = false;

    JitOptions jit;              ///< --lanes
    bool hemisphereOnly = false; ///< --sampling hemisphere
    std::string statisticsFile;  ///< --stats
};

/// Renders all frames of a RIB file ("-" = standard input). 0 if all went well, 1 if anything was
/// wrong (and reported on standard error; everything else has been rendered), statusOfInterrupt if
/// the user interrupted a filter.
int renderFile(const std::string &path, const RenderSettings &);

} // namespace candela
