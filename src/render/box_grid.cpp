// SPDX-License-Identifier: Apache-2.0
#include "render/box_grid.h"

#include "world/shading/shader_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela {

namespace {

constexpr int pointsAlong = 8, pointCount = pointsAlong * pointsAlong;

/// What the shader is told of the place (u, v) of the square.
void put(BoxBounds &boxes, int lane, float u, float v) {
    boxes.set(ShaderInput::P, lane, {2 * u - 1, 1 - 2 * v, 0});
    boxes.set(ShaderInput::N, lane, {0, 0, -1});
    boxes.set(ShaderInput::Ng, lane, {0, 0, -1});
    boxes.set(ShaderInput::fieldAxis, lane, {0, 0, -1});
    boxes.set(ShaderInput::I, lane, {0, 0, 1});
    boxes.set(ShaderInput::dPdu, lane, {2, 0, 0});
    boxes.set(ShaderInput::dPdv, lane, {0, -2, 0});
    boxes.set(ShaderInput::orientation, lane, {1});
    for (ShaderInput across : {ShaderInput::u, ShaderInput::s})
        boxes.set(across, lane, {u});
    for (ShaderInput down : {ShaderInput::v, ShaderInput::t})
        boxes.set(down, lane, {v});
    boxes.set(ShaderInput::dsdu, lane, {1});
    boxes.set(ShaderInput::dtdv, lane, {1});
    boxes.set(ShaderInput::Cs, lane, {1, 1, 1});
    boxes.set(ShaderInput::Os, lane, {1, 1, 1});
}

/// One of the three quantities, as layers.
struct Layers {
    NamedPlanes value, byU, byV, tolerance, deviation;
};

Layers layersOf(const std::string &name, std::size_t boxes) {
    const auto planes = [&](const std::string &what) {
        return NamedPlanes{name + what,
                           std::vector(std::size_t(colorSamples), std::vector<float>(boxes))};
    };
    return {planes(""), planes(" by u"), planes(" by v"), planes(" tolerance"),
            planes(" deviation")};
}

} // namespace

std::vector<NamedPlanes> boundsOfBoxes(const ShaderInstance &instance, int width, int height) {
    const float Du = 1 / float(width), Dv = 1 / float(height);
    BoxBounds row(instance, width), points(instance, pointCount);
    const std::size_t count = std::size_t(width) * std::size_t(height);
    std::array<Layers, 3> layers{layersOf("reflectance", count), layersOf("Ce", count),
                                 layersOf("Oi", count)};
    for (BoxBounds *boxes : {&row, &points}) {
        std::fill_n(boxes->plane(ShaderInput::du), boxes == &row ? width : pointCount, Du);
        std::fill_n(boxes->plane(ShaderInput::dv), boxes == &row ? width : pointCount, Dv);
    }
    std::fill_n(row.plane(ShaderInput::Du), width, Du);
    std::fill_n(row.plane(ShaderInput::Dv), width, Dv);
    const auto offset = [](int k, float side) {
        return (float(k) / float(pointsAlong - 1) - 0.5f) * side;
    };
    for (int y = 0; y < height; ++y) {
        const float v = (float(y) + 0.5f) * Dv;
        for (int x = 0; x < width; ++x)
            put(row, x, (float(x) + 0.5f) * Du, v);
        row.ask(width);
        const BoundPlanes bounds[] = {row.reflectance(), row.emission(), row.opacity()};
        for (int x = 0; x < width; ++x) {
            for (int n = 0; n < pointCount; ++n)
                put(points, n, (float(x) + 0.5f) * Du + offset(n % pointsAlong, Du),
                    v + offset(n / pointsAlong, Dv));
            points.askValues(pointCount);
            const BoundPlanes values[] = {points.reflectance(), points.emission(),
                                          points.opacity()};
            const std::size_t at = std::size_t(y) * std::size_t(width) + std::size_t(x);
            for (std::size_t q = 0; q < layers.size(); ++q)
                for (std::size_t c = 0; c < std::size_t(colorSamples); ++c) {
                    Layers &to = layers[q];
                    to.value.planes[c][at] = bounds[q].value[c][x];
                    to.byU.planes[c][at] = bounds[q].byU[c][x];
                    to.byV.planes[c][at] = bounds[q].byV[c][x];
                    to.tolerance.planes[c][at] = bounds[q].tolerance[c][x];
                    float most = 0;
                    for (int n = 0; n < pointCount; ++n)
                        most = std::max(
                            most, std::fabs(values[q].value[c][n] - bounds[q].value[c][x] -
                                            bounds[q].byU[c][x] * offset(n % pointsAlong, Du) -
                                            bounds[q].byV[c][x] * offset(n / pointsAlong, Dv)));
                    to.deviation.planes[c][at] = most;
                }
        }
    }
    std::vector<NamedPlanes> all;
    for (Layers &quantity : layers)
        for (NamedPlanes *layer : {&quantity.value, &quantity.byU, &quantity.byV,
                                   &quantity.tolerance, &quantity.deviation})
            all.push_back(std::move(*layer));
    return all;
}

} // namespace candela
