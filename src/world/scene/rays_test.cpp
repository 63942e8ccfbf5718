// SPDX-License-Identifier: Apache-2.0
// Rays against brute force, ties, and what comes through transparent surfaces.
#include "world/scene/test_world.h"

#include "world/rays/ray_world.h"

#include "foundation/base/parallel.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace candela {
namespace {

RayShape soup(std::mt19937 &random, int triangles) {
    std::uniform_real_distribution<float> place(-1, 1), edge(-0.3f, 0.3f);
    RayShape mesh;
    for (int i = 0; i < triangles; ++i) {
        Vec3 a{place(random), place(random), place(random)};
        std::uint32_t first = std::uint32_t(mesh.positions.size());
        mesh.positions.push_back(a);
        for (int k = 0; k < 2; ++k)
            mesh.positions.push_back(a + Vec3{edge(random), edge(random), edge(random)});
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    return mesh;
}

/// Distance in double, infinity = none.
double distanceTo(const RayShape &mesh, int triangle, Vec3 o, Vec3 d) {
    auto corner = [&](int k, int axis) {
        return double(mesh.positions[mesh.triangles[triangle][k]][axis]);
    };
    double e1[3], e2[3], s[3];
    for (int axis = 0; axis < 3; ++axis) {
        e1[axis] = corner(1, axis) - corner(0, axis), e2[axis] = corner(2, axis) - corner(0, axis);
        s[axis] = o[axis] - corner(0, axis);
    }
    auto determinant = [](const double *a, const double *b, const double *c) {
        return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) +
               a[2] * (b[0] * c[1] - b[1] * c[0]);
    };
    double minusD[3] = {-d.x, -d.y, -d.z};
    double whole = determinant(e1, e2, minusD);
    double u = determinant(s, e2, minusD) / whole, v = determinant(e1, s, minusD) / whole;
    double t = determinant(e1, e2, s) / whole;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : INFINITY;
}

void setRay(RayBatch &rays, int i, Vec3 o, Vec3 d, float tMax = INFINITY) {
    rays.origin[0][i] = o.x, rays.origin[1][i] = o.y, rays.origin[2][i] = o.z;
    rays.direction[0][i] = d.x, rays.direction[1][i] = d.y, rays.direction[2][i] = d.z;
    rays.tMin[i] = 0, rays.tMax[i] = tMax;
}

TEST(Rays, NearestHitsAreThoseOfBruteForce) {
    std::mt19937 random(7);
    RayObject meshes{soup(random, 60), soup(random, 40)};
    RayWorld world(meshes);
    constexpr int count = 1003;
    RayBatch rays(count);
    HitBatch hits(count);
    std::uniform_real_distribution<float> place(-2, 2);
    rays.count = count;
    for (int i = 0; i < count; ++i)
        setRay(rays, i, {place(random), place(random), place(random)},
               {place(random), place(random), place(random)});
    for (bool coherent : {false, true}) {
        world.intersect(rays, hits, RayWorld::Which::All, coherent);
        int found = 0;
        for (int i = 0; i < count; ++i) {
            Vec3 o{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]};
            Vec3 d{rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]};
            double nearest = INFINITY;
            for (const RayShape &mesh : meshes)
                for (int k = 0; k < int(mesh.triangles.size()); ++k)
                    nearest = std::min(nearest, distanceTo(mesh, k, o, d));
            if (hits.shape[i] == noHit) {
                EXPECT_EQ(nearest, INFINITY);
                continue;
            }
            ++found;
            EXPECT_NEAR(hits.t[i], nearest, 1e-4 * nearest);
        }
        EXPECT_GT(found, 50);
    }
}

/// Small triangles in many coincident copies, in several meshes.
RayObject coincidentMeshes(int meshCount, int places, int copies) {
    RayObject meshes(meshCount);
    for (RayShape &mesh : meshes)
        for (int place = 0; place < places; ++place) {
            float x = float(place % 100) * 0.02f - 1, y = float(place / 100) * 0.02f - 1;
            auto first = std::uint32_t(mesh.positions.size());
            mesh.positions.insert(mesh.positions.end(),
                                  {{x, y, 1}, {x + 0.03f, y, 1}, {x, y + 0.03f, 1}});
            for (int copy = 0; copy < copies; ++copy)
                mesh.triangles.push_back({first, first + 1, first + 2});
        }
    return meshes;
}

/// Which of several equally near hits is kept must depend on the scene alone: Embree sorts what
/// it puts into a leaf, so its trees are the same whatever number of threads built them.
TEST(Rays, EquallyNearHitsDoNotDependOnThreads) {
    RayObject meshes = coincidentMeshes(3, 5000, 4);
    constexpr int count = 4096;
    RayBatch rays(count);
    rays.count = count;
    for (int i = 0; i < count; ++i)
        setRay(rays, i, {0, 0, 0},
               {0.03f * float(i % 64) - 0.98f, 0.015f * float(i / 64) - 0.98f, 1});
    HitBatch alone(count), together(count);
    {
        ThreadLimit one(1);
        RayWorld(meshes).intersect(rays, alone, RayWorld::Which::All, false);
    }
    for (int repeat = 0; repeat < 5; ++repeat) {
        ThreadLimit several(4);
        RayWorld(meshes).intersect(rays, together, RayWorld::Which::All, false);
        int hits = 0;
        for (int i = 0; i < count; ++i) {
            hits += alone.shape[i] != noHit;
            ASSERT_EQ(alone.shape[i], together.shape[i]) << i;
            ASSERT_EQ(alone.element[i], together.element[i]) << i;
        }
        EXPECT_GT(hits, 2000);
    }
}

/// A closed sphere of triangles.
RayShape ball(Vec3 centre, float radius, int steps) {
    RayShape mesh;
    for (int row = 0; row <= steps; ++row)
        for (int column = 0; column < steps; ++column) {
            double polar = M_PI * row / steps, turn = 2 * M_PI * column / steps;
            double ring = row == 0 || row == steps ? 0 : std::sin(polar);
            mesh.positions.push_back(centre + Vec3{float(ring * std::cos(turn)),
                                                   float(ring * std::sin(turn)),
                                                   float(std::cos(polar))} *
                                                  radius);
        }
    for (int row = 0; row < steps; ++row)
        for (int column = 0; column < steps; ++column) {
            auto at = [&](int down, int right) {
                return std::uint32_t((row + down) * steps + (column + right) % steps);
            };
            if (row > 0)
                mesh.triangles.push_back({at(0, 0), at(0, 1), at(1, 1)});
            if (row + 1 < steps)
                mesh.triangles.push_back({at(0, 0), at(1, 1), at(1, 0)});
        }
    return mesh;
}

/// Rays from within closed balls, aimed at the very edges and corners of their triangles.
TEST(Rays, NoneSlipsBetweenTriangles) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> uniform(0, 1);
    for (Vec3 centre : {Vec3{0, 0, 0}, Vec3{0.3f, 0.2f, 1}, Vec3{30, -20, 100}})
        for (int steps : {8, 100}) {
            RayShape mesh = ball(centre, 0.5f, steps);
            RayWorld world({mesh});
            constexpr int count = 4096;
            RayBatch rays(count);
            HitBatch hits(count);
            std::vector<std::uint8_t> blocked(count);
            rays.count = count;
            for (int i = 0; i < count; ++i) {
                const auto &corners = mesh.triangles[random() % mesh.triangles.size()];
                int k = int(random() % 3);
                Vec3 a = mesh.positions[corners[k]], b = mesh.positions[corners[(k + 1) % 3]];
                Vec3 target = a + (b - a) * (i % 4 == 0 ? 0 : uniform(random));
                Vec3 from = centre + Vec3{uniform(random), uniform(random), uniform(random)} * 0.2f;
                setRay(rays, i, from, normalize(target - from));
            }
            world.intersect(rays, hits, RayWorld::Which::All, false);
            world.occluded(rays, blocked.data());
            for (int i = 0; i < count; ++i) {
                ASSERT_NE(hits.shape[i], noHit) << centre.x << " " << steps << " ray " << i;
                ASSERT_EQ(blocked[i], 1) << centre.x << " " << steps << " ray " << i;
                Vec3 d{rays.direction[0][i], rays.direction[1][i], rays.direction[2][i]};
                Vec3 from{rays.origin[0][i], rays.origin[1][i], rays.origin[2][i]};
                float chord = 0.5f - 0.5f * std::cos(float(M_PI) / float(steps)) + 1e-3f;
                ASSERT_NEAR(length(from + d * hits.t[i] - centre), 0.5f, 2 * chord);
            }
        }
}

TEST(Rays, BadRaysAreNotTraced) {
    RayShape mesh;
    mesh.positions = {{-9, -9, 1}, {9, -9, 1}, {0, 9, 1}};
    mesh.triangles = {{0, 1, 2}};
    RayWorld world({mesh});
    RayBatch rays(5);
    HitBatch hits(5);
    rays.count = 5;
    setRay(rays, 0, {NAN, 0, 0}, {0, 0, 1});
    setRay(rays, 1, {0, 0, 0}, {0, INFINITY, 1});
    setRay(rays, 2, {0, 0, 0}, {0, 0, 1}, 0);
    setRay(rays, 3, {0, 0, 0}, {0, 0, 0});
    setRay(rays, 4, {0, 0, 0}, {0, 0, 1});
    world.intersect(rays, hits, RayWorld::Which::All, true);
    std::uint8_t blocked[16];
    world.occluded(rays, blocked);
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(hits.shape[i], noHit);
        EXPECT_EQ(blocked[i], 2);
    }
    EXPECT_EQ(hits.shape[4], 0u);
    EXPECT_EQ(blocked[4], 1);
}

const std::vector<Vec3> wall{{-1, -1, 5}, {1, -1, 5}, {1, 1, 5}, {-1, 1, 5}};

TEST(Rays, OneSidedPrimitivesAreSeenFromTheFrontOnly) {
    for (bool flip : {false, true}) {
        TestWorld world;
        world.attributes.sides = 1;
        world.attributes.flipNormal = flip;
        world.addPolygon(wall);
        world.render([&](const Scene &scene) {
            RayBatch rays(2);
            HitBatch hits(2);
            rays.count = 2;
            setRay(rays, 0, {0, 0, 0}, {0, 0, 1});
            setRay(rays, 1, {0, 0, 9}, {0, 0, -1});
            scene.intersect(rays, hits, Coherence::Secondary);
            ASSERT_NE(hits.shape[0] == noHit, hits.shape[1] == noHit);
            int seen = hits.shape[0] == noHit ? 1 : 0;
            ShadingPoints points(2);
            scene.shadingPoints(rays, hits, &seen, 1, points);
            float Nz = points.input(int(ShaderInput::N) + 2)[0];
            EXPECT_LT(Nz * rays.direction[2][seen], 0) << "the normal looks at the viewer";
        });
    }
}

TEST(Rays, TransmittanceIsTheProductOfWhatComesThrough) {
    TestWorld world;
    auto at = [](float z) {
        return std::vector<Vec3>{{-1, -1, z}, {1, -1, z}, {1, 1, z}, {-1, 1, z}};
    };
    world.attributes.opacity = Color(0.25f, 0.5f, 1.0f);
    world.addPolygon(at(2));
    world.attributes.opacity = Color(0.5f, 0.0f, 0.5f);
    world.addPolygon(at(3));
    world.attributes.opacity = Color(1.0f);
    world.addPolygon(at(6));
    world.render([](const Scene &scene) {
        RayBatch rays(5);
        rays.count = 5;
        setRay(rays, 0, {0.3f, 0, 0}, {0, 0, 1}, 5);
        setRay(rays, 1, {0.3f, 0, 0}, {0, 0, 1}, INFINITY);
        setRay(rays, 2, {0.3f, 0, 0}, {0, 0, 1}, 2.5f);
        setRay(rays, 3, {5, 0, 0}, {0, 0, 1}, 5);
        setRay(rays, 4, {0.2f, 0, 0}, {0, 0, 2}, 1.2f);
        Planes<float> planes(colorSamples, 5);
        float *through[colorSamples] = {planes[0], planes[1], planes[2]};
        scene.transmittance(rays, through);
        const float expected[5][3] = {
            {0.375f, 0.5f, 0}, {0, 0, 0}, {0.75f, 0.5f, 0}, {1, 1, 1}, {0.75f, 0.5f, 0}};
        for (int i = 0; i < 5; ++i)
            for (int c = 0; c < 3; ++c)
                EXPECT_FLOAT_EQ(through[c][i], expected[i][c]) << i << " " << c;
    });
}

} // namespace
} // namespace candela
