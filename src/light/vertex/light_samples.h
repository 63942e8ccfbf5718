// SPDX-License-Identifier: Apache-2.0
// Samples of lights for the vertices of one shader: asking for them, and room for the answers.
#pragma once

#include "light/vertex/surface_vertices.h"

namespace candela {

/// Storage for Lights::sample().
struct LightSampleStorage {
    explicit LightSampleStorage(int capacity);
    /// From now on samples say where on lights they lie: LightSamples::probability, normal.
    void tellPlaces();
    Planes<float> floats;
    Planes<std::int32_t> integers;
    Planes<std::uint8_t> bytes;
    Planes<float> places;
    LightSamples samples;
};

/// Uniform samples that choose a light, and a place on it.
struct LightNumbers {
    const float *choice, *u, *v;
};

/// What lights are told of the vertices themselves.
LightQuery askingPoints(SurfaceVertices &);
/// What lights are asked by vertices with the normals N (LightQuery::N), from which rays are
/// scattered where `scattered` is above 0 (null: nowhere).
LightQuery lightQuery(SurfaceVertices &, const ConstVec3Planes &N, const float *scattered,
                      const LightNumbers &);

/// Rows of light samples, a sample of each vertex to a row, as SurfaceVertices::shade() takes them.
class LightRows {
public:
    /// Makes room; what the rows held is lost.
    void reserve(int rows, int lanes);
    MutableVec3Planes L(int row) const;
    std::array<float *, colorSamples> Cl(int row) const;
    std::int32_t *light(int row) const { return lights_[0] + row * lanes_; }

private:
    Planes<float> directions_, colors_;
    Planes<std::int32_t> lights_;
    int lanes_ = 0;
};

/// Vertices that need a shadow ray: those whose light is not
/// black and may be stopped. Returns how many; `lanes` has room for 15 more than all.
/// `needed` is scratch.
int lanesInNeedOfShadowRays(int count, const LightSamples &, float *const *light, int *needed,
                            int *lanes);

/// directionPdf[i] = 0 where the shader hears light[i] by samples of the light alone (see
/// LightCategories::hearsAsIndirect): no direction can find it, so the sample counts in full.
void leaveToLightSampling(const ShaderCode &, int count, const std::int32_t *light,
                          float *directionPdf);

/// (ux,uy,uz) = (x,y,z) / its length.
void unitDirections(int count, const float *x, const float *y, const float *z, float *ux, float *uy,
                    float *uz);

} // namespace candela
