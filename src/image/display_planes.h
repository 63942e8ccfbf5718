// SPDX-License-Identifier: Apache-2.0
// What a display's mode asks for, plane by plane.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/options.h"
#include "world/scene/sample_sink.h"

#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candela {

/// One float plane of a display.
struct DisplayPlane {
    enum class Source {
        Color,    ///< Ci after the imaging pipeline.
        Alpha,    ///< Mean of the components of Oi.
        Depth,    ///< The film's "z".
        Channel,  ///< A channel of the film as it is.
        Variance, ///< Variance of the pixel mean of Ci, as it is.
    };
    Source source = Source::Color;
    std::string channel; ///< The film's name for it.
    int component = 0;
    std::string name; ///< The plane's name in the file: R G B A Z, or "albedo.R", "N.X", "id".
};

/// Reads a mode: "rgb", "rgba", "a", "z", "az", "rgbz", "rgbaz", the name of a channel (also with
/// its declaration before it, "varying color albedo"), or several of these between commas.
/// "radiance" is Ci before the imaging pipeline, "variance" the variance of its pixel means.
/// `available` are the channels beside Ci and Oi that estimators can give or filters make. Nothing,
/// and `problem` with the names that are known, if a part of the mode is not.
std::optional<std::vector<DisplayPlane>> displayPlanes(const std::string &mode,
                                                       std::span<const ChannelInfo> available,
                                                       std::string &problem);

/// Gives each plane of a file a name of its own; planes that are there twice stay once. The names
/// that had to change, "R as shader.R", empty if none had.
std::string tellApart(std::vector<DisplayPlane> &);

/// RI's default where a scene names no display: all of the picture, in a float file.
DisplayRecord defaultDisplay(const std::string &name);

/// The displays of the options, or the default one, "ri.exr".
std::vector<DisplayRecord> displaysOf(const Options &);

/// The channels that the displays want from the film beside Ci and Oi: what Film::Settings takes.
/// Modes that are not understood are left to planDisplays() to report.
std::vector<ChannelInfo> wantedChannels(std::span<const DisplayRecord>,
                                        std::span<const ChannelInfo> available);

/// True if a display has the parameter "halfbuffers" set: Film::Settings::keepHalves.
bool wantsHalves(std::span<const DisplayRecord>);
bool wantsHalves(const DisplayRecord &);

} // namespace candela
