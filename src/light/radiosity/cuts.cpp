// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/cuts.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <cmath>

namespace candela::radiosity {

namespace {

/// Rays run above an element by this share of its radius,
constexpr float height = 0.01f;
/// and off its edges, where other surfaces meet it.
constexpr float inset = 0.01f;

/// Around the element and across it: rays from each corner to those behind it.
template <class Serve> void forEachWay(const Mesh &mesh, int e, const Serve &serve) {
    const Element &element = mesh.element(e);
    const std::size_t corners = Basis::corners(mesh.basis(e).isTriangle()).size();
    const auto at = [&](std::size_t k) {
        return element.corners[k] + (element.centre - element.corners[k]) * inset;
    };
    for (std::size_t k = 0; k < corners; ++k)
        for (std::size_t l = k + 1; l < corners; ++l)
            serve(at(k), at(l));
    for (std::size_t k = 0; k < corners; ++k)
        serve(element.centre, at(k));
}

} // namespace

GroundRays::GroundRays()
    : rays_(capacity), transmittance_(colorSamples, capacity), isStopped_(capacity) {}

void GroundRays::add(const Mesh &mesh, int e, Vec3 from, Vec3 to) {
    const Element &element = mesh.element(e);
    const float off = mesh.domainOf(e).offset + height * element.radius;
    const int ray = rays_.count++;
    for (int c = 0; c < 3; ++c) {
        rays_.origin[c][ray] = from[c] + off * element.normal[c];
        rays_.direction[c][ray] = to[c] - from[c];
    }
    rays_.tMin[ray] = 0, rays_.tMax[ray] = 1;
    rays_.time[ray] = mesh.scene().options().camera.shutterOpen;
    rays_.width[ray] = 0, rays_.spread[ray] = 0;
}

void GroundRays::trace(const Scene &scene) {
    float *planes[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        planes[c] = transmittance_[c];
    const int colors = scene.transmittance(rays_, planes) ? colorSamples : 1;
    for (int i = 0; i < rays_.count; ++i) {
        bool isStopped = true;
        for (int c = 0; c < colors; ++c)
            isStopped &= !(planes[c][i] > 0);
        isStopped_[std::size_t(i)] = isStopped;
    }
}

std::vector<std::uint8_t> cutElements(const Mesh &mesh, int first) {
    std::vector<std::uint8_t> cut(std::size_t(mesh.size() - first), 0);
    constexpr std::size_t batch = GroundRays::capacity / 10; // Squares have ten ways.
    parallelFor((cut.size() + batch - 1) / batch, [&](std::size_t b) {
        thread_local GroundRays rays;
        rays.clear();
        std::vector<std::size_t> owner;
        for (std::size_t k = b * batch; k < std::min((b + 1) * batch, cut.size()); ++k)
            if (const int e = first + int(k); mesh.element(e).isPlane)
                forEachWay(mesh, e, [&](Vec3 from, Vec3 to) {
                    rays.add(mesh, e, from, to);
                    owner.push_back(k);
                });
        rays.trace(mesh.scene());
        for (std::size_t i = 0; i < owner.size(); ++i)
            cut[owner[i]] |= rays.isStopped(int(i));
    });
    return cut;
}

std::vector<Sides> sidesOf(const Mesh &mesh, std::span<const int> parents) {
    std::vector<Sides> sides(parents.size());
    constexpr std::size_t ways = Basis::children * mostNodes * mostNodes;
    constexpr std::size_t batch = GroundRays::capacity / ways;
    parallelFor((parents.size() + batch - 1) / batch, [&](std::size_t b) {
        thread_local GroundRays rays;
        struct Way {
            std::int8_t &side;
            int node;
            float distance;
        };
        std::vector<Way> asked;
        rays.clear();
        for (std::size_t p = b * batch; p < std::min((b + 1) * batch, parents.size()); ++p) {
            sides[p].fill(-1);
            const std::span<const Node> to = mesh.nodes(parents[p]);
            for (int c = 0; c < Basis::children; ++c) {
                const int child = mesh.element(parents[p]).firstChild + c;
                for (std::size_t i = 0; i < to.size(); ++i)
                    for (std::size_t j = 0; j < to.size(); ++j) {
                        const Vec3 from = mesh.nodes(child)[i].P;
                        asked.push_back({sides[p][std::size_t(c) * mostNodes + i], int(j),
                                         length(to[j].P - from)});
                        rays.add(mesh, child, from, to[j].P);
                    }
            }
        }
        rays.trace(mesh.scene());
        float nearest = INFINITY;
        for (std::size_t k = 0; k < asked.size(); ++k) {
            Way &way = asked[k];
            if (k == 0 || &way.side != &asked[k - 1].side)
                nearest = INFINITY;
            if (!rays.isStopped(int(k)) && way.distance < nearest)
                nearest = way.distance, way.side = std::int8_t(way.node);
        }
    });
    return sides;
}

} // namespace candela::radiosity
