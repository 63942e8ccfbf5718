// SPDX-License-Identifier: Apache-2.0
#include "world/scene/source_geometry.h"

#include "world/shapes/dice_rate.h"
#include "world/shapes/shape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela {

namespace {

constexpr float pi = std::numbers::pi_v<float>;

struct Corners {
    Vec3 p[3];
};

Corners cornersOf(const LightElement &e) {
    return {{e.corner, e.corner + e.edgeA, e.corner + e.edgeB}};
}

} // namespace

double areaOf(const LightElement &e) {
    switch (e.form) {
    case LightElement::Form::NoShape: return 0;
    case LightElement::Form::Triangle: return double(length(cross(e.edgeA, e.edgeB))) / 2;
    case LightElement::Form::Rectangle: return double(length(cross(e.edgeA, e.edgeB)));
    case LightElement::Form::Sphere: return 4 * std::numbers::pi * double(e.edgeA.x) * e.edgeA.x;
    }
    return 0;
}

/// Van Oosterom and Strackee 1983.
static double solidAngleOfTriangle(Vec3 a, Vec3 b, Vec3 c) {
    const double la = length(a), lb = length(b), lc = length(c);
    const double volume = dot(a, cross(b, c));
    const double rest =
        la * lb * lc + double(dot(a, b)) * lc + double(dot(a, c)) * lb + double(dot(b, c)) * la;
    return 2 * std::atan2(std::abs(volume), rest);
}

double solidAngleOf(const LightElement &e) {
    const Corners corners = cornersOf(e);
    switch (e.form) {
    case LightElement::Form::NoShape: return 0;
    case LightElement::Form::Rectangle:
        return solidAngleOfTriangle(corners.p[0], corners.p[1], corners.p[2]) +
               solidAngleOfTriangle(corners.p[1], corners.p[2], e.corner + e.edgeA + e.edgeB);
    case LightElement::Form::Triangle:
        return solidAngleOfTriangle(corners.p[0], corners.p[1], corners.p[2]);
    case LightElement::Form::Sphere: break;
    }
    const double distance = length(e.corner), sine = e.edgeA.x / distance;
    return sine < 1 ? 2 * std::numbers::pi * (1 - std::sqrt(1 - sine * sine))
                    : 4 * std::numbers::pi;
}

EmitterBound boundOf(const LightTable &table, const LightSource &source, LightSides sides,
                     float elementSign) {
    EmitterBound bound;
    // The shading normals, by which the lights' shaders go, may be others than the elements'.
    bound.isLoose = true;
    bound.emissionSpread = sides == LightSides::Both ? pi : pi / 2;
    const float side = sides == LightSides::Back ? -elementSign : elementSign;
    const std::span members(table.members.data() + source.firstMember, source.members);
    Vec3 sum;
    for (std::int32_t member : members) {
        const LightElement &e = table.elements[member];
        if (e.form == LightElement::Form::Sphere) {
            const Vec3 radius{e.edgeA.x, e.edgeA.x, e.edgeA.x};
            bound.normalSpread = pi;
            bound.box = {e.corner - radius, e.corner + radius};
            return bound;
        }
        for (Vec3 corner : cornersOf(e).p)
            bound.box.add(corner);
        if (e.form == LightElement::Form::Rectangle)
            bound.box.add(e.corner + e.edgeA + e.edgeB);
        sum += cross(e.edgeA, e.edgeB);
    }
    bound.axis = normalize(sum) * side;
    double least = 1;
    for (std::int32_t member : members) {
        const LightElement &e = table.elements[member];
        if (const Vec3 normal = cross(e.edgeA, e.edgeB); dot(normal, normal) > 0)
            least = std::min<double>(least, dot(normalize(normal) * side, bound.axis));
    }
    if (source.members > 1) // Of floats: a little wider than it seems.
        bound.normalSpread = std::min(float(std::acos(std::max(least, -1.0))) + 1e-3f, pi);
    return bound;
}

void spreadByMotion(std::span<const Matrix4> steps, const Matrix4 &objectFromOpen,
                    EmitterBound &bound) {
    if (steps.empty() || bound.box.empty())
        return;
    Box3 swept = bound.box; // Between two steps every point goes straight.
    bool turns = false;
    for (const Matrix4 &step : steps) {
        swept.add(transformBox(objectFromOpen * step, bound.box));
        turns |= !std::equal(step.m.begin(), step.m.begin() + 12, steps.front().m.begin());
    }
    bound.box = swept;
    if (turns)
        bound.normalSpread = pi;
}

void setTriangle(LightElement &element, const RayShape &mesh, std::uint32_t number,
                 const Matrix4 &currentFromOuter) {
    auto [a, b, c] = mesh.triangles[number];
    const Vec3 corner = transformPoint(currentFromOuter, mesh.positions[a]);
    element.form = LightElement::Form::Triangle;
    element.element = number;
    element.corner = corner;
    element.edgeA = transformPoint(currentFromOuter, mesh.positions[b]) - corner;
    element.edgeB = transformPoint(currentFromOuter, mesh.positions[c]) - corner;
}

/// Where the near wall lets rays through, the far one shines beside it, or alone.
static float shareOfFarWall(const RayShape &sphere) {
    if (sphere.frontSign != 0)
        return sphere.frontSign < 0 ? 1.0f : 0.0f;
    return sphere.opaque ? 0.0f : 0.5f;
}

std::optional<LightElement> sphereOf(const LightElement &like, const RayShape &shape,
                                     const Matrix4 &currentFromOuter) {
    const RoundElements &round = shape.round;
    if (round.size() != 1 || !round.tubes.empty() || !keepsSpheres(currentFromOuter))
        return std::nullopt;
    const auto [x, y, z, r] = round.knots[0];
    const Vec3 radius = transformVector(currentFromOuter, {r, 0, 0});
    LightElement element = like;
    element.form = LightElement::Form::Sphere;
    element.corner = transformPoint(currentFromOuter, {x, y, z});
    element.edgeA = {length(radius), 0, 0};
    element.edgeB = {shareOfFarWall(shape), 0, 0};
    return element;
}

std::optional<LightElement> rectangleOf(const LightElement &one, const LightElement &other) {
    const Corners a = cornersOf(one), b = cornersOf(other);
    const float size = std::fabs(one.corner.x) + std::fabs(one.corner.y) + std::fabs(one.corner.z) +
                       length(one.edgeA) + length(one.edgeB);
    const float rounding = 4e-7f * size;
    auto same = [&](Vec3 p, Vec3 q) { return length(p - q) <= rounding; };
    for (int k = 0; k < 3; ++k) {
        // The corner with the right angle; the other triangle must fill up the parallelogram.
        const Vec3 corner = a.p[k], next = a.p[(k + 1) % 3], last = a.p[(k + 2) % 3];
        const Vec3 edgeA = next - corner, edgeB = last - corner;
        // Rounded corners turn the short edge of a strip: a milliradian moves nothing by much.
        const float a1 = length(edgeA), b1 = length(edgeB);
        const float turned = std::min(1e-5f * a1 * b1 + rounding * (a1 + b1), 1e-3f * a1 * b1);
        if (std::fabs(dot(edgeA, edgeB)) > turned)
            continue;
        int found = 0;
        for (Vec3 wanted : {next, last, corner + edgeA + edgeB})
            for (Vec3 p : b.p)
                found += same(p, wanted);
        if (found != 3)
            continue;
        LightElement rectangle = one;
        rectangle.form = LightElement::Form::Rectangle;
        rectangle.corner = corner, rectangle.edgeA = edgeA, rectangle.edgeB = edgeB;
        return rectangle;
    }
    return std::nullopt;
}

} // namespace candela
