// SPDX-License-Identifier: Apache-2.0
// Surfaces that shine: which of them links may serve, and what they send.
#pragma once

#include "light/radiosity/mesh.h"
#include "light/vertex/surface_vertices.h"

namespace candela::radiosity {

/// What points of surfaces of one code send to all sides alike: exitance, W m^-2. One a thread.
class EmissionQuestion {
public:
    static constexpr int capacity = 512;
    EmissionQuestion();

    /// `Ng` is the unit normal on the side that is asked about.
    void ask(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &Ng,
             float *const *exitance);
    /// The same; false if some point sends other radiance in other directions.
    bool isTheSameInAllDirections(const Scene &, int code, const SurfacePlaces &,
                                  const Vec3Planes &Ng);

private:
    void askAlong(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &Ng,
                  std::array<float, 2> direction, float *const *radiance);

    SurfaceVertices vertices_;
    Planes<float> I_, first_, other_;
};

/// By index of the light: 1 if it is made of surfaces that send the same radiance in all
/// directions. Of such lights links bring what is sent; others are sampled.
std::vector<std::uint8_t> linkedLamps(const Mesh &);

} // namespace candela::radiosity
