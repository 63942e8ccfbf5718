// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/sources.h"

#include "foundation/base/parallel.h"
#include "light/radiosity/direct.h"
#include "light/radiosity/response.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <mutex>

namespace candela::radiosity {

namespace {

/// Points on faces of one code.
struct PointBatch {
    std::vector<std::uint32_t> instance, shape, piece, key;
    std::vector<float> u, v, nx, ny, nz;

    int size() const { return int(u.size()); }
    void add(const Mesh &mesh, int e, Place inFace, Vec3 N, std::uint32_t seed) {
        const PlacedDomain &domain = mesh.domainOf(e);
        instance.push_back(domain.instance), shape.push_back(domain.shape);
        piece.push_back(mesh.faceOf(e).piece);
        u.push_back(inFace.u), v.push_back(inFace.v);
        nx.push_back(N.x), ny.push_back(N.y), nz.push_back(N.z);
        key.push_back(pixelKey(int(mesh.element(e).face), 0, seed));
    }
    SurfacePlaces places() const {
        return {size(), instance.data(), shape.data(), piece.data(), u.data(), v.data()};
    }
    Vec3Planes N() { return {nx.data(), ny.data(), nz.data()}; }
};

/// Elements from `first` on in batches of one code, whose points fill a question.
std::vector<std::vector<int>> batchesByCode(const Mesh &mesh, int first, int pointsOfElement) {
    std::map<int, std::vector<int>> byCode;
    for (int e = first; e < mesh.size(); ++e)
        byCode[mesh.domainOf(e).code].push_back(e);
    const std::size_t most = std::size_t(ResponseQuestion::capacity / pointsOfElement);
    std::vector<std::vector<int>> batches;
    for (const auto &[code, elements] : byCode)
        for (std::size_t at = 0; at < elements.size(); at += most)
            batches.emplace_back(elements.begin() + std::ptrdiff_t(at),
                                 elements.begin() +
                                     std::ptrdiff_t(std::min(at + most, elements.size())));
    return batches;
}

/// A face is looked at as closely as this share of the scene, whatever its first points see.
constexpr double coarsest = 1.0 / 512;

struct Questions {
    DirectQuestion direct;
    ResponseQuestion response;
    Response answer{ResponseQuestion::capacity};
    Planes<float> E{colorSamples, DirectQuestion::capacity};
};

void askBatch(const Mesh &mesh, const std::vector<int> &elements, const SourceSettings &settings,
              Fields &fields) {
    thread_local std::unique_ptr<Questions> own;
    if (!own)
        own = std::make_unique<Questions>();
    PointBatch points;
    for (int e : elements)
        for (int i = 0; i < mesh.basis(e).nodes(); ++i)
            points.add(mesh, e, Mesh::inFace(mesh.element(e), mesh.basis(e).node(i)),
                       mesh.nodes(e)[std::size_t(i)].N, settings.seed);
    const int code = mesh.domainOf(elements.front()).code;
    float *E[colorSamples];
    for (int c = 0; c < colorSamples; ++c)
        E[c] = own->E[c];
    own->direct.ask(mesh.scene(), code, points.places(), points.N(), points.key.data(),
                    settings.samples, E);
    own->response.ask(mesh.scene(), code, points.places(), points.N(), own->answer);
    int at = 0;
    for (int e : elements)
        for (int i = 0; i < mesh.basis(e).nodes(); ++i, ++at) {
            const std::size_t place = std::size_t(e) * std::size_t(mesh.stride()) + std::size_t(i);
            for (int c = 0; c < colorSamples; ++c) {
                const std::size_t k = std::size_t(c);
                fields.direct[place][k] = E[c][at];
                fields.reflectance[place][k] = own->answer.reflectance[c][at];
                fields.transmittance[place][k] = own->answer.transmittance[c][at];
                fields.ambient[place][k] = own->answer.ambient[c][at];
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

} // namespace

void askSources(const Mesh &mesh, int first, const SourceSettings &settings, Fields &fields) {
    fields.resize(mesh);
    const std::vector<std::vector<int>> batches = batchesByCode(mesh, first, mesh.stride());
    parallelFor(batches.size(),
                [&](std::size_t b) { askBatch(mesh, batches[b], settings, fields); });
}

double directFlux(const Mesh &mesh, const Fields &fields) {
    double flux = 0;
    for (const Face &face : mesh.faces()) {
        if (face.root < 0)
            continue;
        const std::span<const Node> nodes = mesh.nodes(face.root);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            flux += double(brightest(
                        fields.direct[std::size_t(face.root) * std::size_t(mesh.stride()) + i])) *
                    nodes[i].area;
    }
    return flux;
}

void divideByDirectLight(Mesh &mesh, const SourceSettings &settings, Fields &fields) {
    askSources(mesh, 0, settings, fields);
    double flux = directFlux(mesh, fields);
    std::vector<int> tried;
    for (const Face &face : mesh.faces())
        if (face.root >= 0)
            tried.push_back(face.root);
    while (!tried.empty()) {
        std::erase_if(tried, [&](int e) { return mesh.element(e).area <= 4 * settings.leastArea; });
        const int first = mesh.size();
        mesh.subdivide(tried);
        askSources(mesh, first, settings, fields);
        std::vector<int> next;
        double found = 0;
        for (int e : tried)
            found += missedByParent(mesh, e, fields);
        flux = std::max(flux, found); // Where the roots' nodes have seen nothing of it.
        for (int e : tried)
            if (missedByParent(mesh, e, fields) > settings.epsilon * flux ||
                mesh.element(e).area > coarsest * mesh.area())
                for (int c = 0; c < Basis::children; ++c)
                    next.push_back(mesh.element(e).firstChild + c);
        tried = std::move(next);
    }
}

} // namespace candela::radiosity
