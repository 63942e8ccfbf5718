// SPDX-License-Identifier: Apache-2.0
#include "world/scene/surface_domains.h"

#include "foundation/base/scratch.h"
#include "world/points/evaluate.h"
#include "world/points/point_runs.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <cmath>

namespace candela {

std::vector<PlacedDomain> SurfaceDomains::all() const {
    const PointTables &tables = state_->points;
    std::vector<PlacedDomain> domains;
    const auto add = [&](std::uint32_t instance, std::uint32_t shape) {
        const std::int32_t row = tables.appearanceOf(instance, shape);
        const Appearance &appearance = tables.appearances[std::size_t(row)];
        domains.push_back(
            {instance, shape, tables.shapes[shape].surface->domain(), appearance.code,
             appearance.light, appearance.lightSet,
             tables.details[std::size_t(row)].attributes->sides == 1,
             appearance.offset * (instance == noHit ? 1 : tables.instances[instance].stretch)});
    };
    for (std::uint32_t shape = 0; shape < tables.worldShapes; ++shape)
        add(noHit, shape);
    for (std::uint32_t i = 0; i < tables.instances.size(); ++i)
        for (std::uint32_t k = 0; k < tables.instances[i].shapes; ++k)
            add(i, tables.instances[i].firstShape + k);
    return domains;
}

void SurfaceDomains::frames(const SurfacePlaces &places, const Vec3Planes &P, const Vec3Planes &Ng,
                            float *areaScale) const {
    const PointTables &tables = state_->points;
    for (int first = 0, last; first < places.count; first = last) {
        const std::uint32_t instance = places.instance[first], shape = places.shape[first];
        for (last = first + 1; last < places.count && places.shape[last] == shape &&
                               places.instance[last] == instance;)
            ++last;
        SurfaceAnswer answer;
        answer.P = from(P, first), answer.Ng = from(Ng, first);
        answer.areaScale = areaScale + first;
        tables.shapes[shape].surface->evaluate(
            {last - first, places.piece + first, places.u + first, places.v + first}, answer);
        const Matrix4 currentFromShape =
            tables.currentFromShape(instance, shape, state_->camera.shutterOpen());
        const Matrix4 shapeFromCurrent = inverse(currentFromShape).value_or(Matrix4{});
        const float volume = float(std::fabs(determinant3(currentFromShape)));
        const Appearance &appearance =
            tables.appearances[std::size_t(tables.appearanceOf(instance, shape))];
        for (int i = first; i < last; ++i) {
            P.set(i, transformPoint(currentFromShape, P.get(i)));
            const Vec3 normal = transformNormal(shapeFromCurrent, normalize(Ng.get(i)));
            areaScale[i] *= volume * length(normal);
            Ng.set(i, normalize(normal) * appearance.normalSign);
        }
    }
}

void SurfaceDomains::shadingPoints(const SurfacePlaces &places, const Vec3Planes &I, float time,
                                   ShadingPoints &points) const {
    const PointTables &tables = state_->points;
    const int count = points.count = places.count;
    if (count == 0)
        return;
    points.named = true;
    std::copy_n(places.instance, count, points.instance);
    std::copy_n(places.shape, count, points.shape);
    std::copy_n(places.piece, count, points.element);
    std::copy_n(places.u, count, points.u), std::copy_n(places.v, count, points.v);
    const auto vec3 = [&](ShaderInput input) {
        return Vec3Planes{points.input(input, 0), points.input(input, 1), points.input(input, 2)};
    };
    const Vec3Planes P = vec3(ShaderInput::P), Ng = vec3(ShaderInput::Ng);
    thread_local AlignedScratch own;
    frames(places, P, Ng, own.get(std::size_t(paddedLanes(count))));
    const auto rowOf = [&](int i) {
        return std::size_t(tables.appearanceOf(places.instance[i], places.shape[i]));
    };
    for (int i = 0; i < count; ++i)
        if (tables.appearances[rowOf(i)].elementSign < 0)
            Ng.set(i, -Ng.get(i)); // Evaluation turns it as it turns elements' normals.
    for (int c = 0; c < 3; ++c) {
        const float *from[] = {I.x, I.y, I.z};
        std::copy_n(from[c], count, points.input(ShaderInput::I, c));
    }
    const SurfaceCode &code = tables.codes[std::size_t(tables.appearances[rowOf(0)].code)];
    std::fill_n(points.input(ShaderInput::time, 0), count, time);
    evaluatePoints(tables, state_->camera, code, nullptr, points);
    for (int c = 0; c < 3 && code.wanted.E; ++c)
        std::fill_n(points.input(ShaderInput::E, c), count, 0.0f);
    if (code.code->reads(ShaderInput::rayOffset))
        std::copy_n(points.offset, count, points.input(ShaderInput::rayOffset, 0));
    if (code.code->reads(ShaderInput::rayDepth))
        std::fill_n(points.input(ShaderInput::rayDepth, 0), count, 0.0f);
}

void SurfaceDomains::name(ShadingPoints &points, std::uint32_t *piece, float *u, float *v) const {
    nameRuns(state_->points, points, piece, u, v);
}

} // namespace candela
