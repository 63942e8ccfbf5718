// SPDX-License-Identifier: Apache-2.0
// How far a displacement shader moves points, against what a file says of it:
// Attribute "displacementbound" "float sphere" [r] "string coordinatesystem" ["shader"]. Surfaces
// are displaced before they are bounded, so the picture is the same whatever the file says; other
// renderers cut off what is beyond.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/attributes.h"

#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>

namespace candela {

class DisplacementBounds {
public:
    /// Of what one shader displaces under these attributes. `systems`: named coordinate systems,
    /// currentFromSpace; "object" is the shape's own space.
    DisplacementBounds(const Attributes &, std::shared_ptr<const ShaderRecord>,
                       const Matrix4 &currentFromShape,
                       const std::map<std::string, Matrix4> &systems);

    /// A point has been moved so far, current space: from any thread.
    void moved(Vec3 way);
    /// A point was to go where no point is.
    void wentNowhere() { astray_.store(true, std::memory_order_relaxed); }

    /// Tells what is wrong of all together, once for each request that is at fault.
    static void report(std::span<const std::shared_ptr<DisplacementBounds>>, DiagnosticSink &);

private:
    std::shared_ptr<const ShaderRecord> record_;
    std::optional<float> bound_; ///< What the file says, if it does,
    std::string space_;          ///< in this space.
    Matrix4 spaceFromCurrent_;
    std::atomic<float> most_ = 0; ///< In that space.
    std::atomic<bool> astray_ = false;
};

} // namespace candela
