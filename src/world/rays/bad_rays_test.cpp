// SPDX-License-Identifier: Apache-2.0
// No ray that has no meaning reaches Embree, whose AVX2 kernels end the process over it. Run by
// CTest at every instruction set that the host has.
#include "world/rays/ray_world.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace candela {
namespace {

struct Ray {
    Vec3 origin{0, 0, 0}, direction{0, 0, 1};
    float tMin = 0, tMax = INFINITY;
};

/// Every special number in every place of a good ray.
std::vector<Ray> badRays() {
    std::vector<Ray> rays;
    for (int axis = 0; axis < 3; ++axis)
        for (float value : {NAN, INFINITY, -INFINITY}) {
            rays.emplace_back().origin[axis] = value;
            rays.emplace_back().direction[axis] = value;
        }
    rays.emplace_back().direction = {0, 0, 0};
    rays.emplace_back().direction = {-0.0f, 0, -0.0f};
    for (float tMax : {NAN, -INFINITY, -1.0f, -0.0f, 0.0f})
        rays.emplace_back().tMax = tMax;
    for (float tMin : {NAN, INFINITY, -INFINITY})
        rays.emplace_back().tMin = tMin;
    for (float same : {0.5f, 2.0f})
        rays.push_back({{0, 0, 0}, {0, 0, 1}, same, same});
    return rays;
}

/// Finite, however far from all that is useful: some of these reach Embree, and meet nothing.
std::vector<Ray> wildRays() {
    constexpr float denormal = std::numeric_limits<float>::denorm_min();
    std::vector<Ray> rays;
    for (float far : {1e38f, -1e38f, 3.4e38f}) {
        rays.push_back({{far, far, far}, {1, 0, 0}});
        rays.push_back({{far, 0, 0}, {0, far, 0}});
        rays.push_back({{5, 5, 5}, {far, far, far}});
    }
    for (float small : {denormal, 1e-38f, -1e-30f})
        rays.push_back({{5, 5, 5}, {small, 1, small}});
    return rays;
}

/// A triangle that the good ray meets at t = 1.
RayWorld triangle() {
    RayShape mesh;
    mesh.positions = {{-1, -1, 1}, {3, -1, 1}, {-1, 3, 1}};
    mesh.triangles = {{0, 1, 2}};
    return RayWorld(RayObject{mesh});
}

void set(RayBatch &rays, int i, const Ray &ray) {
    for (int axis = 0; axis < 3; ++axis)
        rays.origin[axis][i] = ray.origin[axis], rays.direction[axis][i] = ray.direction[axis];
    rays.tMin[i] = ray.tMin, rays.tMax[i] = ray.tMax, rays.time[i] = 0;
    rays.width[i] = rays.spread[i] = 0;
}

/// Good and other rays take turns, so that packets hold both; numbers left over beyond the end.
void expectMisses(const std::vector<Ray> &others, bool traced) {
    const RayWorld world = triangle();
    for (int count = 1; count <= 2 * int(others.size()); ++count) {
        RayBatch rays(count);
        for (int i = 0; i < paddedLanes(count); ++i)
            set(rays, i, {{NAN, 0, 0}, {NAN, NAN, NAN}, NAN, NAN});
        for (int i = 0; i < count; ++i)
            set(rays, i, i % 2 ? Ray{} : others[i / 2]);
        rays.count = count;
        HitBatch hits(count);
        for (bool coherent : {false, true}) {
            world.intersect(rays, hits, RayWorld::Which::All, coherent);
            for (int i = 0; i < count; ++i) {
                ASSERT_EQ(hits.shape[i], i % 2 ? 0 : noHit) << "ray " << i << " of " << count;
                if (i % 2) {
                    ASSERT_FLOAT_EQ(hits.t[i], 1);
                }
            }
        }
        std::vector<std::uint8_t> blocked(count);
        world.occluded(rays, blocked.data());
        for (int i = 0; i < count; ++i) {
            if (i % 2)
                ASSERT_EQ(blocked[i], 1) << "ray " << i << " of " << count;
            else if (traced)
                ASSERT_NE(blocked[i], 1) << "ray " << i << " of " << count;
            else
                ASSERT_EQ(blocked[i], 2) << "ray " << i << " of " << count;
        }
    }
}

TEST(BadRays, AreNotTraced) { expectMisses(badRays(), false); }

TEST(BadRays, WildOnesMeetNothing) { expectMisses(wildRays(), true); }

} // namespace
} // namespace candela
