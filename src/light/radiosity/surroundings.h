// SPDX-License-Identifier: Apache-2.0
// What shaders make of light around the nodes of elements: a texture that is finer than elements is
// known by its mean there, whatever the nodes themselves meet of it.
#pragma once

#include "light/radiosity/lamps.h"
#include "light/radiosity/points.h"
#include "light/radiosity/response.h"

#include <functional>

namespace candela::radiosity {

/// Asks points of a batch, and returns the planes that have the answers, until the next question.
using PointQuestion =
    std::function<std::span<float *const>(const SurfacePlaces &, const Vec3Planes &Ng)>;

/// One a thread.
class Surroundings {
public:
    static constexpr int capacity = ResponseQuestion::capacity;

    /// Elements of one code, whose nodes have been asked: value[plane][node], element after element
    /// as PointBatch::addNodes() has them. Nodes get the mean of those of `count` points of their
    /// element that are nearest to them; `seed` scatters these. All points count, whatever they
    /// find: looking closer where something has been found would make what is rare rarer.
    void average(const Mesh &, std::span<const int> elements, int count, const PointQuestion &,
                 std::uint32_t seed, std::span<float *const> value);

private:
    void scatter(const Mesh &, int element, int count, std::uint32_t seed);
    std::span<float *const> answers(const Mesh &, const PointQuestion &);
    void takeMeans(int nodes, int firstPoint, int count, std::span<float *const> found,
                   int firstNode, std::span<float *const> value) const;

    PointBatch points_;
    std::vector<int> nearest_; ///< Of each point: the node.
};

} // namespace candela::radiosity
