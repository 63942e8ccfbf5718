// SPDX-License-Identifier: Apache-2.0
// Sensors that lie on surfaces whose light has been solved: the solution tells what they take.
#pragma once

#include "light/path/hit_bins.h"
#include "light/probe/placed_points.h"
#include "light/radiosity/solution.h"

#include <optional>
#include <span>
#include <vector>

namespace candela {

class SolvedPoints {
public:
    /// `most` points are looked up at once. With `direct` the light of light sources is wanted,
    /// too.
    SolvedPoints(const Scene &, const radiosity::Solution &, bool direct, int most);

    /// Finds the sensors that lie on a surface and face as it does.
    void lookUp(std::span<const PlacedPoint>);
    /// The irradiance of a sensor as the solution has it, W m^-2, without that of ambient lights;
    /// nothing of one that lies on no surface.
    const std::optional<Color> &at(int point) const { return found_[std::size_t(point)]; }

private:
    void takeFrom(std::span<const PlacedPoint>, int code, std::span<const int> rays);

    const Scene &scene_;
    const radiosity::Solution &solution_;
    const bool direct_;
    RayBatch rays_;
    HitBatch hits_;
    HitBins bins_;
    SurfaceVertices vertices_;
    Planes<float> light_; ///< Indirect, then direct.
    std::vector<std::optional<Color>> found_;
};

} // namespace candela
