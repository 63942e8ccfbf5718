// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_tree.h"

#include "world/lights/light_tree_builder.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr double largestBelow1 = 0x1.fffffffffffffp-1;
/// Culling leaves this much room for rounding, in cosines.
constexpr double margin = 1e-5;
/// What a cosine weighs at least where light is possible.
constexpr double leastCosine = 0.01;

struct Point {
    double P[3], N[3];
    bool sound, horizon;
};

Point pointAt(const float *const P[3], const float *const N[3], int i) {
    Point p{};
    p.sound = true;
    for (int k = 0; k < 3; ++k) {
        p.P[k] = P[k][i], p.N[k] = N[k][i];
        p.sound = p.sound && std::abs(p.P[k]) < 1e18;
    }
    double length2 = p.N[0] * p.N[0] + p.N[1] * p.N[1] + p.N[2] * p.N[2];
    p.horizon = length2 > 0 && std::isfinite(length2);
    return p;
}

/// cos(max(a - b, 0)) of angles up to pi, from their cosines and sines.
double cosOfDifference(double cosA, double sinA, double cosB, double sinB) {
    return cosA >= cosB ? 1 : cosA * cosB + sinA * sinB;
}

double sineOf(double cosine) { return std::sqrt(std::max(1 - cosine * cosine, 0.0)); }

/// True if the bounds leave the light a way from the emitters' normals to P.
bool mayShine(const LightTree::Node &node, double cosAxis, double d2, double r2) {
    if (d2 <= r2)
        return true;
    double sinBox = std::sqrt(r2 / d2), cosBox = sineOf(sinBox);
    // From the normals' cone, then from the box.
    double c = cosOfDifference(cosAxis, sineOf(cosAxis), node.cosNormal, node.sinNormal);
    return cosOfDifference(c, sineOf(c), cosBox, sinBox) >= node.cosEmission - margin;
}

/// What cosines at emitters and receiver a direction from P (unit) has.
double cosines(const LightTree::Node &node, const Point &p, const double w[3]) {
    double cosAxis = 0, cosine = 0;
    for (int k = 0; k < 3; ++k)
        cosAxis -= node.axis[k] * w[k], cosine += p.N[k] * w[k];
    cosAxis = std::clamp(cosAxis, -1.0, 1.0);
    if (node.cosEmission < -margin && cosAxis < 0) // Backs shine as fronts do.
        cosAxis = -cosAxis;
    double sent = cosOfDifference(cosAxis, sineOf(cosAxis), node.cosNormal, node.sinNormal);
    return std::max(sent, leastCosine) * (p.horizon ? std::max(cosine, leastCosine) : 1);
}

/// An estimate of the irradiance that a node gives; 0 only if it can give none.
double importance(const LightTree::Node &node, const Point &p) {
    if (!(node.intensity > 0) || !p.sound)
        return node.intensity;
    double v[3], w[3], d2 = 0, r2 = 0, near2 = 0;
    double height = 0, reach = 0, scale = 0, facing = 0;
    for (int k = 0; k < 3; ++k) {
        double half = node.half[k];
        v[k] = node.centre[k] - p.P[k];
        w[k] = v[k] - std::clamp(v[k], -half, half); // To the nearest point of the box.
        d2 += v[k] * v[k], r2 += half * half;
        near2 += w[k] * w[k], height += p.N[k] * v[k], reach += std::abs(p.N[k]) * half;
        scale += std::abs(v[k]);
        facing -= node.axis[k] * v[k];
    }
    if (p.horizon && height + reach < -1e-6 * scale)
        return 0;
    double d = std::sqrt(d2), near = std::sqrt(near2);
    if (!mayShine(node, d > 0 ? std::clamp(facing / d, -1.0, 1.0) : 1, d2, r2))
        return 0;
    // In a box, and near a large one, emitters are nearer than its centre.
    double weight = node.intensity / std::max({d2, r2 / 4, 1e-30});
    if (!(near > 0))
        return weight;
    for (int k = 0; k < 3; ++k)
        v[k] /= d, w[k] /= near;
    return weight * std::max(cosines(node, p, v), cosines(node, p, w));
}

/// A probability that isn't 0 stays so as a float.
float rounded(double p) { return p > 0 ? std::max(float(p), 0x1p-126f) : 0; }

} // namespace

LightTree::LightTree(std::span<const EmitterBound> emitters) {
    buildLightTree(emitters, nodes_, trails_);
}

void LightTree::choose(int count, const float *const P[3], const float *const N[3], double *u,
                       std::int32_t *emitter, float *probability) const {
    for (int i = 0; i < count; ++i) {
        const Point p = pointAt(P, N, i);
        emitter[i] = -1, probability[i] = 0;
        if (nodes_.empty() || !(importance(nodes_[0], p) > 0))
            continue;
        std::int32_t at = 0;
        double product = 1, x = u[i] >= 0 ? std::min(u[i], largestBelow1) : 0;
        while (product > 0 && nodes_[at].link >= 0) {
            double a = importance(nodes_[at + 1], p), b = importance(nodes_[nodes_[at].link], p);
            double pA = a + b > 0 ? a / (a + b) : 0, pB = a + b > 0 ? b / (a + b) : 0;
            bool second = x >= pA && pB > 0;
            x = second ? (x - pA) / pB : pA > 0 ? x / pA : x;
            x = std::clamp(x, 0.0, largestBelow1);
            product *= second ? pB : pA;
            at = second ? nodes_[at].link : at + 1;
        }
        u[i] = x;
        if (product > 0)
            emitter[i] = ~nodes_[at].link, probability[i] = rounded(product);
    }
}

void LightTree::probability(int count, const float *const P[3], const float *const N[3],
                            const std::int32_t *emitter, float *probability) const {
    for (int i = 0; i < count; ++i) {
        probability[i] = 0;
        if (emitter[i] < 0 || emitter[i] >= size())
            continue;
        const Point p = pointAt(P, N, i);
        std::int32_t at = 0;
        double product = importance(nodes_[0], p) > 0;
        for (std::uint64_t trail = trails_[emitter[i]]; product > 0 && nodes_[at].link >= 0;
             trail >>= 1) {
            double a = importance(nodes_[at + 1], p), b = importance(nodes_[nodes_[at].link], p);
            double chosen = trail & 1 ? b : a;
            product *= a + b > 0 ? chosen / (a + b) : 0;
            at = trail & 1 ? nodes_[at].link : at + 1;
        }
        probability[i] = rounded(product);
    }
}

void LightTree::irradiance(int count, const float *const P[3], const float *const N[3],
                           double *irradiance) const {
    for (int i = 0; i < count; ++i)
        irradiance[i] = nodes_.empty() ? 0 : importance(nodes_[0], pointAt(P, N, i));
}

} // namespace candela
