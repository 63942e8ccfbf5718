// SPDX-License-Identifier: Apache-2.0
#include "light/frame/darkness.h"

#include "light/vertex/shadow_rays.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <numeric>
#include <optional>
#include <vector>

namespace candela {

namespace {

/// Points of the frame that are looked at, along either side; and places on each light.
constexpr int side = 48, looks = side * side;
constexpr int placesOnLights = 4;
/// Of more lights so many are looked at, from the first to the last: a second's work.
constexpr std::size_t mostLights = 128;

/// The van der Corput sequence of base 2, and of base 3.
float radicalInverse(int base, int i) {
    double value = 0, share = 1.0 / base;
    for (; i > 0; i /= base, share /= base)
        value += (i % base) * share;
    return float(value);
}

/// Rays from the camera through a grid of places, and what they meet.
struct Looks {
    Looks(const Scene &scene, const std::array<int, 4> &crop)
        : scene(scene), rays(looks), hits(looks) {
        std::array<std::vector<float>, 5> numbers;
        for (int i = 0; i < looks; ++i) {
            const float u = (float(i % side) + 0.5f) / side, v = (float(i / side) + 0.5f) / side;
            numbers[0].push_back(float(crop[0]) + u * float(crop[1] - crop[0]));
            numbers[1].push_back(float(crop[2]) + v * float(crop[3] - crop[2]));
            for (int c = 2; c < 5; ++c)
                numbers[std::size_t(c)].push_back(radicalInverse(c, i));
        }
        scene.camera().rays(looks, numbers[0].data(), numbers[1].data(), numbers[2].data(),
                            numbers[3].data(), numbers[4].data(), rays);
        rays.count = looks;
    }

    /// How many rays meet something, if they are of this kind.
    int meet(std::uint8_t kind, bool fromLights = false) {
        kinds.assign(looks, kind);
        rays.kinds = kinds.data();
        rays.fromLights = fromLights;
        scene.intersect(rays, hits, Coherence::Primary);
        order.clear();
        for (int i = 0; i < looks; ++i)
            if (hits.shape[i] != noHit)
                order.push_back(i);
        return int(order.size());
    }

    const Scene &scene;
    RayBatch rays;
    HitBatch hits;
    std::vector<std::uint8_t> kinds;
    std::vector<int> order; ///< Rays that have met something.
};

std::string metres(float value) { return fmt::format("{:.4g}", value); }

/// The box of all there is lies off what the camera sees; empty if some of it does not.
std::string whereabouts(const Scene &scene) {
    const Box3 &box = scene.bound();
    const Camera &camera = scene.camera();
    if (scene.options().camera.near > 0 && box.high.z <= 0)
        return fmt::format("all there is lies behind the camera, which looks along +z: in its "
                           "space from z = {} to {}; move the world by Translate 0 0 {} before "
                           "WorldBegin",
                           metres(box.low.z), metres(box.high.z),
                           metres(std::ceil(2 * length(box.extent()) - box.low.z)));
    const float near = scene.options().camera.near, far = scene.options().camera.far;
    if (box.low.z >= far || box.high.z <= near)
        return fmt::format("all there is lies {} of the clipping planes: from z = {} to {} in the "
                           "camera's space, and Clipping shows {} to {}",
                           box.low.z >= far ? "beyond the farther" : "before the nearer",
                           metres(box.low.z), metres(box.high.z), metres(near), metres(far));
    if (!camera.moves() && !camera.shownDepth(box))
        return fmt::format("all there is lies beside what the camera sees: in its space, which "
                           "looks along +z, from ({}, {}, {}) to ({}, {}, {})",
                           metres(box.low.x), metres(box.low.y), metres(box.low.z),
                           metres(box.high.x), metres(box.high.y), metres(box.high.z));
    return {};
}

/// No camera ray has met anything.
std::string whyNothingIsSeen(const Scene &scene, Looks &look) {
    if (scene.bound().empty())
        return "there is nothing in the world: no primitive stands between WorldBegin and "
               "WorldEnd, or none could be made";
    if (const std::string where = whereabouts(scene); !where.empty())
        return where;
    if (look.meet(ray_kind::diffuse) > 0)
        return "what stands before the camera is hidden from it by Attribute \"visibility\" "
               "\"camera\" 0";
    if (look.meet(ray_kind::camera, true) > 0)
        return "what stands before the camera has one side (Sides 1), and the camera is on the "
               "other: ReverseOrientation turns it, Sides 2 shows both";
    const Vec3 extent = scene.bound().extent();
    return fmt::format("no ray of the camera has met anything: what there is ({} x {} x {} in its "
                       "space) is too small or too thin for the picture, or lies where it does not "
                       "look",
                       metres(extent.x), metres(extent.y), metres(extent.z));
}

/// What one light does for points that are seen.
struct Share {
    int lit = 0;    ///< Points that it is on for.
    int bright = 0; ///< Those that it sends something to, shadows left out,
    int faced = 0;  ///< from their own side,
    int open = 0;   ///< with nothing between.
};

/// The points that the camera sees, and what lights do for them.
class SeenPoints {
public:
    explicit SeenPoints(Looks &look)
        : scene_(look.scene), count_(int(look.order.size())), points_(looks), storage_(looks),
          shadows_(looks), numbers_(3, looks), origins_(3, looks) {
        scene_.describedPoints(look.rays, look.hits, look.order.data(), count_, points_);
        for (int i = 0; i < count_; ++i) {
            const Vec3 I = vector(ShaderInput::I, i), Ng = vector(ShaderInput::Ng, i);
            const Vec3 origin =
                Scene::offsetOrigin(vector(ShaderInput::P, i), Ng, I * -1.0f, points_.offset[i]);
            for (int c = 0; c < 3; ++c)
                origins_[c][i] = origin[c];
        }
    }

    Share shareOf(int light) {
        Share share;
        for (int i = 0; i < count_; ++i)
            share.lit += scene_.lights().isOn(points_.lightSet[i], light + 1);
        if (scene_.lights().facts(light).isAmbient) {
            addAmbient(share);
            return share;
        }
        for (int place = 0; place < placesOnLights; ++place)
            addSamples(light, place, share);
        return share;
    }

private:
    Vec3 vector(ShaderInput first, int i) {
        return {points_.input(first, 0)[i], points_.input(first, 1)[i], points_.input(first, 2)[i]};
    }

    /// What asks at the points; `anySide` is 0 in all lanes.
    LightQuery queryOf(const std::vector<float> &anySide) {
        LightQuery query;
        query.count = count_;
        query.P = {origins_[0], origins_[1], origins_[2]};
        query.Ps = {points_.input(ShaderInput::P, 0), points_.input(ShaderInput::P, 1),
                    points_.input(ShaderInput::P, 2)};
        query.Ns = {points_.input(ShaderInput::N, 0), points_.input(ShaderInput::N, 1),
                    points_.input(ShaderInput::N, 2)};
        query.I = {points_.input(ShaderInput::I, 0), points_.input(ShaderInput::I, 1),
                   points_.input(ShaderInput::I, 2)};
        query.N = {anySide.data(), anySide.data(), anySide.data()};
        query.lightSet = points_.lightSet;
        query.time = points_.input(int(ShaderInput::time));
        return query;
    }

    /// Ambient lights are asked together, and nothing stands between.
    void addAmbient(Share &share) {
        const std::vector<float> anySide(std::size_t(count_), 0.0f);
        Planes<float> light(colorSamples, looks);
        float *const planes[colorSamples] = {light[0], light[1], light[2]};
        scene_.lights().ambient(queryOf(anySide), planes);
        for (int i = 0; i < count_; ++i)
            share.open += planes[0][i] > 0 || planes[1][i] > 0 || planes[2][i] > 0;
        share.bright = share.faced = share.open;
    }

    void addSamples(int light, int place, Share &share) {
        for (int i = 0; i < count_; ++i)
            for (int c = 0; c < 3; ++c)
                numbers_[c][i] = radicalInverse(c + 2, i * placesOnLights + place + 1);
        const std::vector<float> anySide(std::size_t(count_), 0.0f);
        LightQuery query = queryOf(anySide);
        query.choice = numbers_[0];
        query.position = {numbers_[1], numbers_[2]};
        LightSamples &samples = storage_.samples;
        scene_.lights().sampleOne(light, query, samples);
        countBright(samples, share);
    }

    void countBright(const LightSamples &samples, Share &share) {
        shadows_.count = count_;
        for (int i = 0; i < count_; ++i) {
            bool bright = false;
            for (int c = 0; c < colorSamples; ++c)
                bright |= samples.light[i] != 0 && samples.value[c][i] > 0;
            const Vec3 L = {samples.L[0][i], samples.L[1][i], samples.L[2][i]};
            // Points are seen from the side that N, turned to the eye, is on.
            const Vec3 N = vector(ShaderInput::Ng, i), I = vector(ShaderInput::I, i);
            const bool faces = dot(N, L) * dot(N, I) < 0;
            share.bright += bright, share.faced += bright && faces;
            for (int c = 0; c < 3; ++c)
                shadows_.origin[c][i] = origins_[c][i], shadows_.direction[c][i] = L[c];
            shadows_.tMin[i] = 0;
            shadows_.tMax[i] = bright && faces ? shadowRayEndFor(samples.distance[i]) : 0;
            shadows_.time[i] = points_.input(int(ShaderInput::time))[i];
        }
        Planes<float> through(colorSamples, looks);
        float *const planes[colorSamples] = {through[0], through[1], through[2]};
        scene_.transmittance(shadows_, planes);
        for (int i = 0; i < count_; ++i)
            share.open += shadows_.tMax[i] > 0 && (samples.castsShadow[i] == 0 || planes[0][i] > 0);
    }

    const Scene &scene_;
    const int count_;
    ShadingPoints points_;
    LightSampleStorage storage_;
    RayBatch shadows_;
    Planes<float> numbers_, origins_;
};

/// A light as a message names it.
std::string nameOf(const Lights &lights, int index) {
    const LightFacts light = lights.facts(index);
    const std::string place = light.where.text();
    return light.title + (place.empty() ? "" : " (" + place + ")");
}

/// Of several lights the first is named.
std::string named(const Lights &lights, const std::vector<int> &which) {
    std::string text = nameOf(lights, which.front());
    if (which.size() > 1)
        text += fmt::format(" and {} more", which.size() - 1);
    return text;
}

std::string whyTheSeenIsDark(const Scene &scene, Looks &look) {
    const Lights lights = scene.lights();
    std::vector<int> present, off, dark, behind, shadowed;
    for (int light = 0; light < lights.count(); ++light)
        if (lights.facts(light).isThere)
            present.push_back(light);
    if (lights.count() == 0)
        return "nothing shines: there is no light source (LightSource and AreaLightSource make "
               "them), and no surface that is seen gives light of its own";
    if (present.empty())
        return named(lights, {0}) + " has nothing to shine with: its shader has not been found or "
                                    "is faulty, or it is an area light around no primitive";
    const bool hasSource =
        std::ranges::any_of(present, [&](int light) { return !lights.facts(light).isSurface; });
    SeenPoints points(look);
    const std::size_t asked = std::min(present.size(), mostLights);
    for (std::size_t k = 0; k < asked; ++k) {
        const int light = present[k * present.size() / asked];
        const Share share = points.shareOf(light);
        if (share.open > 0)
            return "light reaches what is seen, and nothing comes back from it: its surfaces are "
                   "black (Color, Kd; Ka for ambient light) or want light that they do not get";
        (share.lit == 0      ? off
         : share.bright == 0 ? dark
         : share.faced == 0  ? behind
                             : shadowed)
            .push_back(light);
    }
    if (!shadowed.empty() && !hasSource)
        return {};
    if (!shadowed.empty())
        return "what is seen lies in shadow: something stands between it and " +
               named(lights, shadowed);
    if (!behind.empty())
        return "what is seen turns its back to " + named(lights, behind) +
               ": the light stands behind it, as the camera sees it";
    if (!dark.empty())
        return named(lights, dark) +
               " sends nothing to what is seen: it shines elsewhere (an area light to the side of "
               "its normals alone, which ReverseOrientation turns), or its intensity is 0";
    return named(lights, off) + " is on for nothing that is seen: a light is on to the end of the "
                                "block that it stands in, and where Illuminate says";
}

} // namespace

std::string whyBlack(const Scene &scene, const std::array<int, 4> &crop, bool isClear) {
    Looks look(scene, crop);
    if (look.meet(ray_kind::camera) == 0)
        return whyNothingIsSeen(scene, look);
    if (isClear)
        return "all that is seen is transparent: its Opacity, or the Oi of its shaders, is 0, or "
               "it is Matte";
    return whyTheSeenIsDark(scene, look);
}

} // namespace candela
