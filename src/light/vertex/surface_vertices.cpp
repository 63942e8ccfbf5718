// SPDX-License-Identifier: Apache-2.0
#include "light/vertex/surface_vertices.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "world/scene/opacity.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

CANDELA_HOT void faceForward(int count, const float *__restrict nx, const float *__restrict ny,
                             const float *__restrict nz, const float *__restrict ix,
                             const float *__restrict iy, const float *__restrict iz,
                             float *__restrict fx, float *__restrict fy, float *__restrict fz) {
    for (int i = 0; i < count; ++i) {
        float sign = nx[i] * ix[i] + ny[i] * iy[i] + nz[i] * iz[i] > 0 ? -1.0f : 1.0f;
        fx[i] = nx[i] * sign;
        fy[i] = ny[i] * sign;
        fz[i] = nz[i] * sign;
    }
}

/// Scene::offsetOrigin for unit normals.
CANDELA_HOT void offsetOrigins(int count, const ConstVec3Planes &P, const ConstVec3Planes &normal,
                               const ConstVec3Planes &along, const float *__restrict offset,
                               const MutableVec3Planes &origin) {
    const float *__restrict px = P[0], *__restrict py = P[1], *__restrict pz = P[2];
    const float *__restrict nx = normal[0], *__restrict ny = normal[1], *__restrict nz = normal[2];
    const float *__restrict dx = along[0], *__restrict dy = along[1], *__restrict dz = along[2];
    float *__restrict ox = origin[0], *__restrict oy = origin[1], *__restrict oz = origin[2];
#pragma GCC ivdep // Planes are apart; there are too many to compare.
    for (int i = 0; i < count; ++i) {
        const float side = nx[i] * dx[i] + ny[i] * dy[i] + nz[i] * dz[i];
        const float step = side < 0 ? -offset[i] : offset[i];
        ox[i] = px[i] + nx[i] * step;
        oy[i] = py[i] + ny[i] * step;
        oz[i] = pz[i] + nz[i] * step;
    }
}

CANDELA_HOT void clampOpacities(int count, float *__restrict Oi) {
    for (int i = 0; i < count; ++i)
        Oi[i] = clampedOpacity(Oi[i]);
}

/// Grows storage to what a question needs; keeps it otherwise.
void reserve(Planes<float> &planes, int count, int lanes) {
    if (planes.planes() < count)
        planes = Planes<float>(count, lanes);
}

/// The planes of the cones, as they are before the shader is asked.
void beginCones(int count, const ir::SurfaceFacts &facts, float *const *outputs,
                std::vector<ConePlanes> &cones) {
    cones.clear();
    for (const ir::ConeSlot &cone : facts.cones) {
        float *const *axis = outputs + cone.axis, *angle = outputs[cone.angle];
        float *importance = outputs[cone.importance];
        std::fill_n(importance, count, 0.0f); // Lanes that do not reach the request leave it.
        lanes::fill(count, 180.0f, angle);
        for (int c = 0; c < 3 && !facts.affine; ++c)
            std::fill_n(axis[c], count, 0.0f); // Gathering asks whether there is an axis.
        const bool first = cones.empty() || cones.back().request != cone.request;
        const float *kindAngle = first ? angle : cones.back().kindAngle;
        cones.push_back({{axis[0], axis[1], axis[2]},
                         angle,
                         outputs[cone.exponent],
                         importance,
                         kindAngle,
                         cone.request,
                         first,
                         cone.exact});
    }
}

} // namespace

void facingNormals(int count, const ConstVec3Planes &Ng, const ConstVec3Planes &I,
                   const MutableVec3Planes &facing) {
    faceForward(count, Ng[0], Ng[1], Ng[2], I[0], I[1], I[2], facing[0], facing[1], facing[2]);
}

SurfaceVertices::SurfaceVertices(int capacity)
    : points(capacity), capacity_(paddedLanes(capacity)) {
    storage_.facing = Planes<float>(3, capacity);
    storage_.litPoints = Planes<float>(3, capacity);
    storage_.around = Planes<std::uint32_t>(2, capacity);
}

ConstVec3Planes SurfaceVertices::input(ShaderInput first) {
    int at = int(first);
    return {points.input(at), points.input(at + 1), points.input(at + 2)};
}

void SurfaceVertices::meet(const Scene &scene, int code, const RayBatch &rays, const HitBatch &hits,
                           const int *order, int count) {
    scene_ = &scene;
    codeIndex_ = code;
    scene.shadingPoints(rays, hits, order, count, points);
    findSides();
}

void SurfaceVertices::place(const Scene &scene, int code, const SurfacePlaces &places,
                            const Vec3Planes &I, float time) {
    scene_ = &scene;
    codeIndex_ = code;
    scene.domains().shadingPoints(places, I, time, points);
    findSides();
}

void SurfaceVertices::findSides() {
    const Planes<float> &facing = storage_.facing;
    facingNormals(count(), input(ShaderInput::Ng), input(ShaderInput::I),
                  {facing[0], facing[1], facing[2]});
    const Planes<float> &lit = storage_.litPoints;
    rayOrigins(facingPlanes(), {lit[0], lit[1], lit[2]});
}

void SurfaceVertices::rayOrigins(const ConstVec3Planes &along, const MutableVec3Planes &origin) {
    offsetOrigins(count(), P(), facingPlanes(), along, points.offset, origin);
}

bool SurfaceVertices::isMetFromInside(int i) {
    const ConstVec3Planes n = input(ShaderInput::Ng), along = input(ShaderInput::I);
    return n[0][i] * along[0][i] + n[1][i] * along[1][i] + n[2][i] * along[2][i] > 0;
}

bool SurfaceVertices::leadsInside(int i, const ConstVec3Planes &along) {
    const ConstVec3Planes n = input(ShaderInput::Ng);
    return n[0][i] * along[0][i] + n[1][i] * along[1][i] + n[2][i] * along[2][i] < 0;
}

MediaAround SurfaceVertices::mediaAlong(int i, const ConstVec3Planes &direction) {
    return MediaAround(around()[0][i], around()[1][i])
        .beyond(mediaOf(i), isMetFromInside(i), leadsInside(i, direction));
}

ShaderArgs SurfaceVertices::arguments() const {
    ShaderArgs args;
    scene_->bind(codeIndex_, points, args);
    if (!aloud_)
        code().bind(args, false);
    args.count = points.count;
    return args;
}

/// A lane each: every vertex is seen once.
void SurfaceVertices::bindFrames(PreparedView &view, ShaderArgs &args) {
    args.surfaceFrame = view.surfaceFrame[0];
    args.viewFrame = view.viewFrame[0];
}

void SurfaceVertices::prepare(const float *const *ambient, const float *const *irradiance) {
    prepare(ambient, irradiance, view_);
}

void SurfaceVertices::beginAnswers(const QuestionCode &question, int count,
                                   PreparedView &view) const {
    reserve(view.outputs, int(question.function.outputs.size()), capacity_);
    reserve(view.viewFrame, question.function.viewSlots, capacity_);
    view.outputTable.resize(question.function.outputs.size());
    for (std::size_t slot = 0; slot < view.outputTable.size(); ++slot)
        view.outputTable[slot] = view.outputs[int(slot)];
    beginCones(count, code().facts(), view.outputTable.data(), view.answers.cones);
}

void SurfaceVertices::takeAnswers(const QuestionCode &question, int count, PreparedView &view) {
    float *const *outputs = view.outputTable.data();
    const int completed = question.output(ir::OutputKind::Completed);
    view.answers.completed = completed >= 0 ? outputs[completed] : nullptr;
    const int Oi = question.output(ir::OutputKind::Oi), Ca = question.output(ir::OutputKind::Ca);
    for (int c = 0; c < colorSamples; ++c) {
        clampOpacities(count, outputs[Oi + c]);
        view.answers.Oi[c] = outputs[Oi + c];
        view.answers.Ca[c] = Ca >= 0 ? outputs[Ca + c] : nullptr;
    }
}

void SurfaceVertices::prepare(const float *const *ambient, const float *const *irradiance,
                              PreparedView &view) {
    const QuestionCode &question = code().question(ir::Question::Prepare);
    reserve(view.surfaceFrame, question.function.surfaceSlots, capacity_);
    beginAnswers(question, points.count, view);
    ShaderArgs args = arguments();
    args.outputs = view.outputTable.data();
    bindFrames(view, args);
    args.ambient = ambient;
    args.irradiance = irradiance;
    question.ask(args);
    takeAnswers(question, points.count, view);
}

void SurfaceVertices::scatter(const ConstVec3Planes &direction, const std::int32_t *answered,
                              const std::int32_t *light, float *const *g) {
    scatter(view_, direction, answered, light, g);
}

void SurfaceVertices::scatter(PreparedView &view, const ConstVec3Planes &direction,
                              const std::int32_t *answered, const std::int32_t *light,
                              float *const *g) {
    for (int c = 0; c < 3; ++c)
        points.readFrom(int(ShaderInput::sampleL) + c, direction[c]);
    const QuestionCode &question = code().question(ir::Question::Scatter);
    ShaderArgs args = arguments();
    args.outputs = g;
    bindFrames(view, args);
    args.answeredRequest = answered;
    args.sampleLight = light;
    question.ask(args);
}

/// As long as it lives, the vertices are seen along another I, and stay silent. E is the camera's,
/// whoever looks.
class SurfaceVertices::SeenFrom {
public:
    SeenFrom(SurfaceVertices &vertices, const ConstVec3Planes &I)
        : vertices_(vertices), wasAloud_(vertices.aloud_) {
        for (int c = 0; c < 3; ++c)
            replace(int(ShaderInput::I) + c, const_cast<float *>(I[c]), kept_[c]);
        vertices.aloud_ = false;
    }
    ~SeenFrom() {
        for (int c = 0; c < 3; ++c)
            put(int(ShaderInput::I) + c, kept_[c]);
        vertices_.aloud_ = wasAloud_;
    }
    SeenFrom(const SeenFrom &) = delete;

private:
    struct Planes {
        float *input, *unmoved;
    };
    bool movesPoints() const { return !vertices_.points.unmovedTable.empty(); }
    void replace(int plane, float *by, Planes &kept) {
        kept = {vertices_.points.inputTable[plane],
                movesPoints() ? vertices_.points.unmovedTable[plane] : nullptr};
        put(plane, {by, by});
    }
    void put(int plane, Planes planes) {
        vertices_.points.inputTable[plane] = planes.input;
        if (movesPoints())
            vertices_.points.unmovedTable[plane] = planes.unmoved;
    }

    SurfaceVertices &vertices_;
    bool wasAloud_;
    Planes kept_[3];
};

void SurfaceVertices::prepareFrom(const ConstVec3Planes &I, PreparedView &view) {
    const SeenFrom elsewhere(*this, I);
    prepare(nullptr, nullptr, view);
}

void SurfaceVertices::scatterFrom(const ConstVec3Planes &I, PreparedView &view,
                                  const ConstVec3Planes &direction, const std::int32_t *answered,
                                  const std::int32_t *light, float *const *g) {
    const SeenFrom elsewhere(*this, I);
    scatter(view, direction, answered, light, g);
}

void SurfaceVertices::scatterOf(int count, const std::int32_t *of, const ConstVec3Planes &direction,
                                const std::int32_t *answered, const std::int32_t *light,
                                float *const *g) {
    for (int c = 0; c < 3; ++c)
        points.readFrom(int(ShaderInput::sampleL) + c, direction[c]);
    ShaderArgs args = arguments();
    args.count = count;
    args.viewLane = of;
    args.outputs = g;
    bindFrames(view_, args);
    args.answeredRequest = answered;
    args.sampleLight = light;
    code().question(ir::Question::Scatter).ask(args);
}

void SurfaceVertices::prepareSurface(PreparedView &view) {
    const QuestionCode &question = code().question(ir::Question::Surface);
    reserve(view.surfaceFrame, question.function.surfaceSlots, capacity_);
    ShaderArgs args = arguments();
    code().bind(args, false);
    args.surfaceFrame = view.surfaceFrame[0];
    question.ask(args);
}

void SurfaceVertices::prepareOf(int count, const std::int32_t *of, const ConstVec3Planes &I,
                                PreparedView &view) {
    const QuestionCode &question = code().question(ir::Question::View);
    beginAnswers(question, count, view);
    const SeenFrom elsewhere(*this, I); // E is 0 in all lanes there are.
    ShaderArgs args = arguments();
    args.count = count;
    args.surfaceLane = of;
    args.outputs = view.outputTable.data();
    bindFrames(view, args);
    question.ask(args);
    takeAnswers(question, count, view);
}

ShaderArgs SurfaceVertices::litArguments(int sampleCount, float *const *L, float *const *Cl,
                                         const std::int32_t *light,
                                         const float *const *ambient) const {
    ShaderArgs args = arguments();
    args.sampleCount = sampleCount;
    args.sampleL = L;
    args.sampleCl = Cl;
    args.sampleStride = capacity_;
    args.sampleLight = light;
    args.ambient = ambient;
    return args;
}

/// Planes for all that the question writes.
std::vector<float *> SurfaceVertices::roomForOutputs(const QuestionCode &question) {
    std::vector<float *> outputs(question.function.outputs.size());
    reserve(storage_.shadeOutputs, int(outputs.size()), capacity_);
    for (std::size_t slot = 0; slot < outputs.size(); ++slot)
        outputs[slot] = storage_.shadeOutputs[int(slot)];
    return outputs;
}

void SurfaceVertices::shade(int sampleCount, float *const *L, float *const *Cl,
                            const std::int32_t *light, const float *const *ambient,
                            float *const *Ci, float *const *Oi) {
    const QuestionCode &question = code().question(ir::Question::Shade);
    std::vector<float *> outputs = roomForOutputs(question);
    question.place(ir::OutputKind::Ci, Ci, outputs);
    question.place(ir::OutputKind::Oi, Oi, outputs);
    ShaderArgs args = litArguments(sampleCount, L, Cl, light, ambient);
    args.outputs = outputs.data();
    question.ask(args);
}

std::span<float *const> SurfaceVertices::outputParameters(int sampleCount, float *const *L,
                                                          float *const *Cl,
                                                          const std::int32_t *light,
                                                          const float *const *ambient) {
    const QuestionCode &question = code().question(ir::Question::Outputs);
    storage_.parameterTable = roomForOutputs(question);
    for (float *plane : storage_.parameterTable) // Where a loop is ended they are left.
        std::fill_n(plane, count(), 0.0f);
    ShaderArgs args = litArguments(sampleCount, L, Cl, light, ambient);
    args.outputs = storage_.parameterTable.data();
    question.ask(args);
    return storage_.parameterTable;
}

} // namespace candela
