// SPDX-License-Identifier: Apache-2.0
#include "world/camera/camera.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

Matrix4 screenMatrix(bool perspective, float focal, double near, double far) {
    Matrix4 matrix;
    if (!perspective) {
        matrix.at(2, 2) = float(1 / (far - near));
        matrix.at(3, 2) = float(-near / (far - near));
        return matrix;
    }
    matrix.at(0, 0) = matrix.at(1, 1) = focal;
    matrix.at(2, 2) = float(far / (far - near));
    matrix.at(2, 3) = 1;
    matrix.at(3, 2) = float(-near * far / (far - near));
    matrix.at(3, 3) = 0;
    return matrix;
}

struct RayPlanes {
    float *ox, *oy, *oz, *dx, *dy, *dz, *tMin, *tMax;
};

/// Where raster positions fall on the plane z = 1 (perspective) or z = 0 (orthographic).
struct ImagePlane {
    float left, top; ///< Of the raster's corner.
    float xAlongX, yAlongX, xAlongY, yAlongY;
};

CANDELA_HOT void perspectiveRays(int count, const float *__restrict x, const float *__restrict y,
                                 const float *__restrict lensX, const float *__restrict lensY,
                                 ImagePlane plane, float focalDistance, float near, float far,
                                 RayPlanes rays) {
    float *__restrict ox = rays.ox, *__restrict oy = rays.oy, *__restrict oz = rays.oz;
    float *__restrict dx = rays.dx, *__restrict dy = rays.dy, *__restrict dz = rays.dz;
    float *__restrict tMin = rays.tMin, *__restrict tMax = rays.tMax;
    for (int i = 0; i < count; ++i) {
        float px = plane.left + plane.xAlongX * x[i] + plane.xAlongY * y[i];
        float py = plane.top + plane.yAlongY * y[i] + plane.yAlongX * x[i];
        float vx = px * focalDistance - lensX[i], vy = py * focalDistance - lensY[i];
        float length = std::sqrt(vx * vx + vy * vy + focalDistance * focalDistance);
        float scale = 1 / length;
        dx[i] = vx * scale, dy[i] = vy * scale, dz[i] = focalDistance * scale;
        ox[i] = lensX[i], oy[i] = lensY[i], oz[i] = 0;
        tMin[i] = near / dz[i], tMax[i] = far / dz[i];
    }
}

CANDELA_HOT void parallelRays(int count, const float *__restrict x, const float *__restrict y,
                              ImagePlane plane, float near, float far, RayPlanes rays) {
    float *__restrict ox = rays.ox, *__restrict oy = rays.oy, *__restrict oz = rays.oz;
    float *__restrict dx = rays.dx, *__restrict dy = rays.dy, *__restrict dz = rays.dz;
    float *__restrict tMin = rays.tMin, *__restrict tMax = rays.tMax;
    for (int i = 0; i < count; ++i) {
        ox[i] = plane.left + plane.xAlongX * x[i] + plane.xAlongY * y[i];
        oy[i] = plane.top + plane.yAlongY * y[i] + plane.yAlongX * x[i];
        oz[i] = 0;
        dx[i] = 0, dy[i] = 0, dz[i] = 1;
        tMin[i] = near, tMax[i] = far;
    }
}

/// The area-preserving map of the square to the disc (Shirley and Chiu).
void onDisc(float u, float v, float radius, float &x, float &y) {
    float a = 2 * u - 1, b = 2 * v - 1;
    constexpr float quarterTurn = std::numbers::pi_v<float> / 2;
    if (a == 0 && b == 0) {
        x = y = 0;
    } else if (std::abs(a) > std::abs(b)) {
        float angle = quarterTurn / 2 * (b / a);
        x = radius * a * std::cos(angle), y = radius * a * std::sin(angle);
    } else {
        float angle = quarterTurn - quarterTurn / 2 * (a / b);
        x = radius * b * std::cos(angle), y = radius * b * std::sin(angle);
    }
}

constexpr int chunk = 256;

/// Of a camera that moves: where points of the space that is current when the shutter opens are for
/// it. One step if it stands still.
std::vector<Matrix4> stepsOf(const CameraRecord &record, const Shutter &shutter, bool inverted) {
    std::vector<double> times;
    record.motion->addTimes(times);
    const Matrix4d atOpen = record.motion->at(shutter.open);
    const auto cameraFromCurrent = [&](double time) {
        const Matrix4d moved = record.motion->at(time);
        const Matrix4d &from = inverted ? moved : atOpen, &to = inverted ? atOpen : moved;
        return inverse(from).value_or(Matrix4d{}) * to;
    };
    return motionSteps(cameraFromCurrent, times, shutter);
}

} // namespace

Camera::Camera(const Options &options) {
    const CameraRecord &record = options.camera;
    perspective_ = record.perspective;
    near_ = record.near, far_ = record.far;
    shutter_ = {record.shutterOpen, record.shutterClose};
    if (record.motion && shutter_.hasInterval()) {
        cameraFromCurrent_ = stepsOf(record, shutter_, false);
        currentFromCamera_ = stepsOf(record, shutter_, true);
        if (cameraFromCurrent_.size() == 1)
            cameraFromCurrent_.clear(), currentFromCamera_.clear();
    }
    focal_ = 1;
    if (perspective_)
        focal_ = float(1 / std::tan(double(record.fieldOfView) * std::numbers::pi / 360));
    if (perspective_ && record.fStop > 0 && std::isfinite(record.fStop) &&
        record.focalDistance > 0) {
        lensRadius_ = record.focalLength / record.fStop / 2;
        focalDistance_ = record.focalDistance;
    }
    if (!(lensRadius_ > 0) || !(focalDistance_ < 1e29f))
        lensRadius_ = 0, focalDistance_ = 1;

    auto [left, right, bottom, top] = options.format.effectiveScreenWindow();
    auto [width, height] = options.format.effectiveResolution();
    const Matrix4 projectedFromScreen = inverse(record.screenFromProjected).value_or(Matrix4{});
    const Vec3 corner = transformPoint(projectedFromScreen, {left, top, 0}) / focal_;
    const Vec3 xStep =
        transformVector(projectedFromScreen, {(right - left) / float(width) / focal_, 0, 0});
    const Vec3 yStep =
        transformVector(projectedFromScreen, {0, (bottom - top) / float(height) / focal_, 0});
    for (int axis = 0; axis < 2; ++axis)
        origin_[axis] = corner[axis], xStep_[axis] = xStep[axis], yStep_[axis] = yStep[axis];
    pixelArea_ = std::fabs(xStep_[0] * yStep_[1] - xStep_[1] * yStep_[0]);
    frameArea_ = double(pixelArea_) * width * height;
    for (int axis = 0; axis < 2; ++axis) {
        const float x = xStep[axis] * float(width), y = yStep[axis] * float(height);
        low_[axis] = corner[axis] + std::min(x, 0.0f) + std::min(y, 0.0f);
        high_[axis] = corner[axis] + std::max(x, 0.0f) + std::max(y, 0.0f);
    }

    screenFromCamera_ =
        screenMatrix(perspective_, focal_, near_, far_) * record.screenFromProjected;
    Matrix4 ndcFromScreen =
        translation(-left, -top, 0) * scaling(1 / (right - left), 1 / (bottom - top), 1);
    ndcFromCamera_ = screenFromCamera_ * ndcFromScreen;
    rasterFromCamera_ = ndcFromCamera_ * scaling(float(width), float(height), 1);
}

void Camera::rays(int count, const float *x, const float *y, const float *lensU, const float *lensV,
                  const float *time01, RayBatch &batch) const {
    batch.count = count;
    ImagePlane plane{origin_[0], origin_[1], xStep_[0], xStep_[1], yStep_[0], yStep_[1]};
    float lensX[chunk] = {}, lensY[chunk] = {};
    for (int first = 0; first < count; first += chunk) {
        int n = std::min(chunk, count - first);
        RayPlanes planes{batch.origin[0] + first,    batch.origin[1] + first,
                         batch.origin[2] + first,    batch.direction[0] + first,
                         batch.direction[1] + first, batch.direction[2] + first,
                         batch.tMin + first,         batch.tMax + first};
        if (!perspective_) {
            parallelRays(n, x + first, y + first, plane, near_, far_, planes);
            continue;
        }
        if (hasLens())
            for (int i = 0; i < n; ++i)
                onDisc(lensU[first + i], lensV[first + i], lensRadius_, lensX[i], lensY[i]);
        perspectiveRays(n, x + first, y + first, lensX, lensY, plane, focalDistance_, near_, far_,
                        planes);
    }
    lanes::fill(count, perspective_ ? 0 : pixelSize(0), batch.width);
    lanes::fill(count, perspective_ ? pixelSize(1) : 0, batch.spread);
    lanes::fill(count, shutter_.open, batch.time);
    if (hasShutterInterval())
        for (int i = 0; i < count; ++i)
            batch.time[i] += time01[i] * (shutter_.close - shutter_.open);
    if (moves())
        moveWithCamera(batch);
}

/// From camera space at the rays' times to current space.
void Camera::moveWithCamera(RayBatch &batch) const {
    for (int i = 0; i < batch.count; ++i) {
        const Matrix4 moved = matrixAt(currentFromCamera_, shutter_.share(batch.time[i]));
        const Vec3 origin{batch.origin[0][i], batch.origin[1][i], batch.origin[2][i]};
        const Vec3 direction{batch.direction[0][i], batch.direction[1][i], batch.direction[2][i]};
        const Vec3 from = transformPoint(moved, origin), way = transformVector(moved, direction);
        const float stretch = length(way);
        for (int c = 0; c < 3; ++c)
            batch.origin[c][i] = from[c], batch.direction[c][i] = way[c] / stretch;
        batch.tMin[i] *= stretch, batch.tMax[i] *= stretch;
    }
}

void Camera::giveTimes() {
    constexpr float moment =
        0x1p-12f; // So short that it shows nowhere, so long that floats fill it.
    if (!shutter_.hasInterval())
        shutter_.close = shutter_.open + moment * std::max(1.0f, std::fabs(shutter_.open));
}

Vec3 Camera::eye(float time) const {
    return moves() ? transformPoint(matrixAt(currentFromCamera_, shutter_.share(time)), {})
                   : Vec3{};
}

float Camera::depth(Vec3 P, float time) const {
    return moves() ? transformPoint(matrixAt(cameraFromCurrent_, shutter_.share(time)), P).z : P.z;
}

float Camera::pdf(float cosine) const {
    const double seen = perspective_ ? double(cosine) * cosine * cosine : 1;
    return seen > 0 ? float(1 / (frameArea_ * seen)) : 0.0f;
}

void Camera::see(int count, const std::array<const float *, 3> &P, const float *lensU,
                 const float *lensV, const Sights &sights) const {
    const float determinant = xStep_[0] * yStep_[1] - xStep_[1] * yStep_[0];
    for (int i = 0; i < count; ++i) {
        const Vec3 point{P[0][i], P[1][i], P[2][i]};
        Vec3 from, onPlane{point.x, point.y, 1};
        if (!perspective_) {
            from = {point.x, point.y, 0};
        } else {
            if (hasLens())
                onDisc(lensU[i], lensV[i], lensRadius_, from.x, from.y);
            const float share = point.z != 0 ? focalDistance_ / point.z : 0.0f;
            onPlane = (from + (point - from) * share) / focalDistance_;
        }
        const float x = onPlane.x - origin_[0], y = onPlane.y - origin_[1];
        sights.x[i] = (x * yStep_[1] - y * yStep_[0]) / determinant;
        sights.y[i] = (y * xStep_[0] - x * xStep_[1]) / determinant;
        const Vec3 way = point - from;
        const float distance = length(way), cosine = perspective_ ? way.z / distance : 1.0f;
        const bool shown = point.z >= near_ && point.z <= far_ && cosine > 0;
        const double area = perspective_ ? double(pixelArea_) * cosine * cosine * cosine *
                                               double(distance) * distance
                                         : pixelArea_;
        sights.distance[i] = shown && area > 0 ? distance : 0.0f;
        sights.nearest[i] = near_ / cosine;
        sights.importance[i] = area > 0 ? float(1 / area) : 0.0f;
        sights.pdf[i] = pdf(cosine);
        for (int c = 0; c < 3; ++c)
            sights.origin[c][i] = from[c], sights.direction[c][i] = way[c] / distance;
    }
}

float Camera::pixelSize(float z) const {
    float atOne = std::min(std::hypot(xStep_[0], xStep_[1]), std::hypot(yStep_[0], yStep_[1]));
    return perspective_ ? atOne * std::abs(z) : atOne;
}

std::optional<float> Camera::shownDepth(const Box3 &box) const {
    float nearest = std::max(box.low.z, 0.0f), farthest = box.high.z;
    // Beyond each of the frame's four sides; lenses see a little more.
    const float lens = lensRadius_, lensSlope = lensRadius_ / focalDistance_;
    const auto cut = [&](float place, float limit) {
        if (!perspective_) {
            if (place > limit)
                farthest = -1;
            return;
        }
        // Shown where place - lens <= (limit + lensSlope) z.
        const float beyond = place - lens, slope = limit + lensSlope;
        if (slope > 0)
            nearest = std::max(nearest, beyond / slope);
        else if (beyond > 0)
            farthest = -1;
        else if (slope < 0)
            farthest = std::min(farthest, beyond / slope);
    };
    for (int axis = 0; axis < 2; ++axis)
        cut(box.low[axis], high_[axis]), cut(-box.high[axis], -low_[axis]);
    if (!(farthest > 0 && nearest <= farthest))
        return std::nullopt;
    return nearest;
}

} // namespace candela
