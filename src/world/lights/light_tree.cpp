// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_tree.h"

#include "foundation/base/hot.h"
#include "world/lights/light_tree_builder.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

using Node = LightTree::Node;

constexpr double largestBelow1 = 0x1.fffffffffffffp-1;
/// Culling leaves this much room for rounding, in cosines.
constexpr float margin = 1e-3f;
/// The same for the horizon, against the distance.
constexpr float heightMargin = 2e-6f;
/// What a cosine weighs at least where light is possible.
constexpr float leastCosine = 0.01f;
/// What a child weighs at least where it may shine.
constexpr float leastWeight = 0x1p-120f;

/// Who asks. The horizon is 0 where light from all sides counts.
struct Point {
    float x, y, z, nx, ny, nz;
    bool sound, horizon;
};

[[gnu::always_inline]] inline Point pointAt(const float *const P[3], const float *const N[3],
                                            int i) {
    Point p{P[0][i], P[1][i], P[2][i], N[0][i], N[1][i], N[2][i], false, false};
    constexpr float far = 1e18f;
    p.sound = (std::fabs(p.x) < far) & (std::fabs(p.y) < far) & (std::fabs(p.z) < far);
    const float length2 = p.nx * p.nx + p.ny * p.ny + p.nz * p.nz;
    p.horizon = (length2 > 0) & (length2 < far);
    if (!p.horizon)
        p.nx = p.ny = p.nz = 0;
    return p;
}

inline float larger(float a, float b) { return a > b ? a : b; }
inline float smaller(float a, float b) { return a < b ? a : b; }
inline float within(float x, float half) { return smaller(larger(x, -half), half); }

/// 1 or 0: selections are products, since compilers turn others into branches, which don't
/// vectorise.
inline float mask(bool condition) { return condition ? 1.0f : 0.0f; }
inline float pick(float mask, float a, float b) { return mask * a + (1 - mask) * b; }

/// Where a direction is against the normals: cosine and sine of its angle with the nearest one.
[[gnu::always_inline]] inline void leaveCone(float cosine, float sine, float cosCone, float sinCone,
                                             float &cosRest, float &sinRest) {
    const float rest = sine * cosCone - cosine * sinCone;
    cosRest = pick(mask(rest > 0), cosine * cosCone + sine * sinCone, 1);
    sinRest = larger(rest, 0);
}

/// Estimates of the irradiances that the children give a sound point; 0 only of those that can
/// give none.
[[gnu::always_inline]] inline void weighSound(const Node &n, const Point &p, float *weight) {
    const float leastFacing = p.horizon ? leastCosine : 1.0f;
#pragma GCC ivdep
    for (int k = 0; k < Node::width; ++k) {
        // To the centre (v) and to the nearest point of the box (w).
        const float hx = n.half[0][k], hy = n.half[1][k], hz = n.half[2][k];
        const float vx = n.centre[0][k] - p.x, vy = n.centre[1][k] - p.y, vz = n.centre[2][k] - p.z;
        const float wx = vx - within(vx, hx), wy = vy - within(vy, hy), wz = vz - within(vz, hz);
        const float d2 = vx * vx + vy * vy + vz * vz, r2 = hx * hx + hy * hy + hz * hz;
        const float near2 = wx * wx + wy * wy + wz * wz;
        const float perD = 1 / std::sqrt(larger(d2, 1e-36f));
        const float perNear = 1 / std::sqrt(larger(near2, 1e-36f));
        // The receiver.
        const float height = p.nx * vx + p.ny * vy + p.nz * vz;
        const float reach = std::fabs(p.nx) * hx + std::fabs(p.ny) * hy + std::fabs(p.nz) * hz;
        const float scale = std::fabs(vx) + std::fabs(vy) + std::fabs(vz);
        const float nearHeight = p.nx * wx + p.ny * wy + p.nz * wz;
        const float risen = mask(height + reach >= -heightMargin * scale);
        const float facingV = larger(height * perD, leastFacing);
        const float facingW = larger(nearHeight * perNear, leastFacing);
        // The emitter: the angle of v with the axis, less the spread of normals, less the box.
        const float ax = n.axis[0][k], ay = n.axis[1][k], az = n.axis[2][k];
        const float cosNormal = n.cosNormal[k], sinNormal = n.sinNormal[k];
        const float qx = ay * vz - az * vy, qy = az * vx - ax * vz, qz = ax * vy - ay * vx;
        const float cosV = -(ax * vx + ay * vy + az * vz) * perD;
        const float sinV = std::sqrt(qx * qx + qy * qy + qz * qz) * perD;
        const float sine2 = smaller(r2 * perD * perD, 1);
        const float sinBox = std::sqrt(sine2), cosBox = std::sqrt(1 - sine2);
        float c, s, nearest, rest;
        leaveCone(cosV, sinV, cosNormal, sinNormal, c, s);
        leaveCone(c, s, cosBox, sinBox, nearest, rest);
        const float shines = larger(mask(d2 <= r2), mask(nearest >= n.cosEmission[k] - margin));
        // What cosines the two directions have there.
        const float backs = n.backs[k];
        float sentV, sentW;
        leaveCone(larger(cosV, -backs * cosV), sinV, cosNormal, sinNormal, sentV, rest);
        const float cosW = -(ax * wx + ay * wy + az * wz) * perNear;
        const float sinW = std::sqrt(larger(1 - cosW * cosW, 0));
        leaveCone(larger(cosW, -backs * cosW), sinW, cosNormal, sinNormal, sentW, rest);
        const float seen =
            larger(larger(sentV, leastCosine) * facingV, larger(sentW, leastCosine) * facingW);
        const float cosines = pick(shines, pick(mask(near2 > 0), seen, 1), n.beyond[k] * facingV);
        // In a box, and near a large one, emitters are nearer than its centre.
        const float intensity = n.intensity[k];
        const float square = larger(larger(d2, r2 * 0.25f), 1e-30f);
        const float possible = mask(intensity > 0) * risen * mask(cosines > 0);
        weight[k] = larger(intensity / square * cosines, leastWeight) * possible;
    }
}

[[gnu::always_inline]] inline void weigh(const Node &n, const Point &p, float *weight) {
    if (p.sound)
        return weighSound(n, p, weight);
    for (int k = 0; k < Node::width; ++k)
        weight[k] = n.intensity[k];
}

/// The sum of the weights, always in the same order.
inline double total(const float *weight) {
    double sum = 0;
    for (int k = 0; k < Node::width; ++k)
        sum += double(weight[k]);
    return sum;
}

/// A probability that isn't 0 stays so as a float.
inline float rounded(double p) { return p > 0 ? std::max(float(p), 0x1p-126f) : 0; }

/// Moves x to within the share of the child that it falls to, which is returned; -1 = no child.
[[gnu::always_inline]] inline int descend(const float *weight, double &x, double &product) {
    double below[Node::width + 1];
    below[0] = 0;
    for (int k = 0; k < Node::width; ++k)
        below[k + 1] = below[k] + double(weight[k]);
    const double sum = below[Node::width], at = x * sum;
    // Children without a weight end where they begin, so x is never within them.
    int chosen = 0, last = 0;
    for (int k = 1; k <= Node::width; ++k) {
        chosen += at >= below[k] ? 1 : 0;
        last += below[k] < sum ? 1 : 0;
    }
    chosen = std::min(chosen, last);
    const double share = double(weight[chosen]);
    if (share < sum) // An only child leaves x as it is.
        x = std::min(std::max((at - below[chosen]) / share, 0.0), largestBelow1);
    product *= sum > 0 ? share / sum : 0;
    return sum > 0 ? chosen : -1;
}

/// A point on its way down.
struct Walk {
    Point point;
    double x, product;
    std::int32_t at; ///< A node, or ~emitter.
};

/// Points that go down together, level by level: what one waits for, another computes.
constexpr int together = 32;

CANDELA_HOT void descendAll(const Node *nodes, int count, Walk *walks) {
    std::int32_t active[together];
    for (int i = 0; i < count; ++i)
        active[i] = i;
    while (count > 0) {
        int left = 0;
        for (int k = 0; k < count; ++k) {
            Walk &walk = walks[active[k]];
            float weight[Node::width];
            weigh(nodes[walk.at], walk.point, weight);
            const int child = descend(weight, walk.x, walk.product);
            walk.product = child < 0 ? 0 : walk.product;
            walk.at = nodes[walk.at].link[child < 0 ? 0 : child];
            active[left] = active[k];
            left += (walk.at >= 0) & (walk.product > 0);
        }
        count = left;
    }
}

void chooseEmitters(const Node *nodes, int count, const float *const P[3], const float *const N[3],
                    double *u, std::int32_t *emitter, float *probability) {
    Walk walks[together];
    // A single emitter hangs on the first node.
    const std::int32_t top = nodes[0].link[0] < 0 ? 0 : nodes[0].link[0];
    for (int first = 0; first < count; first += together) {
        const int n = std::min(together, count - first);
        for (int k = 0; k < n; ++k) {
            const double x = u[first + k];
            walks[k] = {pointAt(P, N, first + k), x >= 0 ? std::min(x, largestBelow1) : 0, 1, top};
        }
        descendAll(nodes, n, walks);
        for (int k = 0; k < n; ++k) {
            const Walk &walk = walks[k];
            u[first + k] = walk.x;
            emitter[first + k] = walk.product > 0 ? ~walk.at : -1;
            probability[first + k] = rounded(walk.product);
        }
    }
}

/// Deeper than any tree.
constexpr int mostLevels = 64;

CANDELA_HOT void probabilityOf(const Node *nodes, const Point &p, std::int32_t node,
                               std::int32_t slot, float *probability) {
    std::int32_t path[mostLevels], child[mostLevels];
    int levels = 0;
    const std::int32_t top = nodes[0].link[0] < 0 ? -1 : 0;
    for (; node != top && levels < mostLevels; ++levels) {
        path[levels] = node, child[levels] = slot;
        slot = nodes[node].slot, node = nodes[node].parent;
    }
    double product = 1;
    while (levels-- > 0 && product > 0) { // From the top, as the choice goes.
        float weight[Node::width];
        weigh(nodes[path[levels]], p, weight);
        const double sum = total(weight);
        product *= sum > 0 ? double(weight[child[levels]]) / sum : 0;
    }
    *probability = rounded(product);
}

CANDELA_HOT void irradiances(const Node &top, int count, const float *const P[3],
                             const float *const N[3], double unit, double *irradiance) {
    for (int i = 0; i < count; ++i) {
        float weight[Node::width];
        weigh(top, pointAt(P, N, i), weight);
        irradiance[i] = double(weight[0]) * unit;
    }
}

} // namespace

LightTree::LightTree(std::span<const EmitterBound> emitters) { buildLightTree(emitters, *this); }

void LightTree::choose(int count, const float *const P[3], const float *const N[3], double *u,
                       std::int32_t *emitter, float *probability) const {
    if (!nodes_.empty())
        return chooseEmitters(nodes_.data(), count, P, N, u, emitter, probability);
    std::fill_n(emitter, count, -1);
    std::fill_n(probability, count, 0.0f);
}

void LightTree::probability(int count, const float *const P[3], const float *const N[3],
                            const std::int32_t *emitter, float *probability) const {
    for (int i = 0; i < count; ++i) {
        probability[i] = 0;
        if (emitter[i] < 0 || emitter[i] >= size())
            continue;
        const Leaf leaf = leaves_[emitter[i]];
        probabilityOf(nodes_.data(), pointAt(P, N, i), leaf.node, leaf.slot, probability + i);
    }
}

void LightTree::irradiance(int count, const float *const P[3], const float *const N[3],
                           double *irradiance) const {
    if (!nodes_.empty())
        return irradiances(nodes_[0], count, P, N, unit_, irradiance);
    std::fill_n(irradiance, count, 0.0);
}

} // namespace candela
