// SPDX-License-Identifier: Apache-2.0
#include "world/camera/camera.h"

#include <cmath>
#include <gtest/gtest.h>

namespace candela {
namespace {

Options perspectiveOptions(int width, int height, float fov) {
    Options options;
    options.xResolution = width, options.yResolution = height;
    options.camera.perspective = true, options.camera.fieldOfView = fov;
    return options;
}

struct Ray {
    Vec3 origin, direction;
    float tMax, time;
};

Ray ray(const Camera &camera, float x, float y, float lensU = 0.5f, float lensV = 0.5f,
        float time01 = 0) {
    RayBatch batch(1);
    camera.rays(1, &x, &y, &lensU, &lensV, &time01, batch);
    return {{batch.origin[0][0], batch.origin[1][0], batch.origin[2][0]},
            {batch.direction[0][0], batch.direction[1][0], batch.direction[2][0]},
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
    options.screenWindow = {0, 2, -1, 3};
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
                Vec3 start = transformPoint(camera.screenFromCamera(), r.origin + r.direction * r.tMin);
                EXPECT_NEAR(start.z, 0, 1e-5) << "screen depth is 0 at the near plane";
                Vec3 end = r.origin + r.direction * r.tMax;
                EXPECT_NEAR(transformPoint(camera.screenFromCamera(), end).z, 1, 1e-5);
            }
    }
}

TEST(Camera, OrthographicRaysAreParallel) {
    Options options;
    options.xResolution = options.yResolution = 10;
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

TEST(Camera, TimesFillTheShutterInterval) {
    Options options = perspectiveOptions(8, 8, 90);
    options.camera.shutterOpen = 2, options.camera.shutterClose = 3;
    EXPECT_FLOAT_EQ(ray(Camera(options), 1, 1, 0, 0, 0.25f).time, 2.25f);
}

} // namespace
} // namespace candela
