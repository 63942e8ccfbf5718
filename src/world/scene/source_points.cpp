// SPDX-License-Identifier: Apache-2.0
#include "world/scene/source_points.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"
#include "world/lights/shape_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <numbers>

namespace candela {

namespace {

using Form = LightElement::Form;

constexpr int rowWords = sizeof(LightElement) / sizeof(float);
static_assert(rowWords == 16);
/// Mixed forms are sorted within blocks of so many lanes.
constexpr int block = 256;

CANDELA_HOT void findRows(int count, const std::int32_t *__restrict element, int *__restrict row) {
    for (int i = 0; i < count; ++i)
        row[i] = element[i] > 0 ? element[i] * rowWords : 0;
}

CANDELA_HOT void leaveOutMissing(int count, const std::int32_t *__restrict element,
                                 std::int32_t *__restrict form) {
    for (int i = 0; i < count; ++i)
        form[i] = element[i] < 0 ? std::int32_t(Form::NoShape) : form[i];
}

/// Lanes of one form, in planes that lie anywhere: who looks and what, numbers, and the answers.
struct Lanes {
    int count = 0;
    std::array<const float *, 3> from{}, corner{}, edgeA{}, edgeB{}, given{};
    const float *area = nullptr, *handedness = nullptr, *u = nullptr, *v = nullptr;
    std::array<float *, 3> point{}, normal{};
    float *pdf = nullptr, *uOut = nullptr, *vOut = nullptr;

    /// Every pointer that is read, for those who move lanes about.
    template <class Body> void forInputs(Body body) {
        for (auto *planes : {&from, &corner, &edgeA, &edgeB, &given})
            for (const float *&plane : *planes)
                body(plane);
        body(area), body(handedness), body(u), body(v);
    }
    template <class Body> void forOutputs(Body body) {
        for (auto *planes : {&point, &normal})
            for (float *&plane : *planes)
                body(plane);
        body(pdf), body(uOut), body(vOut);
    }
};

/// Calls body(form, lanes) for all lanes of one form at a time: where they are alike as they lie,
/// else gathered from blocks and put back.
template <class Body> void forForms(const ElementRows &rows, Lanes all, Body body) {
    all.count = rows.count;
    all.handedness = rows.handedness;
    all.corner = {rows.corner[0], rows.corner[1], rows.corner[2]};
    all.edgeA = {rows.edgeA[0], rows.edgeA[1], rows.edgeA[2]};
    all.edgeB = {rows.edgeB[0], rows.edgeB[1], rows.edgeB[2]};
    all.area = rows.area;
    if (rows.count > 0 && lanes::allEqual(rows.count, rows.form, rows.form[0]))
        return body(Form(rows.form[0]), all);
    thread_local Planes<float> own(28, block);
    int lane[block + laneBlock];
    for (int first = 0; first < rows.count; first += block)
        for (Form form : {Form::Triangle, Form::Rectangle, Form::Sphere}) {
            Lanes part = all;
            part.count = lanes::compactEqual(std::min(block, rows.count - first), rows.form + first,
                                             int(form), lane);
            if (part.count == 0)
                continue;
            int plane = 0;
            part.forInputs([&](const float *&input) {
                float *to = own[plane++];
                if (input)
                    lanes::take(part.count, lane, {{input + first, to}}), input = to;
            });
            part.forOutputs([&](float *&output) {
                float *to = own[plane++];
                if (output)
                    output = to;
            });
            body(form, part);
            float *to[9];
            int k = 0;
            all.forOutputs([&](float *output) { to[k++] = output; });
            k = 0;
            part.forOutputs([&](float *output) {
                for (int i = 0; output && i < part.count; ++i)
                    to[k][first + lane[i]] = output[i];
                ++k;
            });
        }
}

CANDELA_HOT void crossEdges(int count, const float *const a[3], const float *const b[3],
                            const float *__restrict handedness, float *const to[3]) {
    const float *ax = a[0], *ay = a[1], *az = a[2], *bx = b[0], *by = b[1], *bz = b[2];
    float *x = to[0], *y = to[1], *z = to[2];
#pragma GCC ivdep
    for (int k = 0; k < count; ++k) {
        x[k] = (ay[k] * bz[k] - az[k] * by[k]) * handedness[k];
        y[k] = (az[k] * bx[k] - ax[k] * bz[k]) * handedness[k];
        z[k] = (ax[k] * by[k] - ay[k] * bx[k]) * handedness[k];
    }
}

/// Barycentric coordinates of points on triangles.
void findBarycentrics(const Lanes &b) {
    for (int k = 0; k < b.count; ++k) {
        auto vec3 = [&](const auto &p) { return Vec3{p[0][k], p[1][k], p[2][k]}; };
        const Vec3 a = vec3(b.edgeA), e = vec3(b.edgeB), w = vec3(b.point) - vec3(b.corner);
        const double aa = dot(a, a), ae = dot(a, e), ee = dot(e, e), wa = dot(w, a), we = dot(w, e);
        const double determinant = aa * ee - ae * ae;
        const double s = determinant > 0 ? (wa * ee - we * ae) / determinant : 0;
        const double t = determinant > 0 ? (we * aa - wa * ae) / determinant : 0;
        b.uOut[k] = float(std::clamp(s, 0.0, 1.0));
        b.vOut[k] = float(std::clamp(t, 0.0, 1.0 - double(b.uOut[k])));
    }
}

/// What else is to be known of the points that were drawn.
void finishPoints(Form form, const Lanes &b) {
    if (form == Form::Sphere)
        for (int c = 0; c < 3; ++c)
            for (int k = 0; k < b.count; ++k)
                b.normal[c][k] = b.point[c][k] - b.corner[c][k];
    else
        crossEdges(b.count, b.edgeA.data(), b.edgeB.data(), b.handedness, b.normal.data());
    if (form == Form::Triangle)
        findBarycentrics(b);
}

/// Uniform by area.
void placeByArea(Form form, const Lanes &b) {
    constexpr float pi = std::numbers::pi_v<float>;
    for (int k = 0; k < b.count; ++k) {
        float u = b.u[k], v = b.v[k];
        if (form == Form::Triangle) {
            const bool lower = u > v;
            const float s = lower ? u - v / 2 : u / 2, t = lower ? v / 2 : v - u / 2;
            u = s, v = t;
        }
        if (form != Form::Sphere) {
            for (int c = 0; c < 3; ++c)
                b.point[c][k] = b.corner[c][k] + u * b.edgeA[c][k] + v * b.edgeB[c][k];
            continue;
        }
        const float z = 1 - 2 * u, r = std::sqrt(std::max(0.0f, 1 - z * z));
        const Vec3 normal{r * std::cos(2 * pi * v), r * std::sin(2 * pi * v), z};
        for (int c = 0; c < 3; ++c)
            b.point[c][k] = b.corner[c][k] + b.edgeA[0][k] * normal[c];
    }
}

Lanes drawnLanes(const float *u, const float *v, SourcePoints &out) {
    Lanes lanes;
    lanes.u = u, lanes.v = v;
    lanes.point = out.point, lanes.normal = out.normal;
    lanes.pdf = out.pdf, lanes.uOut = out.u, lanes.vOut = out.v;
    return lanes;
}

} // namespace

ElementRows::ElementRows(int capacity) : planes(rowWords + 3, capacity), row(1, capacity) {
    auto signedPlane = [&](int plane) { return reinterpret_cast<std::int32_t *>(planes[plane]); };
    auto unsignedPlane = [&](int plane) {
        return reinterpret_cast<std::uint32_t *>(planes[plane]);
    };
    source = signedPlane(0), form = signedPlane(1);
    instance = unsignedPlane(2), shape = unsignedPlane(3), element = unsignedPlane(4);
    constexpr int first = offsetof(LightElement, corner) / sizeof(float);
    for (int c = 0; c < 3; ++c)
        corner[c] = planes[first + c], edgeA[c] = planes[first + 3 + c],
        edgeB[c] = planes[first + 6 + c];
    offset = planes[offsetof(LightElement, offset) / sizeof(float)];
    area = planes[offsetof(LightElement, area) / sizeof(float)];
    light = signedPlane(rowWords), u = planes[rowWords + 1];
    handedness = planes[rowWords + 2];
}

void ElementRows::take(const LightTable &table, int lanes, const std::int32_t *elements) {
    count = lanes, filledLanes_ = 0;
    float *columns[rowWords];
    for (int c = 0; c < rowWords; ++c)
        columns[c] = planes[c];
    findRows(count, elements, row[0]);
    lanes::gatherRows(count, reinterpret_cast<const float *>(table.elements.data()), row[0],
                      rowWords, columns);
    leaveOutMissing(count, elements, form);
    for (int i = 0; i < count; ++i) {
        const LightSource owner = elements[i] < 0 ? LightSource{} : table.sources[source[i]];
        light[i] = owner.light, handedness[i] = owner.handedness;
    }
}

/// Batch after batch may be of one lamp alone: its rows stay as they are.
void ElementRows::fill(const LightTable &table, int rows, std::int32_t number) {
    const LightElement &from = table.elements[number];
    const LightSource &owner = table.sources[from.source];
    count = rows;
    if (filledLanes_ >= rows && std::memcmp(&from, &filled_, sizeof from) == 0 &&
        light[0] == owner.light && handedness[0] == owner.handedness)
        return;
    filled_ = from, filledLanes_ = rows;
    float words[rowWords];
    std::memcpy(words, &from, sizeof words);
    for (int c = 0; c < rowWords; ++c)
        lanes::fill(rows, words[c], planes[c]);
    lanes::fill(rows, owner.light, light);
    lanes::fill(rows, owner.handedness, handedness);
}

void ElementRows::draw(const LightTable &table, int lanes, const std::int32_t *sources,
                       const float *given) {
    if (lanes > 0 && sources[0] >= 0 && lanes::allEqual(lanes, sources, sources[0])) {
        const LightSource &only = table.sources[sources[0]];
        if (only.members == 1) {
            std::copy_n(given, lanes, u);
            return fill(table, lanes, table.members[only.firstMember]);
        }
    }
    thread_local Scratch<std::int32_t> own;
    std::int32_t *drawn = own.get(lanes);
    for (int i = 0; i < lanes; ++i) {
        u[i] = given[i];
        drawn[i] = sources[i] < 0 ? -1 : table.drawElement(table.sources[sources[i]], u[i]);
    }
    take(table, lanes, drawn);
}

void ElementRows::moveTo(const PointTables &tables, const float *time) {
    if (!tables.anythingMoves())
        return;
    for (int i = 0; i < count; ++i) {
        if (Form(form[i]) == Form::NoShape || instance[i] == noHit)
            continue;
        const std::span<const Matrix4> steps = tables.stepsOf(instance[i]);
        if (steps.empty())
            continue;
        filledLanes_ = 0;
        Matrix4 objectFromOpen;
        std::copy_n(tables.matricesOf(instance[i]) + 16, 16, objectFromOpen.m.begin());
        const Matrix4 moved = objectFromOpen * matrixAt(steps, tables.shutter.share(time[i]));
        const auto get = [i](const auto &planes) {
            return Vec3{planes[0][i], planes[1][i], planes[2][i]};
        };
        const auto set = [i](const auto &planes, Vec3 to) {
            for (int c = 0; c < 3; ++c)
                planes[c][i] = to[c];
        };
        set(corner, transformPoint(moved, get(corner)));
        if (Form(form[i]) == Form::Sphere) // Such do not turn.
            continue;
        // What is drawn by area keeps its share, whatever it becomes.
        const float before = length(cross(get(edgeA), get(edgeB)));
        set(edgeA, transformVector(moved, get(edgeA)));
        set(edgeB, transformVector(moved, get(edgeB)));
        if (before > 0)
            area[i] *= length(cross(get(edgeA), get(edgeB))) / before;
    }
}

SourcePoints::SourcePoints(int capacity) : floats(9, capacity) {
    for (int c = 0; c < 3; ++c)
        point[c] = floats[c], normal[c] = floats[3 + c];
    pdf = floats[6], u = floats[7], v = floats[8];
}

void sampleElements(const ElementRows &rows, const float *const from[3], const float *u,
                    const float *v, SourcePoints &out) {
    std::fill_n(out.pdf, rows.count, 0.0f);
    Lanes all = drawnLanes(u, v, out);
    all.from = {from[0], from[1], from[2]};
    forForms(rows, all, [](Form form, const Lanes &b) {
        switch (form) {
        case Form::NoShape: return;
        case Form::Triangle:
            sampleTriangles(b.count, b.from.data(), b.corner.data(), b.edgeA.data(), b.edgeB.data(),
                            b.area, b.u, b.v, b.point.data(), b.pdf);
            break;
        case Form::Rectangle:
            sampleRectangles(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                             b.edgeB.data(), b.u, b.v, b.point.data(), b.pdf);
            break;
        case Form::Sphere:
            sampleSpheres(b.count, b.from.data(), b.corner.data(), b.edgeA[0], b.edgeB[0], b.u, b.v,
                          b.point.data(), b.pdf);
        }
        finishPoints(form, b);
    });
}

void placeOnElements(const ElementRows &rows, const float *u, const float *v, SourcePoints &out) {
    forForms(rows, drawnLanes(u, v, out), [](Form form, const Lanes &b) {
        if (form == Form::NoShape)
            return;
        placeByArea(form, b);
        finishPoints(form, b);
    });
}

void placePoints(const ElementRows &rows, const SourcePoints &drawn, ShadingPoints &points) {
    const int count = points.count = rows.count;
    std::copy_n(rows.instance, count, points.instance);
    std::copy_n(rows.shape, count, points.shape);
    std::copy_n(rows.element, count, points.element);
    std::copy_n(drawn.u, count, points.u);
    std::copy_n(drawn.v, count, points.v);
    for (int c = 0; c < 3; ++c) {
        std::copy_n(drawn.point[c], count, points.input(ShaderInput::P, c));
        std::copy_n(drawn.normal[c], count, points.input(ShaderInput::Ng, c));
    }
}

void elementDensities(const ElementRows &rows, const float *const from[3],
                      const float *const point[3], float *pdf) {
    std::fill_n(pdf, rows.count, 0.0f);
    Lanes all;
    all.from = {from[0], from[1], from[2]}, all.given = {point[0], point[1], point[2]};
    all.pdf = pdf;
    forForms(rows, all, [](Form form, const Lanes &b) {
        switch (form) {
        case Form::NoShape: return;
        case Form::Triangle:
            return triangleDensities(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                                     b.edgeB.data(), b.area, b.given.data(), b.pdf);
        case Form::Rectangle:
            return rectangleDensities(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                                      b.edgeB.data(), b.given.data(), b.pdf);
        case Form::Sphere:
            return sphereDensities(b.count, b.from.data(), b.corner.data(), b.edgeA[0], b.edgeB[0],
                                   b.pdf);
        }
    });
}

} // namespace candela
