// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/lamps.h"

#include "light/radiosity/points.h"
#include "light/vertex/surface_vertices.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Cosine with the normal, and turn about it, of the directions that are compared.
constexpr std::array<float, 2> directions[] = {{1, 0}, {0.7f, 0.1f}, {0.7f, 0.6f}, {0.3f, 0.35f}};
/// Radiance differs by less than this share.
constexpr float alike = 1e-3f;

} // namespace

EmissionQuestion::EmissionQuestion()
    : vertices_(capacity), I_(3, capacity), first_(colorSamples, capacity),
      other_(colorSamples, capacity) {
    vertices_.speak(false);
}

void EmissionQuestion::askAlong(const Scene &scene, int code, const SurfacePlaces &places,
                                const Vec3Planes &Ng, std::array<float, 2> direction,
                                float *const *radiance) {
    const Vec3Planes I{I_[0], I_[1], I_[2]};
    const auto [cosine, turn] = direction;
    const float sine = std::sqrt(1 - cosine * cosine);
    for (int i = 0; i < places.count; ++i) {
        Vec3 s, t;
        orthonormalBasis(Ng.get(i), s, t);
        I.set(i, -(Ng.get(i) * cosine + s * (sine * std::cos(2 * pi * turn)) +
                   t * (sine * std::sin(2 * pi * turn))));
    }
    vertices_.place(scene, code, places, I, scene.options().camera.shutterOpen);
    for (int c = 0; c < colorSamples; ++c)
        std::fill_n(radiance[c], places.count, 0.0f);
    scene.lights().emission(code, vertices_.points, radiance);
}

void EmissionQuestion::ask(const Scene &scene, int code, const SurfacePlaces &places,
                           const Vec3Planes &Ng, float *const *exitance) {
    askAlong(scene, code, places, Ng, directions[0], exitance);
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < places.count; ++i) {
            const float value = exitance[c][i] * pi;
            exitance[c][i] = std::isfinite(value) ? std::max(value, 0.0f) : 0.0f;
        }
}

bool EmissionQuestion::isTheSameInAllDirections(const Scene &scene, int code,
                                                const SurfacePlaces &places, const Vec3Planes &Ng) {
    float *first[colorSamples], *other[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        first[c] = first_[c], other[c] = other_[c];
    askAlong(scene, code, places, Ng, directions[0], first);
    for (std::size_t d = 1; d < std::size(directions); ++d) {
        askAlong(scene, code, places, Ng, directions[d], other);
        for (int c = 0; c < colorSamples; ++c)
            for (int i = 0; i < places.count; ++i)
                if (!(std::fabs(first[c][i] - other[c][i]) <= alike * std::fabs(first[c][i])))
                    return false;
    }
    return true;
}

std::vector<std::uint8_t> linkedLamps(const Mesh &mesh) {
    std::vector<std::uint8_t> linked(std::size_t(mesh.scene().lights().count()), 1);
    std::vector<std::uint8_t> hasSurface(linked.size(), 0);
    EmissionQuestion question;
    std::vector<int> shining;
    for (const Face &face : mesh.faces())
        if (face.root >= 0 && mesh.domains()[face.domain].light > 0)
            shining.push_back(face.root);
    for (const std::vector<int> &batch : batchesByCode(mesh, shining, EmissionQuestion::capacity))
        for (int e : batch) {
            const std::size_t light = std::size_t(mesh.domainOf(e).light) - 1;
            hasSurface[light] = 1;
            if (linked[light] == 0)
                continue;
            PointBatch points;
            points.addNodes(mesh, e);
            if (!question.isTheSameInAllDirections(mesh.scene(), mesh.domainOf(e).code,
                                                   points.places(), points.N()))
                linked[light] = 0;
        }
    for (std::size_t light = 0; light < linked.size(); ++light)
        linked[light] &= hasSurface[light];
    return linked;
}

} // namespace candela::radiosity
