// SPDX-License-Identifier: Apache-2.0
#include "world/points/point_runs.h"

#include "foundation/base/scratch.h"
#include "world/points/shape_run.h"
#include "world/points/surface_points.h"

#include <algorithm>

namespace candela {

namespace {

struct SortScratch {
    Scratch<std::int32_t> order, starts;
    Scratch<std::uint64_t> keys;
};

/// Counts and sums: linear where the shapes are few enough to be counted.
void sortByCounting(const ShadingPoints &points, std::size_t shapes, SortScratch &own,
                    std::int32_t *order) {
    std::int32_t *start = own.starts.get(shapes + 1);
    std::fill_n(start, shapes + 1, 0);
    for (int i = 0; i < points.count; ++i)
        ++start[points.shape[i] + 1];
    for (std::size_t k = 0; k < shapes; ++k)
        start[k + 1] += start[k];
    for (int i = 0; i < points.count; ++i)
        order[start[points.shape[i]]++] = i;
}

/// Order of the points by shape.
const std::int32_t *sortByShape(const ShadingPoints &points, std::size_t shapes, SortScratch &own) {
    std::int32_t *order = own.order.get(points.count);
    if (shapes <= 4 * std::size_t(points.count)) {
        sortByCounting(points, shapes, own, order);
        return order;
    }
    std::uint64_t *keys = own.keys.get(points.count);
    for (int i = 0; i < points.count; ++i)
        keys[i] = std::uint64_t(points.shape[i]) << 32 | std::uint32_t(i);
    std::sort(keys, keys + points.count);
    for (int i = 0; i < points.count; ++i)
        order[i] = std::int32_t(keys[i] & 0xffffffff);
    return order;
}

/// Values of a declared type, or their derivatives, from the surface's own space to current space.
void placeVariable(const ShapeRun &run, const Declaration &declaration, bool isDerivative,
                   float *const *value) {
    const bool isPoint = declaration.type == ValueType::Point;
    const bool isNormal = declaration.type == ValueType::Normal;
    if (!isPoint && !isNormal && declaration.type != ValueType::Vector)
        return;
    for (int at = 0; at < declaration.arraySize; ++at) {
        const Vec3Planes planes{value[3 * at], value[3 * at + 1], value[3 * at + 2]};
        if (isPoint && !isDerivative)
            placePoints(run, planes);
        else if (!isNormal)
            placeVectors(run, planes);
        else {
            placeNormals(run, planes);
            for (int k = 0; k < run.count; ++k)
                planes.set(k, planes.get(k) * run.sign[k]);
        }
    }
}

/// What a surface is asked about the points of a run.
class SurfaceQuestions {
public:
    SurfaceQuestions(const ShapeRun &run, const SurfaceCode &code, ShadingPoints &points,
                     RunScratch &own)
        : run_(run), surface_(*run.shape.surface), code_(code), points_(points), own_(own) {}

    void ask() {
        planes_ = own_.planes.get(planeCount * std::size_t(run_.stride));
        geometry(false);
        if (!points_.unmovedTable.empty())
            geometry(true);
        const Shape &shape = run_.shape;
        if (code_.wanted.st) {
            texture(shape.s, ShaderInput::s, ShaderInput::dsdu, ShaderInput::dsdv);
            texture(shape.t, ShaderInput::t, ShaderInput::dtdu, ShaderInput::dtdv);
        }
        if (code_.wanted.Cs && shape.Cs >= 0)
            color(shape.Cs, code_.wanted.dCs, ShaderInput::Cs, ShaderInput::dCsdu,
                  ShaderInput::dCsdv);
        if (code_.wanted.Os && shape.Os >= 0)
            color(shape.Os, code_.wanted.dOs, ShaderInput::Os, ShaderInput::dOsdu,
                  ShaderInput::dOsdv);
        if (!code_.variableNames.empty())
            variables();
    }

private:
    /// As many as geometry() or color() fills at once.
    static constexpr std::size_t planeCount = std::max(30, 3 * colorSamples);

    float *plane(int index) const { return planes_ + std::size_t(index) * run_.stride; }
    Vec3Planes vec3(int index) const { return {plane(index), plane(index + 1), plane(index + 2)}; }
    void tell(Vec3Planes from, ShaderInput to) const {
        tell(from.x, to, 0), tell(from.y, to, 1), tell(from.z, to, 2);
    }
    void tell(const float *from, ShaderInput to, int component = 0) const {
        const auto &table = unmoved_ ? points_.unmovedTable : points_.inputTable;
        deliver(run_, from, table[std::size_t(int(to) + component)]);
    }

    /// Positions, normals and derivatives; or what they were before the shader moves the points.
    void geometry(bool unmoved) {
        unmoved_ = unmoved;
        const WantedInputs &wanted = code_.wanted;
        const bool curved = run_.shape.curved;
        const bool ownNormals = surface_.hasOwnNormals();
        const Vec3Planes P = vec3(0), Ng = vec3(3), N = vec3(6), dPdu = vec3(9), dPdv = vec3(12);
        const Vec3Planes dNdu = vec3(15), dNdv = vec3(18), dNgdu = vec3(21), dNgdv = vec3(24);
        SurfaceAnswer answer;
        if (run_.shape.away || unmoved)
            answer.P = P;
        const bool mayDisagree = ownNormals && isTurned();
        if (curved || wanted.dNg || mayDisagree)
            answer.Ng = Ng;
        if (curved || ownNormals || wanted.dNd)
            answer.N = N;
        if (wanted.dPd)
            answer.dPdu = dPdu, answer.dPdv = dPdv;
        if (wanted.dNd)
            answer.dNdu = dNdu, answer.dNdv = dNdv;
        if (wanted.dNg)
            answer.dNgdu = dNgdu, answer.dNgdv = dNgdv;
        if (wanted.uv)
            answer.u = plane(27), answer.v = plane(28);
        if (!unmoved || !surface_.evaluateUnmoved(run_.query(), answer))
            surface_.evaluate(run_.query(), answer);
        if (answer.P.x)
            placePoints(run_, P), tell(P, ShaderInput::P);
        if (wanted.dNg)
            normalDerivatives(Ng, dNgdu, dNgdv);
        else if (answer.Ng.x)
            placeNormals(run_, Ng);
        if (wanted.dNd)
            normalDerivatives(N, dNdu, dNdv);
        else if (curved || ownNormals)
            placeNormals(run_, N);
        const float *signOfN = mayDisagree ? agreeing(N, Ng, plane(29)) : run_.sign;
        if (wanted.dNg)
            turn(dNgdu, run_.sign, ShaderInput::dNgdu), turn(dNgdv, run_.sign, ShaderInput::dNgdv);
        if (curved)
            makeUnit(run_.count, run_.sign, Ng), tell(Ng, ShaderInput::Ng);
        if (wanted.dNd)
            turn(dNdu, signOfN, ShaderInput::dNdu), turn(dNdv, signOfN, ShaderInput::dNdv);
        if (curved || ownNormals)
            makeUnit(run_.count, signOfN, N), tell(N, ShaderInput::N);
        if (wanted.dPd) {
            placeVectors(run_, dPdu), placeVectors(run_, dPdv);
            tell(dPdu, ShaderInput::dPdu), tell(dPdv, ShaderInput::dPdv);
        }
        if (wanted.uv)
            tell(answer.u, ShaderInput::u), tell(answer.v, ShaderInput::v);
        unmoved_ = false;
    }

    /// The unit normal in current space is that of the transformed one, and so are its changes. The
    /// normals themselves are transformed too.
    void normalDerivatives(Vec3Planes N, Vec3Planes dNdu, Vec3Planes dNdv) {
        for (int k = 0; k < run_.count; ++k) { // Of any length now, changes with it.
            const float size = length(N.get(k)), scale = size > 0 ? 1 / size : 1;
            N.set(k, N.get(k) * scale);
        }
        placeNormals(run_, N), placeNormals(run_, dNdu), placeNormals(run_, dNdv);
        for (int k = 0; k < run_.count; ++k)
            for (Vec3Planes change : {dNdu, dNdv})
                change.set(k, unitDerivative(N.get(k), change.get(k)));
    }
    void turn(Vec3Planes change, const float *sign, ShaderInput to) {
        for (int k = 0; k < run_.count; ++k)
            change.set(k, change.get(k) * sign[k]);
        tell(change, to);
    }

    bool isTurned() const {
        return std::any_of(run_.sign, run_.sign + run_.count, [](float sign) { return sign < 0; });
    }
    /// The signs of normals that the user gave. Where the surface is turned round, exporters give
    /// either what was outside before or what is so now: both mean the side that Ng has now.
    const float *agreeing(Vec3Planes N, Vec3Planes Ng, float *signs) const {
        for (int k = 0; k < run_.count; ++k)
            signs[k] = run_.sign[k] < 0 && dot(N.get(k), Ng.get(k)) > 0 ? -1.0f : 1.0f;
        return signs;
    }

    /// s or t, and if wanted how it changes with u and v.
    void texture(int variable, ShaderInput to, ShaderInput byU, ShaderInput byV) {
        float *value = plane(0), *du = plane(1), *dv = plane(2);
        const bool derivatives = code_.wanted.stDerivatives;
        if (variable >= 0)
            surface_.evaluateVariable(variable, run_.query(), &value, derivatives ? &du : nullptr,
                                      derivatives ? &dv : nullptr);
        else
            std::fill_n(planes_, 3 * std::size_t(run_.stride), 0.0f);
        tell(value, to);
        if (derivatives)
            tell(du, byU), tell(dv, byV);
    }

    /// Cs or Os, and if wanted how it changes with u and v.
    void color(int variable, bool derivatives, ShaderInput to, ShaderInput byU, ShaderInput byV) {
        float *value[colorSamples], *du[colorSamples], *dv[colorSamples];
        for (int c = 0; c < colorSamples; ++c)
            value[c] = plane(c);
        for (int c = 0; c < colorSamples; ++c)
            du[c] = plane(colorSamples + c), dv[c] = plane(2 * colorSamples + c);
        surface_.evaluateVariable(variable, run_.query(), value, derivatives ? du : nullptr,
                                  derivatives ? dv : nullptr);
        for (int c = 0; c < colorSamples; ++c) {
            tell(value[c], to, c);
            if (derivatives)
                tell(du[c], byU, c), tell(dv[c], byV, c);
        }
    }

    /// Primitive variables that override parameters.
    void variables() {
        const std::int32_t appearance =
            run_.tables.appearanceOf(points_.instance[run_.order[0]], points_.shape[run_.order[0]]);
        const std::vector<int> &overriding = run_.tables.details[appearance].overriding;
        for (std::size_t name = 0; name < code_.variableNames.size(); ++name) {
            const int variable = overriding[name];
            if (variable < 0)
                continue;
            for (int slope : {0, 1, 2})
                if (readsVariable(int(name), slope))
                    tellVariable(variable, int(name), slope);
        }
    }
    bool readsVariable(int name, int slope) const {
        for (std::size_t slot = 0; slot < code_.variableName.size(); ++slot)
            if (code_.variableName[slot] == name && code_.variableSlope[slot] == slope)
                return true;
        return false;
    }
    /// `slope` as SurfaceCode::variableSlope.
    void tellVariable(int variable, int name, int slope) {
        const Declaration &declaration = surface_.variables()[variable].declaration;
        const int components = declaration.components();
        planes_ = own_.planes.get(std::size_t(components) * run_.stride);
        float **values = own_.variablePlanes.get(components);
        for (int c = 0; c < components; ++c)
            values[c] = plane(c);
        surface_.evaluateVariable(variable, run_.query(), slope == 0 ? values : nullptr,
                                  slope == 1 ? values : nullptr, slope == 2 ? values : nullptr);
        placeVariable(run_, declaration, slope != 0, values);
        for (std::size_t slot = 0; slot < code_.variableName.size(); ++slot)
            if (code_.variableName[slot] == name && code_.variableSlope[slot] == slope)
                deliver(run_, values[std::min(code_.variableComponent[slot], components - 1)],
                        points_.variableTable[slot]);
    }

    const ShapeRun &run_;
    const Surface &surface_;
    const SurfaceCode &code_;
    ShadingPoints &points_;
    RunScratch &own_;
    float *planes_ = nullptr;
    bool unmoved_ = false; ///< Which of the tables is told.
};

} // namespace

namespace {

struct RunsScratch {
    SortScratch sorting;
    RunScratch runs;
};

/// Calls `serve` with the runs of the points that lie on one shape.
template <class Serve>
void forEachRun(const PointTables &tables, const float *normalSign, ShadingPoints &points,
                const Serve &serve) {
    thread_local ScratchLevels<RunsScratch> levels; // Displaced surfaces evaluate what is below.
    const ScratchLevels<RunsScratch>::Level own(levels);
    const std::int32_t *order = sortByShape(points, tables.shapes.size(), own->sorting);
    for (int first = 0, last; first < points.count; first = last) {
        const std::uint32_t shape = points.shape[order[first]];
        for (last = first + 1; last < points.count && points.shape[order[last]] == shape;)
            ++last;
        serve(makeRun(tables, points, order + first, last - first, normalSign, own->runs),
              own->runs);
    }
}

} // namespace

void evaluateRuns(const PointTables &tables, const SurfaceCode &code, const float *normalSign,
                  ShadingPoints &points) {
    forEachRun(tables, normalSign, points, [&](const ShapeRun &run, RunScratch &own) {
        SurfaceQuestions(run, code, points, own).ask();
    });
}

void nameRuns(const PointTables &tables, ShadingPoints &points, std::uint32_t *piece, float *u,
              float *v) {
    forEachRun(tables, nullptr, points, [&](const ShapeRun &run, RunScratch &) {
        for (int k = 0; k < run.count; ++k)
            piece[run.order[k]] = run.piece[k];
        deliver(run, run.u, u), deliver(run, run.v, v);
    });
}

} // namespace candela
