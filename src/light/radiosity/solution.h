// SPDX-License-Identifier: Apache-2.0
// Wavelet radiosity: the irradiance of every side of every surface, solved once for a scene and
// asked for at any point of it (paper, section 5.3; DESIGN 6).
#pragma once

#include "light/radiosity/links.h"
#include "light/radiosity/settings.h"
#include "light/vertex/surface_vertices.h"

#include <functional>

namespace candela::radiosity {

/// Immutable: asked by all threads.
class Solution {
public:
    using Progress = std::function<void(double done)>;
    Solution(const Scene &, const SolverSettings &, const Progress & = {});

    /// Irradiance at points that rays have met, on the side that they came from and on the other,
    /// W m^-2; direct light is that of light sources. Null planes are not wanted.
    struct Answer {
        std::array<float *, colorSamples> direct{}, indirect{};
        std::array<float *, colorSamples> directBehind{}, indirectBehind{};
    };
    void irradiance(SurfaceVertices &, const Answer &) const;

    const Mesh &mesh() const { return mesh_; }
    const Fields &fields() const { return fields_; }
    const Links &links() const { return links_; }
    const SolverStatistics &statistics() const { return statistics_; }

private:
    void solve(const SolverSettings &, const Progress &);
    double iterate();
    void gather();
    void pushDown(int element);
    void pull(int element, std::vector<Color> &) const;
    double flux(int root, const std::vector<Color> &) const;
    Color at(std::int32_t face, Place, const std::vector<Color> &) const;
    void shineThrough();

    Mesh mesh_;
    Fields fields_;
    Links links_;
    SolverStatistics statistics_;
};

} // namespace candela::radiosity
