// SPDX-License-Identifier: Apache-2.0
#include "world/scene/flat_light.h"

#include "foundation/base/hot.h"
#include "world/scene/light_question.h"
#include "world/scene/scene_state.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace candela {

namespace {

constexpr int mostTriangles = 16;
/// A row of the table: origin, edgeA, edgeB, unit normal, offset; see ShadingPoints::offset.
constexpr int rowFloats = 13, normalAt = 9, offsetAt = 12;

/// A point of the unit square, folded onto a triangle: uniform, and neighbours stay neighbours.
CANDELA_HOT void place(int count, const float *__restrict cumulative, int triangles,
                       const float *__restrict choice, const float *__restrict x,
                       const float *__restrict y, int *__restrict row, float *__restrict u,
                       float *__restrict v) {
    for (int k = 0; k < count; ++k) {
        int index = 0;
        for (int t = 0; t + 1 < triangles; ++t)
            index += choice[k] >= cumulative[t];
        row[k] = index * rowFloats;
        bool lower = x[k] > y[k];
        u[k] = lower ? x[k] - y[k] / 2 : x[k] / 2;
        v[k] = lower ? y[k] / 2 : y[k] - x[k] / 2;
    }
}

CANDELA_HOT void positions(int count, const float *__restrict rows, const int *__restrict row,
                           const float *__restrict u, const float *__restrict v,
                           float *__restrict P, float *__restrict N) {
    for (int k = 0; k < count; ++k) {
        int at = row[k];
        P[k] = rows[at] + rows[at + 3] * u[k] + rows[at + 6] * v[k];
        N[k] = rows[at + normalAt];
    }
}

/// Direction, distance and density; L ends before the zone in which the light's own triangles
/// might stand in the way. pdf = 0: the light is not to be had from there.
CANDELA_HOT void directions(int count, const float *__restrict rows, const int *__restrict row,
                            float areaDensity, float roundingShare, const float *__restrict px,
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
        float cosine = std::fabs(dx * nx[k] + dy * ny[k] + dz * nz[k]) / length;
        float largest = std::fabs(px[k]);
        largest = std::fabs(py[k]) > largest ? std::fabs(py[k]) : largest;
        largest = std::fabs(pz[k]) > largest ? std::fabs(pz[k]) : largest;
        float offset = rows[row[k] + offsetAt] + roundingShare * largest;
        float before = 1 - offset / (length * cosine);
        before = before > 0.5f ? before : 0.5f;
        float density = areaDensity * squared / cosine;
        lx[k] = dx * before, ly[k] = dy * before, lz[k] = dz * before;
        distance[k] = length * before;
        pdf[k] = density * 0 == 0 ? density : 0.0f;
    }
}

CANDELA_HOT void pick(int count, const std::int32_t *__restrict lanes,
                      const float *__restrict from, float *__restrict to) {
    for (int k = 0; k < count; ++k)
        to[k] = from[lanes[k]];
}

/// The planes of one call.
struct FlatScratch {
    LightBatch batch{lightBatchSize};
    Planes<float> floats{7, lightBatchSize};
    Planes<int> rows{1, lightBatchSize};
    Planes<float> results{5, lightBatchSize};
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

/// Adds a triangle of the table; false if its normals are not those of a plane.
bool addRow(const SceneState &state, const SceneLight::Triangle &place, FlatLight &flat) {
    const ScenePrimitive &primitive = state.primitives[place.primitive];
    const std::uint32_t piece[3] = {place.triangle, place.triangle, place.triangle};
    const float u[3] = {0, 1, 0}, v[3] = {0, 0, 1};
    float planes[9][3];
    auto at = [&](int first) { return Vec3Planes{planes[first], planes[first + 1], planes[first + 2]}; };
    SurfaceAnswer answer;
    answer.P = at(0), answer.Ng = at(3), answer.N = at(6);
    primitive.surface->evaluate({3, piece, u, v}, answer);
    Vec3 corner[3], normal[3];
    for (int k = 0; k < 3; ++k) {
        corner[k] = transformPoint(primitive.currentFromObject, answer.P.get(k));
        normal[k] = normalize(transformNormal(primitive.objectFromCurrent, answer.N.get(k)));
        if (dot(normal[k], normal[0]) < 1 - 1e-6f || answer.N.get(k) != answer.Ng.get(k))
            return false;
    }
    Vec3 n = normal[0] * primitive.normalSign;
    for (Vec3 v3 : {corner[0], corner[1] - corner[0], corner[2] - corner[0], n})
        for (int c = 0; c < 3; ++c)
            flat.rows.push_back(v3[c]);
    flat.rows.push_back(state.summaries[place.primitive].offset);
    return true;
}

} // namespace

FlatLight flatLight(const SceneState &state, const SceneLight &light) {
    FlatLight flat;
    bool few = !light.triangles.empty() && int(light.triangles.size()) <= mostTriangles;
    if (light.kind != LightKind::Area || !few || !readsOnlyPlace(*light.shader.code))
        return {};
    for (const SceneLight::Triangle &triangle : light.triangles) {
        const SceneCode &surface = state.codes[state.summaries[triangle.primitive].code];
        if (triangle.triangle == wholeSurface || surface.code->facts().emits ||
            !state.primitives[triangle.primitive].vertexUv.empty() ||
            !addRow(state, triangle, flat))
            return {};
    }
    flat.cumulative.assign(light.cumulative.begin(), light.cumulative.end());
    return flat;
}

void sampleFlatLight(const SceneState &state, int index, const LightQuery &query,
                     const std::int32_t *lanes, const float *choice, int count, bool chosen,
                     LightSamples &out) {
    FlatScratch &own = scratch();
    const SceneLight &light = state.lights.lights[index];
    const FlatLight &flat = light.flat;
    auto read = [&](const float *from, int plane) {
        if (!lanes)
            return from;
        pick(count, lanes, from, own.floats[plane]);
        return static_cast<const float *>(own.floats[plane]);
    };
    const float *x = read(query.position[0], 0), *y = read(query.position[1], 1);
    const float *Ps[3] = {read(query.P[0], 2), read(query.P[1], 3), read(query.P[2], 4)};
    const float *time = read(query.time, 5);

    LightBatch &batch = own.batch;
    float *u = own.results[3], *v = own.results[4];
    int *row = own.rows[0];
    place(count, flat.cumulative.data(), int(flat.cumulative.size()), choice, x, y, row, u, v);
    float *P[3], *N[3];
    for (int c = 0; c < 3; ++c) {
        P[c] = batch.input(ShaderInput::P, c), N[c] = batch.input(ShaderInput::N, c);
        positions(count, flat.rows.data() + c, row, u, v, P[c], N[c]);
    }
    // The results stand where they belong at once if the points do.
    float *L[3], *distance = lanes ? own.results[3] : out.distance;
    float *pdf = lanes ? own.results[4] : out.pdfSolidAngle;
    for (int c = 0; c < 3; ++c)
        L[c] = lanes ? own.results[c] : out.L[c];
    directions(count, flat.rows.data(), row,
               float(1 / light.area) * (chosen ? light.probability : 1), roundingShare, P[0], P[1],
               P[2], N[0], N[1], N[2], Ps[0], Ps[1], Ps[2], L[0], L[1], L[2], distance, pdf);

    batch.count = count;
    batch.readFrom(ShaderInput::Ng, 3, N);
    batch.readFrom(ShaderInput::Ps, 3, const_cast<float *const *>(Ps));
    float *times[1] = {const_cast<float *>(time)};
    batch.readFrom(ShaderInput::time, 1, times);
    std::fill_n(batch.parameterOffset, count, light.shader.parameterOffset);
    batch.ask(state, *light.shader.code);

    for (int k = 0; k < count; ++k) {
        int i = lanes ? lanes[k] : k;
        bool seen = pdf[k] > 0;
        if (lanes) {
            for (int c = 0; c < 3; ++c)
                out.L[c][i] = L[c][k];
            out.distance[i] = distance[k];
            out.pdfSolidAngle[i] = pdf[k];
        }
        out.light[i] = seen ? index + 1 : 0;
        out.castsShadow[i] = light.castsShadow;
    }
    for (int c = 0; c < colorSamples; ++c)
        for (int k = 0; k < count; ++k)
            out.value[c][lanes ? lanes[k] : k] = pdf[k] > 0 ? batch.Cl[c][k] : 0;
}

} // namespace candela
