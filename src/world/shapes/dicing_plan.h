// SPDX-License-Identifier: Apache-2.0
// One budget for the dicing of a whole scene, and rates that neighbours share.
#pragma once

#include "world/camera/camera.h"
#include "world/shapes/dice_rate.h"
#include "world/shapes/shape.h"

#include <span>
#include <vector>

namespace candela {

/// No scene is diced into more triangles of curved surfaces than this; polygons come as they are.
inline constexpr double dicingBudget = 12e6;

class DicingPlan {
public:
    explicit DicingPlan(const Camera &);

    /// The next shape stands in the world, or moves there (`steps` from where it stands).
    void add(const Shape &, float shadingRate, std::span<const Matrix4> steps = {});
    /// The next shape is of an object, whose nearest placement sees a pixel as so many units of the
    /// object's space. Shapes of one object stand together: `object` numbers them, from 1.
    void add(const Shape &, float shadingRate, float pixel, std::uint32_t object);
    /// Lights are met by rays and sampled: their outlines must hold also where they are small.
    void makeFine(std::uint32_t number, const Shape &);

    /// Units of an object's space that a pixel spans where the placed bound is nearest.
    float nearestPixel(const Box3 &objectBound, const Matrix4 &currentFromObject) const;

    /// Dices all shapes, which must be those that were added.
    std::vector<RayShape> dice(std::vector<Shape> &) const;

private:
    struct Wish {
        Box3 box;             ///< In the outer space.
        float pixel;          ///< Outer units.
        std::uint32_t object; ///< 0: it stands in the world.
        bool isCurved;
        float edge; ///< Displaced: how long edges may be, in pixels (of objects: outer units).
        bool fine = false;
        bool moves = false;
        bool inWorld() const { return object == 0; }
    };
    float pixelOfParts(const Shape &, const Box3 &) const;
    float leniency(const Shape &, const Wish &, float known) const;
    std::vector<float> sharedPixels() const;
    DiceRate rateOf(const Shape &, const Wish &, float pixel, double coarsening) const;
    double coarseningFor(const std::vector<Shape> &, const std::vector<float> &pixels) const;
    void diceDisplaced(std::vector<Shape> &, std::vector<DicedMesh> begun,
                       std::vector<RayShape> &) const;

    const Camera &camera_;
    std::vector<Wish> wishes_;
};

} // namespace candela
