// SPDX-License-Identifier: Apache-2.0
#include "world/scene/flat_light.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "world/scene/flat_points.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>

namespace candela {

namespace {

constexpr int mostTriangles = 16;
/// Columns of the table: origin, edgeA, edgeB, unit normal, offset (see ShadingPoints::offset).
constexpr int normalAt = 9, offsetAt = 12, columns = 13;

/// A point of the unit square, folded onto a triangle: uniform, and neighbours stay neighbours.
CANDELA_HOT void fold(int count, const float *__restrict x, const float *__restrict y,
                      float *__restrict u, float *__restrict v) {
    for (int k = 0; k < count; ++k) {
        bool lower = x[k] > y[k];
        u[k] = lower ? x[k] - y[k] / 2 : x[k] / 2;
        v[k] = lower ? y[k] / 2 : y[k] - x[k] / 2;
    }
}

/// Points whose x lies at or beyond `low` belong to the triangle of [low, low + share), or to a
/// later one; within, x is uniform again. Taking x, and not a number of its own, keeps samples
/// that are stratified over the square stratified over the light.
CANDELA_HOT void passTriangle(int count, const float *__restrict x, float low, float share,
                              int step, int *__restrict triangle, float *__restrict within) {
    for (int k = 0; k < count; ++k) {
        bool reaches = x[k] >= low;
        triangle[k] += reaches ? step : 0;
        float scaled = (x[k] - low) / share;
        within[k] = reaches ? (scaled < 0x1.fffffep-1f ? scaled : 0x1.fffffep-1f) : within[k];
    }
}

CANDELA_HOT void finish(int count, const float *__restrict pdf, std::int32_t light,
                        std::uint8_t castsShadow, std::int32_t *__restrict lights,
                        std::uint8_t *__restrict shadows) {
    for (int k = 0; k < count; ++k) {
        lights[k] = pdf[k] > 0 ? light : 0;
        shadows[k] = castsShadow;
    }
}

CANDELA_HOT void takeValues(int count, const float *__restrict pdf, const float *__restrict Cl,
                            float *__restrict value) {
    for (int k = 0; k < count; ++k)
        value[k] = pdf[k] > 0 ? Cl[k] : 0.0f;
}

/// Direction, distance and density; L ends before the zone in which the light's own triangles
/// might stand in the way. pdf = 0: the light is not to be had from there.
CANDELA_HOT void directions(int count, const float *__restrict lightOffset, float areaDensity,
                            float roundingShare, const float *__restrict px,
                            const float *__restrict py, const float *__restrict pz,
                            const float *__restrict nx, const float *__restrict ny,
                            const float *__restrict nz, const float *__restrict x,
                            const float *__restrict y, const float *__restrict z,
                            float *__restrict lx, float *__restrict ly, float *__restrict lz,
                            float *__restrict distance, float *__restrict pdf) {
    for (int k = 0; k < count; ++k) {
        float dx = px[k] - x[k], dy = py[k] - y[k], dz = pz[k] - z[k];
        float squared = dx * dx + dy * dy + dz * dz;
        float length = std::sqrt(squared);
        float height = std::fabs(dx * nx[k] + dy * ny[k] + dz * nz[k]); // Length times cosine.
        float perHeight = 1 / height;
        float largest = std::fabs(px[k]);
        largest = std::fabs(py[k]) > largest ? std::fabs(py[k]) : largest;
        largest = std::fabs(pz[k]) > largest ? std::fabs(pz[k]) : largest;
        float offset = lightOffset[k] + roundingShare * largest;
        float before = 1 - offset * perHeight;
        before = before > 0.5f ? before : 0.5f;
        float density = areaDensity * squared * length * perHeight;
        lx[k] = dx * before, ly[k] = dy * before, lz[k] = dz * before;
        distance[k] = length * before;
        pdf[k] = density * 0 == 0 ? density : 0.0f;
    }
}

/// The planes of one call.
struct FlatScratch {
    LightBatch batch{lightBatchSize};
    Planes<float> floats{4, lightBatchSize}, edges{6, lightBatchSize};
    Planes<int> triangle{1, lightBatchSize};
};

FlatScratch &scratch() {
    thread_local FlatScratch own;
    return own;
}

bool readsOnlyPlace(const ShaderCode &code) {
    for (int input = 0; input < int(ShaderInput::Count); ++input) {
        auto within = [input](ShaderInput first, int components) {
            return input >= int(first) && input < int(first) + components;
        };
        bool given = within(ShaderInput::P, 3) || within(ShaderInput::N, 3) ||
                     within(ShaderInput::Ng, 3) || within(ShaderInput::Ps, 3) ||
                     within(ShaderInput::time, 1);
        if (!given && code.reads(ShaderInput(input)))
            return false;
    }
    return code.variables().empty();
}

/// Sets a triangle's entries in the table; false if it isn't flat.
bool setTriangle(const SceneState &state, const SceneLight::Triangle &place, int number,
                 FlatLight &light) {
    std::optional<FlatTriangle> flat = flatTriangle(state, place.primitive, place.triangle);
    if (!flat)
        return false;
    int column = 0;
    auto set = [&](float value) { light.columns[column++ * mostTriangles + number] = value; };
    for (Vec3 v : {flat->origin, flat->edgeA, flat->edgeB, normalize(flat->normal)})
        set(v.x), set(v.y), set(v.z);
    set(state.summaries[place.primitive].offset);
    return true;
}

} // namespace

FlatLight flatLight(const SceneState &state, const SceneLight &light) {
    FlatLight flat;
    bool few = !light.triangles.empty() && int(light.triangles.size()) <= mostTriangles;
    if (light.kind != LightKind::Area || !few || !readsOnlyPlace(*light.shader.code))
        return {};
    flat.cumulative.assign(light.cumulative.begin(), light.cumulative.end());
    // Every triangle must have a share to be found by.
    if (std::ranges::adjacent_find(flat.cumulative, std::greater_equal{}) !=
            flat.cumulative.end() ||
        flat.cumulative.front() <= 0)
        return {};
    flat.columns.resize(columns * mostTriangles);
    int number = 0;
    for (const SceneLight::Triangle &triangle : light.triangles) {
        const SceneCode &surface = state.codes[state.summaries[triangle.primitive].code];
        if (triangle.triangle == wholeSurface || surface.code->facts().emits ||
            !setTriangle(state, triangle, number++, flat))
            return {};
    }
    return flat;
}

void sampleFlatLight(const SceneState &state, int index, const LightQuery &query, bool chosen,
                     LightSamples &out) {
    FlatScratch &own = scratch();
    const SceneLight &light = state.lights.lights[index];
    const FlatLight &flat = light.flat;
    const int count = query.count;
    LightBatch &batch = own.batch;
    float *u = own.floats[0], *v = own.floats[1], *within = own.floats[2];
    int *triangle = own.triangle[0];
    std::fill_n(triangle, count, 0);
    float low = 0;
    for (std::size_t t = 0; t < flat.cumulative.size(); low = flat.cumulative[t++])
        passTriangle(count, query.position[0], low, flat.cumulative[t] - low, t > 0 ? 1 : 0,
                     triangle, within);
    fold(count, within, query.position[1], u, v);
    float *P[3], *N[3];
    float *planes[columns];
    for (int c = 0; c < 3; ++c) {
        planes[c] = P[c] = batch.input(ShaderInput::P, c);
        planes[3 + c] = own.edges[c], planes[6 + c] = own.edges[3 + c];
        planes[normalAt + c] = N[c] = batch.input(ShaderInput::N, c);
    }
    planes[offsetAt] = own.floats[3];
    for (int c = 0; c < columns; ++c)
        lanes::lookUp(count, &flat.columns[c * mostTriangles], triangle, planes[c]);
    for (int c = 0; c < 3; ++c)
        walkAlongEdges(count, own.edges[c], own.edges[3 + c], u, v, P[c]);
    directions(count, own.floats[3], float(1 / light.area) * (chosen ? light.probability : 1),
               roundingShare, P[0], P[1], P[2], N[0], N[1], N[2], query.P[0], query.P[1],
               query.P[2], out.L[0], out.L[1], out.L[2], out.distance, out.pdfSolidAngle);

    batch.count = count;
    batch.readFrom(ShaderInput::Ng, 3, N);
    float *Ps[3], *time = const_cast<float *>(query.time);
    for (int c = 0; c < 3; ++c)
        Ps[c] = const_cast<float *>(query.P[c]);
    batch.readFrom(ShaderInput::Ps, 3, Ps);
    batch.readFrom(ShaderInput::time, 1, &time);
    std::fill_n(batch.parameterOffset, count, light.shader.parameterOffset);
    batch.ask(state, *light.shader.code);

    finish(count, out.pdfSolidAngle, index + 1, light.castsShadow, out.light, out.castsShadow);
    for (int c = 0; c < colorSamples; ++c)
        takeValues(count, out.pdfSolidAngle, batch.Cl[c], out.value[c]);
}

} // namespace candela
