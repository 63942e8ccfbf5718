// SPDX-License-Identifier: Apache-2.0
#include "world/displacement/shader_displacement.h"

#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"
#include "world/shapes/dice_rate.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace candela {

namespace {

/// Points are asked about so many at a time.
constexpr int mostPoints = 512;
/// Coordinates beyond this are no place: their squares leave the range of floats.
constexpr float farthest = 1e15f;

bool isPlace(Vec3 p) { // False for NaN.
    return std::fabs(p.x) < farthest && std::fabs(p.y) < farthest && std::fabs(p.z) < farthest;
}

Vec3Planes planesOf(ShadingPoints &points, ShaderInput input) {
    return {points.input(input, 0), points.input(input, 1), points.input(input, 2)};
}

SurfaceQuery part(const SurfaceQuery &query, int first) {
    return {std::min(query.count - first, mostPoints), query.piece ? query.piece + first : nullptr,
            query.u + first, query.v + first};
}

/// The point's own inputs where the shader says nothing of use.
void orElse(int count, Vec3Planes answer, Vec3Planes given) {
    for (int k = 0; k < count; ++k)
        if (!isPlace(answer.get(k)))
            answer.set(k, given.get(k));
}

} // namespace

/// A batch on its way.
struct ShaderDisplacement::Asked {
    Asked() : points(mostPoints), planes(12, mostPoints) {}
    Vec3Planes vec3(int first) const {
        return {planes[first], planes[first + 1], planes[first + 2]};
    }
    Vec3Planes P() const { return vec3(0); }
    Vec3Planes N() const { return vec3(3); }
    Vec3Planes dPdu() const { return vec3(6); }
    Vec3Planes dPdv() const { return vec3(9); }

    ShadingPoints points;
    Planes<float> planes;
    std::vector<float *> outputs;
};

ShaderDisplacement::ShaderDisplacement(const ShaderInstance &shader, const DisplacedThing &thing,
                                       const Camera &camera,
                                       std::shared_ptr<DisplacementBounds> bounds)
    : shapeFromCurrent_(inverse(thing.currentFromShape).value_or(Matrix4{})), camera_(camera),
      pixel_(thing.pixel), rate_(std::sqrt(thing.attributes->shadingRate)),
      sign_(thing.turned ? -1.0f : 1.0f), bounds_(std::move(bounds)) {
    for (ir::Question which : {ir::Question::Displaced, ir::Question::Displace})
        if (which == ir::Question::Displaced || shader.code->displacement().movesP)
            tables_.codes.push_back(
                surfaceCode(shader.code, &shader.code->question(which).function));
    Shape shape = *makeShape(thing.surface, thing.currentFromShape);
    shape.naming = Naming::Direct, shape.curved = shape.away = true; // Queries name points.
    for (const Matrix4 *matrix : {&shape.outerFromShape, &shape.shapeFromOuter})
        tables_.shapeMatrices.insert(tables_.shapeMatrices.end(), matrix->m.begin(),
                                     matrix->m.end());
    tables_.shapes.push_back(std::move(shape)), tables_.worldShapes = 1;
    Appearance appearance;
    appearance.parameterOffset = shader.parameterOffset;
    appearance.normalSign = appearance.elementSign = sign_;
    appearance.Cs = thing.attributes->color.c, appearance.Os = thing.attributes->opacity.c;
    tables_.appearances.push_back(appearance);
    AppearanceDetail detail{thing.attributes, {}, {}, {}, {}, {}};
    for (const std::string &name : tables_.codes.front().variableNames)
        detail.overriding.push_back(numericVariable(*thing.surface, name));
    tables_.details.push_back(std::move(detail));
}

float ShaderDisplacement::width(Vec3 P) const {
    const Matrix4 &currentFromShape = tables_.shapes.front().outerFromShape;
    const float pixel =
        pixel_ > 0 ? pixel_ : camera_.pixelSize(length(transformPoint(currentFromShape, P)));
    return pixel * rate_ / std::max(largestStretch(currentFromShape), 1e-30f);
}

/// Makes shading points of the surface's points; seen from the eye.
void ShaderDisplacement::locate(const SurfaceQuery &query, const SurfaceCode &code,
                                ShadingPoints &points) const {
    const int n = points.count = query.count;
    std::fill_n(points.instance, n, noHit);
    std::fill_n(points.shape, n, 0u);
    for (int k = 0; k < n; ++k)
        points.element[k] = query.piece ? query.piece[k] : 0;
    std::copy_n(query.u, n, points.u);
    std::copy_n(query.v, n, points.v);
    const Vec3Planes P = planesOf(points, ShaderInput::P), I = planesOf(points, ShaderInput::I);
    for (Vec3Planes planes : {P, I, planesOf(points, ShaderInput::Ng)})
        for (int k = 0; k < n; ++k)
            planes.set(k, {});
    if (pixel_ > 0) {
        const std::vector<float> footprint(std::size_t(n), pixel_ * rate_);
        const RayFootprints footprints{footprint.data(), std::nullopt};
        evaluatePoints(tables_, camera_, code, &footprints, points);
    } else {
        evaluatePoints(tables_, camera_, code, nullptr, points);
        for (ShaderInput extent : {ShaderInput::du, ShaderInput::dv, ShaderInput::dudx,
                                   ShaderInput::dvdx, ShaderInput::dudy, ShaderInput::dvdy})
            for (int k = 0; code.wanted.footprint && k < n; ++k) {
                float &value = points.input(extent, 0)[k];
                value = std::clamp(value * rate_, -1.0f, 1.0f);
            }
    }
    for (int k = 0; k < n; ++k)
        I.set(k, P.get(k));
}

/// Where the shader says nothing, the outputs are no numbers.
void ShaderDisplacement::ask(ir::Question which, ShadingPoints &points, Asked &asked) const {
    const QuestionCode &question = code().question(which);
    for (int plane = 0; plane < 12; ++plane)
        std::fill_n(asked.planes[plane], points.count, std::numeric_limits<float>::quiet_NaN());
    const std::pair<ir::OutputKind, Vec3Planes> outputs[] = {{ir::OutputKind::P, asked.P()},
                                                             {ir::OutputKind::N, asked.N()},
                                                             {ir::OutputKind::dPdu, asked.dPdu()},
                                                             {ir::OutputKind::dPdv, asked.dPdv()}};
    for (const auto &[kind, planes] : outputs) {
        float *const table[3] = {planes.x, planes.y, planes.z};
        question.place(kind, table, asked.outputs);
    }
    ShaderArgs args;
    bindPoints(tables_, 0, points, args);
    args.outputs = asked.outputs.data();
    question.ask(args);
}

void ShaderDisplacement::move(const SurfaceQuery &query, Vec3Planes P) const {
    for (int first = 0; first < query.count; first += mostPoints)
        movePart(part(query, first), from(P, first));
}

void ShaderDisplacement::movePart(const SurfaceQuery &query, Vec3Planes P) const {
    thread_local ScratchLevels<Asked> levels;
    const ScratchLevels<Asked>::Level own(levels);
    locate(query, tables_.codes.back(), own->points);
    ask(ir::Question::Displace, own->points, *own);
    const Vec3Planes start = planesOf(own->points, ShaderInput::P);
    for (int k = 0; k < query.count; ++k) {
        Vec3 moved = own->P().get(k);
        if (!isPlace(moved))
            bounds_->wentNowhere(), moved = start.get(k);
        bounds_->moved(moved - start.get(k));
        P.set(k, moved);
    }
    transformPoints(query.count, shapeFromCurrent_, P);
}

void ShaderDisplacement::displace(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    for (int first = 0; first < query.count; first += mostPoints) {
        SurfaceAnswer to;
        to.P = from(answer.P, first), to.N = from(answer.N, first);
        to.dPdu = from(answer.dPdu, first), to.dPdv = from(answer.dPdv, first);
        displacePart(part(query, first), to);
    }
}

void ShaderDisplacement::displacePart(const SurfaceQuery &query,
                                      const SurfaceAnswer &answer) const {
    thread_local ScratchLevels<Asked> levels;
    const ScratchLevels<Asked>::Level own(levels);
    ShadingPoints &points = own->points;
    const int n = query.count;
    locate(query, tables_.codes.front(), points);
    ask(ir::Question::Displaced, points, *own);
    auto give = [&](Vec3Planes to, Vec3Planes from) {
        for (int k = 0; k < n; ++k)
            to.set(k, from.get(k));
    };
    if (answer.P.x) {
        orElse(n, own->P(), planesOf(points, ShaderInput::P));
        give(answer.P, own->P());
        transformPoints(n, shapeFromCurrent_, answer.P);
    }
    if (answer.N.x) {
        // A normal of no length says as little as none.
        for (int k = 0; k < n; ++k)
            if (!isPlace(own->N().get(k)) || own->N().get(k) == Vec3{})
                own->N().set(k, planesOf(points, ShaderInput::N).get(k));
        give(answer.N, own->N());
        transformNormals(n, tables_.shapes.front().outerFromShape, answer.N);
        for (int k = 0; k < n; ++k)
            answer.N.set(k, answer.N.get(k) * sign_);
    }
    const std::pair<Vec3Planes, Vec3Planes> slopes[] = {{answer.dPdu, own->dPdu()},
                                                        {answer.dPdv, own->dPdv()}};
    for (const auto &[to, from] : slopes)
        if (to.x && knowsSlopes()) {
            orElse(n, from,
                   planesOf(points, to.x == answer.dPdu.x ? ShaderInput::dPdu : ShaderInput::dPdv));
            give(to, from);
            transformVectors(n, shapeFromCurrent_, to);
        }
}

} // namespace candela
