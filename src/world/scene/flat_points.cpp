// SPDX-License-Identifier: Apache-2.0
#include "world/scene/flat_points.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "world/scene/scene_state.h"
#include "world/scene/surface_points.h"

#include <algorithm>
#include <cstddef>

namespace candela {

namespace {

/// A row: origin, edgeA, edgeB, unit normal, density; padded to a cache line.
constexpr int rowFloats = 16, normalAt = 9, densityAt = 12;
constexpr int block = 256;
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

bool servedFromTable(const SceneCode &code) {
    const WantedInputs &w = code.wanted;
    return !w.dPd && !w.orientation && !w.uv && !w.footprint && !w.st && code.variableNames.empty();
}

} // namespace

CANDELA_HOT void walkAlongEdges(int count, const float *__restrict edgeA,
                                const float *__restrict edgeB, const float *__restrict u,
                                const float *__restrict v, float *__restrict P) {
    for (int i = 0; i < count; ++i)
        P[i] = P[i] + edgeA[i] * u[i] + edgeB[i] * v[i];
}

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
        for (Vec3 v : {flat->origin, flat->edgeA, flat->edgeB, normalize(flat->normal)})
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

/// What the primitives say of all their points.
void FlatTable::takeSummaries(const SceneState &state, const SceneCode &code, int count,
                              const int *summary, ShadingPoints &out) {
    constexpr int columns = offsetof(PrimitiveSummary, Os) / sizeof(float) + colorSamples;
    float *planes[columns] = {};
    auto word = [&](std::size_t bytes) -> float *& { return planes[bytes / sizeof(float)]; };
    word(offsetof(PrimitiveSummary, parameterOffset)) =
        reinterpret_cast<float *>(out.parameterOffset);
    word(offsetof(PrimitiveSummary, lightSet)) = reinterpret_cast<float *>(out.lightSet);
    word(offsetof(PrimitiveSummary, light)) = reinterpret_cast<float *>(out.light);
    word(offsetof(PrimitiveSummary, offset)) = out.offset;
    for (int c = 0; c < colorSamples; ++c) {
        if (code.wanted.Cs)
            (&word(offsetof(PrimitiveSummary, Cs)))[c] = out.inputTable[int(ShaderInput::Cs) + c];
        if (code.wanted.Os)
            (&word(offsetof(PrimitiveSummary, Os)))[c] = out.inputTable[int(ShaderInput::Os) + c];
    }
    lanes::gatherRows(count, reinterpret_cast<const float *>(state.summaries.data()), summary,
                      columns, planes);
}

void FlatTable::evaluate(const SceneState &state, const TrianglePoints &points,
                         const SceneCode &code, ShadingPoints &out) const {
    thread_local Scratch<int> scratch;
    const int count = out.count = points.count, stride = paddedLanes(count);
    int *row = scratch.get(2 * stride), *summary = row + stride;
    findRows(count, firstRow_.data(), points.primitive, points.triangle, row, summary);
    auto plane = [&](ShaderInput input, int c) { return out.inputTable[int(input) + c]; };
    takeSummaries(state, code, count, summary, out);

    // In blocks, whose edges stay in the first-level cache.
    thread_local Planes<float> edges(6, block);
    for (int first = 0; first < count; first += block) {
        const int n = std::min(block, count - first);
        float *planes[densityAt + 1];
        for (int c = 0; c < 3; ++c) {
            planes[c] = plane(ShaderInput::P, c) + first;
            planes[3 + c] = edges[c], planes[6 + c] = edges[3 + c];
            planes[normalAt + c] = plane(ShaderInput::Ng, c) + first;
        }
        planes[densityAt] = out.lightPdfArea + first;
        lanes::gatherRows(n, rows_.data(), row + first, densityAt + 1, planes);
        for (int c = 0; c < 3; ++c) {
            walkAlongEdges(n, edges[c], edges[3 + c], points.u + first, points.v + first,
                           planes[c]);
            std::copy_n(planes[normalAt + c], n, plane(ShaderInput::N, c) + first);
        }
    }
    std::copy_n(points.primitive, count, out.objectIndex);
    std::copy_n(points.primitive, count, out.primitive);
    addRounding(count,
                {plane(ShaderInput::P, 0), plane(ShaderInput::P, 1), plane(ShaderInput::P, 2)},
                roundingShare, out.offset);
}

} // namespace candela
