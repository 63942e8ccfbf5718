// SPDX-License-Identifier: Apache-2.0
#include "world/scene/source_points.h"

#include "foundation/base/lanes.h"
#include "world/lights/shape_sampling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace candela {

namespace {

constexpr int block = 256;
constexpr int rowWords = sizeof(LightElement) / sizeof(float);
static_assert(rowWords == 16);

using Form = LightElement::Form;
constexpr int forms = 3;

/// Up to a block of lanes whose elements have one form, and what was gathered of these.
struct FormBlock {
    Planes<float> rows{11, block}, query{8, block}, answer{7, block};
    Planes<int> integers{2, block};
    int *lane = integers[0], *row = integers[1];
    std::array<float *, 3> corner{rows[0], rows[1], rows[2]}, edgeA{rows[3], rows[4], rows[5]},
        edgeB{rows[6], rows[7], rows[8]}, from{query[0], query[1], query[2]},
        given{query[5], query[6], query[7]}, point{answer[0], answer[1], answer[2]},
        normal{answer[3], answer[4], answer[5]};
    float *offset = rows[9], *area = rows[10], *u = query[3], *v = query[4], *pdf = answer[6];
    int count = 0;

    void takeRows(const LightTable &table, const std::int32_t *element) {
        for (int k = 0; k < count; ++k)
            row[k] = element[lane[k]] * rowWords;
        constexpr int first = offsetof(LightElement, corner) / sizeof(float);
        float *planes[rowWords] = {};
        for (int c = 0; c < rows.planes(); ++c)
            planes[first + c] = rows[c];
        lanes::gatherRows(count, reinterpret_cast<const float *>(table.elements.data()), row,
                          rowWords, planes);
    }
    void take(const float *from, float *to) { lanes::gather(count, lane, from, to); }
    void put(const float *from, float *to) const {
        for (int k = 0; k < count; ++k)
            to[lane[k]] = from[k];
    }
};
static_assert(offsetof(LightElement, area) == offsetof(LightElement, corner) + 10 * sizeof(float));

/// Calls body(form, block) until all lanes that have an element were in a block.
template <class Body>
void forForms(const LightTable &table, int count, const std::int32_t *element, Body body) {
    thread_local std::array<FormBlock, forms> blocks;
    auto flush = [&](FormBlock &own) {
        own.takeRows(table, element);
        body(Form(&own - blocks.data()), own);
        own.count = 0;
    };
    for (int i = 0; i < count; ++i) {
        if (element[i] < 0)
            continue;
        FormBlock &own = blocks[int(table.elements[element[i]].form)];
        own.lane[own.count++] = i;
        if (own.count == block)
            flush(own);
    }
    for (FormBlock &own : blocks)
        if (own.count > 0)
            flush(own);
}

void crossEdges(FormBlock &b) {
    for (int k = 0; k < b.count; ++k)
        for (int c = 0; c < 3; ++c) {
            const int d = (c + 1) % 3, e = (c + 2) % 3;
            b.normal[c][k] = b.edgeA[d][k] * b.edgeB[e][k] - b.edgeA[e][k] * b.edgeB[d][k];
        }
}

/// Barycentric coordinates of points on triangles.
void findBarycentrics(FormBlock &b) {
    for (int k = 0; k < b.count; ++k) {
        auto vec3 = [&](const std::array<float *, 3> &p) {
            return Vec3{p[0][k], p[1][k], p[2][k]};
        };
        const Vec3 a = vec3(b.edgeA), e = vec3(b.edgeB), w = vec3(b.point) - vec3(b.corner);
        const double aa = dot(a, a), ae = dot(a, e), ee = dot(e, e), wa = dot(w, a), we = dot(w, e);
        const double determinant = aa * ee - ae * ae;
        const double s = determinant > 0 ? (wa * ee - we * ae) / determinant : 0;
        const double t = determinant > 0 ? (we * aa - wa * ae) / determinant : 0;
        b.u[k] = float(std::clamp(s, 0.0, 1.0));
        b.v[k] = float(std::clamp(t, 0.0, 1.0 - double(b.u[k])));
    }
}

/// Uniform by area: no one looks.
void placeByArea(Form form, FormBlock &b) {
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

void placeAsSeen(Form form, FormBlock &b) {
    switch (form) {
    case Form::Triangle:
        return sampleTriangles(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                               b.edgeB.data(), b.area, b.u, b.v, b.point.data(), b.pdf);
    case Form::Rectangle:
        return sampleRectangles(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                                b.edgeB.data(), b.u, b.v, b.point.data(), b.pdf);
    case Form::Sphere:
        return sampleSpheres(b.count, b.from.data(), b.corner.data(), b.edgeA[0], b.u, b.v,
                             b.point.data(), b.pdf);
    }
}

void findNormals(Form form, FormBlock &b) {
    if (form != Form::Sphere)
        return crossEdges(b);
    for (int c = 0; c < 3; ++c)
        for (int k = 0; k < b.count; ++k)
            b.normal[c][k] = b.point[c][k] - b.corner[c][k];
}

} // namespace

SourcePoints::SourcePoints(int capacity) : floats(10, capacity), integers(1, capacity) {
    element = integers[0];
    for (int c = 0; c < 3; ++c)
        point[c] = floats[c], normal[c] = floats[3 + c];
    pdf = floats[6], offset = floats[7], u = floats[8], v = floats[9];
}

void sampleSources(const LightTable &table, const SourceQuery &query, const float *u,
                   const float *v, bool byArea, SourcePoints &out) {
    std::fill_n(out.pdf, query.count, 0.0f);
    for (int i = 0; i < query.count; ++i) {
        const std::int32_t source = query.index[i];
        const bool extended = source >= 0 && table.sources[source].members > 0;
        out.u[i] = u[i];
        out.element[i] = extended ? table.drawElement(table.sources[source], out.u[i]) : -1;
    }
    forForms(table, query.count, out.element, [&](Form form, FormBlock &b) {
        b.take(out.u, b.u), b.take(v, b.v);
        if (byArea) {
            placeByArea(form, b);
        } else {
            for (int c = 0; c < 3; ++c)
                b.take(query.from[c], b.from[c]);
            placeAsSeen(form, b);
            b.put(b.pdf, out.pdf);
        }
        findNormals(form, b);
        if (form == Form::Triangle)
            findBarycentrics(b);
        for (int c = 0; c < 3; ++c)
            b.put(b.point[c], out.point[c]), b.put(b.normal[c], out.normal[c]);
        b.put(b.offset, out.offset);
        b.put(b.u, out.u), b.put(b.v, out.v);
    });
}

void elementDensities(const LightTable &table, const SourceQuery &elements,
                      const float *const point[3], float *pdf) {
    std::fill_n(pdf, elements.count, 0.0f);
    forForms(table, elements.count, elements.index, [&](Form form, FormBlock &b) {
        for (int c = 0; c < 3; ++c)
            b.take(elements.from[c], b.from[c]), b.take(point[c], b.given[c]);
        switch (form) {
        case Form::Triangle:
            triangleDensities(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                              b.edgeB.data(), b.area, b.given.data(), b.pdf);
            break;
        case Form::Rectangle:
            rectangleDensities(b.count, b.from.data(), b.corner.data(), b.edgeA.data(),
                               b.edgeB.data(), b.given.data(), b.pdf);
            break;
        case Form::Sphere:
            sphereDensities(b.count, b.from.data(), b.corner.data(), b.edgeA[0], b.pdf);
        }
        b.put(b.pdf, pdf);
    });
}

} // namespace candela
