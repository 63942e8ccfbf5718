// SPDX-License-Identifier: Apache-2.0
#include "world/lights/light_choice.h"

#include "foundation/base/lanes.h"
#include "foundation/base/scratch.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr double largestBelow1 = 0x1.fffffffffffffp-1;
/// What either side gets at least where both may shine: estimates know nothing of shadows.
constexpr double leastShare = 0.1;
/// What one that surrounds a point gets beside others where no scattered rays find it.
constexpr double surroundingShare = 0.5;
/// What a cosine weighs at least where light is possible, and the room culling leaves for rounding.
constexpr double leastCosine = 0.01, margin = 1e-5;

struct Normal {
    double x, y, z;
    bool horizon;
};

Normal normalAt(const float *const N[3], int i) {
    Normal n{N[0][i], N[1][i], N[2][i], false};
    double length2 = n.x * n.x + n.y * n.y + n.z * n.z;
    n.horizon = length2 > 0 && std::isfinite(length2);
    return n;
}

/// An estimate of the irradiance of a light, 0 only if it gives none.
double irradiance(const InfiniteLight &light, const Normal &n) {
    if (light.everywhere || !n.horizon)
        return light.irradiance;
    double cosine = n.x * light.axis.x + n.y * light.axis.y + n.z * light.axis.z;
    cosine = std::clamp(cosine, -1.0, 1.0);
    double cosHalf = light.cosHalfAngle, sinHalf = std::sqrt(1 - cosHalf * cosHalf);
    if (cosine < -sinHalf - margin)
        return 0;
    double sine = std::sqrt(1 - cosine * cosine);
    double nearest = cosine >= cosHalf ? 1 : cosine * cosHalf + sine * sinHalf;
    return light.irradiance * std::max(nearest, leastCosine);
}

double irradiance(std::span<const InfiniteLight> lights, const Normal &n) {
    double sum = 0;
    for (const InfiniteLight &light : lights)
        sum += irradiance(light, n);
    return sum;
}

/// The probability of the infinite ones together, from the irradiances of both sides.
double infiniteShare(double infinite, double finite) {
    if (!(infinite > 0) || !(finite > 0))
        return infinite > 0 ? 1 : 0;
    return leastShare + (1 - 2 * leastShare) * (infinite / (infinite + finite));
}

/// The probability of one that surrounds, if there is any, from the irradiances of all others.
double shareOfSurrounding(bool any, double others, bool found) {
    if (!any || found)
        return 0;
    return others > 0 ? surroundingShare : 1;
}

/// Broken estimates become black, broken cones the whole sphere.
InfiniteLight sound(InfiniteLight light) {
    if (!(light.irradiance > 0 && std::isfinite(light.irradiance)))
        light.irradiance = 0;
    double length = candela::length(light.axis);
    if (!(std::abs(length - 1) < 1e-3 && light.cosHalfAngle >= 0))
        light.everywhere = true;
    light.cosHalfAngle = std::min(light.cosHalfAngle, 1.0f);
    return light;
}

/// A probability that isn't 0 stays so as a float.
float rounded(double p) { return p > 0 ? std::max(float(p), 0x1p-126f) : 0; }

/// Makes x, uniform in [low, low + share), uniform in [0,1).
double stretched(double x, double low, double share) {
    return std::clamp((x - low) / share, 0.0, largestBelow1);
}

/// Moves `u` to within the chosen light's share; `sum` is the irradiance of all, above 0.
int pick(std::span<const InfiniteLight> lights, const Normal &n, double sum, double &u,
         double &probability) {
    int chosen = -1;
    double low = 0, next = 0;
    for (int k = 0; k < int(lights.size()) && (chosen < 0 || u >= next); ++k) {
        double share = irradiance(lights[k], n) / sum;
        if (!(share > 0))
            continue;
        chosen = k, probability = share, low = next, next += share;
    }
    u = stretched(u, low, probability);
    return chosen;
}

} // namespace

LightChoice::LightChoice(std::span<const EmitterBound> bounds,
                         std::span<const std::int32_t> finiteSources,
                         std::span<const InfiniteLight> infinite, int sourceCount,
                         const SurroundingLight &surrounding)
    : tree_(bounds), finiteSources_(finiteSources.begin(), finiteSources.end()),
      surrounding_(surrounding), places_(sourceCount, -1) {
    for (std::size_t i = 0; i < finiteSources_.size(); ++i)
        places_[finiteSources_[i]] = std::int32_t(i);
    for (const InfiniteLight &light : infinite) {
        places_[light.source] = std::int32_t(tree_.size() + infinite_.size());
        infinite_.push_back(sound(light));
    }
    if (!isSurrounded())
        return;
    places_[surrounding_.source] = std::int32_t(tree_.size() + infinite_.size());
    std::vector<EmitterBound> all(bounds.begin(), bounds.end());
    std::vector<std::int32_t> sources = finiteSources_;
    if (surrounding_.bound.power > 0)
        all.push_back(surrounding_.bound), sources.push_back(surrounding_.source);
    outside_ = std::make_unique<const LightChoice>(all, sources, infinite, sourceCount);
}

bool LightChoice::isOutside(const float *const P[3], int i) const {
    if (!isSurrounded())
        return false;
    const Vec3 off = Vec3{P[0][i], P[1][i], P[2][i]} - surrounding_.centre;
    return !(dot(off, off) < surrounding_.radius * surrounding_.radius);
}

LightChoice::Shares LightChoice::sharesAt(const float *const P[3], const float *const N[3],
                                          bool found) const {
    double finite;
    const double infinite = irradiance(infinite_, normalAt(N, 0));
    tree_.irradiance(1, P, N, &finite);
    return {infinite, shareOfSurrounding(isSurrounded(), infinite + finite, found),
            infiniteShare(infinite, finite)};
}

void LightChoice::choose(int count, const float *const P[3], const float *const N[3], double *u,
                         std::int32_t *source, float *probability, const float *scattered) const {
    if (isSingle(nullptr, 0)) {
        lanes::fill(count, single(), source);
        lanes::fill(count, 1.0f, probability);
        return;
    }
    if (onlyTree()) {
        tree_.choose(count, P, N, u, source, probability);
        for (int i = 0; i < count; ++i)
            source[i] = source[i] < 0 ? -1 : finiteSources_[source[i]];
        return;
    }
    for (int i = 0; i < count; ++i) {
        const float *const p[3] = {P[0] + i, P[1] + i, P[2] + i};
        const float *const n[3] = {N[0] + i, N[1] + i, N[2] + i};
        if (isOutside(P, i)) {
            outside_->choose(1, p, n, u + i, source + i, probability + i);
            continue;
        }
        if (isSingle(scattered, i)) {
            source[i] = single(), probability[i] = 1;
            continue;
        }
        const auto [infinite, around, share] = sharesAt(p, n, scattered && scattered[i] > 0);
        u[i] = u[i] >= 0 ? std::min(u[i], largestBelow1) : 0;
        if (u[i] < around) {
            u[i] = stretched(u[i], 0, around);
            source[i] = surrounding_.source;
            probability[i] = rounded(around);
            continue;
        }
        u[i] = stretched(u[i], around, 1 - around);
        if (u[i] < share) {
            double within = 0;
            u[i] = stretched(u[i], 0, share);
            source[i] = infinite_[pick(infinite_, normalAt(N, i), infinite, u[i], within)].source;
            probability[i] = rounded((1 - around) * (share * within));
            continue;
        }
        float within;
        std::int32_t emitter;
        u[i] = stretched(u[i], share, 1 - share);
        tree_.choose(1, p, n, u + i, &emitter, &within);
        source[i] = emitter < 0 ? -1 : finiteSources_[emitter];
        probability[i] = rounded((1 - around) * ((1 - share) * within));
    }
}

void LightChoice::probability(int count, const float *const P[3], const float *const N[3],
                              const std::int32_t *source, float *probability,
                              const float *scattered) const {
    if (onlyTree()) {
        thread_local Scratch<std::int32_t> own;
        std::int32_t *emitter = own.get(count);
        for (int i = 0; i < count; ++i)
            emitter[i] = placeOf(source[i]);
        return tree_.probability(count, P, N, emitter, probability);
    }
    const int others = tree_.size() + int(infinite_.size());
    for (int i = 0; i < count; ++i) {
        const float *const p[3] = {P[0] + i, P[1] + i, P[2] + i};
        const float *const n[3] = {N[0] + i, N[1] + i, N[2] + i};
        if (isOutside(P, i)) {
            outside_->probability(1, p, n, source + i, probability + i);
            continue;
        }
        probability[i] = isSingle(scattered, i) && source[i] == single() ? 1.0f : 0.0f;
        if (isSingle(scattered, i))
            continue;
        const std::int32_t place = placeOf(source[i]);
        if (place < 0)
            continue;
        const auto [infinite, around, share] = sharesAt(p, n, scattered && scattered[i] > 0);
        if (place >= others) {
            probability[i] = rounded(around);
            continue;
        }
        if (place >= tree_.size()) {
            double one = irradiance(infinite_[place - tree_.size()], normalAt(N, i));
            probability[i] = infinite > 0 ? rounded((1 - around) * (share * (one / infinite))) : 0;
            continue;
        }
        float within;
        tree_.probability(1, p, n, &place, &within);
        probability[i] = rounded((1 - around) * ((1 - share) * within));
    }
}

} // namespace candela
