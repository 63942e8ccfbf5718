// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/links.h"

#include "foundation/base/parallel.h"

#include <algorithm>
#include <memory>

namespace candela::radiosity {

namespace {

class Refinement {
public:
    Refinement(Mesh &mesh, const ClusterTree &tree, const LinkSettings &settings, Fields &fields)
        : mesh_(mesh), settings_(settings), fields_(fields), elements_(mesh, settings, fields),
          clusters_(mesh, tree, fields.*settings.sent, everyOneHears() ? settings.tolerance : 0) {}

    Links run() {
        std::vector<Pair> pairs{{~0, ~0}};
        while (!pairs.empty())
            pairs = round(pairs);
        std::ranges::stable_sort(links_.links, {}, &Link::receiver);
        return std::move(links_);
    }

private:
    /// Clusters know nothing of lamps that are off for some of their faces.
    bool everyOneHears() const {
        if (settings_.sent != &Fields::emission)
            return true;
        const Lights lights = mesh_.scene().lights();
        for (const PlacedDomain &receiver : mesh_.domains())
            for (std::size_t light = 0; light < settings_.sources.linked.size(); ++light)
                if (settings_.sources.linked[light] != 0 &&
                    !lights.isOn(receiver.lightSet, std::int32_t(light) + 1))
                    return false;
        return true;
    }

    /// Judges all pairs at once and returns those that come in the place of divided ones.
    std::vector<Pair> round(const std::vector<Pair> &pairs) {
        isFull_ = std::size_t(mesh_.size()) > settings_.mostElements ||
                  links_.links.size() > settings_.mostLinks;
        elements_.beginRound(isFull_);
        std::vector<Verdict> verdicts(std::min<std::size_t>(pairs.size(), roundSize));
        std::vector<Pair> next;
        for (std::size_t first = 0; first < pairs.size(); first += roundSize) {
            const std::span<const Pair> some =
                std::span(pairs).subspan(first, std::min(roundSize, pairs.size() - first));
            judge(some, verdicts);
            for (std::size_t k = 0; k < some.size(); ++k)
                if (verdicts[k].kind == Verdict::Linked)
                    link(some[k], verdicts[k]);
            divide(some, verdicts, next);
        }
        return next;
    }

    void judge(std::span<const Pair> pairs, std::vector<Verdict> &verdicts) {
        constexpr std::size_t batch = VisibilityRays::pairs / ClusterOracle::looks;
        parallelFor((pairs.size() + batch - 1) / batch, [&](std::size_t b) {
            thread_local std::unique_ptr<VisibilityRays> rays;
            if (!rays)
                rays = std::make_unique<VisibilityRays>();
            const std::size_t first = b * batch, last = std::min(first + batch, pairs.size());
            std::vector<Pair> asked;
            std::vector<std::size_t> place, begin;
            for (std::size_t k = first; k < last; ++k) {
                verdicts[k] =
                    hasCluster(pairs[k]) ? judgeClusters(pairs[k]) : elements_.judge(pairs[k]);
                if (verdicts[k].kind != Verdict::Linked)
                    continue;
                place.push_back(k), begin.push_back(asked.size());
                if (hasCluster(pairs[k]))
                    clusters_.look(pairs[k], asked);
                else
                    asked.push_back(ElementOracle::seenOf(pairs[k], verdicts[k]));
            }
            begin.push_back(asked.size());
            std::vector<Visibility> visibility(asked.size());
            rays->ask(mesh_, asked, visibility.data());
            for (std::size_t k = 0; k < place.size(); ++k) {
                const std::span<const Visibility> seen =
                    std::span(visibility).subspan(begin[k], begin[k + 1] - begin[k]);
                Verdict &verdict = verdicts[place[k]];
                if (!hasCluster(pairs[place[k]])) {
                    elements_.judgeOccluded(pairs[place[k]], seen.front(), verdict);
                    continue;
                }
                verdict.visibility = meanVisibility(seen);
                if (brightest(verdict.visibility) == 0)
                    verdict.kind = Verdict::Nothing;
            }
        });
    }

    Verdict judgeClusters(const Pair &pair) const {
        Verdict verdict;
        if (clusters_.sends(pair.sender))
            verdict.kind = clusters_.mayLink(pair, isFull_) ? Verdict::Linked : Verdict::Divided;
        return verdict;
    }

    void link(const Pair &pair, const Verdict &verdict) {
        if (hasCluster(pair)) {
            links_.clusters.push_back({pair.receiver, pair.sender, verdict.visibility});
            return;
        }
        links_.links.push_back({pair.receiver, ElementOracle::seenOf(pair, verdict).sender,
                                verdict.visibility, links_.kernels.size(), verdict.isRough,
                                verdict.transfer.isNear, pair.sender});
        const std::size_t count =
            mesh_.nodes(pair.receiver).size() * mesh_.nodes(pair.sender).size();
        links_.kernels.insert(links_.kernels.end(), verdict.transfer.kernel.begin(),
                              verdict.transfer.kernel.begin() + std::ptrdiff_t(count));
    }

    /// The larger of the two, if it can be, unless the verdict names one.
    int dividedOf(const Pair &pair, const Verdict &verdict) const {
        if (verdict.end != Verdict::none)
            return verdict.end;
        const bool isLarger =
            hasCluster(pair) ? clusters_.radius(pair.receiver) >= clusters_.radius(pair.sender)
                             : mesh_.element(pair.receiver).area >= mesh_.element(pair.sender).area;
        const int larger = isLarger ? pair.receiver : pair.sender;
        const int other = isLarger ? pair.sender : pair.receiver;
        return isCluster(larger) || elements_.isDivisible(larger) ? larger : other;
    }

    void divide(std::span<const Pair> pairs, const std::vector<Verdict> &verdicts,
                std::vector<Pair> &next) {
        std::vector<int> leaves;
        for (std::size_t k = 0; k < pairs.size(); ++k)
            if (verdicts[k].kind == Verdict::Divided)
                if (const int e = dividedOf(pairs[k], verdicts[k]);
                    !isCluster(e) && mesh_.element(e).firstChild < 0)
                    leaves.push_back(e);
        std::ranges::sort(leaves);
        const auto [end, last] = std::ranges::unique(leaves);
        leaves.erase(end, last);
        const int first = mesh_.size();
        mesh_.subdivide(leaves);
        askSources(mesh_, first, settings_.sources, fields_);
        for (int e : leaves)
            for (int c = 0; c < Basis::children; ++c) {
                push(mesh_, e, c, fields_.indirect, fields_.indirect);
                push(mesh_, e, c, fields_.lamps, fields_.lamps);
                push(mesh_, e, c, fields_.exitance, fields_.exitance);
            }
        for (int e = first; e < mesh_.size(); ++e)
            if (!letsLightThrough(e)) // What comes from behind, the parent knows.
                reflect(mesh_, e, fields_);
        for (std::size_t k = 0; k < pairs.size(); ++k)
            if (verdicts[k].kind == Verdict::Divided)
                addChildren(pairs[k], dividedOf(pairs[k], verdicts[k]), next);
    }

    bool letsLightThrough(int e) const {
        const std::size_t first = std::size_t(e) * std::size_t(mesh_.stride());
        for (std::size_t i = first; i < first + mesh_.nodes(e).size(); ++i)
            if (brightest(fields_.transmittance[i]) > 0)
                return true;
        return false;
    }

    void addChildren(const Pair &pair, int divided, std::vector<Pair> &next) const {
        const auto [a, b] = pair;
        std::vector<int> parts;
        if (isCluster(divided))
            clusters_.open(divided, parts);
        else
            for (int c = 0; c < Basis::children; ++c)
                parts.push_back(mesh_.element(divided).firstChild + c);
        for (int part : parts) {
            if (a == b)
                for (int other : parts)
                    next.push_back({part, other});
            else if (divided == a)
                next.push_back({part, b});
            else
                next.push_back({a, part});
        }
    }

    static constexpr std::size_t roundSize = 1 << 16;
    Mesh &mesh_;
    const LinkSettings &settings_;
    Fields &fields_;
    ElementOracle elements_;
    const ClusterOracle clusters_;
    Links links_;
    bool isFull_ = false;
};

} // namespace

Links refine(Mesh &mesh, const ClusterTree &tree, const LinkSettings &settings, Fields &fields) {
    return Refinement(mesh, tree, settings, fields).run();
}

void reflect(const Mesh &mesh, int element, Fields &fields) {
    const std::size_t first = std::size_t(element) * std::size_t(mesh.stride());
    for (std::size_t i = first; i < first + mesh.nodes(element).size(); ++i)
        for (std::size_t k = 0; k < colorSamples; ++k)
            fields.exitance[i][k] =
                fields.reflectance[i][k] *
                    (fields.direct[i][k] + fields.lamps[i][k] + fields.indirect[i][k]) +
                fields.ambient[i][k];
}

} // namespace candela::radiosity
