// SPDX-License-Identifier: Apache-2.0
// What becomes of the displays of a frame, settled before its first sample: a long render is not
// to find out at its end that no picture can be written.
#pragma once

#include "image/display_planes.h"
#include "image/display_taker.h"
#include "image/output_path.h"

namespace candela {

enum class FileFormat { OpenExr, Png, Tiff, RadianceHdr };

/// A display that can be written.
struct PlannedDisplay {
    DisplayRecord record;
    FileFormat format = FileFormat::OpenExr;
    std::vector<DisplayPlane> planes;
    std::string path;
    bool standsIn = false; ///< For a type that is not known: written as it comes, unquantised.
    bool isFile = true;    ///< Else it has neither format nor path.
    bool isTaken = false;  ///< By the policy's taker.
};

struct OutputPolicy {
    OutputFolder folder;
    std::string firstFile{}; ///< -o: where the first display that holds no depths goes, by its
                             ///< extension; empty = where the RIB says.
    DisplayTaker *taker = nullptr; ///< Null = nobody.
};

/// The displays of the options that can be written: their formats, planes and paths. Types that
/// are not known become OpenEXR, with a warning. What cannot be written (an unknown mode, more than
/// its format holds, a path that is not allowed, not writable or taken by a display before it) is
/// an error and left out. `available` as for displayPlanes().
std::vector<PlannedDisplay> planDisplays(const Options &, std::span<const ChannelInfo> available,
                                         const OutputPolicy &, DiagnosticSink &);

/// Whether it is of type "zfile" or "shadow": a float file of depths, with the camera's matrices.
bool holdsDepths(const DisplayRecord &);

/// How a display quantises depth.
QuantizeRecord depthQuantize(const DisplayRecord &, const Options &);

} // namespace candela
