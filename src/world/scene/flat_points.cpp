// SPDX-License-Identifier: Apache-2.0
#include "world/scene/flat_points.h"

#include "foundation/base/hot.h"
#include "world/scene/scene_state.h"
#include "world/scene/surface_points.h"

#include <algorithm>
#include <cstddef>

namespace candela {

namespace {

/// A row: origin, edgeA, edgeB, normal, density; padded to a cache line.
constexpr int rowFloats = 16, normalAt = 9, densityAt = 12;
/// Larger scenes would fill the caches with the table.
constexpr std::size_t mostTriangles = 1 << 18;
constexpr int summaryWords = sizeof(PrimitiveSummary) / sizeof(float);

CANDELA_HOT void findRows(int count, const int *__restrict firstRow,
                          const std::uint32_t *__restrict primitive,
                          const std::uint32_t *__restrict triangle, int *__restrict row,
                          int *__restrict summary) {
    for (int i = 0; i < count; ++i) {
        row[i] = (firstRow[primitive[i]] + int(triangle[i])) * rowFloats;
        summary[i] = int(primitive[i]) * summaryWords;
    }
}

CANDELA_HOT void positions(int count, const float *__restrict rows, const int *__restrict row,
                           const float *__restrict u, const float *__restrict v,
                           float *__restrict P) {
    for (int i = 0; i < count; ++i)
        P[i] = rows[row[i]] + rows[row[i] + 3] * u[i] + rows[row[i] + 6] * v[i];
}

CANDELA_HOT void column(int count, const float *__restrict table, const int *__restrict at,
                        float *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = table[at[i]];
}

CANDELA_HOT void column(int count, const int *__restrict table, const int *__restrict at,
                        int *__restrict to) {
    for (int i = 0; i < count; ++i)
        to[i] = table[at[i]];
}

bool servedFromTable(const SceneCode &code) {
    const WantedInputs &w = code.wanted;
    return !w.dPd && !w.uv && !w.footprint && !w.st && code.variableNames.empty();
}

} // namespace

std::optional<FlatTriangle> flatTriangle(const SceneState &state, std::uint32_t index,
                                         std::uint32_t triangle) {
    const ScenePrimitive &primitive = state.primitives[index];
    if (!primitive.vertexUv.empty())
        return std::nullopt;
    const std::uint32_t piece[3] = {triangle, triangle, triangle};
    const float u[3] = {0, 1, 0}, v[3] = {0, 0, 1};
    float planes[9][3];
    auto at = [&](int first) {
        return Vec3Planes{planes[first], planes[first + 1], planes[first + 2]};
    };
    SurfaceAnswer answer;
    answer.P = at(0), answer.Ng = at(3), answer.N = at(6);
    primitive.surface->evaluate({3, piece, u, v}, answer);
    Vec3 corner[3];
    for (int k = 0; k < 3; ++k) {
        corner[k] = transformPoint(primitive.currentFromObject, answer.P.get(k));
        if (answer.N.get(k) != answer.Ng.get(k))
            return std::nullopt;
    }
    Vec3 normal = transformNormal(primitive.objectFromCurrent, answer.N.get(0));
    return FlatTriangle{corner[0], corner[1] - corner[0], corner[2] - corner[0],
                        normal * primitive.normalSign};
}

bool FlatTable::takePrimitive(const SceneState &state, std::uint32_t index) {
    const ScenePrimitive &primitive = state.primitives[index];
    firstRow_[index] = int(rows_.size() / rowFloats);
    std::size_t triangles = state.triangleCounts[index];
    if (rows_.size() / rowFloats + triangles > mostTriangles || primitive.Cs >= 0 ||
        primitive.Os >= 0)
        return false;
    for (std::uint32_t t = 0; t < triangles; ++t) {
        std::optional<FlatTriangle> flat = flatTriangle(state, index, t);
        if (!flat)
            return false;
        for (Vec3 v : {flat->origin, flat->edgeA, flat->edgeB, flat->normal})
            rows_.insert(rows_.end(), {v.x, v.y, v.z});
        rows_.push_back(t < primitive.density.size() ? primitive.density[t] : 0);
        rows_.insert(rows_.end(), rowFloats - densityAt - 1, 0.0f);
    }
    return true;
}

void FlatTable::build(SceneState &state) {
    firstRow_.assign(state.primitives.size(), 0);
    for (std::size_t c = 0; c < state.codes.size(); ++c) {
        SceneCode &code = state.codes[c];
        const std::size_t rowsBefore = rows_.size();
        bool flat = servedFromTable(code);
        for (std::uint32_t i = 0; flat && i < state.primitives.size(); ++i)
            if (state.summaries[i].code == int(c))
                flat = takePrimitive(state, i);
        code.flat = flat;
        if (!flat)
            rows_.resize(rowsBefore);
    }
}

void FlatTable::evaluate(const SceneState &state, const TrianglePoints &points,
                         const SceneCode &code, ShadingPoints &out) const {
    thread_local Scratch<int> scratch;
    const int count = out.count = points.count, stride = paddedLanes(count);
    int *row = scratch.get(2 * stride), *summary = row + stride;
    findRows(count, firstRow_.data(), points.primitive, points.triangle, row, summary);

    const float *rows = rows_.data();
    auto plane = [&](ShaderInput input, int c) { return out.inputTable[int(input) + c]; };
    for (int c = 0; c < 3; ++c) {
        positions(count, rows + c, row, points.u, points.v, plane(ShaderInput::P, c));
        column(count, rows + normalAt + c, row, plane(ShaderInput::Ng, c));
        std::copy_n(plane(ShaderInput::Ng, c), count, plane(ShaderInput::N, c));
    }
    column(count, rows + densityAt, row, out.lightPdfArea);

    const float *floats = reinterpret_cast<const float *>(state.summaries.data());
    const int *integers = reinterpret_cast<const int *>(state.summaries.data());
    auto word = [](std::size_t bytes) { return bytes / sizeof(float); };
    column(count, integers + word(offsetof(PrimitiveSummary, parameterOffset)), summary,
           out.parameterOffset);
    column(count, integers + word(offsetof(PrimitiveSummary, lightSet)), summary, out.lightSet);
    column(count, integers + word(offsetof(PrimitiveSummary, light)), summary, out.light);
    column(count, floats + word(offsetof(PrimitiveSummary, offset)), summary, out.offset);
    for (int c = 0; c < colorSamples; ++c) {
        if (code.wanted.Cs)
            column(count, floats + word(offsetof(PrimitiveSummary, Cs)) + c, summary,
                   plane(ShaderInput::Cs, c));
        if (code.wanted.Os)
            column(count, floats + word(offsetof(PrimitiveSummary, Os)) + c, summary,
                   plane(ShaderInput::Os, c));
    }
    std::copy_n(points.primitive, count, out.objectIndex);
    std::copy_n(points.primitive, count, out.primitive);
    addRounding(count,
                {plane(ShaderInput::P, 0), plane(ShaderInput::P, 1), plane(ShaderInput::P, 2)},
                roundingShare, out.offset);
}

} // namespace candela
