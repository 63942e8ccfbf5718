// SPDX-License-Identifier: Apache-2.0
// Shading points against direct evaluation of the surfaces.
#include "world/scene/test_world.h"

#include "world/geometry/surface.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

/// Rays from the origin through a grid, and their hits.
struct Grid {
    static constexpr int side = 32, count = side * side;
    RayBatch rays{count};
    HitBatch hits{count};
    ShadingPoints points{count};

    explicit Grid(const Scene &scene) {
        rays.count = count;
        for (int i = 0; i < count; ++i) {
            int place = count - 1 - i;
            rays.direction[0][i] = (place % side + 0.5f) * 2 / side - 1;
            rays.direction[1][i] = (place / side + 0.5f) * 2 / side - 1;
            rays.direction[2][i] = 1, rays.tMin[i] = 0, rays.tMax[i] = INFINITY,
            rays.time[i] = 0.5f;
        }
        scene.intersect(rays, hits, Coherence::Primary);
    }
    std::vector<int> ofCode(const Scene &scene, int code) const {
        std::vector<int> order;
        for (int i = 0; i < count; ++i)
            if (hits.shape[i] != noHit && scene.codeOf(hits, i) == code)
                order.push_back(i);
        return order;
    }
    Vec3 vec3(ShaderInput input, int k) {
        return {points.input(int(input))[k], points.input(int(input) + 1)[k],
                points.input(int(input) + 2)[k]};
    }
};

TEST(ShadingPoints, LieOnTheTrueSphereWhateverTheOrder) {
    TestWorld world;
    world.attributes.surface = TestWorld::shader("probe");
    world.attributes.color = Color(0.1f, 0.2f, 0.3f);
    const Vec3 centres[3] = {{-1, 0, 4}, {1, 0.5f, 4}, {0, -1.5f, 5}};
    for (Vec3 centre : centres) {
        world.transform = scaling(0.5f, 0.5f, 0.5f) * translation(centre.x, centre.y, centre.z);
        world.attributes.color = Color(centre.x, centre.y, centre.z);
        world.add(SphereRecord{2, -2, 2, 360});
    }
    world.render([&](const Scene &scene) {
        Grid grid(scene);
        ASSERT_EQ(scene.codeCount(), 1);
        auto order = grid.ofCode(scene, 0);
        ASSERT_GT(order.size(), 100u);
        scene.shadingPoints(grid.rays, grid.hits, order.data(), int(order.size()), grid.points);
        for (int k = 0; k < grid.points.count; ++k) {
            int primitive = grid.points.id[k] - 1;
            ASSERT_EQ(primitive, int(grid.hits.shape[order[k]]));
            Vec3 P = grid.vec3(ShaderInput::P, k), outward = P - centres[primitive];
            EXPECT_NEAR(length(outward), 1, 1e-5);
            EXPECT_NEAR(dot(normalize(grid.vec3(ShaderInput::N, k)), outward), 1, 1e-5);
            Vec3 color = grid.vec3(ShaderInput::Cs, k);
            EXPECT_EQ(color, centres[primitive]);
            float t = grid.hits.t[order[k]];
            for (int c = 0; c < 3; ++c)
                EXPECT_EQ(grid.vec3(ShaderInput::I, k)[c], t * grid.rays.direction[c][order[k]]);
            EXPECT_LT(length(P - t * Vec3{grid.rays.direction[0][order[k]],
                                          grid.rays.direction[1][order[k]], 1}),
                      0.2f)
                << "near where the ray met the dicing";
            EXPECT_NEAR(dot(grid.vec3(ShaderInput::dPdu, k), outward), 0, 1e-4);
            EXPECT_EQ(grid.points.input(int(ShaderInput::time))[k], 0.5f);
            EXPECT_GT(grid.points.offset[k], 0);
        }
    });
}

TEST(ShadingPoints, VariablesOverrideAttributesAndParameters) {
    TestWorld world;
    world.attributes.surface = TestWorld::shader("probe");
    using enum StorageClass;
    world.addPolygon(
        {{-1, -1, 2}, {1, -1, 2}, {1, 1, 2}, {-1, 1, 2}},
        {TestWorld::variable("Cs", Vertex, ValueType::Color, {0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1}),
         TestWorld::variable("Kd", Vertex, ValueType::Float, {0, 2, 4, 2})});
    world.render([&](const Scene &scene) {
        Grid grid(scene);
        auto order = grid.ofCode(scene, 0);
        scene.shadingPoints(grid.rays, grid.hits, order.data(), int(order.size()), grid.points);
        ASSERT_EQ(scene.code(0).variables().size(), 1u);
        ASSERT_GT(order.size(), 200u);
        for (int k = 0; k < grid.points.count; ++k) {
            Vec3 P = grid.vec3(ShaderInput::P, k), Cs = grid.vec3(ShaderInput::Cs, k);
            EXPECT_NEAR(P.z, 2, 1e-6);
            EXPECT_NEAR(Cs.x, (P.x + 1) / 2, 1e-5);
            EXPECT_NEAR(Cs.y, (P.y + 1) / 2, 1e-5);
            EXPECT_EQ(Cs.z, 1);
            EXPECT_NEAR(grid.points.variableTable[0][k], P.x + P.y + 2, 1e-5);
            EXPECT_NEAR(grid.points.input(int(ShaderInput::s))[k], P.x, 1e-5);
        }
    });
}

/// What rays meet of a diced surface names the point that they have met.
TEST(ShadingPoints, OfDicedSurfacesLieWhereRaysMeetThem) {
    TestWorld world;
    world.attributes.shadingRate = 1e-3f;
    world.transform = translation(0.1f, 0, 2);
    world.add(DiskRecord{0, 3, 360});
    world.render([](const Scene &scene) {
        Grid grid(scene);
        auto order = grid.ofCode(scene, 0);
        ASSERT_GT(order.size(), 100u);
        scene.shadingPoints(grid.rays, grid.hits, order.data(), int(order.size()), grid.points);
        for (int k = 0; k < grid.points.count; ++k) {
            Vec3 P = grid.vec3(ShaderInput::P, k), I = grid.vec3(ShaderInput::I, k);
            EXPECT_LT(length(P - I), grid.points.offset[k]) << k; // From the eye in the origin.
        }
    });
}

/// What surrounds the eye is diced by what the frame shows of it: to half a pixel there.
TEST(ShadingPoints, OfSkiesLieWithinHalfAPixel) {
    const Matrix4 upright = rotation(-90, {1, 0, 0}), turned = rotation(33, {1, 2, 3});
    const struct {
        ShapeRecord shape;
        Matrix4 transform;
    } skies[] = {{SphereRecord{1000, 0, 1000, 360}, upright},
                 {SphereRecord{1000, -1000, 1000, 350}, translation(300, -500, 100)},
                 {SphereRecord{1000, -1000, 1000, 360}, turned * scaling(1, .5f, 1)},
                 {SphereRecord{1000, -1000, 1000, 360}, scaling(1, .1f, 1) * translation(0, 90, 0)},
                 {CylinderRecord{1000, -900, 900, 360}, upright},
                 {ConeRecord{2000, 1000, 360}, upright * translation(0, -500, 0)},
                 {ParaboloidRecord{1000, 0, 1500, 360}, translation(0, 0, -900) * turned},
                 {DiskRecord{100, 1000, 360}, upright},
                 {TorusRecord{900, 800, 0, 360, 360}, upright}};
    for (const auto &sky : skies)
        for (int resolution : {8, 64, 512}) {
            TestWorld world;
            world.options.format.xResolution = world.options.format.yResolution = resolution;
            world.transform = sky.transform;
            world.add(sky.shape);
            world.render([&](const Scene &scene) {
                Grid grid(scene);
                auto order = grid.ofCode(scene, 0);
                ASSERT_GT(order.size(), 100u);
                scene.shadingPoints(grid.rays, grid.hits, order.data(), int(order.size()),
                                    grid.points);
                for (int k = 0; k < grid.points.count; ++k) {
                    const Vec3 P = grid.vec3(ShaderInput::P, k), I = grid.vec3(ShaderInput::I, k);
                    const float pixel = P.z * 2 / float(resolution);
                    ASSERT_LT(length(P - I), 0.5f * pixel)
                        << &sky - skies << ' ' << resolution << ' ' << P.z;
                }
            });
        }
}

/// Rays back towards the viewer, rather flat over the surface, miss the surface they start from.
void expectOffsetRaysLeave(const Scene &scene, Grid &grid) {
    const int count = grid.points.count;
    RayBatch away(count);
    HitBatch hits(count);
    away.count = count;
    for (int k = 0; k < count; ++k) {
        Vec3 Ng = normalize(grid.vec3(ShaderInput::Ng, k)), s, t;
        if (dot(Ng, grid.vec3(ShaderInput::I, k)) > 0)
            Ng = -Ng;
        orthonormalBasis(Ng, s, t);
        Vec3 direction = normalize(s + Ng * 0.1f);
        Vec3 origin =
            Scene::offsetOrigin(grid.vec3(ShaderInput::P, k), Ng, direction, grid.points.offset[k]);
        away.origin[0][k] = origin.x, away.origin[1][k] = origin.y, away.origin[2][k] = origin.z;
        away.direction[0][k] = direction.x, away.direction[1][k] = direction.y;
        away.direction[2][k] = direction.z, away.tMin[k] = 0, away.tMax[k] = INFINITY;
    }
    scene.intersect(away, hits, Coherence::Secondary);
    for (int k = 0; k < count; ++k)
        EXPECT_NE(hits.shape[k], std::uint32_t(grid.points.id[k] - 1)) << k;
}

TEST(ShadingPoints, OffsetRaysLeaveTheSurfaceTheyStartFrom) {
    TestWorld world;
    world.transform = translation(0, 0, 3);
    world.add(SphereRecord{1, -1, 1, 360});
    world.transform = translation(100, 50, 0);
    world.addPolygon({{-200, -200, 9}, {200, -200, 9}, {200, 200, 9}, {-200, 200, 9}});
    world.render([&](const Scene &scene) {
        Grid grid(scene);
        auto order = grid.ofCode(scene, 0);
        ASSERT_EQ(int(order.size()), Grid::count);
        scene.shadingPoints(grid.rays, grid.hits, order.data(), int(order.size()), grid.points);
        expectOffsetRaysLeave(scene, grid);
    });
}

/// A ground of 100 km, eye at a man's height: contact shadows of a millimetre are there.
TEST(ShadingPoints, LargeGroundsCostNearPointsNothing) {
    TestWorld world;
    std::vector<Vec3> corners;
    for (Vec3 p : {Vec3{-1, 0, -1}, {1, 0, -1}, {1, 0, 1}, {-1, 0, 1}})
        corners.push_back({5e4f * p.x, -1.5f + 5e4f * (0.013f * p.x + 0.11f * p.z), 5e4f * p.z});
    world.addPolygon(corners);
    world.render([&](const Scene &scene) {
        Grid grid(scene);
        auto order = grid.ofCode(scene, 0);
        ASSERT_GT(order.size(), 50u);
        scene.shadingPoints(grid.rays, grid.hits, order.data(), int(order.size()), grid.points);
        for (int k = 0; k < grid.points.count; ++k)
            EXPECT_LT(grid.points.offset[k], 2e-5f * length(grid.vec3(ShaderInput::P, k)));
        expectOffsetRaysLeave(scene, grid);
    });
}

TEST(ShadingPoints, SingularTransformationsAreReportedAndLeftOut) {
    TestWorld world;
    world.transform = scaling(1, 0, 1);
    world.add(SphereRecord{1, -1, 1, 360});
    world.render([](const Scene &scene) { EXPECT_EQ(scene.statistics().primitives, 0u); });
    EXPECT_EQ(world.diagnostics.count(Severity::Warning), 1);
}

} // namespace
} // namespace candela
