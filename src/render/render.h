// SPDX-License-Identifier: Apache-2.0
// The whole flow, from the names of RIB files to pictures on disk.
#pragma once

#include "image/display_taker.h"
#include "interface/ri/frame_chooser.h"
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
    /// Unset: as the RIB has it, unless samplesPerPixel is given.
    std::optional<float> pixelVariance;
    std::optional<std::string> integrator;    ///< "path", "bidir", "vcm", "radiosity" or "classic".
    std::optional<std::array<float, 4>> crop; ///< NDC: x0, x1, y0, y1.
    std::optional<std::array<int, 2>> resolution;
    std::uint32_t seed = 0;
    int threads = 0;        ///< 0 = all cores.
    std::string outputFile; ///< In place of the first display's; empty = as the RIB has it.
    std::string outputDirectory = ".";
    FrameNumbers frames;        ///< Which are rendered; none = all.
    double timeLimit = 0;       ///< Seconds; 0 = none.
    std::string checkpointFile; ///< Empty = none.
    double secondsBetweenCheckpoints = 60;
    std::string resumeFile;   ///< A checkpoint to go on from; empty = none.
    std::string solutionFile; ///< Where radiosity's solution is kept; empty = nowhere.
    std::string solutionMesh; ///< Where it goes as PLY; empty = nowhere.
    bool trust = false;       ///< The RIB may run programs and write outside the output directory.
    std::vector<std::string> shaderPath, archivePath, texturePath;
    bool quiet = false;
    bool heedsSignals = false;     ///< Of a RenderSession: Ctrl-C ends a frame, not the program.
    DisplayTaker *taker = nullptr; ///< Of pictures that are no files, or more; null = nobody.

    JitOptions jit;              ///< --lanes
    bool hemisphereOnly = false; ///< --sampling hemisphere
    std::string statisticsFile;  ///< --stats
};

/// Renders all frames of RIB files ("-" = standard input), which are read one after the other as if
/// they were one. 0 if all went well or the time was up, 1 if anything was wrong (and reported on
/// standard error; everything else has been rendered), statusOfInterrupt if the user has ended it.
int renderFiles(const std::vector<std::string> &paths, const RenderSettings &);

} // namespace candela
