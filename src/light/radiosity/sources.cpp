// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/sources.h"

#include "foundation/base/parallel.h"
#include "light/radiosity/direct.h"
#include "light/radiosity/lamps.h"
#include "light/radiosity/points.h"
#include "light/radiosity/response.h"
#include "light/radiosity/surroundings.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace candela::radiosity {

namespace {

/// Beyond 1 by rounding and by quadrature.
constexpr float tolerated = 1.02f;

/// A face is looked at as closely as this share of the scene, whatever its first points see.
constexpr double coarsest = 1.0 / 512;

/// Points of an element that shaders are asked about: one evaluation each, or some hundred.
constexpr int cheapPoints = 64, dearPoints = 8;

struct Questions {
    DirectQuestion direct;
    ResponseQuestion response;
    EmissionQuestion emission;
    Response answer{ResponseQuestion::capacity};
    Planes<float> E{colorSamples, DirectQuestion::capacity};
    Planes<float> sent{colorSamples, EmissionQuestion::capacity};
    /// What points are asked of themselves: the response, and what they send.
    using Table = std::array<float *, 4 * colorSamples>;
    Surroundings surroundings;
    Response around{ResponseQuestion::capacity};
    Planes<float> sentAround{colorSamples, EmissionQuestion::capacity};

    static Table table(Response &response, const Planes<float> &sent) {
        Table table{};
        for (int c = 0; c < colorSamples; ++c) {
            table[std::size_t(c)] = response.reflectance[c];
            table[std::size_t(colorSamples + c)] = response.transmittance[c];
            table[std::size_t(2 * colorSamples + c)] = response.ambient[c];
            table[std::size_t(3 * colorSamples + c)] = sent[c];
        }
        return table;
    }
};

/// What is sent on is no more than what comes.
bool makePossible(Color &reflectance, Color &transmittance) {
    bool isPossible = true;
    for (std::size_t k = 0; k < colorSamples; ++k) {
        for (float *value : {&reflectance[k], &transmittance[k]})
            if (!(*value >= 0) || !std::isfinite(*value))
                *value = 0, isPossible = false;
        const float sum = reflectance[k] + transmittance[k];
        if (sum > 1) {
            reflectance[k] /= sum, transmittance[k] /= sum;
            isPossible &= sum <= tolerated;
        }
    }
    return isPossible;
}

void askBatch(const Mesh &mesh, const std::vector<int> &elements, const SourceSettings &settings,
              Fields &fields) {
    thread_local std::unique_ptr<Questions> own;
    if (!own)
        own = std::make_unique<Questions>();
    PointBatch points;
    std::vector<std::uint32_t> key;
    for (int e : elements) {
        points.addNodes(mesh, e);
        key.resize(std::size_t(points.size()),
                   pixelKey(int(mesh.element(e).face), 0, settings.seed));
    }
    const int code = mesh.domainOf(elements.front()).code;
    float *E[colorSamples], *emission[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        E[c] = own->E[c], emission[c] = own->sent[c];
    own->direct.ask(mesh.scene(), code, points.places(), points.N(), key.data(), settings.samples,
                    settings.linked, E);
    own->response.ask(mesh.scene(), code, points.places(), points.N(), own->answer);
    const auto isLinked = [&](int e) {
        const int light = mesh.domainOf(e).light;
        return light > 0 && settings.linked[std::size_t(light) - 1] != 0;
    };
    const bool someShine = std::ranges::any_of(elements, isLinked);
    if (someShine)
        own->emission.ask(mesh.scene(), code, points.places(), points.N(), emission);
    const Questions::Table around = Questions::table(own->around, own->sentAround);
    const auto ask = [&](const SurfacePlaces &places, const Vec3Planes &Ng) {
        own->response.ask(mesh.scene(), code, places, Ng, own->around);
        if (someShine)
            own->emission.ask(mesh.scene(), code, places, Ng,
                              &around[std::size_t(3 * colorSamples)]);
        return std::span<float *const>(around);
    };
    const int count = isOneLobe(mesh.scene().code(code)) ? cheapPoints : dearPoints;
    own->surroundings.average(mesh, elements, count, ask, settings.seed,
                              Questions::table(own->answer, own->sent));
    int at = 0;
    for (int e : elements) {
        const bool shines = isLinked(e);
        for (int i = 0; i < mesh.basis(e).nodes(); ++i, ++at) {
            const std::size_t place = std::size_t(e) * std::size_t(mesh.stride()) + std::size_t(i);
            for (int c = 0; c < colorSamples; ++c) {
                const std::size_t k = std::size_t(c);
                fields.direct[place][k] = E[c][at];
                fields.emission[place][k] = shines ? emission[c][at] : 0;
                fields.reflectance[place][k] = own->answer.reflectance[c][at];
                fields.transmittance[place][k] = own->answer.transmittance[c][at];
                fields.ambient[place][k] = own->answer.ambient[c][at];
            }
            if (!makePossible(fields.reflectance[place], fields.transmittance[place]) &&
                settings.impossible)
                settings.impossible->add(mesh.scene().code(code).name());
        }
    }
}

/// By how much the parent's direct light misses its children's, in W.
double missedByParent(const Mesh &mesh, int parent, const Fields &fields) {
    const Basis &basis = mesh.basis(parent);
    const std::size_t stride = std::size_t(mesh.stride());
    const int first = mesh.element(parent).firstChild;
    double missed = 0;
    for (int c = 0; c < Basis::children; ++c)
        for (int i = 0; i < basis.nodes(); ++i) {
            const std::size_t at = stride * std::size_t(first + c) + std::size_t(i);
            double worst = 0;
            for (std::size_t k = 0; k < colorSamples; ++k) {
                double sum = 0;
                for (int j = 0; j < basis.nodes(); ++j)
                    sum += double(basis.toChild(c, i, j)) *
                           fields.direct[stride * std::size_t(parent) + std::size_t(j)][k];
                worst = std::max(worst, std::fabs(sum - fields.direct[at][k]));
            }
            missed += worst * mesh.nodes(first + c)[std::size_t(i)].area;
        }
    return missed;
}

double brightestDirect(const Mesh &mesh, int e, const Fields &fields) {
    float most = 0;
    const std::size_t first = std::size_t(e) * std::size_t(mesh.stride());
    for (std::size_t i = first; i < first + mesh.nodes(e).size(); ++i)
        most = std::max(most, brightest(fields.direct[i]));
    return most;
}

} // namespace

void Impossible::add(const std::string &shader) {
    const std::lock_guard lock(mutex_);
    ++counts_[shader];
}

void askSources(const Mesh &mesh, int first, const SourceSettings &settings, Fields &fields) {
    fields.resize(mesh);
    std::vector<int> elements;
    for (int e = first; e < mesh.size(); ++e)
        elements.push_back(e);
    const std::vector<std::vector<int>> batches =
        batchesByCode(mesh, elements, ResponseQuestion::capacity);
    parallelFor(batches.size(),
                [&](std::size_t b) { askBatch(mesh, batches[b], settings, fields); });
}

void divideByDirectLight(Mesh &mesh, const SourceSettings &settings, Fields &fields) {
    askSources(mesh, 0, settings, fields);
    double flux = radiosity::flux(mesh, fields.direct);
    std::vector<int> tried;
    for (const Face &face : mesh.faces())
        if (face.root >= 0)
            tried.push_back(face.root);
    while (!tried.empty()) {
        std::erase_if(tried, [&](int e) {
            const float area = mesh.element(e).area;
            return area <= 4 * settings.leastArea ||
                   (area <= coarsest * mesh.area() &&
                    brightestDirect(mesh, e, fields) * area <= settings.epsilon * flux);
        });
        const int first = mesh.size();
        mesh.subdivide(tried);
        askSources(mesh, first, settings, fields);
        std::vector<int> next;
        double found = 0;
        std::vector<double> missed;
        for (int e : tried) {
            missed.push_back(missedByParent(mesh, e, fields));
            found += missed.back();
        }
        flux = std::max(flux, found); // Where the roots' nodes have seen nothing of it.
        for (std::size_t k = 0; k < tried.size(); ++k)
            if (missed[k] > settings.epsilon * flux ||
                mesh.element(tried[k]).area > coarsest * mesh.area())
                for (int c = 0; c < Basis::children; ++c)
                    next.push_back(mesh.element(tried[k]).firstChild + c);
        tried = std::move(next);
    }
}

} // namespace candela::radiosity
