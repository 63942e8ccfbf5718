// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/bezier_net.h"

#include <algorithm>
#include <cmath>

namespace candela {

BezierNet bezierNet(const PatchPolynomials &polynomials, int patch, int component) {
    const float *c = polynomials.of(patch, component);
    if (polynomials.isBernstein()) {
        BezierNet net(polynomials.bernstein[0] + 1, polynomials.bernstein[1] + 1);
        std::copy_n(c, net.ordinates.size(), net.ordinates.begin());
        return net;
    }
    int size = polynomials.degree + 1;
    BezierNet net(4, 4);
    for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l)
            for (int i = 0; i < size; ++i)
                for (int j = 0; j < size; ++j)
                    net.at(k, l) +=
                        ordinatesOfPowers[k][i] * ordinatesOfPowers[l][j] * c[i * size + j];
    return net;
}

namespace {

/// Greatest length over a net of a difference of its points, n components.
template <class Difference>
double greatest(std::span<const BezierNet> nets, int lessU, int lessV, Difference difference) {
    double most = 0;
    for (int i = 0; i < nets[0].sizeU - lessU; ++i)
        for (int j = 0; j < nets[0].sizeV - lessV; ++j) {
            double squared = 0;
            for (const BezierNet &b : nets) {
                double d = difference(b, i, j);
                squared += d * d;
            }
            most = std::max(most, squared);
        }
    return std::sqrt(most);
}

} // namespace

/// Derivatives of a Bezier patch are Bezier patches of its differences: the hull bounds them.
DerivativeBounds derivativeBounds(std::span<const BezierNet> nets) {
    const int n = nets[0].sizeU - 1, m = nets[0].sizeV - 1;
    DerivativeBounds bounds;
    bounds.skew = true;
    bounds.du =
        n * greatest(nets, 1, 0, [](auto &b, int i, int j) { return b.at(i + 1, j) - b.at(i, j); });
    bounds.dv =
        m * greatest(nets, 0, 1, [](auto &b, int i, int j) { return b.at(i, j + 1) - b.at(i, j); });
    bounds.duu = n * (n - 1) * greatest(nets, 2, 0, [](auto &b, int i, int j) {
                     return b.at(i + 2, j) - 2 * b.at(i + 1, j) + b.at(i, j);
                 });
    bounds.dvv = m * (m - 1) * greatest(nets, 0, 2, [](auto &b, int i, int j) {
                     return b.at(i, j + 2) - 2 * b.at(i, j + 1) + b.at(i, j);
                 });
    bounds.duv = n * m * greatest(nets, 1, 1, [](auto &b, int i, int j) {
                     return b.at(i + 1, j + 1) - b.at(i + 1, j) - b.at(i, j + 1) + b.at(i, j);
                 });
    return bounds;
}

/// P = H/w gives w P_u = H_u - w_u P and so on; `radius` bounds |P| about the origin of H.
static DerivativeBounds rationalBounds(const DerivativeBounds &h, const DerivativeBounds &w,
                                       double leastWeight, double radius) {
    DerivativeBounds p;
    p.skew = true;
    p.du = (h.du + w.du * radius) / leastWeight;
    p.dv = (h.dv + w.dv * radius) / leastWeight;
    p.duu = (h.duu + 2 * w.du * p.du + w.duu * radius) / leastWeight;
    p.dvv = (h.dvv + 2 * w.dv * p.dv + w.dvv * radius) / leastWeight;
    p.duv = (h.duv + w.du * p.dv + w.dv * p.du + w.duv * radius) / leastWeight;
    return p;
}

DerivativeBounds rationalDerivatives(std::vector<BezierNet> nets) {
    const std::span<BezierNet> points = std::span(nets).first(nets.size() - 1);
    const std::vector<double> &weights = nets.back().ordinates;
    // About the middle of the box, where the quotient's terms are smallest.
    double squaredRadius = 0;
    for (BezierNet &net : points) {
        double low = 1e300, high = -1e300;
        for (std::size_t i = 0; i < weights.size(); ++i) {
            low = std::min(low, net.ordinates[i] / weights[i]);
            high = std::max(high, net.ordinates[i] / weights[i]);
        }
        const double half = (high - low) / 2;
        squaredRadius += half * half;
        for (std::size_t i = 0; i < weights.size(); ++i)
            net.ordinates[i] -= weights[i] * (low + half);
    }
    return rationalBounds(derivativeBounds(points), derivativeBounds(std::span(nets).last(1)),
                          *std::ranges::min_element(weights), std::sqrt(squaredRadius));
}

static double coefficientSum(const PatchPolynomials &positions, int patch) {
    double most = 0;
    for (int component = 0; component < 3; ++component) {
        double sum = 0;
        const float *c = positions.of(patch, component);
        for (int i = 0; i < positions.coefficientCount(); ++i)
            // Bernstein's functions add up to 1.
            sum = positions.isBernstein() ? std::max(sum, double(std::abs(c[i])))
                                          : sum + std::abs(c[i]);
        most = std::max(most, sum);
    }
    return most;
}

/// Which sides are a point, by the ordinates along them.
static std::array<bool, 4> collapsedSides(std::span<const BezierNet> nets, double tolerance) {
    const int lastU = nets[0].sizeU - 1, lastV = nets[0].sizeV - 1;
    auto isPoint = [&](int last, auto ordinate) {
        double most = 0;
        for (int c = 0; c < 3; ++c)
            for (int k = 1; k <= last; ++k) {
                auto place = [&](int i) {
                    return ordinate(nets[c], i) / (nets.size() == 4 ? ordinate(nets[3], i) : 1);
                };
                most = std::max(most, std::abs(place(k) - place(0)));
            }
        return most <= tolerance;
    };
    return {isPoint(lastU, [](const BezierNet &b, int k) { return b.at(k, 0); }),
            isPoint(lastU, [=](const BezierNet &b, int k) { return b.at(k, lastV); }),
            isPoint(lastV, [](const BezierNet &b, int k) { return b.at(0, k); }),
            isPoint(lastV, [=](const BezierNet &b, int k) { return b.at(lastU, k); })};
}

PatchBounds patchBounds(const PatchPolynomials &positions, int patch) {
    std::vector<BezierNet> nets;
    for (int c = 0; c < positions.components; ++c)
        nets.push_back(bezierNet(positions, patch, c));
    bool rational = positions.components == 4;
    PatchBounds bounds;
    bounds.coefficientSum = coefficientSum(positions, patch);
    double leastWeight = 1e300;
    for (std::size_t i = 0; i < nets[0].ordinates.size(); ++i) {
        double w = rational ? nets[3].ordinates[i] : 1;
        leastWeight = std::min(leastWeight, w);
        auto along = [&](int c) { return float(nets[c].ordinates[i] / w); };
        bounds.box.add(Vec3{along(0), along(1), along(2)});
    }
    std::span<const BezierNet> homogeneous = std::span(nets).first(3);
    bounds.collapsed =
        collapsedSides(nets, 4e-7 * bounds.coefficientSum / std::min(leastWeight, 1.0));
    if (!rational) {
        bounds.derivatives = derivativeBounds(homogeneous);
        bounds.derivatives.ruled = positions.degree == 1 && !positions.isBernstein();
        return bounds;
    }
    bounds.valid = leastWeight > 0;
    if (bounds.valid)
        bounds.derivatives = rationalDerivatives(std::move(nets));
    bounds.coefficientSum *= 1 / leastWeight;
    return bounds;
}

bool hasUsableSize(const Box3 &box) {
    double size = std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.low.z),
                            std::abs(box.high.x), std::abs(box.high.y), std::abs(box.high.z)});
    return size <= 1e12 && length(box.extent()) >= 1e-12;
}

/// Do the last ordinates of one net along u (or v) equal the first of the next?
static bool netsMeet(const BezierNet &here, const BezierNet &next, bool alongU, double tolerance) {
    const int lastU = here.sizeU - 1, lastV = here.sizeV - 1;
    for (int k = 0; k <= (alongU ? lastV : lastU); ++k) {
        double end = alongU ? here.at(lastU, k) : here.at(k, lastV);
        double start = alongU ? next.at(0, k) : next.at(k, 0);
        if (!(std::abs(end - start) <= tolerance))
            return false;
    }
    return true;
}

bool patchesMeet(const PatchGrid &grid, const PatchPolynomials &positions, double tolerance) {
    const int across = grid.u.patches;
    for (int patch = 0; patch < grid.patches(); ++patch)
        for (int c = 0; c < positions.components; ++c) {
            BezierNet here = bezierNet(positions, patch, c);
            bool lastColumn = (patch + 1) % across == 0;
            bool lastRow = patch + across >= grid.patches();
            if (!lastColumn && !netsMeet(here, bezierNet(positions, patch + 1, c), true, tolerance))
                return false;
            if (!lastRow &&
                !netsMeet(here, bezierNet(positions, patch + across, c), false, tolerance))
                return false;
        }
    return true;
}

} // namespace candela
