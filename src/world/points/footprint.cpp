// SPDX-License-Identifier: Apache-2.0
#include "world/points/footprint.h"

#include "foundation/base/vec3.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

/// A surface that is seen at a lower angle than this (its sine) is taken to be seen at it: beyond,
/// the footprint is not where the surface still looks flat.
constexpr float leastSlant = 1e-3f;

/// The axes of a footprint in space.
struct Axes {
    Vec3 across, along;
};

/// Of a cone of width 1 about the direction `way` (0 = from straight above).
Axes axesOf(const Vec3 &way, const Vec3 &normal, const Vec3 &dPdu) {
    const float distance = length(way), cosine = distance > 0 ? dot(way, normal) / distance : 1;
    Vec3 across = distance > 0 ? cross(normal, way / distance) : Vec3{};
    // From above all directions are alike.
    if (!(length(across) > 1e-4f))
        across = dPdu - normal * dot(dPdu, normal);
    const float size = length(across);
    if (!(size > 0))
        return {};
    across = across / size;
    return {across, cross(normal, across) / std::max(std::abs(cosine), leastSlant)};
}

/// Vectors on the surface as changes of (u,v).
class Parameters {
public:
    Parameters(const Vec3 &dPdu, const Vec3 &dPdv)
        : dPdu_(dPdu), dPdv_(dPdv), uu_(product(dPdu, dPdu)), uv_(product(dPdu, dPdv)),
          vv_(product(dPdv, dPdv)), determinant_(uu_ * vv_ - uv_ * uv_) {}

    /// False at poles and folds.
    bool areGood() const { return determinant_ > 1e-12 * uu_ * vv_ && determinant_ > 0; }
    void of(const Vec3 &vector, float &du, float &dv) const {
        const double byU = product(vector, dPdu_), byV = product(vector, dPdv_);
        du = limited((byU * vv_ - byV * uv_) / determinant_);
        dv = limited((byV * uu_ - byU * uv_) / determinant_);
    }
    /// What is left where (u,v) are no coordinates: as much of either as the width takes.
    float uAlone(float width) const { return limited(uu_ > 0 ? width / std::sqrt(uu_) : 1); }
    float vAlone(float width) const { return limited(vv_ > 0 ? width / std::sqrt(vv_) : 1); }

private:
    static double product(const Vec3 &a, const Vec3 &b) {
        return double(a.x) * b.x + double(a.y) * b.y + double(a.z) * b.z;
    }
    static float limited(double change) { return float(std::clamp(change, -1.0, 1.0)); }

    const Vec3 dPdu_, dPdv_;
    const double uu_, uv_, vv_, determinant_;
};

/// Where the footprints of a batch go.
struct FootprintPlanes {
    explicit FootprintPlanes(ShadingPoints &points)
        : dudx(points.input(ShaderInput::dudx, 0)), dvdx(points.input(ShaderInput::dvdx, 0)),
          dudy(points.input(ShaderInput::dudy, 0)), dvdy(points.input(ShaderInput::dvdy, 0)),
          uShift(points.input(ShaderInput::uShift, 0)),
          vShift(points.input(ShaderInput::vShift, 0)), du(points.input(ShaderInput::du, 0)),
          dv(points.input(ShaderInput::dv, 0)) {}
    float *dudx, *dvdx, *dudy, *dvdy, *uShift, *vShift, *du, *dv;

    /// Of a share of a pixel, whose axes are these on the surface.
    void setShare(int i, const Parameters &parameters, const Vec3 &stepX, const Vec3 &stepY,
                  const PixelShares &shares) {
        parameters.of(stepX * shares.wide[i], dudx[i], dvdx[i]);
        parameters.of(stepY * shares.high[i], dudy[i], dvdy[i]);
        parameters.of(stepX * shares.x[i] + stepY * shares.y[i], uShift[i], vShift[i]);
    }
    void setCone(int i, const Parameters &parameters, const Axes &axes, float width) {
        parameters.of(axes.across * width, dudx[i], dvdx[i]);
        parameters.of(axes.along * width, dudy[i], dvdy[i]);
        uShift[i] = vShift[i] = 0;
    }
    void setAlone(int i, const Parameters &parameters, float width) {
        dudx[i] = parameters.uAlone(width), dvdx[i] = 0;
        dudy[i] = 0, dvdy[i] = parameters.vAlone(width);
        uShift[i] = vShift[i] = 0;
    }
    void setExtent(int i) {
        du[i] = std::min(1.0f, std::hypot(dudx[i], dudy[i]));
        dv[i] = std::min(1.0f, std::hypot(dvdx[i], dvdy[i]));
    }
};

/// Along the line of sight a step beside the surface falls on it here.
Vec3 fallen(const Vec3 &step, const Vec3 &way, const Vec3 &normal) {
    const float least = leastSlant * length(way), along = dot(normal, way);
    const float slant = along < 0 ? std::min(along, -least) : std::max(along, least);
    return slant != 0 ? step - way * (dot(normal, step) / slant) : step;
}

} // namespace

void fillFootprints(const Camera &camera, const RayFootprints *rays, ShadingPoints &points) {
    const auto vec = [&](ShaderInput input, int i) {
        return Vec3{points.input(input, 0)[i], points.input(input, 1)[i],
                    points.input(input, 2)[i]};
    };
    FootprintPlanes footprints(points);
    for (int i = 0; i < points.count; ++i) {
        const Vec3 P = vec(ShaderInput::P, i), dPdu = vec(ShaderInput::dPdu, i);
        const Vec3 way = vec(ShaderInput::I, i), normal = vec(ShaderInput::Ng, i);
        const Parameters parameters(dPdu, vec(ShaderInput::dPdv, i));
        const float width = rays ? rays->width[i] : camera.pixelSize(length(P));
        if (!parameters.areGood())
            footprints.setAlone(i, parameters, width);
        else if (rays && rays->shares)
            footprints.setShare(i, parameters, fallen(camera.pixelStepX(P.z), way, normal),
                                fallen(camera.pixelStepY(P.z), way, normal), *rays->shares);
        else
            footprints.setCone(i, parameters, axesOf(way, normal, dPdu), width);
        footprints.setExtent(i);
    }
}

} // namespace candela
