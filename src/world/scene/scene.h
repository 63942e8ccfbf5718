// SPDX-License-Identifier: Apache-2.0
// The immutable world, as estimators see it: rays in, hits and shading points and light out, all
// in batches. Embree stands behind this door alone.
#pragma once

#include "interface/ri/scene_builder.h"
#include "world/camera/camera.h"
#include "world/points/shading_points.h"
#include "world/rays/ray_batch.h"
#include "world/scene/lights.h"
#include "world/scene/media.h"
#include "world/scene/surface_domains.h"
#include "world/shading/shader_library.h"

#include <functional>
#include <memory>
#include <string>

namespace candela {

struct SceneState;

/// The volumes that shadow rays go through, ray by ray: what each is in where it begins, and the
/// number of the atmosphere to what it ends at.
struct ShadowMedia {
    const std::uint32_t *inner, *outer;
    const std::int32_t *atmosphere;
    /// They begin where the rays' origins are, and not at tMin.
    bool fromOrigins = false;
};

enum class Coherence { Primary, Secondary };

class Scene {
public:
    ~Scene();

    const Options &options() const;
    const Camera &camera() const;
    /// The integrator is "classic" (DESIGN section 6): ambient() is the ambient lights alone.
    bool isClassic() const;
    /// Paths begin on lights, too (`bidir`, `vcm`).
    bool isBidirectional() const;
    /// Light is solved for on surfaces (`radiosity`).
    bool isSolved() const;

    // ---- Rays ----
    /// Nearest hits. Which of several equally near ones is kept depends on the scene and on the
    /// rays' packet alone. Sets of 16 consecutive rays are packets, always the same ones.
    void intersect(const RayBatch &, HitBatch &, Coherence) const;
    /// transmittance[c][i]: what part of light comes through along ray i up to tMax: 0 behind
    /// opaque surfaces, the product of (1 - Oi) through transparent ones, else 1. False if
    /// nothing is transparent: then all c are the same, and transmittance[0] alone is filled.
    /// With media the volumes on the way count, too: each segment up to tMax, if that is finite.
    bool transmittance(const RayBatch &, float *const *transmittance,
                       const ShadowMedia *media = nullptr) const;

    // ---- Surfaces ----
    /// Surface shader codes, numbered.
    int codeCount() const;
    const ShaderCode &code(int index) const;
    /// The code that shades what ray i has met.
    int codeOf(const HitBatch &, int i) const;
    /// Bins: what is shaded together, the shapes of one code, those that are lights apart.
    int binCount() const;
    int codeOfBin(int bin) const;
    /// Rays that meet nothing: their bin, -1 as long as nothing shines there.
    int escapedBin() const;
    /// Rays meet the shape from one side alone: the one that Ng, turned as the points have it,
    /// points to.
    bool isOneSided(std::uint32_t instance, std::uint32_t shape) const;
    /// bin[i] = bin of hit i, escapedBin() where nothing was hit.
    void bins(int count, const HitBatch &, int *bin) const;
    /// Fills the shading points of hits[order[0..count)], `order` increasing, which must share one
    /// code; rays are those that made the hits. I is the ray's direction times t.
    void shadingPoints(const RayBatch &, const HitBatch &, const int *order, int count,
                       ShadingPoints &) const;
    /// Some shapes are hidden from some kinds of rays: RayBatch::kinds matters.
    bool hidesShapes() const;
    /// Some shapes are held out (RiMatte): what the eye sees of them is black and clear.
    bool hasMatte() const;
    bool isMatte(std::uint32_t instance, std::uint32_t shape) const;
    /// shadingPoints() fills this plane of ShaderInput at points of the code: position and normals,
    /// and of s, t, u, v, Cs and Os what its shader reads.
    bool tells(int code, int input) const;
    /// The same for points of any codes: their geometry, s, t, u, v, Cs and Os, whatever their
    /// shaders read.
    void describedPoints(const RayBatch &, const HitBatch &, const int *order, int count,
                         ShadingPoints &) const;
    /// False if no shader wants to know how wide rays are: their footprints need not be filled.
    bool readsFootprints() const;
    /// True if points of the code know how N changes over their footprints: what a curved surface
    /// does to the width of rays that it reflects or refracts.
    bool bendsRays(int code) const;
    /// Where the rays met the elements, on these rather than on the true surface.
    void elementPoints(const RayBatch &, const HitBatch &, const int *order, int count,
                       const std::array<float *, 3> &point) const;
    /// The shader arguments to ask the points' shader with: inputs, parameters, variables bound.
    void bind(int code, const ShadingPoints &, ShaderArgs &) const;
    /// The documented ray-offset rule: where a ray that leaves P along `direction` starts.
    static Vec3 offsetOrigin(Vec3 P, Vec3 Ng, Vec3 direction, float offset);

    // ---- Volumes ----
    /// False if there are none: no segment of a ray need be looked at.
    bool hasVolumes() const;
    /// Those of what a ray has met.
    const SurfaceMedia &mediaOf(std::uint32_t instance, std::uint32_t shape) const;
    /// One more than there are.
    int mediaCount() const;
    /// By its number, from 1.
    const ShaderInstance &medium(std::int32_t number) const;
    /// The atmosphere of what light `light` (index + 1) shines from; 0 where it has no surface.
    std::int32_t mediumOfLight(std::int32_t light) const;

    // ---- Volumes and paths that begin on lights ----
    /// Some surface has an Interior.
    bool hasInteriors() const;
    /// The bodies that rays begin in: those that they leave, going straight through everything, and
    /// have not entered.
    void bodiesAround(const RayBatch &, MediaAround *) const;
    /// Why such paths would not find what camera paths do; empty if they would.
    std::string whyVolumesStopLightPaths() const;

    Lights lights() const;
    /// Around all shapes, current space; empty if there are none.
    const Box3 &bound() const;
    /// Surfaces by their parameters.
    SurfaceDomains domains() const;

    struct Statistics {
        std::size_t primitives = 0, instances = 0, triangles = 0, lights = 0, codes = 0;
        double secondsDicing = 0, secondsBuilding = 0;
        double secondsTracing = 0; ///< Of all threads, with rays, so far.
    };
    Statistics statistics() const;

private:
    friend class SceneCompiler;
    explicit Scene(std::unique_ptr<SceneState>);
    std::unique_ptr<SceneState> state_;
};

/// Builds scenes from what the graphics state says, and hands each to `render` at worldEnd.
class SceneCompiler : public SceneBuilder {
public:
    using Render = std::function<void(const Scene &)>;
    SceneCompiler(ShaderLibrary &, DiagnosticSink &, Render);
    ~SceneCompiler() override;

    void worldBegin(const Options &) override;
    void light(std::shared_ptr<const LightRecord>) override;
    void primitive(std::shared_ptr<const PrimitiveRecord>, std::shared_ptr<const Attributes>,
                   const MotionTransform &currentFromObject) override;
    void objectBegin(int object) override;
    void objectEnd() override;
    void instance(int object, std::shared_ptr<const Attributes>,
                  const MotionTransform &currentFromObject) override;
    void solidBegin(SolidOperation) override;
    void solidEnd() override;
    void coordinateSystem(const std::string &name, const Matrix4 &currentFromSpace) override;
    void imager(std::shared_ptr<const ShaderRecord>) override;
    void worldEnd() override;

private:
    struct State;
    std::unique_ptr<State> state_;
};

} // namespace candela
