// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/spline_spans.h"

#include <algorithm>

namespace candela {

/// Weights of a span's vertices in the Bezier ordinate that has the end so many times among its
/// arguments, the beginning else: the spline's polar form, by de Boor's scheme.
static std::vector<double> polarForm(const SplineRecord &spline, const SplineSpan &span, int ends) {
    const int order = spline.order, degree = order - 1;
    std::vector<double> weights(std::size_t(order) * order, 0.0); // Row j: of point j.
    for (int j = 0; j < order; ++j)
        weights[std::size_t(j) * order + j] = 1;
    const float *knots = spline.knots.data() + span.segment;
    for (int round = 1; round <= degree; ++round) {
        const double argument = round <= ends ? span.end : span.begin;
        for (int j = degree; j >= round; --j) {
            const double from = knots[j], to = knots[j + degree - round + 1];
            const double share = (argument - from) / (to - from);
            for (int k = 0; k < order; ++k) {
                double &weight = weights[std::size_t(j) * order + k];
                weight = (1 - share) * weights[std::size_t(j - 1) * order + k] + share * weight;
            }
        }
    }
    return {weights.end() - order, weights.end()};
}

std::vector<SplineSpan> splineSpans(const SplineRecord &spline) {
    std::vector<SplineSpan> spans;
    for (int segment = 0; segment < spline.segments(); ++segment) {
        const float *ends = &spline.knots[segment + spline.order - 1];
        SplineSpan span{segment, std::max(ends[0], spline.low), std::min(ends[1], spline.high), {}};
        if (!(span.begin < span.end))
            continue;
        for (int k = 0; k < spline.order; ++k) {
            const auto row = polarForm(spline, span, k);
            span.ordinates.insert(span.ordinates.end(), row.begin(), row.end());
        }
        spans.push_back(std::move(span));
    }
    return spans;
}

/// Patches are as wide as floats that count from one end to the other can tell.
static PatchAxis axisOf(const SplineRecord &spline, std::vector<SplineSpan> &spans) {
    const double low = spans.front().begin, high = spans.back().end;
    PatchAxis axis;
    axis.low = float(low), axis.high = float(high);
    axis.segmentCount = spline.segments();
    axis.breaks = {0};
    std::vector<SplineSpan> kept;
    for (SplineSpan &span : spans) {
        const float end = float((span.end - low) / (high - low));
        if (!(end > axis.breaks.back()))
            continue;
        axis.breaks.push_back(end);
        axis.segmentOf.push_back(span.segment);
        kept.push_back(std::move(span));
    }
    axis.patches = int(kept.size());
    spans = std::move(kept);
    return axis;
}

SplineMesh::SplineMesh(const NuPatchRecord &patch)
    : uVertices_(patch.u.vertices), vVertices_(patch.v.vertices), uOrder_(patch.u.order),
      vOrder_(patch.v.order), u_(splineSpans(patch.u)), v_(splineSpans(patch.v)) {
    grid_.u = axisOf(patch.u, u_), grid_.v = axisOf(patch.v, v_);
}

std::vector<double> SplineMesh::product(std::span<const float> values, int components,
                                        int component, const SplineSpan &u, const SplineSpan &v,
                                        std::span<const double> uRows,
                                        std::span<const double> vRows) const {
    const int rowsU = int(uRows.size()) / uOrder_, rowsV = int(vRows.size()) / vOrder_;
    std::vector<double> result(std::size_t(rowsU) * rowsV, 0.0), half(rowsU);
    for (int b = 0; b < vOrder_; ++b) {
        const float *row = &values[std::size_t(v.segment + b) * uVertices_ * components];
        for (int i = 0; i < rowsU; ++i) {
            half[i] = 0;
            for (int a = 0; a < uOrder_; ++a)
                half[i] += uRows[i * uOrder_ + a] * row[(u.segment + a) * components + component];
        }
        for (int i = 0; i < rowsU; ++i)
            for (int j = 0; j < rowsV; ++j)
                result[i * rowsV + j] += half[i] * vRows[j * vOrder_ + b];
    }
    return result;
}

/// Coefficients of powers up to `degree` by vertices, from Bezier ordinates of a degree no higher.
static std::vector<double> powerRows(const std::vector<double> &ordinates, int order, int degree) {
    static constexpr double choose[4][4] = {{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 2, 1, 0}, {1, 3, 3, 1}};
    std::vector<double> rows(std::size_t(degree + 1) * order, 0.0);
    for (int power = 0; power < order; ++power)
        for (int k = 0; k <= power; ++k) {
            const double sign = (power - k) % 2 ? -1 : 1;
            const double factor = sign * choose[order - 1][power] * choose[power][k];
            for (int vertex = 0; vertex < order; ++vertex)
                rows[power * order + vertex] += factor * ordinates[k * order + vertex];
        }
    return rows;
}

PatchPolynomials SplineMesh::convert(std::span<const float> values, int components) const {
    const int degree = std::max(uOrder_, vOrder_) - 1;
    PatchPolynomials result{degree == 1 ? 1 : 3, components};
    if (degree > 3)
        result.bernstein = {uOrder_ - 1, vOrder_ - 1};
    const auto rowsOf = [&](const SplineSpan &span, int order) {
        return result.isBernstein() ? span.ordinates
                                    : powerRows(span.ordinates, order, result.degree);
    };
    for (const SplineSpan &v : v_) {
        const std::vector<double> vRows = rowsOf(v, vOrder_);
        for (const SplineSpan &u : u_) {
            const std::vector<double> uRows = rowsOf(u, uOrder_);
            for (int c = 0; c < components; ++c)
                for (double coefficient : product(values, components, c, u, v, uRows, vRows))
                    result.coefficients.push_back(float(coefficient));
        }
    }
    return result;
}

MeshSides SplineMesh::sides(std::span<const float> points) const {
    MeshSides sides;
    const auto add = [&](int side, const SplineSpan &u, const SplineSpan &v) {
        const bool alongU = side < 2, atEnd = side % 2 == 1;
        const int order = alongU ? vOrder_ : uOrder_; // Across the side.
        const std::span across = alongU ? std::span(v.ordinates) : std::span(u.ordinates);
        const std::span row = atEnd ? across.last(order) : across.first(order);
        SideCurve curve;
        curve.ordinates.resize(alongU ? uOrder_ : vOrder_);
        for (int c = 0; c < 4; ++c) {
            const auto along = alongU ? product(points, 4, c, u, v, u.ordinates, row)
                                      : product(points, 4, c, u, v, row, v.ordinates);
            for (std::size_t k = 0; k < along.size(); ++k)
                curve.ordinates[k][c] = float(along[k]);
        }
        sides[side].push_back(std::move(curve));
    };
    for (const SplineSpan &u : u_)
        add(0, u, v_.front()), add(1, u, v_.back());
    for (const SplineSpan &v : v_)
        add(2, u_.front(), v), add(3, u_.back(), v);
    return sides;
}

} // namespace candela
