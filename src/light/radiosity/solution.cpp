// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/solution.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace candela::radiosity {

namespace {

/// Sweeps end when exitance changes by no more.
constexpr double smallestResidual = 1e-4;

/// What a first exchange of light would come to, spread evenly: exitance to begin links with.
void guessIndirect(const Mesh &mesh, Fields &fields) {
    double reflected = 0, received = 0, ambient = 0;
    for (const Face &face : mesh.faces()) {
        if (face.root < 0)
            continue;
        const std::size_t first = std::size_t(face.root) * std::size_t(mesh.stride());
        const std::span<const Node> nodes = mesh.nodes(face.root);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const double E = brightest(fields.direct[first + i]) * nodes[i].area;
            received += E, reflected += E * brightest(fields.reflectance[first + i]);
            ambient += double(brightest(fields.ambient[first + i])) * nodes[i].area;
        }
    }
    const double share = received > 0 ? std::min(reflected / received, 0.9) : 0.5;
    const float even = float((reflected + ambient) / (mesh.area() * (1 - share)));
    for (Color &value : fields.indirect)
        value.fill(even);
}

} // namespace

Solution::Solution(const Scene &scene, const SolverSettings &settings, const Progress &progress)
    : mesh_(scene, settings.order) {
    const auto start = std::chrono::steady_clock::now();
    solve(settings, progress);
    statistics_.seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void Solution::solve(const SolverSettings &settings, const Progress &progress) {
    const auto tell = [&](double done) {
        if (progress)
            progress(done);
    };
    const float leastArea = float(settings.leastElement * mesh_.area());
    const SourceSettings sources{settings.directSamples, settings.seed, settings.epsilon * 10,
                                 leastArea};
    divideByDirectLight(mesh_, sources, fields_);
    for (const Face &face : mesh_.faces())
        if (face.root >= 0)
            for (std::vector<Color> *field :
                 {&fields_.direct, &fields_.reflectance, &fields_.transmittance, &fields_.ambient})
                pull(face.root, *field);
    tell(0.3);
    guessIndirect(mesh_, fields_);
    LinkSettings links{0, leastArea, settings.mostElements, settings.mostLinks, sources};
    for (int pass = 0; pass < 2; ++pass) {
        double exchanged = 0;
        for (int e = 0; e < mesh_.size(); ++e)
            reflect(mesh_, e, fields_);
        for (const Face &face : mesh_.faces())
            if (face.root >= 0) {
                pull(face.root, fields_.exitance);
                exchanged += flux(face.root, fields_.exitance);
            }
        links.tolerance = settings.epsilon * exchanged * (pass == 0 ? 4 : 1);
        links_ = refine(mesh_, links, fields_);
        tell(pass == 0 ? 0.4 : 0.7);
        for (int k = 0; k < settings.mostIterations; ++k) {
            statistics_.residual = iterate();
            ++statistics_.iterations;
            if (statistics_.residual < (pass == 0 ? 0.03 : smallestResidual))
                break;
        }
    }
    if (getenv("LOSS")) {
        const std::vector<Color> actual = fields_.exitance;
        for (int f = 0; f < 4; ++f) {
            double out = 0, in = 0, in2 = 0;
            for (int e = 0; e < mesh_.size(); ++e)
                if (mesh_.element(e).firstChild < 0)
                    for (size_t i = 0; i < mesh_.nodes(e).size(); ++i) {
                        size_t at = size_t(e) * mesh_.stride() + i;
                        const Node &n = mesh_.nodes(e)[i];
                        bool lit = fields_.direct[at][0] > 0;
                        float b = !lit     ? 0
                                  : f == 0 ? 1
                                  : f == 1 ? n.P.x + 3
                                  : f == 2 ? fields_.direct[at][0]
                                           : actual[at][0];
                        fields_.exitance[at].fill(b);
                        out += double(b) * n.area;
                    }
            for (const Face &face : mesh_.faces())
                if (face.root >= 0)
                    pull(face.root, fields_.exitance);
            double root = 0;
            for (const Face &face : mesh_.faces())
                if (face.root >= 0)
                    root += flux(face.root, fields_.exitance);
            gather();
            for (int e = 0; e < mesh_.size(); ++e)
                for (size_t i = 0; i < mesh_.nodes(e).size(); ++i)
                    in += double(fields_.gathered[size_t(e) * mesh_.stride() + i][0]) *
                          mesh_.nodes(e)[i].area;
            fprintf(stderr, "f %d out %.3f root %.3f in %.3f ratio %.5f\n", f, out, root, in,
                    in / out);
        }
    }
    if (getenv("ROWSUM")) {
        for (Color &c : fields_.exitance)
            c.fill(1);
        for (Color &c : fields_.reflectance)
            c.fill(0);
        iterate();
        double sum = 0, area = 0;
        float lo = 9, hi = 0;
        for (int e = 0; e < mesh_.size(); ++e)
            if (mesh_.element(e).firstChild < 0 &&
                brightest(fields_.direct[size_t(e) * mesh_.stride()]) > 0)
                for (size_t i = 0; i < mesh_.nodes(e).size(); ++i) {
                    float v = fields_.indirect[size_t(e) * mesh_.stride() + i][0];
                    sum += double(v) * mesh_.nodes(e)[i].area;
                    area += mesh_.nodes(e)[i].area;
                    lo = std::min(lo, v);
                    hi = std::max(hi, v);
                }
        std::vector<double> fs(mesh_.faces().size()), fa(fs.size());
        for (int e = 0; e < mesh_.size(); ++e)
            if (mesh_.element(e).firstChild < 0 &&
                brightest(fields_.direct[size_t(e) * mesh_.stride()]) > 0)
                for (size_t i = 0; i < mesh_.nodes(e).size(); ++i)
                    fs[mesh_.element(e).face] +=
                        double(fields_.indirect[size_t(e) * mesh_.stride() + i][0]) *
                        mesh_.nodes(e)[i].area,
                        fa[mesh_.element(e).face] += mesh_.nodes(e)[i].area;
        for (size_t f = 0; f < fs.size(); ++f)
            if (fa[f] > 0)
                fprintf(stderr, "face %zu domain %u back %d: %.5f\n", f, mesh_.faces()[f].domain,
                        mesh_.faces()[f].isBack, fs[f] / fa[f]);
        fprintf(stderr, "row sums mean %.5f min %.4f max %.4f\n", sum / area, lo, hi);
        double vis[3] = {0, 0, 0};
        for (auto &l : links_.links) {
            vis[l.visibility[0] >= .9999 ? 2 : l.visibility[0] > 0 ? 1 : 0]++;
        }
        fprintf(stderr, "links: occluded %g partial %g clear %g\n", vis[0], vis[1], vis[2]);
    }
    statistics_.elements = std::size_t(mesh_.size());
    statistics_.links = links_.links.size();
    for (const Face &face : mesh_.faces())
        if (face.root >= 0) {
            pull(face.root, fields_.indirect);
            statistics_.directFlux += flux(face.root, fields_.direct);
            statistics_.indirectFlux += flux(face.root, fields_.indirect);
        }
    tell(1);
}

double Solution::flux(int root, const std::vector<Color> &field) const {
    double flux = 0;
    const std::size_t first = std::size_t(root) * std::size_t(mesh_.stride());
    const std::span<const Node> nodes = mesh_.nodes(root);
    for (std::size_t i = 0; i < nodes.size(); ++i)
        flux += double(brightest(field[first + i])) * nodes[i].area;
    return flux;
}

/// A sweep: irradiance from exitance, and back. Returns by how much exitance changed.
double Solution::iterate() {
    const std::vector<Color> before = fields_.exitance;
    gather();
    parallelFor(mesh_.faces().size(), [&](std::size_t f) {
        const int root = mesh_.faces()[f].root;
        if (root < 0)
            return;
        const std::size_t first = std::size_t(root) * std::size_t(mesh_.stride());
        std::copy_n(fields_.gathered.begin() + std::ptrdiff_t(first), mesh_.stride(),
                    fields_.indirect.begin() + std::ptrdiff_t(first));
        pushDown(root);
    });
    shineThrough();
    parallelFor(mesh_.faces().size(), [&](std::size_t f) {
        if (const int root = mesh_.faces()[f].root; root >= 0)
            pull(root, fields_.exitance);
    });
    double change = 0, all = 0;
    for (const Face &face : mesh_.faces()) {
        if (face.root < 0)
            continue;
        const std::size_t first = std::size_t(face.root) * std::size_t(mesh_.stride());
        const std::span<const Node> nodes = mesh_.nodes(face.root);
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (std::size_t k = 0; k < colorSamples; ++k) {
                const double now = fields_.exitance[first + i][k];
                change += std::fabs(now - before[first + i][k]) * nodes[i].area;
                all += std::fabs(now) * nodes[i].area;
            }
    }
    return all > 0 ? change / all : 0;
}

void Solution::gather() {
    std::ranges::fill(fields_.gathered, Color{});
    const std::vector<Link> &links = links_.links;
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
            const std::size_t to = mesh_.nodes(link.receiver).size(),
                              from = mesh_.nodes(link.sender).size();
            const Color *sent = fields_.exitance.data() + stride * std::size_t(link.sender);
            Color *received = fields_.gathered.data() + stride * std::size_t(link.receiver);
            const float *kernel = links_.kernels.data() + link.kernel;
            for (std::size_t i = 0; i < to; ++i, kernel += from) {
                Color sum{};
                for (std::size_t j = 0; j < from; ++j)
                    for (std::size_t k = 0; k < colorSamples; ++k)
                        sum[k] += kernel[j] * sent[j][k];
                for (std::size_t k = 0; k < colorSamples; ++k)
                    received[i][k] += link.visibility[k] * sum[k];
            }
        }
    });
}

/// Of links to parents; `indirect` of the element is complete.
void Solution::pushDown(int element) {
    const int child = mesh_.element(element).firstChild;
    if (child < 0)
        return reflect(mesh_, element, fields_);
    const std::size_t stride = std::size_t(mesh_.stride());
    for (int c = 0; c < Basis::children; ++c) {
        push(mesh_, element, c, fields_.indirect, fields_.indirect);
        const std::size_t first = stride * std::size_t(child + c);
        for (std::size_t i = first; i < first + stride; ++i)
            for (std::size_t k = 0; k < colorSamples; ++k)
                fields_.indirect[i][k] += fields_.gathered[i][k];
        pushDown(child + c);
    }
}

/// Values of the element and all below it but for leaves.
void Solution::pull(int element, std::vector<Color> &field) const {
    const int child = mesh_.element(element).firstChild;
    if (child < 0)
        return;
    for (int c = 0; c < Basis::children; ++c)
        pull(child + c, field);
    radiosity::pull(mesh_, element, field);
}

/// What leaves leaves that light shines through from the other side.
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
            const Color there =
                at(opposite, Mesh::inFace(mesh_.element(e), basis.node(i)), fields_.direct);
            const Color more =
                at(opposite, Mesh::inFace(mesh_.element(e), basis.node(i)), fields_.indirect);
            for (std::size_t k = 0; k < colorSamples; ++k)
                fields_.exitance[first + std::size_t(i)][k] += passes[k] * (there[k] + more[k]);
        }
    }
}

Color Solution::at(std::int32_t face, Place place, const std::vector<Color> &field) const {
    Color sum{};
    const int leaf = mesh_.leafAt(face, place);
    if (leaf < 0)
        return sum;
    float value[mostNodes];
    mesh_.basis(leaf).values(place, value);
    const std::size_t first = std::size_t(leaf) * std::size_t(mesh_.stride());
    for (std::size_t i = 0; i < mesh_.nodes(leaf).size(); ++i)
        for (std::size_t k = 0; k < colorSamples; ++k)
            sum[k] += value[i] * field[first + i][k];
    return sum;
}

void Solution::irradiance(SurfaceVertices &vertices, const Answer &answer) const {
    const int count = vertices.count();
    thread_local std::vector<std::uint32_t> piece;
    thread_local std::vector<float> u, v;
    piece.resize(std::size_t(count)), u.resize(std::size_t(count)), v.resize(std::size_t(count));
    mesh_.scene().domains().name(vertices.points, piece.data(), u.data(), v.data());
    for (int i = 0; i < count; ++i) {
        const bool isBack = vertices.isMetFromInside(i);
        const auto tell = [&](bool back, const std::vector<Color> &field,
                              const std::array<float *, colorSamples> &to) {
            if (!to[0])
                return;
            const Color found =
                at(mesh_.faceAt(vertices.points.instance[i], vertices.points.shape[i],
                                piece[std::size_t(i)], back),
                   {u[std::size_t(i)], v[std::size_t(i)]}, field);
            for (std::size_t k = 0; k < colorSamples; ++k)
                to[k][i] = std::max(found[k], 0.0f);
        };
        tell(isBack, fields_.direct, answer.direct);
        tell(isBack, fields_.indirect, answer.indirect);
        tell(!isBack, fields_.direct, answer.directBehind);
        tell(!isBack, fields_.indirect, answer.indirectBehind);
    }
}

} // namespace candela::radiosity
