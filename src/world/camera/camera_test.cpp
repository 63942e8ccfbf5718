// SPDX-License-Identifier: Apache-2.0
#include "world/camera/camera.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace candela {
namespace {

Options perspectiveOptions(int width, int height, float fov) {
    Options options;
    options.format.xResolution = width, options.format.yResolution = height;
    options.camera.perspective = true, options.camera.fieldOfView = fov;
    return options;
}

struct Ray {
    Vec3 origin, direction;
    float tMin, tMax, time;
};

Ray ray(const Camera &camera, float x, float y, float lensU = 0.5f, float lensV = 0.5f,
        float time01 = 0) {
    RayBatch batch(1);
    camera.rays(1, &x, &y, &lensU, &lensV, &time01, batch);
    return {{batch.origin[0][0], batch.origin[1][0], batch.origin[2][0]},
            {batch.direction[0][0], batch.direction[1][0], batch.direction[2][0]},
            batch.tMin[0],
            batch.tMax[0],
            batch.time[0]};
}

TEST(Camera, TheCentreLooksAlongZ) {
    Camera camera(perspectiveOptions(640, 480, 60));
    Ray centre = ray(camera, 320, 240);
    EXPECT_NEAR(centre.direction.x, 0, 1e-6);
    EXPECT_NEAR(centre.direction.y, 0, 1e-6);
    EXPECT_NEAR(centre.direction.z, 1, 1e-6);
}

TEST(Camera, TheFieldOfViewSpansTheNarrowerAxis) {
    Camera wide(perspectiveOptions(640, 480, 60));
    Ray top = ray(wide, 320, 0);
    EXPECT_NEAR(top.direction.y / top.direction.z, std::tan(M_PI / 6), 1e-6);
    EXPECT_GT(top.direction.y, 0) << "raster y runs down, camera y up";
    Ray right = ray(wide, 640, 240);
    EXPECT_NEAR(right.direction.x / right.direction.z, std::tan(M_PI / 6) * 4 / 3, 1e-6);
    Camera tall(perspectiveOptions(100, 300, 90));
    EXPECT_NEAR(ray(tall, 100, 150).direction.x, std::sqrt(0.5), 1e-6);
}

TEST(Camera, ScreenWindowScalesTheView) {
    Options options = perspectiveOptions(100, 100, 90);
    options.format.screenWindow = {0, 2, -1, 3};
    Camera camera(options);
    Ray corner = ray(camera, 100, 0);
    EXPECT_NEAR(corner.direction.x / corner.direction.z, 2, 1e-5);
    EXPECT_NEAR(corner.direction.y / corner.direction.z, 3, 1e-5);
}

TEST(Camera, RasterAndNdcRoundTrip) {
    for (bool perspective : {false, true}) {
        Options options = perspectiveOptions(320, 200, 50);
        options.camera.perspective = perspective;
        options.camera.near = 0.5f, options.camera.far = 100;
        Camera camera(options);
        for (float x : {0.5f, 100.25f, 319.5f})
            for (float y : {0.5f, 60.0f, 199.0f}) {
                Ray r = ray(camera, x, y);
                Vec3 P = r.origin + r.direction * 7.0f;
                Vec3 raster = transformPoint(camera.rasterFromCamera(), P);
                EXPECT_NEAR(raster.x, x, 2e-3);
                EXPECT_NEAR(raster.y, y, 2e-3);
                Vec3 ndc = transformPoint(camera.ndcFromCamera(), P);
                EXPECT_NEAR(ndc.x, x / 320, 1e-5);
                EXPECT_NEAR(ndc.y, y / 200, 1e-5);
                Vec3 start =
                    transformPoint(camera.screenFromCamera(), r.origin + r.direction * r.tMin);
                EXPECT_NEAR(start.z, 0, 1e-5) << "screen depth is 0 at the near plane";
                Vec3 end = r.origin + r.direction * r.tMax;
                EXPECT_NEAR(transformPoint(camera.screenFromCamera(), end).z, 1, 1e-5);
            }
    }
}

// What stands before Projection moves the picture: a point is seen where it was, moved so.
TEST(Camera, TransformationsOfTheScreenMoveThePicture) {
    const Matrix4 moves[] = {scaling(0.5f, 0.5f, 1),
                             rotation(90, {0, 0, 1}),
                             scaling(-1, 1, 1),
                             translation(0.25f, -0.5f, 0),
                             rotation(30, {0, 0, 1}) * scaling(2, 0.5f, 3) * translation(1, 0, 0),
                             skew(20, {0, 1, 0}, {1, 0, 0})};
    for (bool perspective : {false, true})
        for (const Matrix4 &move : moves) {
            Options options = perspectiveOptions(200, 200, 50);
            options.camera.perspective = perspective;
            options.camera.near = 0.5f, options.camera.far = 100;
            const Camera still(options);
            options.camera.screenFromProjected = move;
            const Camera moved(options);
            for (Vec3 P : {Vec3{0, 0, 2}, {0.3f, 0.1f, 2}, {-0.2f, 0.4f, 7}}) {
                const Vec3 screen =
                    transformPoint(move, transformPoint(still.screenFromCamera(), P));
                EXPECT_NEAR(length(transformPoint(moved.screenFromCamera(), P) - screen), 0, 2e-6);
                const Vec3 raster = transformPoint(moved.rasterFromCamera(), P);
                const Ray r = ray(moved, raster.x, raster.y);
                const Vec3 seen = r.origin + r.direction * ((P.z - r.origin.z) / r.direction.z);
                EXPECT_NEAR(length(seen - P), 0, 1e-5);
                // One pixel on is as far as dicing believes at least.
                const Ray next = ray(moved, raster.x + 1, raster.y);
                const Vec3 beside =
                    next.origin + next.direction * ((P.z - next.origin.z) / next.direction.z);
                EXPECT_GE(length(beside - P), moved.pixelSize(P.z) * 0.999f);
            }
        }
}

TEST(Camera, OrthographicRaysAreParallel) {
    Options options;
    options.format.xResolution = options.format.yResolution = 10;
    Camera camera(options);
    Ray r = ray(camera, 10, 0);
    EXPECT_EQ(r.direction, (Vec3{0, 0, 1}));
    EXPECT_NEAR(r.origin.x, 1, 1e-6);
    EXPECT_NEAR(r.origin.y, 1, 1e-6);
    EXPECT_NEAR(camera.pixelSize(5), 0.2f, 1e-6);
}

TEST(Camera, ALensKeepsTheFocalPlaneSharp) {
    Options options = perspectiveOptions(64, 64, 40);
    options.camera.fStop = 2, options.camera.focalLength = 0.4f, options.camera.focalDistance = 3;
    Camera camera(options), pinhole(perspectiveOptions(64, 64, 40));
    Ray sharp = ray(pinhole, 10, 50);
    Vec3 target = sharp.direction * (3 / sharp.direction.z);
    float largest = 0;
    for (float u : {0.0f, 0.2f, 0.7f, 0.99f})
        for (float v : {0.0f, 0.3f, 0.8f}) {
            Ray r = ray(camera, 10, 50, u, v);
            Vec3 P = r.origin + r.direction * ((3 - r.origin.z) / r.direction.z);
            EXPECT_NEAR(length(P - target), 0, 1e-5);
            EXPECT_NEAR(length(r.direction), 1, 1e-6);
            largest = std::max(largest, std::hypot(r.origin.x, r.origin.y));
        }
    EXPECT_LE(largest, 0.1f + 1e-5);
    EXPECT_GT(largest, 0.09f);
}

/// The depth at which a ray enters the box; nothing if it misses.
std::optional<float> entry(const Ray &ray, const Box3 &box) {
    float from = 0, to = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        const float a = (box.low[axis] - ray.origin[axis]) / ray.direction[axis];
        const float b = (box.high[axis] - ray.origin[axis]) / ray.direction[axis];
        from = std::fmax(from, std::fmin(a, b)), to = std::fmin(to, std::fmax(a, b));
    }
    if (from > to)
        return std::nullopt;
    return from * ray.direction.z;
}

std::vector<Options> variousCameras() {
    std::vector<Options> cameras;
    for (bool perspective : {true, false})
        for (float fStop : {0.0f, 0.5f})
            for (std::array<float, 4> window :
                 {std::array{-1.f, 1.f, -1.f, 1.f}, std::array{1.f, 2.f, -3.f, -2.f}}) {
                Options options = perspectiveOptions(64, 64, 50);
                options.camera.perspective = perspective, options.format.screenWindow = window;
                options.camera.fStop = fStop, options.camera.focalLength = 0.4f;
                options.camera.focalDistance = 3;
                cameras.push_back(options);
            }
    return cameras;
}

TEST(Camera, ShowsNothingOfABoxNearerThanTheShownDepth) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> unit(0, 1);
    int hits = 0, unseen = 0;
    for (const Options &options : variousCameras()) {
        const Camera camera(options);
        for (int k = 0; k < 200; ++k) {
            Box3 box;
            for (int corner = 0; corner < 2; ++corner)
                box.add(Vec3{unit(random) * 16 - 8, unit(random) * 16 - 8, unit(random) * 12 - 4});
            const std::optional<float> shown = camera.shownDepth(box);
            unseen += !shown;
            for (int i = 0; i < 200; ++i) {
                const Ray r =
                    ray(camera, 64 * unit(random), 64 * unit(random), unit(random), unit(random));
                const std::optional<float> depth = entry(r, box);
                if (!depth)
                    continue;
                ++hits;
                ASSERT_TRUE(shown);
                ASSERT_LE(*shown, *depth + 1e-4f);
            }
        }
    }
    EXPECT_GT(hits, 1000);
    EXPECT_GT(unseen, 200);
}

TEST(Camera, ABoxBesideTheEyeIsShownFromWhereTheFrameReachesIt) {
    const Camera camera(perspectiveOptions(100, 100, 40));
    const float slope = std::tan(float(M_PI) / 9);
    for (float sign : {1.0f, -1.0f}) {
        Box3 box;
        box.add(Vec3{500 * sign, -1, -100}), box.add(Vec3{600 * sign, 1, 2000});
        EXPECT_NEAR(camera.shownDepth(box).value_or(0), 500 / slope, 0.1f);
    }
    EXPECT_FALSE(camera.shownDepth({{500, -1, -100}, {600, 1, 1000}}));
    EXPECT_FALSE(camera.shownDepth({{-1, -1, -100}, {1, 1, -1}}));
    EXPECT_EQ(camera.shownDepth({{-1, -1, -100}, {1, 1, 1}}), 0.0f);
    EXPECT_EQ(camera.shownDepth({{-1, -1, 7}, {1, 1, 9}}), 7.0f);
}

TEST(Camera, TimesFillTheShutterInterval) {
    Options options = perspectiveOptions(8, 8, 90);
    options.camera.shutterOpen = 2, options.camera.shutterClose = 3;
    EXPECT_FLOAT_EQ(ray(Camera(options), 1, 1, 0, 0, 0.25f).time, 2.25f);
}

} // namespace
} // namespace candela
