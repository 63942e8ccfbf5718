// SPDX-License-Identifier: Apache-2.0
#include "world/shapes/dicing_plan.h"

#include "foundation/base/parallel.h"
#include "world/shapes/dice_rate.h"
#include "world/shapes/displaced_dicing.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

namespace candela {

namespace {

/// The parts that shapes near the eye are looked at in keep to them by this share of their size.
constexpr float partChord = 5e-3f;

/// Outlines of lights keep this share of their size.
constexpr float lightChord = 2e-4f;

float squareRootOf(float shadingRate) {
    return shadingRate > 0 && std::isfinite(shadingRate)
               ? std::sqrt(std::max(shadingRate, finestShadingRate))
               : 1;
}

bool touch(const Box3 &a, const Box3 &b) {
    for (int axis = 0; axis < 3; ++axis) {
        float slack = 1e-6f * (std::fabs(a.high[axis]) + std::fabs(a.low[axis]));
        if (a.high[axis] + slack < b.low[axis] || b.high[axis] + slack < a.low[axis])
            return false;
    }
    return true;
}

} // namespace

DicingPlan::DicingPlan(const Camera &camera) : camera_(camera) {}

float DicingPlan::nearestPixel(const Box3 &bound, const Matrix4 &currentFromObject) const {
    const float stretch = largestStretch(currentFromObject);
    const float pixel = viewingPixel(camera_, transformBox(currentFromObject, bound));
    return stretch > 0 ? pixel / stretch : pixel;
}

/// Its triangles depend on the rate.
static bool isCurved(const Shape &shape) { return !shape.surface->isFlat() && !isMetRound(shape); }

void DicingPlan::add(const Shape &shape, float shadingRate, std::span<const Matrix4> steps) {
    const Box3 box = transformBox(shape.outerFromShape, shape.surface->bound());
    const Vec3 extent = box.extent();
    float guess = viewingPixel(camera_, box);
    for (const Matrix4 &step : steps)
        guess = std::min(guess, nearestPixel(box, step));
    const bool isNear =
        steps.empty() && box.high.z > 0 && box.low.z < std::max({extent.x, extent.y, extent.z});
    const float known = isNear && isCurved(shape) ? pixelOfParts(shape, box) : guess;
    add(shape, shadingRate, std::max(guess, known), 0);
    Wish &wish = wishes_.back();
    wish.edge = displacedEdgePixels * squareRootOf(shadingRate);
    wish.moves = !steps.empty();
    if (box.low.z <= 0)
        wish.pixel *= leniency(shape, wish, known / std::max(guess, known));
}

/// The pixel at what the frame shows of a shape whose box, near or around the eye, says little of
/// where the shape is: the least of its parts'.
float DicingPlan::pixelOfParts(const Shape &shape, const Box3 &box) const {
    const Vec3 extent = shape.surface->bound().extent();
    const float size = std::max({extent.x, extent.y, extent.z});
    const DicedMesh parts = shape.surface->dice({4 * size, partChord * size});
    const float chord = parts.chordError * largestStretch(shape.outerFromShape);
    const Vec3 margin{chord, chord, chord};
    float least = unseenPixel(box);
    for (const auto &triangle : parts.triangles) {
        Box3 part;
        for (std::uint32_t corner : triangle) {
            const Vec3 p = transformPoint(shape.outerFromShape, parts.positions[corner]);
            part.add(p - margin), part.add(p + margin);
        }
        if (camera_.shownDepth(part))
            least = std::min(least, viewingPixel(camera_, part));
    }
    return least;
}

/// Skies and halls are large, and mostly out of sight: beyond some number of triangles their error
/// grows, to half a pixel at most. `known`: how many of the wish's pixels a pixel is.
float DicingPlan::leniency(const Shape &shape, const Wish &wish, float known) const {
    const double mostLenient = std::max(0.5f / chordPixels * known, 1.0f);
    constexpr double enough = 1 << 14;
    const double triangles = shape.surface->triangleCount(rateOf(shape, wish, wish.pixel, 1));
    return float(std::clamp(triangles / enough, 1.0, mostLenient));
}

void DicingPlan::add(const Shape &shape, float shadingRate, float pixel, std::uint32_t object) {
    const Box3 box = transformBox(shape.outerFromShape, shape.surface->bound());
    const float rated = pixel * squareRootOf(shadingRate);
    wishes_.push_back({box, rated, object, isCurved(shape), displacedEdgePixels * rated});
}

void DicingPlan::makeFine(std::uint32_t number, const Shape &shape) {
    wishes_[number].fine = true;
    wishes_[number].isCurved = isCurved(shape);
}

/// On a ladder of powers of two, and no coarser than those that it touches ask for, within a factor
/// of eight: bodies made of several primitives close where these share a rim.
std::vector<float> DicingPlan::sharedPixels() const {
    std::vector<float> pixels;
    for (const Wish &wish : wishes_)
        pixels.push_back(wish.pixel > 0 && std::isfinite(wish.pixel)
                             ? std::exp2(std::floor(std::log2(wish.pixel)))
                             : wish.pixel);
    std::vector<std::uint32_t> order;
    for (std::uint32_t i = 0; i < wishes_.size(); ++i)
        if (wishes_[i].isCurved)
            order.push_back(i);
    std::ranges::sort(order, {}, [&](std::uint32_t i) {
        return std::pair(!wishes_[i].inWorld(), wishes_[i].box.low.x);
    });
    constexpr int rounds = 4;
    constexpr std::size_t neighbours = 64; // As far as it looks along the order.
    for (int round = 0; round < rounds; ++round)
        for (std::size_t a = 0; a < order.size(); ++a)
            for (std::size_t b = a + 1; b < std::min(order.size(), a + 1 + neighbours); ++b) {
                const Wish &one = wishes_[order[a]], &other = wishes_[order[b]];
                if (one.object != other.object || !touch(one.box, other.box))
                    continue;
                float &p = pixels[order[a]], &q = pixels[order[b]];
                const float least = std::min(p, q);
                if (std::max(p, q) <= 8 * least)
                    p = q = least;
            }
    return pixels;
}

DiceRate DicingPlan::rateOf(const Shape &shape, const Wish &wish, float pixel,
                            double coarsening) const {
    const Vec3 extent = shape.surface->bound().extent();
    const float size = std::max({extent.x, extent.y, extent.z, 1e-30f});
    const float stretch = largestStretch(shape.outerFromShape);
    if (!(stretch > 0) || !std::isfinite(pixel) || !(pixel > 0))
        return {size / 16, size / 1000};
    // Hits are named and evaluated on the true surface: edges may be as long as they like. Finer
    // than a float's rounding means nothing.
    DiceRate rate;
    rate.edgeLength = 4 * size;
    rate.chordError = std::max(chordPixels * pixel / stretch, size * 1e-7f);
    if (wish.fine)
        rate.chordError = std::min(rate.chordError, lightChord * size);
    rate.chordError *= float(coarsening);
    return rate;
}

/// The factor by which chord errors must grow for the budget.
double DicingPlan::coarseningFor(const std::vector<Shape> &shapes,
                                 const std::vector<float> &pixels) const {
    auto triangles = [&](double coarsening) {
        double sum = 0;
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (wishes_[i].isCurved)
                sum += shapes[i].surface->triangleCount(
                    rateOf(shapes[i], wishes_[i], pixels[i], coarsening));
        return sum;
    };
    double coarsening = 1;
    while (triangles(coarsening) > dicingBudget && coarsening < 1e12)
        coarsening *= 2;
    return coarsening;
}

std::vector<RayShape> DicingPlan::dice(std::vector<Shape> &shapes) const {
    const std::vector<float> pixels = sharedPixels();
    const double coarsening = coarseningFor(shapes, pixels);
    std::vector<RayShape> meshes(shapes.size());
    std::vector<DicedMesh> begun(shapes.size());
    parallelFor(shapes.size(), [&](std::size_t i) {
        const DiceRate rate = rateOf(shapes[i], wishes_[i], pixels[i], coarsening);
        // Instances stand anywhere, and so does what moves: that is not cut for the eye.
        const Vec3 eye{};
        if (shapes[i].displacement)
            begun[i] = shapes[i].surface->dice(rate);
        else
            meshes[i] = candela::dice(shapes[i], rate,
                                      wishes_[i].inWorld() && !wishes_[i].moves ? &eye : nullptr);
    });
    diceDisplaced(shapes, std::move(begun), meshes);
    return meshes;
}

/// The world's together, and each object's.
void DicingPlan::diceDisplaced(std::vector<Shape> &shapes, std::vector<DicedMesh> begun,
                               std::vector<RayShape> &meshes) const {
    std::map<std::uint32_t, std::vector<std::size_t>> together; // By object.
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (shapes[i].displacement)
            together[wishes_[i].object].push_back(i);
    double left = displacedBudget;
    for (const auto &[object, members] : together) {
        std::vector<DisplacedDicing> dicings;
        for (std::size_t i : members)
            dicings.push_back({&shapes[i], std::move(begun[i]), wishes_[i].edge});
        auto diced = candela::diceDisplaced(dicings, object == 0 ? &camera_ : nullptr, left);
        for (std::size_t k = 0; k < members.size(); ++k) {
            left -= double(diced[k].triangles.size());
            meshes[members[k]] = std::move(diced[k]);
        }
    }
}

} // namespace candela
