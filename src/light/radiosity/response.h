// SPDX-License-Identifier: Apache-2.0
// What shaders make of diffuse light (ALGORITHMS 6): the questions that the solution asks them.
#pragma once

#include "light/sampling/cone_mixture.h"
#include "light/vertex/scattering_event.h"
#include "light/vertex/surface_vertices.h"

namespace candela::radiosity {

/// Of points on one side of surfaces, in planes of a colour each. A side's exitance is
/// reflectance * E of the side + transmittance * E of the other side + ambient.
struct Response {
    explicit Response(int capacity)
        : reflectance(colorSamples, capacity), transmittance(colorSamples, capacity),
          ambient(colorSamples, capacity) {}
    Planes<float> reflectance, transmittance;
    Planes<float> ambient; ///< Exitance that ambient lights leave, W m^-2.
};

/// The whole answer to light is one lobe, up to a factor: one direction tells it.
bool isOneLobe(const ShaderCode &);

/// Asks the points of a batch. One a thread.
class ResponseQuestion {
public:
    static constexpr int capacity = 512;
    ResponseQuestion();

    /// `Ng` is the unit normal on the side that is asked about; all points are of one code.
    void ask(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &Ng, Response &);

private:
    /// If so, `response` is that of every view.
    bool isAlikeInAllViews(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &Ng,
                           Response &response);
    void look(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &Ng,
              std::array<float, 2> view);
    void addView(Response &, float share);
    void addFinite(Response &, float share);
    void addDirections(Response &, float share);
    void addIrradiance(Response &, float share);
    void add(int i, Vec3 direction, float weight, float *const *g, Response &);

    SurfaceVertices vertices_;
    ConeMixture mixture_;
    ScatteringEvents events_;
    Planes<float> I_, direction_, numbers_, pdf_, response_, ambient_, one_;
    Planes<std::int32_t> answered_;
    std::array<const float *, colorSamples> ambientTable_{}, oneTable_{};
    Response slanting_{capacity}; ///< To compare with.
};

} // namespace candela::radiosity
