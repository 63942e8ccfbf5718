// SPDX-License-Identifier: Apache-2.0
// From raster positions to rays. Current space is camera space when the shutter opens, so the
// camera stands at the origin and looks along +z (perspective), or looks along +z from the screen
// window's plane (orthographic); what moves is the camera, afterwards.
#pragma once

#include "foundation/base/box3.h"
#include "foundation/base/matrix4.h"
#include "foundation/base/motion_steps.h"
#include "interface/ri/options.h"
#include "world/rays/ray_batch.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace candela {

class Camera {
public:
    explicit Camera(const Options &);

    /// Rays through raster positions (x right, y down, pixels; centre of pixel 0 at 0.5). They
    /// start at the lens (or, orthographic, on the plane z = 0) and reach from the near to the far
    /// clipping plane. Directions are of unit length, footprints as wide as a pixel. lensU, lensV
    /// in [0,1) choose the point on the lens, time01 the moment of the shutter interval; they are
    /// read if there is a lens, or an interval.
    void rays(int count, const float *x, const float *y, const float *lensU, const float *lensV,
              const float *time01, RayBatch &) const;

    /// How points are seen from the lens, planes of the caller's.
    struct Sights {
        std::array<float *, 3> origin{}, direction{}; ///< From the lens, of unit length.
        float *distance = nullptr;        ///< To the point; 0 = it lies beyond the clipping planes.
        float *nearest = nullptr;         ///< Along it, of the near clipping plane.
        float *x = nullptr, *y = nullptr; ///< Raster position; anywhere, also off the frame.
        /// The mean radiance of a pixel that 1 W leaving towards the lens makes there, from an
        /// area seen face on, per W m^-2 sr^-1: 1 over the area that the pixel sees at the point.
        float *importance = nullptr;
        float *pdf = nullptr; ///< As pdf().
    };
    void see(int count, const std::array<const float *, 3> &P, const float *lensU,
             const float *lensV, const Sights &) const;
    /// The density with which rays through random places of the whole frame take this direction,
    /// given by the cosine with the axis: per steradian; of parallel rays that of the place, per
    /// m^2.
    float pdf(float cosine) const;
    /// All rays have one direction.
    bool isParallel() const { return !perspective_; }
    float shutterOpen() const { return shutter_.open; }
    const Shutter &shutter() const { return shutter_; }
    /// Rays get times of their own, also where the shutter is open for no more than an instant.
    void giveTimes();

    bool hasLens() const { return lensRadius_ > 0; }
    bool hasShutterInterval() const { return shutter_.hasInterval(); }

    /// It moves while the shutter is open. What see() and the matrices below tell is when it opens.
    bool moves() const { return !cameraFromCurrent_.empty(); }
    /// Where points of current space are for it, at even steps over the shutter's interval; empty
    /// if it stands still.
    std::span<const Matrix4> cameraFromCurrent() const { return cameraFromCurrent_; }
    /// The middle of the lens.
    Vec3 eye(float time) const;
    /// z in the space of the camera at that time.
    float depth(Vec3 P, float time) const;

    /// "screen", "NDC" and "raster" seen from camera space (homogeneous; RI 3.2, 4.1.1).
    const Matrix4 &screenFromCamera() const { return screenFromCamera_; }
    const Matrix4 &ndcFromCamera() const { return ndcFromCamera_; }
    const Matrix4 &rasterFromCamera() const { return rasterFromCamera_; }
    /// Edge length of a pixel, in metres, at depth z: what dicing is measured by.
    float pixelSize(float z) const;
    /// Steps of a pixel in x and in y, in metres, at depth z.
    Vec3 pixelStepX(float z) const { return {xStep_[0] * atDepth(z), xStep_[1] * atDepth(z), 0}; }
    Vec3 pixelStepY(float z) const { return {yStep_[0] * atDepth(z), yStep_[1] * atDepth(z), 0}; }
    /// The least depth (z, metres) at which the frame may show something of the box, whatever the
    /// crop window; nothing if it shows none of it.
    std::optional<float> shownDepth(const Box3 &) const;

private:
    float atDepth(float z) const { return perspective_ ? z : 1; }
    void moveWithCamera(RayBatch &) const;

    Matrix4 screenFromCamera_, ndcFromCamera_, rasterFromCamera_;
    bool perspective_ = false;
    float near_ = 0, far_ = 0;
    /// Raster to the plane z = 1 (perspective; orthographic: any z): a row each for the origin, a
    /// step of a pixel in x, and one in y.
    float origin_[2] = {-1, 1}, xStep_[2] = {}, yStep_[2] = {};
    float low_[2] = {}, high_[2] = {}; ///< Bounds of the frame on that plane.
    float lensRadius_ = 0, focalDistance_ = 0;
    Shutter shutter_;
    std::vector<Matrix4> cameraFromCurrent_, currentFromCamera_; ///< See cameraFromCurrent().
    float pixelArea_ = 1;                                        ///< On that plane,
    double frameArea_ = 1;                                       ///< and of the whole frame.
    float focal_ = 1; ///< Distance of the screen plane for which the screen window is stated.
};

} // namespace candela
