// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/links.h"

#include "foundation/base/parallel.h"
#include "light/radiosity/transfer.h"

#include <algorithm>
#include <cmath>
#include <memory>

namespace candela::radiosity {

namespace {

/// Of the tolerance: what has leaked into a body by rounding is not exchanged there.
constexpr double negligible = 1e-5;
/// Where normals turn by more than this over an element, the rule knows too little of it.
constexpr float bent = 0.94f;
/// And where the corners tell so little of its size, contours do.
constexpr float fullest = 1.2f;
/// What a pair in partial view gets wrong, in shares of what it exchanges.
constexpr double partialError = 0.25;
/// Rays find no way between pairs that exchange so many tolerances at most: there is none.
constexpr double closed = 1;

bool isBent(const Mesh &mesh, int e) {
    for (const Node &node : mesh.nodes(e))
        if (dot(node.N, mesh.element(e).normal) < bent)
            return true;
    return false;
}

/// What becomes of a pair.
struct Verdict {
    enum Kind { Nothing, Linked, Divided } kind = Nothing; ///< Or its larger end is opened.
    Transfer transfer;
    Color visibility{};
    bool isRough = false;
};

class Refinement {
public:
    Refinement(Mesh &mesh, const ClusterTree &tree, const LinkSettings &settings, Fields &fields)
        : mesh_(mesh), settings_(settings), fields_(fields),
          clusters_(mesh, tree, fields.*settings.sent, everyOneHears() ? settings.tolerance : 0) {}

    Links run() {
        measureRoughness();
        std::vector<Pair> pairs{{~0, ~0}};
        while (!pairs.empty())
            pairs = round(pairs);
        std::ranges::stable_sort(links_.links, {}, &Link::receiver);
        return std::move(links_);
    }

private:
    /// By how much exitance differs below an element from what its basis makes of it.
    void measureRoughness() {
        roughness_.assign(std::size_t(mesh_.size()), 0);
        const std::size_t stride = std::size_t(mesh_.stride());
        const std::vector<Color> &sent = fields_.*settings_.sent;
        std::vector<Color> pushed(sent.size());
        for (int e = mesh_.size() - 1; e >= 0; --e) { // Children stand behind their parents.
            const int child = mesh_.element(e).firstChild;
            for (int c = 0; child >= 0 && c < Basis::children; ++c) {
                push(mesh_, e, c, sent, pushed);
                float missed = roughness_[std::size_t(child + c)];
                const std::size_t first = stride * std::size_t(child + c);
                for (std::size_t i = first; i < first + mesh_.nodes(child + c).size(); ++i)
                    for (std::size_t k = 0; k < colorSamples; ++k)
                        missed = std::max(missed, std::fabs(pushed[i][k] - sent[i][k]));
                roughness_[std::size_t(e)] = std::max(roughness_[std::size_t(e)], missed);
            }
        }
    }

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

    bool isDivisible(int e) const {
        return mesh_.element(e).firstChild >= 0 ||
               (mesh_.element(e).area > 4 * settings_.leastArea && !isFull_);
    }

    /// Judges all pairs at once and returns those that come in the place of divided ones.
    std::vector<Pair> round(const std::vector<Pair> &pairs) {
        isFull_ = std::size_t(mesh_.size()) > settings_.mostElements ||
                  links_.links.size() > settings_.mostLinks;
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
                    hasCluster(pairs[k]) ? judgeClusters(pairs[k]) : judgeUnoccluded(pairs[k]);
                if (verdicts[k].kind != Verdict::Linked)
                    continue;
                place.push_back(k), begin.push_back(asked.size());
                if (hasCluster(pairs[k]))
                    clusters_.look(pairs[k], asked);
                else
                    asked.push_back(pairs[k]);
            }
            begin.push_back(asked.size());
            std::vector<Visibility> visibility(asked.size());
            rays->ask(mesh_, asked, visibility.data());
            for (std::size_t k = 0; k < place.size(); ++k) {
                const std::span<const Visibility> seen =
                    std::span(visibility).subspan(begin[k], begin[k + 1] - begin[k]);
                Verdict &verdict = verdicts[place[k]];
                if (!hasCluster(pairs[place[k]])) {
                    judgeOccluded(pairs[place[k]], seen.front(), verdict);
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

    Verdict judgeUnoccluded(const Pair &pair) const {
        Verdict verdict;
        const auto [a, b] = pair;
        const Color *exitance = exitanceOf(b);
        const std::size_t count = mesh_.nodes(b).size();
        float most = 0, least = INFINITY;
        for (std::size_t j = 0; j < count; ++j) {
            most = std::max(most, brightest(exitance[j]));
            least = std::min(least, brightest(exitance[j]));
        }
        const double area = mesh_.element(a).area;
        if (!(most * area > negligible * settings_.tolerance) ||
            (a == b && mesh_.element(a).isFlat) || !isHeard(pair))
            return verdict;
        if (a == b && isBent(mesh_, a) && isDivisible(a)) {
            verdict.kind = Verdict::Divided;
            return verdict;
        }
        if (a != b && areTurnedAway(mesh_, a, b))
            return verdict;
        verdict.transfer = transferBetween(mesh_, a, b);
        const double exchanged = double(verdict.transfer.largest) * most * area;
        const double missed = (double(verdict.transfer.receiverError) * most +
                               double(verdict.transfer.senderError) * (most - least) +
                               double(verdict.transfer.curvature) * roughness_[std::size_t(b)]) *
                              area;
        const bool isTooBent = isBent(mesh_, a) || isBent(mesh_, b) ||
                               (verdict.transfer.isNear && mesh_.element(b).fullness >= fullest);
        if ((missed > settings_.tolerance || (isTooBent && mayExchange(pair, most))) &&
            (isDivisible(a) || isDivisible(b)))
            verdict.kind = Verdict::Divided;
        else if (exchanged > 0)
            verdict.kind = Verdict::Linked;
        return verdict;
    }

    /// Of lamps, whether they are on for the receiver.
    bool isHeard(const Pair &pair) const {
        return settings_.sent != &Fields::emission ||
               mesh_.scene().lights().isOn(mesh_.domainOf(pair.receiver).lightSet,
                                           mesh_.domainOf(pair.sender).light);
    }

    /// Even if they faced each other all over.
    bool mayExchange(const Pair &pair, double exitance) const {
        const Element &a = mesh_.element(pair.receiver), &b = mesh_.element(pair.sender);
        const double distance = std::max(0.0f, length(b.centre - a.centre) - a.radius - b.radius);
        const double factor = b.area / (M_PI * distance * distance + b.area);
        return factor * exitance * a.area > settings_.tolerance;
    }

    void judgeOccluded(const Pair &pair, const Visibility &visibility, Verdict &verdict) const {
        verdict.visibility = visibility.mean;
        const auto [a, b] = pair;
        float exitance = 0;
        for (std::size_t j = 0; j < mesh_.nodes(b).size(); ++j)
            exitance = std::max(exitance, brightest(exitanceOf(b)[j]));
        const double exchanged =
            double(verdict.transfer.largest) * exitance * mesh_.element(a).area;
        const bool mayDivide = isDivisible(a) || isDivisible(b);
        const float seen = brightest(visibility.mean);
        if (seen == 0) {
            verdict.kind = mayDivide && exchanged > closed * settings_.tolerance ? Verdict::Divided
                                                                                 : Verdict::Nothing;
            return;
        }
        const double missed = exchanged * 2 * std::min(seen, 1 - seen) * partialError;
        if (mayDivide && missed > settings_.tolerance) {
            verdict.kind = Verdict::Divided;
            return;
        }
        verdict.isRough =
            double(errorAtCorners(mesh_, a, b, verdict.transfer)) * exitance > settings_.contrast;
        refineKernel(mesh_, a, b, verdict.transfer);
        if (seen < 1)
            for (std::size_t k = 0; k < visibility.share.size(); ++k)
                verdict.transfer.kernel[k] *= visibility.share[k];
    }

    void link(const Pair &pair, const Verdict &verdict) {
        if (hasCluster(pair)) {
            links_.clusters.push_back({pair.receiver, pair.sender, verdict.visibility});
            return;
        }
        links_.links.push_back({pair.receiver, pair.sender, verdict.visibility,
                                links_.kernels.size(), verdict.isRough, verdict.transfer.isNear});
        const std::size_t count =
            mesh_.nodes(pair.receiver).size() * mesh_.nodes(pair.sender).size();
        links_.kernels.insert(links_.kernels.end(), verdict.transfer.kernel.begin(),
                              verdict.transfer.kernel.begin() + std::ptrdiff_t(count));
    }

    /// The larger of the two, if it can be.
    int dividedOf(const Pair &pair) const {
        const bool isLarger =
            hasCluster(pair) ? clusters_.radius(pair.receiver) >= clusters_.radius(pair.sender)
                             : mesh_.element(pair.receiver).area >= mesh_.element(pair.sender).area;
        const int larger = isLarger ? pair.receiver : pair.sender;
        const int other = isLarger ? pair.sender : pair.receiver;
        return isCluster(larger) || isDivisible(larger) ? larger : other;
    }

    void divide(std::span<const Pair> pairs, const std::vector<Verdict> &verdicts,
                std::vector<Pair> &next) {
        std::vector<int> leaves;
        for (std::size_t k = 0; k < pairs.size(); ++k)
            if (verdicts[k].kind == Verdict::Divided)
                if (const int e = dividedOf(pairs[k]);
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
        roughness_.resize(std::size_t(mesh_.size()), 0);
        for (std::size_t k = 0; k < pairs.size(); ++k)
            if (verdicts[k].kind == Verdict::Divided)
                addChildren(pairs[k], next);
    }

    bool letsLightThrough(int e) const {
        const std::size_t first = std::size_t(e) * std::size_t(mesh_.stride());
        for (std::size_t i = first; i < first + mesh_.nodes(e).size(); ++i)
            if (brightest(fields_.transmittance[i]) > 0)
                return true;
        return false;
    }

    void addChildren(const Pair &pair, std::vector<Pair> &next) const {
        const auto [a, b] = pair;
        const int divided = dividedOf(pair);
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

    const Color *exitanceOf(int e) const {
        return (fields_.*settings_.sent).data() + std::size_t(e) * std::size_t(mesh_.stride());
    }

    static constexpr std::size_t roundSize = 1 << 16;
    Mesh &mesh_;
    const LinkSettings &settings_;
    Fields &fields_;
    const ClusterOracle clusters_;
    Links links_;
    std::vector<float> roughness_; ///< By element.
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
