// SPDX-License-Identifier: Apache-2.0
// The choice of one light for each point among the lights of a set: those that have a place by a
// light tree, those infinitely far by the irradiance they give, and one that shines from all around
// those within it.
#pragma once

#include "world/lights/light_tree.h"

#include <memory>

namespace candela {

/// A light without a place: a dome or a sun.
struct InfiniteLight {
    std::int32_t source = 0; ///< Its number among the scene's sources of light.
    float irradiance = 0;    ///< Estimate, W m^-2, on a surface that faces it. 0 = never chosen.
    bool everywhere = true;  ///< Light may come from all directions; what follows is not read.
    Vec3 axis;               ///< Unit vector towards the middle of the directions it shines from.
    float cosHalfAngle = 1;  ///< Of the cone of these directions; at least 0.
};

/// A light on a sphere, which shines from all around on what is within it, and is like any other to
/// what is not.
struct SurroundingLight {
    std::int32_t source = -1; ///< Its number; -1 = there is no such light.
    EmitterBound bound;
    Vec3 centre;
    float radius = 0;
};

/// Sources are named by the scene's numbers. An instance doesn't change: any thread may ask.
class LightChoice {
public:
    /// `bounds[i]`, with power in watts, is what is known of source `finiteSources[i]`. All numbers
    /// lie in [0, sourceCount) and differ. Scattered rays find the `surrounding` light at least as
    /// well, so that it is not picked within it where such rays are sent.
    LightChoice(std::span<const EmitterBound> bounds, std::span<const std::int32_t> finiteSources,
                std::span<const InfiniteLight> infinite, int sourceCount,
                const SurroundingLight &surrounding = {});

    /// Picks a source for each point P. Where there is but one, and that finite, it is picked,
    /// whether it shines there or not. N is the unit normal of the side that receives, or zero
    /// where light from all sides counts. `u` is uniform in [0,1) before and after. `scattered` > 0
    /// says that rays are scattered from P, which may find light, too; null: none are. Source -1,
    /// probability 0: nothing that might have been picked shines here (see LightTree::choose).
    void choose(int count, const float *const P[3], const float *const N[3], double *u,
                std::int32_t *source, float *probability, const float *scattered = nullptr) const;

    /// The probability with which choose() picks source[i]: bit for bit the same. 0 for sources
    /// that aren't in the set, and for -1. Where one source alone may shine it is exactly 1.
    void probability(int count, const float *const P[3], const float *const N[3],
                     const std::int32_t *source, float *probability,
                     const float *scattered = nullptr) const;

private:
    /// What a point chooses between: irradiance of the infinite ones, the share of what surrounds
    /// it, and of the rest that of the infinite ones.
    struct Shares {
        double infinite, around, share;
    };
    /// One point's; `found`: scattered rays find what surrounds.
    Shares sharesAt(const float *const P[3], const float *const N[3], bool found) const;
    bool isSurrounded() const { return surrounding_.source >= 0; }
    /// Point i has no light around it: those without have a choice of their own.
    bool isOutside(const float *const P[3], int i) const;
    /// True if one finite source is all that point i, within what surrounds, may pick.
    bool isSingle(const float *scattered, int i) const {
        return tree_.size() == 1 && infinite_.empty() &&
               (!isSurrounded() || (scattered && scattered[i] > 0));
    }
    std::int32_t placeOf(std::int32_t source) const {
        const bool known = source >= 0 && source < std::int32_t(places_.size());
        return known ? places_[source] : -1;
    }
    /// True if all that can be picked are several finite sources.
    bool onlyTree() const { return infinite_.empty() && !isSurrounded() && tree_.size() != 1; }
    std::int32_t single() const { return finiteSources_.front(); }

    LightTree tree_;
    std::vector<std::int32_t> finiteSources_; ///< By the tree's emitter.
    std::vector<InfiniteLight> infinite_;
    SurroundingLight surrounding_;
    std::unique_ptr<const LightChoice> outside_; ///< What is chosen from outside of that.
    std::vector<std::int32_t> places_; ///< By source: emitter, or size of the tree + infinite, or
                                       ///< beyond all these: what surrounds; -1.
};

} // namespace candela
