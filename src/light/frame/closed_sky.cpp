// SPDX-License-Identifier: Apache-2.0
#include "light/frame/closed_sky.h"

#include "light/vertex/light_samples.h"
#include "light/vertex/shadow_rays.h"

#include <algorithm>
#include <numeric>

namespace candela {

namespace {

/// Places about the world's middle that are looked from, along either side: within a dome, too.
constexpr int side = 3, places = side * side * side;
constexpr float apart = 0.2f; // As a share of the world's extent.
/// Surfaces that a view passes: what lies behind more is not known.
constexpr int mostPassed = 64;

/// Views from the middle of the world towards a distant light.
class Views {
public:
    Views(const Scene &scene, int light) : scene_(scene), rays_(places), hits_(places) {
        const Box3 &box = scene.bound();
        Planes<float> numbers(3, places), anySide(1, places);
        for (int i = 0; i < places; ++i) {
            const float steps[] = {float(i % side), float(i / side % side),
                                   float(i / (side * side))};
            for (int c = 0; c < 3; ++c) {
                const float off = (steps[c] - (side - 1) / 2) * apart;
                rays_.origin[c][i] = box.centre()[c] + off * box.extent()[c];
                numbers[c][i] = (float(i) + 0.5f) / places;
            }
            anySide[0][i] = 0;
            rays_.time[i] = scene.camera().shutterOpen();
        }
        aim(light, numbers, anySide[0]);
    }

    /// No light comes through.
    bool areAllStopped() {
        Planes<float> through(colorSamples, places);
        float *const planes[colorSamples] = {through[0], through[1], through[2]};
        scene_.transmittance(rays_, planes);
        return std::all_of(planes[0], planes[0] + rays_.count,
                           [](float share) { return share == 0; });
    }

    /// The index of the light that is the last thing of every view, and stops it; -1 if there is
    /// none such.
    int outermostLight() {
        std::vector<int> order(places), last(places, -1);
        std::vector<float> before(places, 0.0f); // The tMin behind all but the last thing.
        for (int passed = 0; passed < mostPassed; ++passed) {
            scene_.intersect(rays_, hits_, Coherence::Secondary);
            int met = 0;
            for (int i = 0; i < rays_.count; ++i)
                if (rays_.tMin[i] < rays_.tMax[i] && hits_.shape[i] != noHit)
                    order[std::size_t(met++)] = i;
            if (met == 0)
                return commonLight(last, before);
            ShadingPoints points(places);
            scene_.describedPoints(rays_, hits_, order.data(), met, points);
            for (int k = 0; k < met; ++k) {
                const int i = order[std::size_t(k)];
                last[std::size_t(i)] = points.light[k] - 1;
                before[std::size_t(i)] = rays_.tMin[i];
                rays_.tMin[i] = passing(hits_.t[i]);
            }
        }
        return -1;
    }

private:
    void aim(int light, const Planes<float> &numbers, const float *anySide) {
        const std::vector<std::int32_t> lightSet(places, scene_.lights().setOfAll());
        LightQuery query;
        query.count = places;
        query.P = query.Ps = {rays_.origin[0], rays_.origin[1], rays_.origin[2]};
        query.N = {anySide, anySide, anySide};
        query.lightSet = lightSet.data();
        query.time = rays_.time;
        query.choice = numbers[0];
        query.position = {numbers[1], numbers[2]};
        LightSampleStorage storage(places);
        scene_.lights().sampleOne(light, query, storage.samples);
        for (int i = 0; i < places; ++i) {
            for (int c = 0; c < 3; ++c)
                rays_.direction[c][i] = storage.samples.L[c][i];
            rays_.tMin[i] = 0;
            rays_.tMax[i] = shadowRayEndFor(storage.samples.distance[i]);
        }
        rays_.count = places;
    }

    /// Things may be last and yet let light pass (Attribute "visibility").
    int commonLight(const std::vector<int> &last, const std::vector<float> &before) {
        const auto [least, most] = std::ranges::minmax(last);
        std::copy(before.begin(), before.end(), rays_.tMin);
        return least == most && least >= 0 && areAllStopped() ? least : -1;
    }

    const Scene &scene_;
    RayBatch rays_;
    HitBatch hits_;
};

} // namespace

int closedSkyBefore(const Scene &scene, int distantLight) {
    Views views(scene, distantLight);
    return views.areAllStopped() ? views.outermostLight() : -1;
}

} // namespace candela
