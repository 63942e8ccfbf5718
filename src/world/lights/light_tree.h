// SPDX-License-Identifier: Apache-2.0
// A tree over emitters, from which points choose one by what it may send them (Conty Estevez and
// Kulla 2018, without splitting). Nodes have up to eight children, which are weighed at once.
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
    /// Light may also be sent beyond the emission spread, though hardly any: there the emitter is
    /// chosen rarely instead of never.
    bool isLoose = false;
};

class LightTree {
public:
    explicit LightTree(std::span<const EmitterBound> emitters);
    int size() const { return int(leaves_.size()); }

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

    /// Bounds of the children, in planes.
    struct alignas(64) Node {
        static constexpr int width = 8;
        using Plane = float[width];
        Plane centre[3]{}, half[3]{}; ///< Of the box.
        Plane axis[3]{};
        Plane cosNormal{}, sinNormal{}, cosEmission{};
        /// What the cosine at the emitter counts at least beyond the emission spread.
        Plane beyond{};
        Plane backs{};     ///< 1: they shine as fronts do.
        Plane intensity{}; ///< In units of unit_ watts per steradian, see EmitterBound. 0 = black.
        std::int32_t link[width]{}; ///< A node, or ~emitter.
        std::int32_t parent = -1, slot = 0;
    };

private:
    friend class LightTreeBuilder;
    /// The first has one child, which bounds all.
    std::vector<Node> nodes_;
    struct Leaf {
        std::int32_t node, slot;
    };
    std::vector<Leaf> leaves_; ///< By emitter.
    double unit_ = 1;
};

} // namespace candela
