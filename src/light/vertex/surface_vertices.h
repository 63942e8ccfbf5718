// SPDX-License-Identifier: Apache-2.0
// The points where a wave meets surfaces of one shader, and the questions it asks them.
#pragma once

#include "foundation/units/color.h"
#include "light/sampling/cone_mixture.h"
#include "world/scene/scene.h"

#include <span>
#include <vector>

namespace candela {

/// What surfaces said to Prepare; the planes are the vertices'.
struct PreparedSurface {
    std::vector<ConePlanes> cones;                ///< One for each of facts().cones.
    std::array<const float *, colorSamples> Oi{}; ///< In [0,1].
    std::array<const float *, colorSamples> Ca{}; ///< Null = none.
    const float *completed = nullptr; ///< 0 where a loop was ended: black. Null = nowhere.
};

/// Unit normals on the side that I comes from.
void facingNormals(int count, const ConstVec3Planes &Ng, const ConstVec3Planes &I,
                   const MutableVec3Planes &facing);

/// What a shader has answered to Prepare for a view of the vertices: frames and outputs.
struct PreparedView {
    Planes<float> surfaceFrame, viewFrame, outputs;
    std::vector<float *> outputTable;
    PreparedSurface answers;
};

class SurfaceVertices {
public:
    explicit SurfaceVertices(int capacity);

    /// Fills the points of hits[order[0..count)] and their facing geometric normals.
    void meet(const Scene &, int code, const RayBatch &, const HitBatch &, const int *order,
              int count);
    /// The same of points that are named by their surfaces, seen along I.
    void place(const Scene &, int code, const SurfacePlaces &, const Vec3Planes &I, float time);
    /// Asks for importance, opacity and the answer to ambient light (Prepare), and with
    /// `irradiance`, W m^-2, to that, too.
    void prepare(const float *const *ambient, const float *const *irradiance = nullptr);
    /// Linear response g (see ir::Question::Scatter) to light along `direction` (any length);
    /// `answered` is finiteRequests or the number of a delta request, lane by lane; `light` says
    /// whose light it is (index + 1, 0 = indirect).
    void scatter(const ConstVec3Planes &direction, const std::int32_t *answered,
                 const std::int32_t *light, float *const *g);
    /// The same two of the vertices as they are seen along I (from a viewer at P - I), silently and
    /// without ambient light. What is asked next is seen again from where they were met.
    void prepareFrom(const ConstVec3Planes &I, PreparedView &);
    void scatterFrom(const ConstVec3Planes &I, PreparedView &, const ConstVec3Planes &direction,
                     const std::int32_t *answered, const std::int32_t *light, float *const *g);
    /// Many answers of some vertices, in lanes of their own, `count` <= lanes(): lane k is about
    /// vertex of[k]; both planes may name vertices again and again. scatterOf() as scatter().
    void scatterOf(int count, const std::int32_t *of, const ConstVec3Planes &direction,
                   const std::int32_t *answered, const std::int32_t *light, float *const *g);
    /// What all views of the vertices share; must come before prepareOf().
    void prepareSurface(PreparedView &);
    /// As prepareFrom(), of views along I: only answers are there, no responses.
    void prepareOf(int count, const std::int32_t *of, const ConstVec3Planes &I, PreparedView &);
    /// All light given: `sampleCount` rows of `lanes()` lanes in L and Cl. Answers Ci and Oi.
    void shade(int sampleCount, float *const *L, float *const *Cl, const std::int32_t *light,
               const float *const *ambient, float *const *Ci, float *const *Oi);
    /// Likewise the shader's output parameters: planes in the order of the outputs of
    /// ir::Question::Outputs, valid until the next question.
    std::span<float *const> outputParameters(int sampleCount, float *const *L, float *const *Cl,
                                             const std::int32_t *light,
                                             const float *const *ambient);

    /// False: shade() prints nothing, for who asks beside what is seen. At first they speak.
    void speak(bool aloud) { aloud_ = aloud; }

    const Scene &scene() const { return *scene_; }
    const ShaderCode &code() const { return scene_->code(codeIndex_); }
    int count() const { return points.count; }
    int lanes() const { return capacity_; }
    /// From where lights are sampled: where rays to the facing side start, so that those that meet
    /// lamps ask for densities from the very same points.
    ConstVec3Planes litPoints() const {
        return {storage_.litPoints[0], storage_.litPoints[1], storage_.litPoints[2]};
    }
    ConstVec3Planes facingPlanes() const {
        return {storage_.facing[0], storage_.facing[1], storage_.facing[2]};
    }
    /// Where rays start that leave the vertices along `direction` (docs/ray-offset.md).
    void rayOrigins(const ConstVec3Planes &direction, const MutableVec3Planes &origin);
    ConstVec3Planes P() { return input(ShaderInput::P); }

    /// What the rays that met the vertices were in (MediaAround); only where scenes have volumes.
    const Planes<std::uint32_t> &around() const { return storage_.around; }
    const SurfaceMedia &mediaOf(int i) const {
        return scene_->mediaOf(points.instance[i], points.shape[i]);
    }
    /// Vertex i was met from the inside.
    bool isMetFromInside(int i);
    /// Rays along `direction` leave vertex i to its inside.
    bool leadsInside(int i, const ConstVec3Planes &direction);
    /// What rays are in that leave vertex i along `direction`.
    MediaAround mediaAlong(int i, const ConstVec3Planes &direction);
    ConstVec3Planes input(ShaderInput first);

    const PreparedSurface &prepared() const { return view_.answers; }

    /// Instead of what the shader has answered.
    void setOpacity(int sample, int i, float Oi) {
        const_cast<float *>(view_.answers.Oi[sample])[i] = Oi;
    }

    ShadingPoints points;

private:
    struct Storage {
        Planes<float> facing, litPoints, shadeOutputs;
        std::vector<float *> parameterTable;
        Planes<std::uint32_t> around;
    };
    class SeenFrom;
    void findSides();
    void prepare(const float *const *ambient, const float *const *irradiance, PreparedView &);
    /// Room for what `question`, Prepare or View, says of `count` views.
    void beginAnswers(const QuestionCode &question, int count, PreparedView &) const;
    /// The answers, once it has said it.
    static void takeAnswers(const QuestionCode &, int count, PreparedView &);
    void scatter(PreparedView &, const ConstVec3Planes &direction, const std::int32_t *answered,
                 const std::int32_t *light, float *const *g);
    ShaderArgs arguments() const;
    ShaderArgs litArguments(int sampleCount, float *const *L, float *const *Cl,
                            const std::int32_t *light, const float *const *ambient) const;
    std::vector<float *> roomForOutputs(const QuestionCode &);
    static void bindFrames(PreparedView &, ShaderArgs &);

    const Scene *scene_ = nullptr;
    int codeIndex_ = 0, capacity_;
    bool aloud_ = true;
    Storage storage_;
    PreparedView view_;
};

} // namespace candela
