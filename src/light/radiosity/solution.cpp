// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/solution.h"

#include "foundation/base/parallel.h"
#include "light/radiosity/lamps.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <fmt/format.h>
#include <utility>

namespace candela::radiosity {

namespace {

/// Sweeps end when all that are left would change exitance by no more.
constexpr double smallestResidual = 1e-4;

/// What is left, if changes go on to shrink as the last one has.
double changesToCome(double before, double last) {
    if (!(last > 0))
        return 0;
    const double ratio = std::min(last / std::max(before, last), 0.99);
    return last * ratio / (1 - ratio);
}

void multiply(const std::vector<float> &factor, std::vector<Color> &field) {
    for (std::size_t i = 0; i < factor.size(); ++i)
        for (float &value : field[i])
            value *= factor[i];
}

} // namespace

Solution::Solution(const Scene &scene, int order) : mesh_(scene, order), tree_(mesh_) {}

Solution::Solution(const Scene &scene, const SolverSettings &settings, DiagnosticSink &diagnostics,
                   const Progress &progress)
    : Solution(scene, settings.order) {
    const auto start = std::chrono::steady_clock::now();
    solve(settings, diagnostics, progress);
    statistics_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Solution::solve(const SolverSettings &settings, DiagnosticSink &diagnostics,
                     const Progress &progress) {
    const auto tell = [&](double done) {
        if (progress)
            progress(done);
    };
    const float leastArea = float(settings.leastElement * mesh_.area());
    Impossible impossible;
    LinkSettings links;
    links.leastArea = leastArea;
    links.cutArea = float(settings.cutElement * mesh_.area());
    links.mostElements = settings.mostElements, links.mostLinks = settings.mostLinks;
    links.sources = {settings.directSamples, settings.seed, settings.epsilon * 10, leastArea,
                     linkedLamps(mesh_),     &impossible};
    divideBySources(mesh_, links.sources, fields_);
    pullAll(fields_.emission); // What is narrow, small elements have met.
    tell(0.2);
    linkLamps(links, settings.epsilon, settings.contrast);
    pullSources();
    tell(0.4);
    for (int pass = 0; pass < 2; ++pass) {
        for (int e = 0; e < mesh_.size(); ++e)
            reflect(mesh_, e, fields_);
        shineThrough();
        pullAll(fields_.exitance);
        const double coarser = pass == 0 ? 4 : 1;
        links.tolerance = settings.epsilon * flux(mesh_, fields_.exitance) * coarser;
        links.contrast = settings.contrast * evenIrradiance(fields_.exitance) * coarser;
        links_ = refine(mesh_, tree_, links, fields_);
        factor_ = factorsOf(links_);
        tell(pass == 0 ? 0.5 : 0.8);
        double before = 0;
        for (int k = 0; k < settings.mostIterations; ++k) {
            statistics_.residual = iterate();
            ++statistics_.iterations;
            if (changesToCome(std::exchange(before, statistics_.residual), statistics_.residual) <
                (pass == 0 ? 0.03 : smallestResidual))
                break;
        }
    }
    pullSources();
    pullAll(fields_.indirect);
    indirect_ = answering(links_, fields_.exitance, factor_);
    lamps_ = answering(lampLinks_, fields_.emission, factorsOf(lampLinks_));
    statistics_.elements = std::size_t(mesh_.size());
    statistics_.links = links_.links.size();
    statistics_.clusterLinks = links_.clusters.size();
    statistics_.directFlux = flux(mesh_, fields_.direct) + flux(mesh_, fields_.lamps);
    statistics_.indirectFlux = flux(mesh_, fields_.indirect);
    report(impossible, settings, diagnostics);
    tell(1);
}

/// What users should know of the solution.
void Solution::report(const Impossible &impossible, const SolverSettings &settings,
                      DiagnosticSink &diagnostics) const {
    for (const auto &[shader, count] : impossible.all())
        diagnostics.warning(
            {},
            fmt::format("radiosity: at {} points shader \"{}\" sends on more light than it gets, "
                        "or what is no number; there it is taken to send on all",
                        count, shader));
    if (statistics_.elements > settings.mostElements || statistics_.links > settings.mostLinks)
        diagnostics.warning(
            {}, fmt::format("radiosity: the solution would have more than {} elements or {} links, "
                            "and is coarser than \"epsilon\" asks for",
                            settings.mostElements, settings.mostLinks));
}

/// Surfaces that shine, as far as links may serve them.
void Solution::linkLamps(LinkSettings settings, double epsilon, double contrast) {
    settings.sent = &Fields::emission;
    settings.tolerance = epsilon * flux(mesh_, fields_.emission);
    settings.contrast = contrast * evenIrradiance(fields_.emission);
    if (!(settings.tolerance > 0))
        return;
    lampLinks_ = refine(mesh_, tree_, settings, fields_);
    pullAll(fields_.emission);
    const std::vector<float> factor = factorsOf(lampLinks_);
    gather(lampLinks_, fields_.emission, Which::All);
    pushAll(fields_.lamps);
    multiply(factor, fields_.lamps);
    statistics_.lampLinks = lampLinks_.links.size();
}

std::vector<float> Solution::factorsOf(const Links &links) {
    gather(links, std::vector<Color>(fields_.gathered.size(), Color{1, 1, 1}), Which::Clear);
    std::vector<Color> unit(fields_.gathered.size());
    pushAll(unit);
    return closureFactors(mesh_, unit);
}

Solution::Answering Solution::answering(const Links &links, const std::vector<Color> &sent,
                                        std::vector<float> factor) {
    Answering answer;
    gather(links, sent, Which::Smooth);
    answer.smooth.resize(sent.size());
    pushAll(answer.smooth);
    factor.resize(sent.size(), 1.0f); // Of no links there are none.
    multiply(factor, answer.smooth);
    answer.factor = std::move(factor);
    answer.near = NearLight(mesh_, nearRecords(mesh_, links), sent);
    return answer;
}

void Solution::pullSources() {
    for (std::vector<Color> *field : {&fields_.direct, &fields_.lamps, &fields_.reflectance,
                                      &fields_.transmittance, &fields_.ambient})
        pullAll(*field);
}

/// As if all that is sent fell on all surfaces alike, on one side each.
double Solution::evenIrradiance(const std::vector<Color> &sent) const {
    return 2 * flux(mesh_, sent) / mesh_.area();
}

/// A sweep: irradiance from exitance, and back. Returns by how much exitance changed.
double Solution::iterate() {
    const std::vector<Color> before = fields_.exitance;
    gather(links_, fields_.exitance, Which::All);
    pushAll(fields_.indirect);
    multiply(factor_, fields_.indirect);
    for (int e = 0; e < mesh_.size(); ++e)
        if (mesh_.element(e).firstChild < 0)
            reflect(mesh_, e, fields_);
    shineThrough();
    pullAll(fields_.exitance);
    double change = 0, all = 0;
    forEachRootNode(mesh_, [&](std::size_t at, float area) {
        for (std::size_t k = 0; k < colorSamples; ++k) {
            change += std::fabs(fields_.exitance[at][k] - before[at][k]) * area;
            all += std::fabs(fields_.exitance[at][k]) * area;
        }
    });
    return all > 0 ? change / all : 0;
}

void Solution::gather(const Links &all, const std::vector<Color> &sent, Which which) {
    std::ranges::fill(fields_.gathered, Color{});
    const std::vector<Link> &links = all.links;
    const std::size_t stride = std::size_t(mesh_.stride());
    // Ranges of links end where a receiver's do.
    constexpr std::size_t range = 2048;
    const auto beginOf = [&](std::size_t at) {
        at = std::min(at, links.size());
        while (at > 0 && at < links.size() && links[at].receiver == links[at - 1].receiver)
            ++at;
        return at;
    };
    parallelFor((links.size() + range - 1) / range, [&](std::size_t r) {
        const std::size_t last = beginOf((r + 1) * range);
        for (std::size_t l = beginOf(r * range); l < last; ++l) {
            const Link &link = links[l];
            if ((which == Which::Smooth && link.isRough) ||
                (which == Which::Clear && *std::ranges::min_element(link.visibility) < 1))
                continue;
            const std::size_t to = mesh_.nodes(link.receiver).size(),
                              from = mesh_.nodes(link.sender).size();
            const Color *exitance = sent.data() + stride * std::size_t(link.sender);
            Color *received = fields_.gathered.data() + stride * std::size_t(link.receiver);
            const float *kernel = all.kernels.data() + link.kernel;
            for (std::size_t i = 0; i < to; ++i, kernel += from) {
                Color sum{};
                for (std::size_t j = 0; j < from; ++j)
                    for (std::size_t k = 0; k < colorSamples; ++k)
                        sum[k] += kernel[j] * exitance[j][k];
                for (std::size_t k = 0; k < colorSamples; ++k)
                    received[i][k] += link.visibility[k] * sum[k];
            }
        }
    });
    if (which != Which::Clear)
        gatherFromClusters(mesh_, tree_, all.clusters, sent, fields_.gathered);
}

/// What links have brought to elements and to all above them.
void Solution::pushAll(std::vector<Color> &field) const {
    parallelFor(mesh_.faces().size(), [&](std::size_t f) {
        const int root = mesh_.faces()[f].root;
        if (root < 0)
            return;
        const std::ptrdiff_t first = std::ptrdiff_t(root) * mesh_.stride();
        std::copy_n(fields_.gathered.begin() + first, mesh_.stride(), field.begin() + first);
        pushDown(root, field);
    });
}

void Solution::pushDown(int element, std::vector<Color> &field) const {
    const int child = mesh_.element(element).firstChild;
    const std::size_t stride = std::size_t(mesh_.stride());
    for (int c = 0; child >= 0 && c < Basis::children; ++c) {
        push(mesh_, element, c, field, field);
        const std::size_t first = stride * std::size_t(child + c);
        for (std::size_t i = first; i < first + stride; ++i)
            for (std::size_t k = 0; k < colorSamples; ++k)
                field[i][k] += fields_.gathered[i][k];
        pushDown(child + c, field);
    }
}

/// Values of elements with children.
void Solution::pullAll(std::vector<Color> &field) const {
    parallelFor(mesh_.faces().size(), [&](std::size_t f) {
        if (const int root = mesh_.faces()[f].root; root >= 0)
            pullUp(root, field);
    });
}

void Solution::pullUp(int element, std::vector<Color> &field) const {
    const int child = mesh_.element(element).firstChild;
    if (child < 0)
        return;
    for (int c = 0; c < Basis::children; ++c)
        pullUp(child + c, field);
    pull(mesh_, element, field);
}

/// What leaves send that light shines through from the other side.
void Solution::shineThrough() {
    for (int e = 0; e < mesh_.size(); ++e) {
        const std::int32_t opposite = mesh_.faceOf(e).opposite;
        if (mesh_.element(e).firstChild >= 0 || opposite < 0)
            continue;
        const Basis &basis = mesh_.basis(e);
        const std::size_t first = std::size_t(e) * std::size_t(mesh_.stride());
        for (int i = 0; i < basis.nodes(); ++i) {
            const Color &passes = fields_.transmittance[first + std::size_t(i)];
            if (brightest(passes) <= 0)
                continue;
            const Place place = Mesh::inFace(mesh_.element(e), basis.node(i));
            const Color behind =
                at(opposite, place, {&fields_.direct, &fields_.lamps, &fields_.indirect});
            for (std::size_t k = 0; k < colorSamples; ++k)
                fields_.exitance[first + std::size_t(i)][k] += passes[k] * behind[k];
        }
    }
}

Color Solution::at(std::int32_t face, Place place,
                   std::initializer_list<const std::vector<Color> *> fields) const {
    Color sum{};
    const int leaf = mesh_.leafAt(face, place);
    if (leaf < 0)
        return sum;
    float value[mostNodes];
    mesh_.basis(leaf).values(place, value);
    const std::size_t first = std::size_t(leaf) * std::size_t(mesh_.stride());
    for (const std::vector<Color> *field : fields)
        for (std::size_t i = 0; i < mesh_.nodes(leaf).size(); ++i)
            for (std::size_t k = 0; k < colorSamples; ++k)
                sum[k] += value[i] * (*field)[first + i][k];
    return sum;
}

} // namespace candela::radiosity
