// SPDX-License-Identifier: Apache-2.0
// Filter shaders over whole pictures: what PushFilter has put on the stack, run in that order.
#pragma once

#include "foundation/base/diagnostics.h"
#include "image/filter/image_maps.h"
#include "interface/ri/options.h"
#include "world/shading/filter_code.h"
#include "world/shading/shader_library.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace candela {

/// Whom a running stack tells what; from any thread, one at a time.
struct FilterListeners {
    DiagnosticSink &diagnostics;
    /// The filter at work, how many of the stack are done, and what part of this one is, where that
    /// is known (else negative). Called some times a second.
    std::function<void(const std::string &filter, int done, double part)> progress;
    /// True: the stack is to end soon. Asked some times a second; may be empty.
    std::function<bool()> interrupted;
};

/// What is not finite becomes 0, and is counted and told (of `what`, "the picture"): one such pixel
/// would spread over its neighbourhood, or the whole picture.
void makeFinite(OwnedImage &, const std::string &what, DiagnosticSink &);

/// A stack of filters, compiled.
class FilterStack {
public:
    /// Finds and compiles the filters. One that is missing or faulty is reported (once) and left
    /// out. What the parameters of a filter decide is part of its code.
    FilterStack(const std::vector<ShaderRecord> &, ShaderLibrary &, const Options &);

    bool empty() const { return filters_.empty(); }
    /// The filters that are there, in the order in which they run.
    const std::vector<ShaderRecord> &records() const { return records_; }
    /// The maps that some filter reads by name, "Cs" and "Ci" excepted: what the film has to give.
    std::vector<std::string> mapsRead() const;

    /// The maps that some filter sets, "Ci" excepted, with the channels that they get if nobody
    /// else gives them.
    std::vector<MapInfo> mapsSet() const;

    /// Runs the filters in order over the maps, each one's Ci being the next one's Cs. `maps` holds
    /// "Ci", of finite numbers, and what a filter makes is made so for the next one. False if it
    /// was interrupted: then Ci is what the last whole filter made of it.
    bool run(ImageMaps &maps, const FilterListeners &) const;

private:
    std::vector<std::shared_ptr<const FilterCode>> filters_;
    std::vector<ShaderRecord> records_; ///< Theirs.
};

} // namespace candela
