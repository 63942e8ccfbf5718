// SPDX-License-Identifier: Apache-2.0
// The points where a wave meets surfaces of one shader, and the questions it asks them.
#pragma once

#include "foundation/units/color.h"
#include "light/transport/cone_mixture.h"
#include "world/scene/scene.h"

#include <vector>

namespace candela {

class SurfaceVertices {
public:
    explicit SurfaceVertices(int capacity);

    /// Fills the points of hits[order[0..count)] and their facing geometric normals.
    void meet(const Scene &, int code, const RayBatch &, const HitBatch &, const int *order,
              int count);
    /// Asks for importance, opacity and the answer to ambient light (Prepare).
    void prepare(const float *const *ambient);
    /// Linear response g (see ir::Question::Scatter) to light along `direction` (any length);
    /// `answered` is finiteRequests or the number of a delta request, lane by lane; `light` says
    /// whose light it is (index + 1, 0 = indirect).
    void scatter(const ConstVec3Planes &direction, const std::int32_t *answered,
                 const std::int32_t *light, float *const *g);
    /// All light given: `sampleCount` rows of `lanes()` lanes in L and Cl. Answers Ci and Oi.
    void shade(int sampleCount, float *const *L, float *const *Cl, const std::int32_t *light,
               const float *const *ambient, float *const *Ci, float *const *Oi);

    const Scene &scene() const { return *scene_; }
    const ShaderCode &code() const { return *code_; }
    int codeIndex() const { return codeIndex_; }
    int count() const { return points.count; }
    int lanes() const { return capacity_; }
    Vec3 facing(int i) const { return {facing_[0][i], facing_[1][i], facing_[2][i]}; }
    ConstVec3Planes facingPlanes() const { return {facing_[0], facing_[1], facing_[2]}; }
    /// Where rays start that leave the vertices along `direction` (docs/ray-offset.md).
    void rayOrigins(const ConstVec3Planes &direction, const MutableVec3Planes &origin);
    ConstVec3Planes P() { return input(ShaderInput::P); }
    ConstVec3Planes input(ShaderInput first);

    /// The cones of the last prepare(), one for each of facts().cones.
    const std::vector<ConePlanes> &cones() const { return cones_; }
    const float *Oi(int channel) const { return opacity_[channel]; }
    const float *Ca(int channel) const { return ambientAnswer_[channel]; } ///< Null = none.

    ShadingPoints points;

private:
    ShaderArgs arguments() const;

    const Scene *scene_ = nullptr;
    const ShaderCode *code_ = nullptr;
    int codeIndex_ = 0, capacity_;
    Planes<float> facing_, step_, frame_, outputs_, shadeOutputs_;
    std::vector<float *> outputTable_;
    std::vector<ConePlanes> cones_;
    std::array<const float *, colorSamples> opacity_{}, ambientAnswer_{};
};

} // namespace candela
