// SPDX-License-Identifier: Apache-2.0
// Points on the dicing become points on the true surface, in current space. The points are sorted
// by primitive, so that a surface is asked once for all of its points; answers are put back into
// the caller's order.
#include "world/scene/scene_state.h"
#include "world/scene/surface_points.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

struct EvaluationScratch {
    Scratch<std::int32_t> order, starts;
    Scratch<std::uint64_t> keys;
    Scratch<std::uint32_t> pieces, triangles;
    Scratch<float> u, v, baryU, baryV, planes, extra;
    Scratch<float *> extraPlanes;
};

EvaluationScratch &scratch() {
    thread_local EvaluationScratch own;
    return own;
}

/// Counts and sums: linear where the primitives are few enough to be counted.
void sortByCounting(const TrianglePoints &points, std::size_t primitives, EvaluationScratch &own,
                    std::int32_t *order) {
    std::int32_t *start = own.starts.get(primitives + 1);
    std::fill_n(start, primitives + 1, 0);
    for (int i = 0; i < points.count; ++i)
        ++start[points.primitive[i] + 1];
    for (std::size_t k = 0; k < primitives; ++k)
        start[k + 1] += start[k];
    for (int i = 0; i < points.count; ++i)
        order[start[points.primitive[i]]++] = i;
}

/// Order of the points by primitive; false (and no order) if they are sorted as they stand.
bool sortByPrimitive(const TrianglePoints &points, std::size_t primitives, EvaluationScratch &own,
                     std::int32_t *&order) {
    const std::uint32_t *primitive = points.primitive;
    if (std::is_sorted(primitive, primitive + points.count))
        return false;
    order = own.order.get(points.count);
    if (primitives <= 4 * std::size_t(points.count)) {
        sortByCounting(points, primitives, own, order);
        return true;
    }
    std::uint64_t *keys = own.keys.get(points.count);
    for (int i = 0; i < points.count; ++i)
        keys[i] = std::uint64_t(primitive[i]) << 32 | std::uint32_t(i);
    std::sort(keys, keys + points.count);
    for (int i = 0; i < points.count; ++i)
        order[i] = std::int32_t(keys[i] & 0xffffffff);
    return true;
}

/// Where evaluation writes while the points are sorted: scratch planes, or the final ones.
class PlaneSet {
public:
    PlaneSet(ShadingPoints &points, bool direct, int count, EvaluationScratch &own)
        : points_(points), stride_(direct ? 0 : paddedLanes(count)) {
        if (!direct)
            planes_ = own.planes.get(std::size_t(ShaderInput::Count) * stride_);
    }
    float *plane(ShaderInput input, int component = 0) const {
        int index = int(input) + component;
        return stride_ ? planes_ + std::size_t(index) * stride_ : points_.inputTable[index];
    }
    Vec3Planes vec3(ShaderInput input, int first = 0) const {
        return {plane(input, 0) + first, plane(input, 1) + first, plane(input, 2) + first};
    }

private:
    ShadingPoints &points_;
    int stride_;
    float *planes_ = nullptr;
};

struct Run {
    const ScenePrimitive &primitive;
    SurfaceQuery query;
    const std::uint32_t *triangle;
    int first;
};

/// Positions, normals and derivatives of one primitive's points.
void evaluateGeometry(const Run &run, const WantedInputs &wanted, const PlaneSet &planes) {
    int n = run.query.count;
    SurfaceAnswer answer;
    answer.P = planes.vec3(ShaderInput::P, run.first);
    answer.Ng = planes.vec3(ShaderInput::Ng, run.first);
    answer.N = planes.vec3(ShaderInput::N, run.first);
    if (wanted.dPd) {
        answer.dPdu = planes.vec3(ShaderInput::dPdu, run.first);
        answer.dPdv = planes.vec3(ShaderInput::dPdv, run.first);
    }
    if (wanted.uv) {
        answer.u = planes.plane(ShaderInput::u) + run.first;
        answer.v = planes.plane(ShaderInput::v) + run.first;
    }
    const ScenePrimitive &primitive = run.primitive;
    primitive.surface->evaluate(run.query, answer);
    transformPoints(n, primitive.currentFromObject, answer.P);
    transformNormals(n, primitive.objectFromCurrent, primitive.normalSign, answer.Ng);
    transformNormals(n, primitive.objectFromCurrent, primitive.normalSign, answer.N);
    if (wanted.dPd) {
        transformVectors(n, primitive.currentFromObject, answer.dPdu);
        transformVectors(n, primitive.currentFromObject, answer.dPdv);
    }
}

/// Which way dPdu ^ dPdv stands to the normals, which don't turn with mirrored spaces.
void fillOrientation(const Run &run, const PlaneSet &planes) {
    const float turn = flipsHandedness(run.primitive.currentFromObject) ? -1.0f : 1.0f;
    std::fill_n(planes.plane(ShaderInput::orientation) + run.first, run.query.count,
                turn * run.primitive.normalSign);
}

void evaluateNamed(const Run &run, int variable, int components, ShaderInput input,
                   const PlaneSet &planes) {
    float *to[3];
    for (int c = 0; c < components; ++c)
        to[c] = planes.plane(input, c) + run.first;
    run.primitive.surface->evaluateVariable(variable, run.query, to, nullptr, nullptr);
}

/// s or t, and if wanted how it changes with u and v.
void evaluateTexture(const Run &run, int variable, ShaderInput input, bool derivatives,
                     ShaderInput byU, ShaderInput byV, const PlaneSet &planes) {
    float *value = planes.plane(input) + run.first;
    float *du = derivatives ? planes.plane(byU) + run.first : nullptr;
    float *dv = derivatives ? planes.plane(byV) + run.first : nullptr;
    if (variable >= 0) {
        run.primitive.surface->evaluateVariable(variable, run.query, &value, du ? &du : nullptr,
                                                dv ? &dv : nullptr);
        return;
    }
    for (float *plane : {value, du, dv})
        if (plane)
            std::fill_n(plane, run.query.count, 0.0f);
}

void evaluateColors(const Run &run, const WantedInputs &wanted, const PrimitiveSummary &summary,
                    const PlaneSet &planes) {
    auto fill = [&](int variable, ShaderInput input, const std::array<float, colorSamples> &value) {
        if (variable >= 0)
            return evaluateNamed(run, variable, colorSamples, input, planes);
        for (int c = 0; c < colorSamples; ++c)
            std::fill_n(planes.plane(input, c) + run.first, run.query.count, value[c]);
    };
    if (wanted.Cs)
        fill(run.primitive.Cs, ShaderInput::Cs, summary.Cs);
    if (wanted.Os)
        fill(run.primitive.Os, ShaderInput::Os, summary.Os);
}

/// pdf of light sampling at the points of an emitting primitive, per unit area.
void evaluateDensity(const Run &run, const PlaneSet &planes, float *scratchLengths, float *pdf) {
    const ScenePrimitive &primitive = run.primitive;
    int n = run.query.count;
    if (!primitive.uvDensity) {
        for (int i = 0; i < n; ++i)
            pdf[i] = primitive.density[run.triangle[i]];
        return;
    }
    crossLengths(n, planes.vec3(ShaderInput::dPdu, run.first),
                 planes.vec3(ShaderInput::dPdv, run.first), scratchLengths);
    for (int i = 0; i < n; ++i) {
        float density = primitive.uvDensity->at(run.query.u[i], run.query.v[i]);
        pdf[i] = scratchLengths[i] > 0 ? density / scratchLengths[i] : 0;
    }
}

void transformVariable(const Declaration &declaration, const ScenePrimitive &primitive, int count,
                       float *const *value) {
    for (int element = 0; element < declaration.arraySize; ++element) {
        Vec3Planes planes{value[3 * element], value[3 * element + 1], value[3 * element + 2]};
        if (declaration.type == ValueType::Point)
            transformPoints(count, primitive.currentFromObject, planes);
        else if (declaration.type == ValueType::Vector)
            transformVectors(count, primitive.currentFromObject, planes);
        else
            transformNormals(count, primitive.objectFromCurrent, primitive.normalSign, planes);
    }
}

bool isGeometric(const Declaration &declaration) {
    return declaration.type == ValueType::Point || declaration.type == ValueType::Vector ||
           declaration.type == ValueType::Normal;
}

/// Primitive variables that override parameters, put straight into the caller's order.
void evaluateVariables(const Run &run, const SceneCode &code, const std::int32_t *order,
                       EvaluationScratch &own, ShadingPoints &out) {
    int n = run.query.count, stride = paddedLanes(n);
    for (std::size_t name = 0; name < code.variableNames.size(); ++name) {
        int variable = run.primitive.overriding[name];
        if (variable < 0)
            continue;
        const Declaration &declaration = run.primitive.surface->variables()[variable].declaration;
        int components = declaration.components();
        float *values = own.extra.get(std::size_t(components) * stride);
        float **planes = own.extraPlanes.get(components);
        for (int c = 0; c < components; ++c)
            planes[c] = values + std::size_t(c) * stride;
        run.primitive.surface->evaluateVariable(variable, run.query, planes, nullptr, nullptr);
        if (isGeometric(declaration))
            transformVariable(declaration, run.primitive, n, planes);
        for (std::size_t slot = 0; slot < code.variableName.size(); ++slot) {
            if (code.variableName[slot] != int(name))
                continue;
            int component = std::min(code.variableComponent[slot], components - 1);
            for (int i = 0; i < n; ++i)
                out.variableTable[slot][order ? order[run.first + i] : run.first + i] =
                    planes[component][i];
        }
    }
}

/// du and dv: how far u and v run over a pixel's width at the distance of the primary ray.
void fillFootprint(const Camera &camera, int count, ShadingPoints &points) {
    for (int i = 0; i < count; ++i) {
        auto lengthOf = [&](ShaderInput input) {
            float x = points.inputTable[int(input)][i], y = points.inputTable[int(input) + 1][i];
            float z = points.inputTable[int(input) + 2][i];
            return std::sqrt(x * x + y * y + z * z);
        };
        float width = camera.pixelSize(lengthOf(ShaderInput::P));
        float alongU = lengthOf(ShaderInput::dPdu), alongV = lengthOf(ShaderInput::dPdv);
        points.input(int(ShaderInput::du))[i] = alongU > 0 ? std::min(width / alongU, 1.0f) : 1;
        points.input(int(ShaderInput::dv))[i] = alongV > 0 ? std::min(width / alongV, 1.0f) : 1;
    }
}

void scatterInputs(int count, const std::int32_t *order, const WantedInputs &wanted,
                   const PlaneSet &planes, ShadingPoints &out) {
    auto move = [&](ShaderInput input, int components) {
        for (int c = 0; c < components; ++c)
            scatter(count, order, planes.plane(input, c), out.inputTable[int(input) + c]);
    };
    move(ShaderInput::P, 3), move(ShaderInput::N, 3), move(ShaderInput::Ng, 3);
    if (wanted.dPd)
        move(ShaderInput::dPdu, 3), move(ShaderInput::dPdv, 3);
    if (wanted.orientation)
        move(ShaderInput::orientation, 1);
    if (wanted.uv)
        move(ShaderInput::u, 1), move(ShaderInput::v, 1);
    if (wanted.st)
        move(ShaderInput::s, 1), move(ShaderInput::t, 1);
    if (wanted.stDerivatives)
        for (ShaderInput input :
             {ShaderInput::dsdu, ShaderInput::dsdv, ShaderInput::dtdu, ShaderInput::dtdv})
            move(input, 1);
    if (wanted.Cs)
        move(ShaderInput::Cs, colorSamples);
    if (wanted.Os)
        move(ShaderInput::Os, colorSamples);
}

void fillSummaries(const std::vector<PrimitiveSummary> &summaries, const TrianglePoints &points,
                   ShadingPoints &out) {
    for (int i = 0; i < points.count; ++i) {
        const PrimitiveSummary &summary = summaries[points.primitive[i]];
        out.parameterOffset[i] = summary.parameterOffset;
        out.objectIndex[i] = std::int32_t(points.primitive[i]);
        out.primitive[i] = std::int32_t(points.primitive[i]);
        out.lightSet[i] = summary.lightSet;
        out.light[i] = summary.light;
        out.offset[i] = summary.offset;
        out.lightPdfArea[i] = 0;
    }
}

} // namespace

void SceneState::evaluate(const TrianglePoints &points, const SceneCode &code,
                          ShadingPoints &out) const {
    if (code.flat)
        return flatTable.evaluate(*this, points, code, out);
    EvaluationScratch &own = scratch();
    int count = points.count;
    out.count = count;
    out.makeRoomForVariables(int(code.variableName.size()));
    fillSummaries(summaries, points, out);

    std::int32_t *order = nullptr;
    bool direct = !sortByPrimitive(points, primitives.size(), own, order);
    auto at = [&](int i) { return direct ? i : order[i]; };
    std::uint32_t *pieces = own.pieces.get(count), *triangles = own.triangles.get(count);
    float *u = own.u.get(count), *v = own.v.get(count);
    float *baryU = own.baryU.get(count), *baryV = own.baryV.get(count);
    for (int i = 0; i < count; ++i) {
        triangles[i] = pieces[i] = points.triangle[at(i)];
        baryU[i] = u[i] = points.u[at(i)], baryV[i] = v[i] = points.v[at(i)];
    }

    WantedInputs wanted = code.wanted;
    wanted.dPd |= wanted.footprint;
    PlaneSet planes(out, direct, count, own);
    for (int first = 0, last; first < count; first = last) {
        std::uint32_t index = points.primitive[at(first)];
        for (last = first + 1; last < count && points.primitive[at(last)] == index;)
            ++last;
        const ScenePrimitive &primitive = primitives[index];
        int n = last - first;
        if (!primitive.vertexUv.empty()) {
            interpolateUv(n, triangles + first, baryU + first, baryV + first,
                          primitive.triangles.data(), primitive.vertexUv.data(), u + first,
                          v + first);
            std::fill_n(pieces + first, n, 0u);
        }
        Run run{primitive, {n, pieces + first, u + first, v + first}, triangles + first, first};
        WantedInputs wantedHere = wanted;
        // Emitters with (u,v) need the Jacobian, whoever shades them.
        wantedHere.dPd |= summaries[index].light != 0 && primitive.uvDensity;
        evaluateGeometry(run, wantedHere, planes);
        if (wanted.orientation)
            fillOrientation(run, planes);
        evaluateColors(run, wanted, summaries[index], planes);
        if (wanted.st) {
            evaluateTexture(run, primitive.s, ShaderInput::s, wanted.stDerivatives,
                            ShaderInput::dsdu, ShaderInput::dsdv, planes);
            evaluateTexture(run, primitive.t, ShaderInput::t, wanted.stDerivatives,
                            ShaderInput::dtdu, ShaderInput::dtdv, planes);
        }
        if (summaries[index].light != 0) {
            float *pdf = baryU + first; // The triangle's own coordinates have had their use.
            evaluateDensity(run, planes, baryV + first, pdf);
            for (int i = 0; i < n; ++i)
                out.lightPdfArea[at(first + i)] = pdf[i];
        }
        if (!code.variableNames.empty())
            evaluateVariables(run, code, direct ? nullptr : order, own, out);
    }
    if (!direct)
        scatterInputs(count, order, wanted, planes, out);
    Vec3Planes P{out.inputTable[0], out.inputTable[1], out.inputTable[2]};
    static_assert(int(ShaderInput::P) == 0);
    addRounding(count, P, roundingShare, out.offset);
    if (wanted.footprint)
        fillFootprint(camera, count, out);
}

void WantedInputs::add(const ShaderCode &code) {
    dPd |= code.reads(ShaderInput::dPdu) || code.reads(ShaderInput::dPdv);
    orientation |= code.reads(ShaderInput::orientation);
    uv |= code.reads(ShaderInput::u) || code.reads(ShaderInput::v);
    footprint |= code.reads(ShaderInput::du) || code.reads(ShaderInput::dv);
    stDerivatives |= code.reads(ShaderInput::dsdu) || code.reads(ShaderInput::dsdv) ||
                     code.reads(ShaderInput::dtdu) || code.reads(ShaderInput::dtdv);
    st |= stDerivatives || code.reads(ShaderInput::s) || code.reads(ShaderInput::t);
    Cs |= code.reads(ShaderInput::Cs), Os |= code.reads(ShaderInput::Os);
    time |= code.reads(ShaderInput::time), E |= code.reads(ShaderInput::E);
}

} // namespace candela
