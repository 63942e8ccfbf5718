// SPDX-License-Identifier: Apache-2.0
// A binary tree over emitters, from which points choose one by what it may send them
// (Conty Estevez and Kulla 2018, without splitting).
#pragma once

#include "foundation/base/box3.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candela {

/// What is known of an emitter. Angles in radians, 0 to pi.
///
/// Its intensity is estimated as power / (the solid angle it may light, weighted by the cosine with
/// the nearest normal): power / (4 pi) with normals in all directions, power / pi for one normal
/// and an emission spread of pi / 2 (Lambertian), power / (2 pi) for one normal and a spread above
/// pi / 2, which stands for Lambertian on both sides.
struct EmitterBound {
    Box3 box;                 ///< Metres.
    Vec3 axis;                ///< Unit vector; zero stands for normals in all directions.
    float normalSpread = 0;   ///< Largest angle of its normals with the axis.
    float emissionSpread = 0; ///< Largest angle to a normal in which light is sent.
    float power = 0;          ///< Watts.
};

class LightTree {
public:
    explicit LightTree(std::span<const EmitterBound> emitters);
    int size() const { return int(trails_.size()); }

    /// Picks an emitter for each point P. N is the unit normal of the side that receives, or zero
    /// where light from all sides counts. `u` is uniform in [0,1) before and after; it is a double
    /// because 24 bits are too few to tell a million emitters apart and still be uniform.
    /// Emitter -1, probability 0: the bounds say that nothing below the chosen branch shines here.
    /// So the emitters' probabilities sum to 1 less the share of such branches.
    void choose(int count, const float *const P[3], const float *const N[3], double *u,
                std::int32_t *emitter, float *probability) const;

    /// The probability with which choose() picks emitter[i]: bit for bit the same. -1 gives 0.
    void probability(int count, const float *const P[3], const float *const N[3],
                     const std::int32_t *emitter, float *probability) const;

    /// An estimate of the irradiance of all emitters together, W m^-2. 0 only if the bounds say
    /// that nothing shines here; there choose() gives -1.
    void irradiance(int count, const float *const P[3], const float *const N[3],
                    double *irradiance) const;

    /// Bounds of a subtree, prepared for the walk. The first child follows its parent.
    struct Node {
        Vec3 centre, half; ///< Of the box.
        Vec3 axis;
        float cosNormal, sinNormal, cosEmission;
        float intensity;   ///< Watts per steradian, see EmitterBound. 0 only if black.
        std::int32_t link; ///< The second child, or ~emitter in a leaf.
    };

private:
    std::vector<Node> nodes_;
    std::vector<std::uint64_t> trails_; ///< By emitter: from the root, bit 0 first, 1 = second.
};

} // namespace candela
