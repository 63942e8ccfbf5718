// SPDX-License-Identifier: Apache-2.0
// Instances as rays meet them: what hits name, and where the points that are made of hits stand.
#include "world/scene/test_world.h"

#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>

namespace candela {
namespace {

using Triangle = std::array<Vec3, 3>;

/// Triangles of all attitudes, two metres apart along x.
std::vector<Triangle> scattered(int count) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> place(-0.4f, 0.4f);
    std::vector<Triangle> triangles(count);
    for (int i = 0; i < count; ++i)
        do {
            for (Vec3 &corner : triangles[i])
                corner =
                    Vec3{2.0f * float(i), 0, 0} + Vec3{place(random), place(random), place(random)};
        } while (length(cross(triangles[i][1] - triangles[i][0],
                              triangles[i][2] - triangles[i][0])) < 0.1f);
    return triangles;
}

std::shared_ptr<const PrimitiveRecord> recordOf(const std::vector<Triangle> &triangles) {
    PolygonsRecord polygons;
    std::vector<float> P;
    for (const Triangle &triangle : triangles)
        for (Vec3 corner : triangle) {
            polygons.vertices.push_back(int(P.size() / 3));
            P.insert(P.end(), {corner.x, corner.y, corner.z});
        }
    polygons.loopCounts.assign(triangles.size(), 1);
    polygons.vertexCounts.assign(triangles.size(), 3);
    auto record = std::make_shared<PrimitiveRecord>();
    record->shape = polygons;
    record->variables.all.push_back(
        TestWorld::variable("P", StorageClass::Vertex, ValueType::Point, P));
    return record;
}

std::shared_ptr<const PrimitiveRecord> unitSphere() {
    auto record = std::make_shared<PrimitiveRecord>();
    record->shape = SphereRecord{1, -1, 1, 360};
    return record;
}

MotionTransform still(const Matrix4 &matrix) {
    MotionTransform motion;
    motion.matrix = matrix;
    return motion;
}

/// Two objects, the second of which has the first inside, and where instances place them (more than
/// once: what stands in one place alone is a shape of the world). The sphere stands at (-3, 0, 0)
/// of the first object.
struct World {
    std::vector<Triangle> first = scattered(7), second = scattered(3), own = scattered(2);
    Matrix4 inner = scaling(-0.5f, 0.5f, 0.5f) * translation(0, 3, 0);
    std::array<Matrix4, 4> outer = {translation(0, 0, 30),
                                    scaling(1, -2, 0.7f) * rotation(40, {1, 2, 3}) *
                                        translation(5, 30, 30),
                                    scaling(0.3f, 0.3f, -0.3f) * translation(0, -30, 30),
                                    rotation(70, {0, 1, 0}) * translation(40, 0, 30)};
    bool turnedInside = false; ///< The sphere and triangles are turned in their definition,
    bool turned = false;       ///< all instances where they stand.

    struct Placed {
        Matrix4 matrix;
        bool isSecond;
        bool turned;
    };
    std::vector<Placed> placements() const {
        const bool flipped = turnedInside != turned;
        // The instance inside the second object is turned with the definition's attributes.
        return {{outer[0], false, flipped}, {outer[1], false, flipped},
                {outer[2], true, flipped},  {inner * outer[2], false, turned},
                {outer[3], true, flipped},  {inner * outer[3], false, turned}};
    }

    void render(const std::function<void(const Scene &)> &with) const {
        DiagnosticList diagnostics;
        ShaderLibrary library({}, diagnostics);
        SceneCompiler compiler(library, diagnostics, with);
        Attributes attributes;
        attributes.surface = TestWorld::shader("probe");
        auto plain = std::make_shared<Attributes>(attributes);
        attributes.flipNormal = true;
        auto flipped = std::make_shared<Attributes>(attributes);
        const auto within = turnedInside ? flipped : plain, around = turned ? flipped : plain;
        Options options;
        options.format.xResolution = options.format.yResolution = 64;
        compiler.worldBegin(options);
        compiler.objectBegin(0);
        compiler.primitive(recordOf(first), within, still({}));
        compiler.primitive(unitSphere(), within, still(translation(-3, 0, 0)));
        compiler.objectEnd();
        compiler.objectBegin(1);
        compiler.primitive(recordOf(second), within, still({}));
        compiler.instance(0, within, still(inner));
        compiler.objectEnd();
        compiler.primitive(recordOf(own), plain, still(translation(0, 0, 60)));
        for (int i = 0; i < 4; ++i)
            compiler.instance(i < 2 ? 0 : 1, around, still(outer[i]));
        compiler.worldEnd();
        EXPECT_EQ(diagnostics.count(Severity::Error), 0);
    }
};

float determinant(const Matrix4 &m) {
    return dot(transformVector(m, {1, 0, 0}),
               cross(transformVector(m, {0, 1, 0}), transformVector(m, {0, 0, 1})));
}

/// The natural normal where the matrix puts it: it keeps its side in every mirror.
Vec3 placedNormal(const Matrix4 &m, Vec3 a, Vec3 b) {
    const Vec3 normal = normalize(cross(transformVector(m, a), transformVector(m, b)));
    return determinant(m) < 0 ? -normal : normal;
}

/// A ray that meets a known point of an instance head-on.
struct Aim {
    std::uint32_t instance;
    bool isSecond;
    std::uint32_t triangle;
    float u, v;
    Vec3 point, normal, objectNormal; ///< Turned, but for the last.
};

std::vector<Aim> aims(const World &world) {
    std::vector<Aim> all;
    const auto placements = world.placements();
    for (std::size_t i = 0; i < placements.size(); ++i) {
        const auto &triangles = placements[i].isSecond ? world.second : world.first;
        for (std::size_t k = 0; k < triangles.size(); ++k)
            for (auto [u, v] : {std::pair{0.2f, 0.3f}, {0.6f, 0.1f}, {0.1f, 0.8f}}) {
                const auto &[a, b, c] = triangles[k];
                const Vec3 normal = placedNormal(placements[i].matrix, b - a, c - a);
                all.push_back(
                    {std::uint32_t(i), placements[i].isSecond, std::uint32_t(k), u, v,
                     transformPoint(placements[i].matrix, a * (1 - u - v) + b * u + c * v),
                     placements[i].turned ? -normal : normal, normalize(cross(b - a, c - a))});
            }
    }
    return all;
}

/// From 5 cm beside the point, from the front or from behind.
RayBatch raysAt(const std::vector<Aim> &all, float side) {
    RayBatch rays(int(all.size()));
    rays.count = int(all.size());
    for (int i = 0; i < rays.count; ++i) {
        const Vec3 from = all[i].point + all[i].normal * (0.05f * side);
        for (int c = 0; c < 3; ++c)
            rays.origin[c][i] = from[c], rays.direction[c][i] = -side * all[i].normal[c];
        rays.tMin[i] = 0, rays.tMax[i] = INFINITY, rays.time[i] = 0;
        rays.width[i] = rays.spread[i] = 0;
    }
    return rays;
}

Vec3 vec3(ShadingPoints &points, ShaderInput input, int k) {
    return {points.input(input, 0)[k], points.input(input, 1)[k], points.input(input, 2)[k]};
}

void expectHits(const Scene &scene, const std::vector<Aim> &all, float side) {
    const RayBatch rays = raysAt(all, side);
    const int count = rays.count;
    HitBatch hits(count);
    scene.intersect(rays, hits, Coherence::Secondary);
    std::map<std::pair<bool, std::uint32_t>, std::uint32_t> shapes;
    std::vector<int> order(count);
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE("ray " + std::to_string(i) + " at instance " +
                     std::to_string(all[i].instance));
        order[i] = i;
        ASSERT_NE(hits.shape[i], noHit);
        EXPECT_EQ(hits.instance[i], all[i].instance);
        // The world's own shape has number 0; instances of about one size share an object's shapes.
        EXPECT_NE(hits.shape[i], 0u);
        const std::pair kind(all[i].isSecond, all[i].instance / 2);
        EXPECT_EQ(shapes.try_emplace(kind, hits.shape[i]).first->second, hits.shape[i]);
        EXPECT_EQ(hits.element[i], all[i].triangle);
        EXPECT_NEAR(hits.u[i], all[i].u, 1e-3);
        EXPECT_NEAR(hits.v[i], all[i].v, 1e-3);
        EXPECT_NEAR(hits.t[i], 0.05f, 1e-4);
        const Vec3 Ng = normalize(Vec3{hits.Ng[0][i], hits.Ng[1][i], hits.Ng[2][i]});
        EXPECT_NEAR(dot(Ng, all[i].objectNormal), 1, 1e-4) << "in the object's space";
    }
    EXPECT_NE((shapes[{false, 1}]), (shapes[{true, 1}]));
    ShadingPoints points(count);
    scene.shadingPoints(rays, hits, order.data(), count, points);
    std::map<int, std::uint32_t> instanceOfId;
    for (int i = 0; i < count; ++i) {
        SCOPED_TRACE("point " + std::to_string(i) + " of instance " +
                     std::to_string(all[i].instance));
        EXPECT_LT(length(vec3(points, ShaderInput::P, i) - all[i].point), 1e-4);
        EXPECT_NEAR(dot(vec3(points, ShaderInput::N, i), all[i].normal), 1, 1e-4);
        EXPECT_NEAR(dot(vec3(points, ShaderInput::Ng, i), all[i].normal), 1, 1e-4);
        EXPECT_NEAR(dot(vec3(points, ShaderInput::dPdu, i), all[i].normal), 0, 1e-3);
        EXPECT_LT(length(vec3(points, ShaderInput::I, i) + all[i].normal * (0.05f * side)), 1e-4);
        EXPECT_EQ(instanceOfId.try_emplace(points.id[i], all[i].instance).first->second,
                  all[i].instance);
    }
    EXPECT_EQ(instanceOfId.size(), 6u);
}

TEST(Instances, HitsNameInstanceShapeElementAndPlace) {
    for (bool turnedInside : {false, true})
        for (bool turned : {false, true}) {
            World world;
            world.turnedInside = turnedInside, world.turned = turned;
            world.render([&](const Scene &scene) {
                for (float side : {1.0f, -1.0f})
                    expectHits(scene, aims(world), side);
            });
        }
}

TEST(Instances, SpheresAreEllipsoidsWithTheirNormalsOutside) {
    World world;
    world.render([&](const Scene &scene) {
        const auto placements = world.placements();
        for (std::uint32_t p : {0u, 1u, 3u, 5u}) {
            const Matrix4 &matrix = placements[p].matrix;
            const float sign = placements[p].turned ? -1 : 1;
            std::vector<Aim> all;
            for (int i = 0; i < 50; ++i) {
                const float z = 0.98f - 0.04f * float(i), r = std::sqrt(1 - z * z);
                const Vec3 out{r * std::cos(float(i)), r * std::sin(float(i)), z};
                Vec3 s, t;
                orthonormalBasis(out, s, t);
                all.push_back(
                    {p, false, 0, 0, 0, transformPoint(matrix, out + Vec3{-3, 0, 0}),
                     placedNormal(matrix, s, t) * (dot(cross(s, t), out) < 0 ? -sign : sign), out});
            }
            const RayBatch rays = raysAt(all, 1);
            HitBatch hits(rays.count);
            scene.intersect(rays, hits, Coherence::Secondary);
            std::vector<int> order;
            for (int i = 0; i < rays.count; ++i) {
                ASSERT_NE(hits.shape[i], noHit) << i;
                EXPECT_EQ(hits.instance[i], p);
                order.push_back(i);
            }
            ShadingPoints points(rays.count);
            scene.shadingPoints(rays, hits, order.data(), rays.count, points);
            for (int i = 0; i < rays.count; ++i) {
                EXPECT_LT(length(vec3(points, ShaderInput::P, i) - all[i].point), 1e-4) << i;
                EXPECT_NEAR(dot(vec3(points, ShaderInput::N, i), all[i].normal), 1, 1e-4) << i;
            }
        }
    });
}

} // namespace
} // namespace candela
