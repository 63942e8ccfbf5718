// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/response.h"

#include "light/sampling/sobol.h"
#include "light/vertex/finite_lobes.h"
#include "light/vertex/light_samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candela::radiosity {

namespace {

constexpr float pi = std::numbers::pi_v<float>;
/// Of shaders that are not Lambertian: views, and directions of light for each.
constexpr int views = 8, directions = 16;
/// Reflectances that differ by less are the same.
constexpr float alike = 1e-3f;

Vec3 get(const ConstVec3Planes &planes, int i) {
    return {planes[0][i], planes[1][i], planes[2][i]};
}

/// By the cosine about the normal, for points of a unit square.
Vec3 cosineDirection(Vec3 normal, float u, float v) {
    Vec3 s, t;
    orthonormalBasis(normal, s, t);
    const float radius = std::sqrt(u), turn = 2 * pi * v;
    return s * (radius * std::cos(turn)) + t * (radius * std::sin(turn)) +
           normal * std::sqrt(std::max(0.0f, 1 - u));
}

/// Point k of a sequence that all lanes share: what is asked twice answers the same.
std::array<float, 2> numberOf(int k, std::uint32_t salt) {
    const std::uint32_t key = pixelKey(0, 0, salt), index = std::uint32_t(k);
    std::array<float, 2> number;
    sobolPairs(1, &key, &index, 0, &number[0], &number[1]);
    return number;
}

void clear(int count, Response &response) {
    for (Planes<float> *planes :
         {&response.reflectance, &response.transmittance, &response.ambient})
        for (int c = 0; c < colorSamples; ++c)
            std::fill_n((*planes)[c], count, 0.0f);
}

} // namespace

bool isOneLobe(const ShaderCode &code) {
    const std::vector<ir::ConeSlot> &cones = code.facts().cones;
    return cones.size() == 1 && cones[0].exact && code.facts().affine;
}

ResponseQuestion::ResponseQuestion()
    : vertices_(capacity), mixture_(capacity), events_(capacity), I_(3, capacity),
      direction_(3, capacity), numbers_(2, capacity), pdf_(1, capacity),
      response_(colorSamples, capacity), ambient_(colorSamples, capacity),
      one_(colorSamples, capacity), answered_(1, capacity) {
    std::fill_n(answered_[0], capacity, finiteRequests);
    for (int c = 0; c < colorSamples; ++c) {
        ambientTable_[c] = ambient_[c], oneTable_[c] = one_[c];
        std::fill_n(one_[c], capacity, 1.0f);
    }
    vertices_.speak(false);
}

void ResponseQuestion::ask(const Scene &scene, int code, const SurfacePlaces &places,
                           const Vec3Planes &Ng, Response &response) {
    if (isAlikeInAllViews(scene, code, places, Ng, response))
        return;
    clear(places.count, response);
    for (int view = 0; view < views; ++view) {
        look(scene, code, places, Ng, numberOf(view, 1));
        addView(response, 1 / float(views));
    }
}

void ResponseQuestion::look(const Scene &scene, int code, const SurfacePlaces &places,
                            const Vec3Planes &Ng, std::array<float, 2> view) {
    const Vec3Planes I{I_[0], I_[1], I_[2]};
    for (int i = 0; i < places.count; ++i)
        I.set(i, -cosineDirection(Ng.get(i), view[0], view[1]));
    vertices_.place(scene, code, places, I, scene.options().camera.shutterOpen);
}

bool ResponseQuestion::isAlikeInAllViews(const Scene &scene, int code, const SurfacePlaces &places,
                                         const Vec3Planes &Ng, Response &response) {
    if (!isOneLobe(scene.code(code)))
        return false;
    const auto ask = [&](std::array<float, 2> view, Response &answer) {
        clear(places.count, answer);
        look(scene, code, places, Ng, view);
        addView(answer, 1);
    };
    ask({0, 0}, response);
    ask({0.8f, 0.3f}, slanting_);
    const auto areAlike = [&](const Planes<float> &a, const Planes<float> &b) {
        for (int c = 0; c < colorSamples; ++c)
            for (int i = 0; i < places.count; ++i)
                if (std::fabs(a[c][i] - b[c][i]) > alike)
                    return false;
        return true;
    };
    return areAlike(response.reflectance, slanting_.reflectance) &&
           areAlike(response.transmittance, slanting_.transmittance);
}

void ResponseQuestion::addView(Response &response, float share) {
    const Scene &scene = vertices_.scene();
    const ir::SurfaceFacts &facts = vertices_.code().facts();
    const bool hasAmbient = scene.lights().hasAmbient() && facts.readsAmbient;
    if (facts.readsIrradiance)
        addIrradiance(response, share);
    if (hasAmbient) {
        float *ambient[colorSamples];
        for (int c = 0; c < colorSamples; ++c)
            std::fill_n(ambient[c] = ambient_[c], vertices_.count(), 0.0f);
        scene.lights().ambient(askingPoints(vertices_), ambient);
    }
    vertices_.prepare(hasAmbient ? ambientTable_.data() : nullptr);
    for (int c = 0; hasAmbient && c < colorSamples; ++c)
        for (int i = 0; i < vertices_.count(); ++i)
            response.ambient[c][i] += share * pi * vertices_.prepared().Ca[c][i];
    events_.look(vertices_);
    if (!facts.readsIrradiance)
        addFinite(response, share);
    addDirections(response, share);
}

/// Equation 7: a shader that calls irradiance() reflects E by that alone.
void ResponseQuestion::addIrradiance(Response &response, float share) {
    vertices_.prepare(nullptr, oneTable_.data());
    for (int c = 0; c < colorSamples; ++c)
        for (int i = 0; i < vertices_.count(); ++i)
            response.reflectance[c][i] += share * pi * vertices_.prepared().Ca[c][i];
}

void ResponseQuestion::add(int i, Vec3 direction, float weight, float *const *g,
                           Response &response) {
    const bool reflected = dot(direction, get(vertices_.facingPlanes(), i)) > 0;
    for (int c = 0; c < colorSamples; ++c) {
        (reflected ? response.reflectance : response.transmittance)[c][i] += weight * g[c][i];
    }
}

/// A uniform field, by directions of the shader's own lobes.
void ResponseQuestion::addFinite(Response &response, float share) {
    const int lanes = vertices_.count();
    stateFiniteLobes(lanes, vertices_.prepared().cones, vertices_.facingPlanes(),
                     events_.transmission(), nullptr, mixture_);
    const int count = isOneLobe(vertices_.code()) ? 1 : directions;
    const ConstVec3Planes direction{direction_[0], direction_[1], direction_[2]};
    float *g[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        g[c] = response_[c];
    for (int k = 0; k < count; ++k) {
        const std::array<float, 2> number = numberOf(k, 2);
        for (int axis : {0, 1})
            std::fill_n(numbers_[axis], lanes, number[std::size_t(axis)]);
        mixture_.sample(numbers_[0], numbers_[1], {direction_[0], direction_[1], direction_[2]});
        mixture_.pdf(direction, pdf_[0]);
        vertices_.scatter(direction, answered_[0], nullptr, g);
        for (int i = 0; i < lanes; ++i)
            if (mixture_.total()[i] > 0 && pdf_[0][i] > 0)
                add(i, get(direction, i), share / (float(count) * pi * pdf_[0][i]), g, response);
    }
}

/// Mirrors and glass scatter as if they were matt.
void ResponseQuestion::addDirections(Response &response, float share) {
    float *g[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        g[c] = response_[c];
    for (int kind = 0; kind < events_.kinds(); ++kind) {
        if (!events_.takeKind(vertices_, kind))
            continue;
        const MutableVec3Planes taken = events_.direction();
        const ConstVec3Planes direction{taken[0], taken[1], taken[2]};
        vertices_.scatter(direction, events_.event(), nullptr, g);
        for (int i = 0; i < vertices_.count(); ++i)
            if (events_.event()[i] >= 0)
                add(i, get(direction, i), share, g, response);
    }
}

} // namespace candela::radiosity
