// SPDX-License-Identifier: Apache-2.0
#include "world/points/point_runs.h"

#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/points/surface_points.h"

#include <algorithm>

namespace candela {

namespace {

struct RunScratch {
    Scratch<std::int32_t> order, starts;
    Scratch<std::uint64_t> keys;
    Scratch<std::uint32_t> integers;
    Scratch<float> names, planes;
    Scratch<float *> variablePlanes;
};

RunScratch &scratch() {
    thread_local RunScratch own;
    return own;
}

/// Counts and sums: linear where the shapes are few enough to be counted.
void sortByCounting(const ShadingPoints &points, std::size_t shapes, RunScratch &own,
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
const std::int32_t *sortByShape(const ShadingPoints &points, std::size_t shapes, RunScratch &own) {
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

/// The points of one shape: where they stand in the batch, and planes of their own to work on.
class Run {
public:
    Run(const PointTables &tables, const SurfaceCode &code, const std::int32_t *order, int count,
        const float *normalSign, ShadingPoints &points, RunScratch &own)
        : tables_(tables), code_(code), shape_(tables.shapes[points.shape[order[0]]]),
          order_(order), count_(count), stride_(paddedLanes(count)), points_(points), own_(own) {
        names_ = own.names.get(3 * std::size_t(stride_));
        integers_ = own.integers.get(3 * std::size_t(stride_));
        for (int k = 0; k < count; ++k) {
            const int i = order[k];
            sign()[k] = normalSign[i];
            instance()[k] = points.instance[i], element()[k] = points.element[i];
            u()[k] = points.u[i], v()[k] = points.v[i];
        }
        placed_ = instance()[0] != noHit;
        name();
    }

    void evaluate() {
        planes_ = own_.planes.get((22 + 3 * std::size_t(colorSamples)) * stride_);
        geometry();
        if (code_.wanted.st) {
            texture(shape_.s, ShaderInput::s, ShaderInput::dsdu, ShaderInput::dsdv);
            texture(shape_.t, ShaderInput::t, ShaderInput::dtdu, ShaderInput::dtdv);
        }
        if (code_.wanted.Cs && shape_.Cs >= 0)
            color(shape_.Cs, ShaderInput::Cs);
        if (code_.wanted.Os && shape_.Os >= 0)
            color(shape_.Os, ShaderInput::Os);
        if (!code_.variableNames.empty())
            variables();
    }

private:
    float *u() const { return names_; }
    float *v() const { return names_ + stride_; }
    float *sign() const { return names_ + 2 * stride_; }
    std::uint32_t *instance() const { return integers_; }
    std::uint32_t *element() const { return integers_ + stride_; }
    std::uint32_t *piece() const { return integers_ + 2 * stride_; }
    SurfaceQuery query() const { return {count_, piece(), u(), v()}; }
    float *plane(int index) const { return planes_ + std::size_t(index) * stride_; }
    Vec3Planes vec3(int index) const { return {plane(index), plane(index + 1), plane(index + 2)}; }
    float *input(ShaderInput input, int component = 0) const {
        return points_.input(input, component);
    }

    /// (piece, u, v) of the surface from what the rays have met.
    void name() {
        switch (shape_.naming) {
        case Naming::Direct: std::copy_n(element(), count_, piece()); break;
        case Naming::Corners:
            for (int k = 0; k < count_; ++k)
                piece()[k] = shape_.pieces.empty() ? 0 : shape_.pieces[element()[k]];
            interpolateUv(count_, element(), u(), v(), shape_.triangles.data(),
                          shape_.vertexUv.data(), u(), v());
            break;
        case Naming::Sphere: nameOnSphere();
        }
    }

    void nameOnSphere() {
        std::fill_n(piece(), count_, 0u);
        planes_ = own_.planes.get(3 * std::size_t(stride_));
        for (int c = 0; c < 3; ++c)
            lanes::gather(count_, order_, input(ShaderInput::P, c), plane(c));
        if (placed_)
            for (int k = 0; k < count_; ++k) {
                Matrix4 objectFromCurrent;
                std::copy_n(tables_.matricesOf(instance()[k]) + 16, 16,
                            objectFromCurrent.m.begin());
                vec3(0).set(k, transformPoint(objectFromCurrent, vec3(0).get(k)));
            }
        transformPoints(count_, shape_.shapeFromOuter, vec3(0));
        shape_.surface->sphereCoordinates(count_, vec3(0), u(), v());
    }

    void deliver(const float *from, float *to) const { scatter(count_, order_, from, to); }
    void deliver(Vec3Planes from, ShaderInput to) const {
        deliver(from.x, input(to, 0)), deliver(from.y, input(to, 1)), deliver(from.z, input(to, 2));
    }

    void placeVectors(Vec3Planes planes) const {
        transformVectors(count_, shape_.outerFromShape, planes);
        if (placed_)
            transformVectorsEach(count_, tables_.instanceMatrices.data(), instance(), planes);
    }
    void placePoints(Vec3Planes planes) const {
        transformPoints(count_, shape_.outerFromShape, planes);
        if (placed_)
            transformPointsEach(count_, tables_.instanceMatrices.data(), instance(), planes);
    }
    void placeNormals(Vec3Planes planes) const {
        transformNormals(count_, shape_.shapeFromOuter, planes);
        if (placed_)
            transformNormalsEach(count_, tables_.instanceMatrices.data(), instance(), planes);
    }

    /// Positions, normals and derivatives.
    void geometry() {
        const WantedInputs &wanted = code_.wanted;
        const bool curved = shape_.naming == Naming::Corners && shape_.pieces.empty();
        const bool ownNormals = shape_.surface->hasOwnNormals();
        const Vec3Planes P = vec3(0), Ng = vec3(3), N = vec3(6), dPdu = vec3(9), dPdv = vec3(12);
        const Vec3Planes dNdu = vec3(15), dNdv = vec3(18);
        SurfaceAnswer answer;
        if (curved)
            answer.P = P, answer.Ng = Ng;
        if (curved || ownNormals || wanted.dNd)
            answer.N = N;
        if (wanted.dPd)
            answer.dPdu = dPdu, answer.dPdv = dPdv;
        if (wanted.dNd)
            answer.dNdu = dNdu, answer.dNdv = dNdv;
        if (wanted.uv)
            answer.u = plane(21), answer.v = plane(22);
        shape_.surface->evaluate(query(), answer);
        if (answer.P.x)
            placePoints(P), deliver(P, ShaderInput::P);
        if (answer.Ng.x)
            placeNormals(Ng), makeUnit(count_, sign(), Ng), deliver(Ng, ShaderInput::Ng);
        if (wanted.dNd)
            normalDerivatives(N, dNdu, dNdv);
        if (curved || ownNormals) {
            placeNormals(N), makeUnit(count_, sign(), N), deliver(N, ShaderInput::N);
        }
        if (wanted.dPd) {
            placeVectors(dPdu), placeVectors(dPdv);
            deliver(dPdu, ShaderInput::dPdu), deliver(dPdv, ShaderInput::dPdv);
        }
        if (wanted.uv)
            deliver(answer.u, input(ShaderInput::u)), deliver(answer.v, input(ShaderInput::v));
    }

    /// The unit normal in current space is that of the transformed one, and so are its changes.
    void normalDerivatives(Vec3Planes N, Vec3Planes dNdu, Vec3Planes dNdv) {
        for (int k = 0; k < count_; ++k) { // Of any length now, changes with it.
            const float size = length(N.get(k)), scale = size > 0 ? 1 / size : 1;
            N.set(k, N.get(k) * scale);
        }
        placeNormals(N), placeNormals(dNdu), placeNormals(dNdv);
        for (int k = 0; k < count_; ++k)
            for (Vec3Planes change : {dNdu, dNdv})
                change.set(k, unitDerivative(N.get(k), change.get(k)) * sign()[k]);
        deliver(dNdu, ShaderInput::dNdu), deliver(dNdv, ShaderInput::dNdv);
    }

    /// s or t, and if wanted how it changes with u and v.
    void texture(int variable, ShaderInput to, ShaderInput byU, ShaderInput byV) {
        float *value = plane(0), *du = plane(1), *dv = plane(2);
        const bool derivatives = code_.wanted.stDerivatives;
        if (variable >= 0)
            shape_.surface->evaluateVariable(variable, query(), &value, derivatives ? &du : nullptr,
                                             derivatives ? &dv : nullptr);
        else
            std::fill_n(planes_, 3 * std::size_t(stride_), 0.0f);
        deliver(value, input(to));
        if (derivatives)
            deliver(du, input(byU)), deliver(dv, input(byV));
    }

    void color(int variable, ShaderInput to) {
        float *value[colorSamples];
        for (int c = 0; c < colorSamples; ++c)
            value[c] = plane(c);
        shape_.surface->evaluateVariable(variable, query(), value, nullptr, nullptr);
        for (int c = 0; c < colorSamples; ++c)
            deliver(value[c], input(to, c));
    }

    void placeVariable(const Declaration &declaration, float *const *value) {
        for (int at = 0; at < declaration.arraySize; ++at) {
            Vec3Planes planes{value[3 * at], value[3 * at + 1], value[3 * at + 2]};
            if (declaration.type == ValueType::Point)
                placePoints(planes);
            else if (declaration.type == ValueType::Vector)
                placeVectors(planes);
            else if (declaration.type == ValueType::Normal)
                placeNormals(planes), turn(planes);
        }
    }
    void turn(Vec3Planes n) const {
        for (int k = 0; k < count_; ++k)
            n.set(k, n.get(k) * sign()[k]);
    }

    /// Primitive variables that override parameters.
    void variables() {
        const std::int32_t appearance =
            tables_.appearanceOf(instance()[0], points_.shape[order_[0]]);
        const std::vector<int> &overriding = tables_.details[appearance].overriding;
        for (std::size_t name = 0; name < code_.variableNames.size(); ++name) {
            const int variable = overriding[name];
            if (variable < 0)
                continue;
            const Declaration &declaration = shape_.surface->variables()[variable].declaration;
            const int components = declaration.components();
            planes_ = own_.planes.get(std::size_t(components) * stride_);
            float **values = own_.variablePlanes.get(components);
            for (int c = 0; c < components; ++c)
                values[c] = plane(c);
            shape_.surface->evaluateVariable(variable, query(), values, nullptr, nullptr);
            placeVariable(declaration, values);
            for (std::size_t slot = 0; slot < code_.variableName.size(); ++slot)
                if (code_.variableName[slot] == int(name))
                    deliver(values[std::min(code_.variableComponent[slot], components - 1)],
                            points_.variableTable[slot]);
        }
    }

    const PointTables &tables_;
    const SurfaceCode &code_;
    const Shape &shape_;
    const std::int32_t *order_;
    int count_, stride_;
    ShadingPoints &points_;
    RunScratch &own_;
    float *names_ = nullptr, *planes_ = nullptr;
    std::uint32_t *integers_ = nullptr;
    bool placed_ = false;
};

} // namespace

void evaluateRuns(const PointTables &tables, const SurfaceCode &code, const float *normalSign,
                  ShadingPoints &points) {
    RunScratch &own = scratch();
    const std::int32_t *order = sortByShape(points, tables.shapes.size(), own);
    for (int first = 0, last; first < points.count; first = last) {
        const std::uint32_t shape = points.shape[order[first]];
        for (last = first + 1; last < points.count && points.shape[order[last]] == shape;)
            ++last;
        Run(tables, code, order + first, last - first, normalSign, points, own).evaluate();
    }
}

} // namespace candela
