// SPDX-License-Identifier: Apache-2.0
#include "world/scene/source_geometry.h"

#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

struct Corners {
    Vec3 p[3];
};

Corners cornersOf(const LightSource &s) {
    return {{s.corner, s.corner + s.edgeA, s.corner + s.edgeB}};
}

} // namespace

double areaOf(const LightSource &s) {
    switch (s.form) {
    case LightSource::Form::NoShape: return 0;
    case LightSource::Form::Triangle: return double(length(cross(s.edgeA, s.edgeB))) / 2;
    case LightSource::Form::Rectangle: return double(length(cross(s.edgeA, s.edgeB)));
    case LightSource::Form::Sphere: return 4 * std::numbers::pi * double(s.edgeA.x) * s.edgeA.x;
    }
    return 0;
}

EmitterBound boundOf(const LightSource &s, double power) {
    EmitterBound bound;
    bound.power = float(power);
    bound.emissionSpread = pi; // To both sides, as far as is known.
    const Vec3 radius{s.edgeA.x, s.edgeA.x, s.edgeA.x};
    bound.box.add(s.corner);
    switch (s.form) {
    case LightSource::Form::NoShape: bound.normalSpread = pi; return bound;
    case LightSource::Form::Sphere:
        bound.normalSpread = pi;
        bound.box = {s.corner - radius, s.corner + radius};
        return bound;
    case LightSource::Form::Rectangle: bound.box.add(s.corner + s.edgeA + s.edgeB); break;
    case LightSource::Form::Triangle: break;
    }
    bound.box.add(s.corner + s.edgeA), bound.box.add(s.corner + s.edgeB);
    bound.axis = normalize(cross(s.edgeA, s.edgeB));
    return bound;
}

void setTriangle(LightSource &source, const RayShape &mesh, std::uint32_t element,
                 const Matrix4 &currentFromOuter) {
    auto [a, b, c] = mesh.triangles[element];
    const Vec3 corner = transformPoint(currentFromOuter, mesh.positions[a]);
    source.form = LightSource::Form::Triangle;
    source.element = element;
    source.corner = corner;
    source.edgeA = transformPoint(currentFromOuter, mesh.positions[b]) - corner;
    source.edgeB = transformPoint(currentFromOuter, mesh.positions[c]) - corner;
}

std::optional<LightSource> rectangleOf(const LightSource &one, const LightSource &other) {
    const Corners a = cornersOf(one), b = cornersOf(other);
    const float size = std::fabs(one.corner.x) + std::fabs(one.corner.y) + std::fabs(one.corner.z) +
                       length(one.edgeA) + length(one.edgeB);
    auto same = [&](Vec3 p, Vec3 q) { return length(p - q) <= 4e-7f * size; };
    for (int k = 0; k < 3; ++k) {
        // The corner with the right angle; the other triangle must fill up the parallelogram.
        const Vec3 corner = a.p[k], next = a.p[(k + 1) % 3], last = a.p[(k + 2) % 3];
        const Vec3 edgeA = next - corner, edgeB = last - corner;
        if (std::fabs(dot(edgeA, edgeB)) > 1e-5f * length(edgeA) * length(edgeB))
            continue;
        int found = 0;
        for (Vec3 wanted : {next, last, corner + edgeA + edgeB})
            for (Vec3 p : b.p)
                found += same(p, wanted);
        if (found != 3)
            continue;
        LightSource rectangle = one;
        rectangle.form = LightSource::Form::Rectangle;
        rectangle.corner = corner, rectangle.edgeA = edgeA, rectangle.edgeB = edgeB;
        return rectangle;
    }
    return std::nullopt;
}

} // namespace candela
