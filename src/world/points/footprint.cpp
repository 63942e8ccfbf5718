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

} // namespace

void fillFootprints(const Camera &camera, const float *width, ShadingPoints &points) {
    const auto vec = [&](ShaderInput input, int i) {
        return Vec3{points.input(input, 0)[i], points.input(input, 1)[i],
                    points.input(input, 2)[i]};
    };
    const auto plane = [&](ShaderInput input) { return points.input(input, 0); };
    float *dudx = plane(ShaderInput::dudx), *dvdx = plane(ShaderInput::dvdx);
    float *dudy = plane(ShaderInput::dudy), *dvdy = plane(ShaderInput::dvdy);
    float *du = plane(ShaderInput::du), *dv = plane(ShaderInput::dv);
    for (int i = 0; i < points.count; ++i) {
        const float wide = width ? width[i] : camera.pixelSize(length(vec(ShaderInput::P, i)));
        const Vec3 dPdu = vec(ShaderInput::dPdu, i);
        const Parameters parameters(dPdu, vec(ShaderInput::dPdv, i));
        if (parameters.areGood()) {
            const Axes axes = axesOf(vec(ShaderInput::I, i), vec(ShaderInput::Ng, i), dPdu);
            parameters.of(axes.across * wide, dudx[i], dvdx[i]);
            parameters.of(axes.along * wide, dudy[i], dvdy[i]);
        } else {
            dudx[i] = parameters.uAlone(wide), dvdx[i] = 0;
            dudy[i] = 0, dvdy[i] = parameters.vAlone(wide);
        }
        du[i] = std::min(1.0f, std::hypot(dudx[i], dudy[i]));
        dv[i] = std::min(1.0f, std::hypot(dvdx[i], dvdy[i]));
    }
}

} // namespace candela
