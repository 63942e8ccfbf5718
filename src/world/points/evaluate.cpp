// SPDX-License-Identifier: Apache-2.0
#include "world/points/evaluate.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/points/point_runs.h"
#include "world/points/surface_points.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace candela {

namespace {

/// Rounding of a point's coordinates and of the rays that come and go there: sixteen units.
constexpr float pointRounding = 16 * 0x1p-24f;

constexpr int rowWords = sizeof(Appearance) / sizeof(float);
static_assert(rowWords == 16);

Vec3Planes vec3(ShadingPoints &points, ShaderInput input) {
    return {points.input(input, 0), points.input(input, 1), points.input(input, 2)};
}

/// What the appearances say of all their points.
void takeAppearances(const PointTables &tables, const SurfaceCode &code, const int *row,
                     float *normalSign, float *elementSign, float *offsetShare,
                     ShadingPoints &points) {
    constexpr int columns = offsetof(Appearance, Os) / sizeof(float) + colorSamples;
    float *planes[columns] = {};
    auto word = [&](std::size_t bytes) -> float *& { return planes[bytes / sizeof(float)]; };
    auto integers = [](std::int32_t *plane) { return reinterpret_cast<float *>(plane); };
    word(offsetof(Appearance, parameterOffset)) = integers(points.parameterOffset);
    word(offsetof(Appearance, lightSet)) = integers(points.lightSet);
    word(offsetof(Appearance, light)) = integers(points.light);
    word(offsetof(Appearance, id)) = integers(points.id);
    word(offsetof(Appearance, normalSign)) = normalSign;
    word(offsetof(Appearance, elementSign)) = elementSign;
    word(offsetof(Appearance, offset)) = points.offset;
    word(offsetof(Appearance, offsetShare)) = offsetShare;
    for (int c = 0; c < colorSamples; ++c) {
        if (code.wanted.Cs)
            (&word(offsetof(Appearance, Cs)))[c] = points.input(ShaderInput::Cs, c);
        if (code.wanted.Os)
            (&word(offsetof(Appearance, Os)))[c] = points.input(ShaderInput::Os, c);
    }
    lanes::gatherRows(points.count, reinterpret_cast<const float *>(tables.appearances.data()), row,
                      columns, planes);
}

/// Cs and Os of what changes them with time.
void takeColorsInTime(const PointTables &tables, const SurfaceCode &code, const int *row,
                      ShadingPoints &points) {
    const auto take = [&](const std::vector<Color> &steps, float share, ShaderInput input, int i) {
        const float place = share * float(steps.size() - 1);
        const std::size_t step = std::min(std::size_t(place), steps.size() - 2);
        const float to = place - float(step);
        for (int c = 0; c < colorSamples; ++c)
            points.input(input, c)[i] = steps[step].c[c] * (1 - to) + steps[step + 1].c[c] * to;
    };
    for (int i = 0; i < points.count; ++i) {
        const AppearanceDetail &detail = tables.details[std::size_t(row[i] / rowWords)];
        const float share = tables.shutter.share(points.input(ShaderInput::time, 0)[i]);
        if (code.wanted.Cs && !detail.colors.empty())
            take(detail.colors, share, ShaderInput::Cs, i);
        if (code.wanted.Os && !detail.opacities.empty())
            take(detail.opacities, share, ShaderInput::Os, i);
    }
}

/// Lanes on instances: their number, size and "object" space.
void takeInstances(const PointTables &tables, const SurfaceCode &code, ShadingPoints &points) {
    points.objectMatrices.clear();
    for (int i = 0; i < points.count; ++i) {
        const std::uint32_t number = points.instance[i];
        points.objectIndex[i] = std::int32_t(points.shape[i]);
        if (number == noHit)
            continue;
        points.id[i] += tables.instances[number].firstId;
        points.offset[i] *= tables.instances[number].stretch;
        points.objectIndex[i] = 0;
        if (!code.readsObjectSpace)
            continue;
        const Matrix4 currentFromShape =
            tables.currentFromShape(number, points.shape[i], points.input(ShaderInput::time, 0)[i]);
        const Matrix4 shapeFromCurrent = inverse(currentFromShape).value_or(Matrix4{});
        points.objectIndex[i] = -1 - std::int32_t(points.objectMatrices.size() / 32);
        for (const Matrix4 *matrix : {&currentFromShape, &shapeFromCurrent})
            points.objectMatrices.insert(points.objectMatrices.end(), matrix->m.begin(),
                                         matrix->m.end());
    }
    if (points.objectMatrices.empty())
        return;
    // One table for the batch: those of the world's shapes that occur join the instances'.
    for (int i = 0; i < points.count; ++i) {
        std::int32_t &index = points.objectIndex[i];
        if (index < 0) {
            index = -1 - index;
            continue;
        }
        const float *matrices = tables.shapeMatrices.data() + 32 * std::size_t(index);
        index = std::int32_t(points.objectMatrices.size() / 32);
        points.objectMatrices.insert(points.objectMatrices.end(), matrices, matrices + 32);
    }
}

/// The world's own shapes and their appearances have one order.
CANDELA_HOT void findRows(int count, const std::uint32_t *__restrict shape, int *__restrict row) {
    for (int i = 0; i < count; ++i)
        row[i] = rowWords * int(shape[i]);
}

/// What the points lie on, and how that looks.
void locate(const PointTables &tables, const SurfaceCode &code, float *normalSign,
            float *elementSign, float *offsetShare, ShadingPoints &points) {
    thread_local Scratch<int> own;
    int *row = own.get(paddedLanes(points.count));
    if (tables.instances.empty())
        findRows(points.count, points.shape, row);
    else
        for (int i = 0; i < points.count; ++i)
            row[i] = rowWords * tables.appearanceOf(points.instance[i], points.shape[i]);
    takeAppearances(tables, code, row, normalSign, elementSign, offsetShare, points);
    if (tables.colorsChange)
        takeColorsInTime(tables, code, row, points);
    if (tables.instances.empty())
        std::copy_n(reinterpret_cast<const std::int32_t *>(points.shape), points.count,
                    points.objectIndex);
    else
        takeInstances(tables, code, points);
}

/// On which side of dPdu x dPdv, taken in current space, the oriented natural normal lies.
void fillOrientation(const PointTables &tables, const float *normalSign, ShadingPoints &points) {
    float *orientation = points.input(ShaderInput::orientation, 0);
    for (int i = 0; i < points.count; ++i) {
        orientation[i] = normalSign[i] * tables.shapes[points.shape[i]].handedness;
        if (points.instance[i] != noHit)
            orientation[i] *= tables.instances[points.instance[i]].handedness;
    }
}

/// At outlines a ray may meet the front of an element whose named point has its true normal turned
/// away: what is seen from outside is to be shaded from outside. Such normals are mirrored at the
/// line of sight, which moves them by as little as they were off. Those of displaced surfaces may
/// be off by much: there the element's own is taken. A shader that moves the points itself finds
/// out their true normals itself: there it is the line of sight that is mirrored at those.
void keepSides(const PointTables &tables, const float *const *elementNg, ShadingPoints &points) {
    const Vec3Planes Ng = vec3(points, ShaderInput::Ng), N = vec3(points, ShaderInput::N);
    const Vec3Planes I = vec3(points, ShaderInput::I);
    for (int i = 0; i < points.count; ++i) {
        const Vec3 way = I.get(i), normal = Ng.get(i);
        const float met =
            elementNg[0][i] * way.x + elementNg[1][i] * way.y + elementNg[2][i] * way.z;
        const float seen = dot(normal, way);
        if (!(met * seen < 0))
            continue;
        if (!points.unmovedTable.empty()) {
            I.set(i, way - normal * (2 * seen));
            continue;
        }
        const Shape &shape = tables.shapes[points.shape[i]];
        const Vec3 turned = shape.curved && !shape.away
                                ? Vec3{elementNg[0][i], elementNg[1][i], elementNg[2][i]}
                                : normal - way * (2 * seen / dot(way, way));
        if (N.get(i) == normal)
            N.set(i, turned);
        Ng.set(i, turned);
    }
}

/// The same for the normals of points as they were before their shader moves them: it faces forward
/// by these, and would look for light within the body.
void keepUnmovedSides(ShadingPoints &points) {
    const Vec3Planes Ng = vec3(points, ShaderInput::Ng), I = vec3(points, ShaderInput::I);
    for (ShaderInput input : {ShaderInput::N, ShaderInput::Ng}) {
        float *const *planes = points.unmovedTable.data() + int(input);
        const Vec3Planes normals{planes[0], planes[1], planes[2]};
        for (int i = 0; i < points.count; ++i) {
            const Vec3 normal = normals.get(i), moved = Ng.get(i), way = I.get(i);
            const float seen = dot(normal, way);
            if (seen * dot(moved, way) < 0 && dot(normal, moved) > 0)
                normals.set(i, normal - way * (2 * seen / dot(way, way)));
        }
    }
}

/// Asks the surfaces, where elements don't tell all.
void askSurfaces(const PointTables &tables, const SurfaceCode &code, const float *normalSign,
                 ShadingPoints &points) {
    thread_local ScratchLevels<AlignedScratch> levels; // Displaced surfaces evaluate what is below.
    const ScratchLevels<AlignedScratch>::Level own(levels);
    const int stride = paddedLanes(points.count);
    float *elementNg[3];
    for (int c = 0; c < 3; ++c) {
        elementNg[c] = own->get(3 * std::size_t(stride)) + c * stride;
        std::copy_n(points.input(ShaderInput::Ng, c), points.count, elementNg[c]);
    }
    evaluateRuns(tables, code, normalSign, points);
    keepSides(tables, elementNg, points);
    if (!points.unmovedTable.empty())
        keepUnmovedSides(points);
}

/// Colours that are the attributes' do not change; those that do are told by their surfaces.
void clearColorDerivatives(const WantedInputs &wanted, ShadingPoints &points) {
    const auto clear = [&](ShaderInput first, ShaderInput last) {
        for (int plane = int(first); plane <= int(last); ++plane)
            std::fill_n(points.input(plane), points.count, 0.0f);
    };
    if (wanted.dCs)
        clear(ShaderInput::dCsdu, ShaderInput::dCsdvLast_);
    if (wanted.dOs)
        clear(ShaderInput::dOsdu, ShaderInput::dOsdvLast_);
}

} // namespace

void evaluatePoints(const PointTables &tables, const Camera &camera, const SurfaceCode &code,
                    const RayFootprints *rays, ShadingPoints &points) {
    if (points.count == 0)
        return;
    points.makeRoomForVariables(int(code.variableName.size()));
    points.useUnmoved(code.movesPoints);
    const int stride = paddedLanes(points.count);
    thread_local ScratchLevels<AlignedScratch> levels;
    const ScratchLevels<AlignedScratch>::Level own(levels);
    float *signs = own->get(3 * stride), *normalSign = signs, *elementSign = signs + stride;
    float *offsetShare = elementSign + stride;
    locate(tables, code, normalSign, elementSign, offsetShare, points);
    makeUnit(points.count, elementSign, vec3(points, ShaderInput::Ng));
    for (int c = 0; c < 3; ++c)
        std::copy_n(points.input(ShaderInput::Ng, c), points.count,
                    points.input(ShaderInput::N, c));
    if (code.wanted.orientation)
        fillOrientation(tables, normalSign, points);
    clearColorDerivatives(code.wanted, points);
    if (!code.fromElements)
        askSurfaces(tables, code, normalSign, points);
    limitOffsets(points.count, vec3(points, ShaderInput::P), offsetShare, points.offset);
    addRounding(points.count, vec3(points, ShaderInput::P), pointRounding, points.offset);
    if (code.wanted.footprint)
        fillFootprints(camera, rays, points);
    if (code.code)
        points.parameters.take(*code.code, tables.shutter, points.count, points.parameterOffset,
                               points.input(ShaderInput::time, 0));
}

void placeElementNormals(const PointTables &tables, int count, const std::uint32_t *instance,
                         const float *time, float *const *Ng) {
    for (int i = 0; i < count; ++i) {
        if (instance[i] == noHit)
            continue;
        const Vec3Planes normal{Ng[0] + i, Ng[1] + i, Ng[2] + i};
        if (tables.instances[instance[i]].steps == 0) {
            transformNormalsEach(1, tables.instanceMatrices.data(), instance + i, normal);
            continue;
        }
        float matrices[32];
        tables.placeAt(instance[i], time[i], matrices);
        const std::uint32_t row = 0;
        transformNormalsEach(1, matrices, &row, normal);
    }
}

void bindPoints(const PointTables &tables, int code, const ShadingPoints &points,
                ShaderArgs &args) {
    args.count = points.count;
    args.inputs =
        points.unmovedTable.empty() ? points.inputTable.data() : points.unmovedTable.data();
    args.parameterOffset = points.parameterOffset;
    args.objectIndex = points.objectIndex;
    args.objectMatrices =
        points.objectMatrices.empty() ? tables.shapeMatrices.data() : points.objectMatrices.data();
    args.variables = points.variableTable.data();
    tables.codes[code].code->bind(args);
    points.parameters.bind(args);
}

} // namespace candela
