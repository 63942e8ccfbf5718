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
/// And about what they send of themselves, which may be a narrow stripe.
constexpr int shiningPoints = Surroundings::capacity;

struct Questions {
    DirectQuestion direct;
    ResponseQuestion response;
    EmissionQuestion emission;
    Response answer{ResponseQuestion::capacity};
    Planes<float> E{colorSamples, DirectQuestion::capacity};
    Planes<float> sent{colorSamples, EmissionQuestion::capacity};
    Surroundings surroundings;
    Response around{ResponseQuestion::capacity};
    Planes<float> sentAround{colorSamples, EmissionQuestion::capacity};

    static std::array<float *, 3 * colorSamples> table(Response &response) {
        std::array<float *, 3 * colorSamples> table{};
        for (int c = 0; c < colorSamples; ++c) {
            table[std::size_t(c)] = response.reflectance[c];
            table[std::size_t(colorSamples + c)] = response.transmittance[c];
            table[std::size_t(2 * colorSamples + c)] = response.ambient[c];
        }
        return table;
    }
    static std::array<float *, colorSamples> table(const Planes<float> &sent) {
        std::array<float *, colorSamples> table{};
        for (int c = 0; c < colorSamples; ++c)
            table[std::size_t(c)] = sent[c];
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

bool isLinked(const Mesh &mesh, int e, const SourceSettings &settings) {
    const int light = mesh.domainOf(e).light;
    return light > 0 && settings.linked[std::size_t(light) - 1] != 0;
}

/// By its surface's shader, which may vary as it likes.
bool shinesByItself(const Mesh &mesh, int e, const SourceSettings &settings) {
    return isLinked(mesh, e, settings) && mesh.scene().code(mesh.domainOf(e).code).facts().emits;
}

/// What nodes have been told of themselves becomes what is so around them.
void askAround(const Mesh &mesh, const std::vector<int> &elements, std::uint32_t seed, bool shine,
               Questions &own) {
    const int code = mesh.domainOf(elements.front()).code;
    const auto response = Questions::table(own.around);
    const int points = isOneLobe(mesh.scene().code(code)) ? cheapPoints : dearPoints;
    own.surroundings.average(
        mesh, elements, points,
        [&](const SurfacePlaces &places, const Vec3Planes &Ng) {
            own.response.ask(mesh.scene(), code, places, Ng, own.around);
            return std::span<float *const>(response);
        },
        seed, Questions::table(own.answer));
    if (!shine)
        return;
    const auto sent = Questions::table(own.sentAround);
    own.surroundings.average(
        mesh, elements, mesh.scene().code(code).facts().emits ? shiningPoints : cheapPoints,
        [&](const SurfacePlaces &places, const Vec3Planes &Ng) {
            own.emission.ask(mesh.scene(), code, places, Ng, sent.data());
            return std::span<float *const>(sent);
        },
        seed, Questions::table(own.sent));
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
    const auto E = Questions::table(own->E), emission = Questions::table(own->sent);
    own->direct.ask(mesh.scene(), code, points.places(), points.N(), key.data(), settings.samples,
                    settings.linked, E.data());
    own->response.ask(mesh.scene(), code, points.places(), points.N(), own->answer);
    const auto shines = [&](int e) { return isLinked(mesh, e, settings); };
    const bool someShine = std::ranges::any_of(elements, shines);
    if (someShine)
        own->emission.ask(mesh.scene(), code, points.places(), points.N(), emission.data());
    askAround(mesh, elements, settings.seed, someShine, *own);
    int at = 0;
    for (int e : elements) {
        const bool isShining = shines(e);
        for (int i = 0; i < mesh.basis(e).nodes(); ++i, ++at) {
            const std::size_t place = std::size_t(e) * std::size_t(mesh.stride()) + std::size_t(i);
            for (int c = 0; c < colorSamples; ++c) {
                const std::size_t k = std::size_t(c);
                fields.direct[place][k] = E[k][at];
                fields.emission[place][k] = isShining ? emission[k][at] : 0;
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

/// By how much the parent's field misses its children's, in W.
double missedByParent(const Mesh &mesh, int parent, const std::vector<Color> &field) {
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
                           field[stride * std::size_t(parent) + std::size_t(j)][k];
                worst = std::max(worst, std::fabs(sum - field[at][k]));
            }
            missed += worst * mesh.nodes(first + c)[std::size_t(i)].area;
        }
    return missed;
}

/// Divides where one field varies, and where elements are large.
class Division {
public:
    Division(const Mesh &mesh, const std::vector<Color> Fields::*field, const Fields &fields,
             double epsilon)
        : mesh_(mesh), field_(field), epsilon_(epsilon), flux_(flux(mesh, fields.*field)) {}

    /// At least looked at: no share of all light is to be found in it.
    bool mayMatter(int e, const Fields &fields) const {
        float most = 0;
        const std::size_t first = std::size_t(e) * std::size_t(mesh_.stride());
        for (std::size_t i = first; i < first + mesh_.nodes(e).size(); ++i)
            most = std::max(most, brightest((fields.*field_)[i]));
        return most * mesh_.element(e).area > epsilon_ * flux_;
    }
    void measure(std::span<const int> parents, const Fields &fields) {
        missed_.clear();
        double found = 0;
        for (const int e : parents) {
            missed_.push_back(missedByParent(mesh_, e, fields.*field_));
            found += missed_.back();
        }
        flux_ = std::max(flux_, found); // Where the roots' nodes have seen nothing of it.
    }
    /// Of the parents that have been measured.
    bool isMissed(std::size_t k) const { return missed_[k] > epsilon_ * flux_; }

private:
    const Mesh &mesh_;
    const std::vector<Color> Fields::*field_;
    double epsilon_, flux_;
    std::vector<double> missed_;
};

/// All that has been seen of it does.
bool shinesEvenly(const Mesh &mesh, int e, const Fields &fields) {
    const std::size_t first = std::size_t(e) * std::size_t(mesh.stride());
    for (std::size_t i = first; i < first + mesh.nodes(e).size(); ++i)
        if (fields.emission[i] != fields.emission[first])
            return false;
    return brightest(fields.emission[first]) > 0;
}

double areaOfShining(const Mesh &mesh, const SourceSettings &settings) {
    double area = 0;
    for (const Face &face : mesh.faces())
        if (face.root >= 0 && shinesByItself(mesh, face.root, settings))
            area += mesh.element(face.root).area;
    return area;
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

void divideBySources(Mesh &mesh, const SourceSettings &settings, Fields &fields) {
    askSources(mesh, 0, settings, fields);
    const double shining = areaOfShining(mesh, settings);
    const auto isCoarse = [&](int e) {
        const bool mayHideMore =
            shinesByItself(mesh, e, settings) && !shinesEvenly(mesh, e, fields);
        return mesh.element(e).area > coarsest * (mayHideMore ? shining : mesh.area());
    };
    Division direct(mesh, &Fields::direct, fields, settings.epsilon);
    Division emission(mesh, &Fields::emission, fields, settings.epsilon);
    std::vector<int> tried;
    for (const Face &face : mesh.faces())
        if (face.root >= 0)
            tried.push_back(face.root);
    while (!tried.empty()) {
        std::erase_if(tried, [&](int e) {
            return mesh.element(e).area <= 4 * settings.leastArea ||
                   (!isCoarse(e) && !direct.mayMatter(e, fields) &&
                    (shinesEvenly(mesh, e, fields) || !emission.mayMatter(e, fields)));
        });
        const int first = mesh.size();
        mesh.subdivide(tried);
        askSources(mesh, first, settings, fields);
        direct.measure(tried, fields), emission.measure(tried, fields);
        std::vector<int> next;
        for (std::size_t k = 0; k < tried.size(); ++k)
            if (direct.isMissed(k) || emission.isMissed(k) || isCoarse(tried[k]))
                for (int c = 0; c < Basis::children; ++c)
                    next.push_back(mesh.element(tried[k]).firstChild + c);
        tried = std::move(next);
    }
}

} // namespace candela::radiosity
