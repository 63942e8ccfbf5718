// SPDX-License-Identifier: Apache-2.0
#include "light/radiosity/link_oracle.h"

#include "light/radiosity/donors.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela::radiosity {

namespace {

/// Of the tolerance: what has leaked into a body by rounding is not exchanged there.
constexpr double negligible = 1e-5;
/// Where normals turn by more than this over an element, the rule knows too little of it.
constexpr float bent = 0.94f;
/// And where the corners tell so little of its size, contours do.
constexpr float fullest = 1.2f;
/// Below that they get about so much of what they exchange wrong, in shares of what curved edges
/// add; and all of them alike.
constexpr double outlineError = 1;
/// Of the tolerance: what pairs in partial view may get wrong, whose errors are alike all along a
/// shadow's border.
constexpr double partialShare = 0.25;
/// What a sender that something stands on gets wrong, in shares of what it exchanges: its basis has
/// both sides' light.
constexpr double cutError = 0.15;
/// Receivers so many times as large as what varies on them are divided: few points are to ask for
/// it.
constexpr float farLarger = 3;
/// Rays find no way between pairs that exchange so many tolerances at most: there is none.
constexpr double closed = 1;

bool isBent(const Mesh &mesh, int e) {
    for (const Node &node : mesh.nodes(e))
        if (dot(node.N, mesh.element(e).normal) < bent)
            return true;
    return false;
}

} // namespace

ElementOracle::ElementOracle(const Mesh &mesh, const LinkSettings &settings, const Fields &fields)
    : mesh_(mesh), settings_(settings), fields_(fields) {
    measureRoughness();
}

void ElementOracle::beginRound(bool isFull) {
    isFull_ = isFull;
    roughness_.resize(std::size_t(mesh_.size()), 0);
}

/// By how much exitance differs below an element from what its basis makes of it.
void ElementOracle::measureRoughness() {
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

/// Walls stand on it: what one side gets, the other does not.
bool ElementOracle::isTooCut(int e) const {
    return mesh_.element(e).isCut && mesh_.element(e).area > settings_.cutArea && isDivisible(e);
}

/// The sender's share is told by a neighbour's nodes.
void ElementOracle::takeDonor(const Pair &pair, Verdict &verdict) const {
    const std::array<float, mostNodes> weights = donorWeights(mesh_, pair.receiver, verdict.donor);
    Transfer &transfer = verdict.transfer;
    for (std::size_t i = 0; i < mesh_.nodes(pair.receiver).size(); ++i) {
        float *row = &transfer.kernel[i * std::size_t(transfer.senders)];
        const float factor = std::accumulate(row, row + transfer.senders, 0.0f);
        for (int j = 0; j < transfer.senders; ++j)
            row[j] = factor * weights[std::size_t(j)];
    }
}

ElementOracle::Range ElementOracle::rangeSent(int e) const {
    Range range{INFINITY, 0};
    for (std::size_t j = 0; j < mesh_.nodes(e).size(); ++j) {
        const float sent = brightest(sentBy(e)[j]);
        range.most = std::max(range.most, sent), range.least = std::min(range.least, sent);
    }
    return range;
}

Verdict ElementOracle::judge(const Pair &pair) const {
    Verdict verdict;
    const auto [a, b] = pair;
    if ((a == b && mesh_.element(a).isFlat) || !isHeard(pair))
        return verdict;
    const bool areAway = a != b && areTurnedAway(mesh_, a, b);
    if (mesh_.element(b).isCut && !areAway) {
        thread_local PlaceLookup lookup;
        verdict.donor = donorOf(mesh_, a, b, lookup);
    }
    const int known = seenOf(pair, verdict).sender;
    const auto [least, most] = rangeSent(known);
    const double area = mesh_.element(a).area;
    if (!(most * area > negligible * settings_.tolerance))
        return verdict;
    if (a == b && isBent(mesh_, a) && isDivisible(a)) {
        verdict.kind = Verdict::Divided;
        return verdict;
    }
    if (areAway) {
        verdict.end = bentEnd(pair);
        if (verdict.end != Verdict::none && mayExchange(pair, most))
            verdict.kind = Verdict::Divided;
        return verdict;
    }
    if (isTooCut(a)) {
        verdict.kind = Verdict::Divided, verdict.end = a;
        return verdict;
    }
    verdict.transfer = transferBetween(mesh_, a, b);
    const double exchanged = double(verdict.transfer.largest) * most * area;
    const double missed =
        (double(verdict.transfer.receiverError) * most +
         double(verdict.transfer.senderError) * (most - least) +
         double(verdict.transfer.curvature) * roughness_[std::size_t(b)]) *
            area +
        (verdict.transfer.isNear ? outlineError * outlineExcess(b) : 0) * exchanged;
    if (isTooCut(b) && (mesh_.element(b).isTorn || cutError * exchanged > settings_.tolerance ||
                        cutError * double(verdict.transfer.largest) * most > settings_.contrast)) {
        verdict.kind = Verdict::Divided, verdict.end = b;
        return verdict;
    }
    const bool isTooBent = isBent(mesh_, a) || isBent(mesh_, b) ||
                           (verdict.transfer.isNear && mesh_.element(b).fullness >= fullest);
    if ((missed > settings_.tolerance || (isTooBent && mayExchange(pair, most))) &&
        (isDivisible(a) || isDivisible(b)))
        verdict.kind = Verdict::Divided;
    else if (exchanged > 0)
        verdict.kind = Verdict::Linked;
    if (verdict.kind == Verdict::Linked && verdict.donor >= 0)
        takeDonor(pair, verdict);
    return verdict;
}

/// By how much what curved edges add to the polygon of its corners makes it larger.
double ElementOracle::outlineExcess(int e) const {
    return mesh_.element(e).isPlane ? std::fabs(double(mesh_.element(e).fullness) - 1) : 0;
}

/// Of lamps, whether they are on for the receiver.
bool ElementOracle::isHeard(const Pair &pair) const {
    return settings_.sent != &Fields::emission ||
           mesh_.scene().lights().isOn(mesh_.domainOf(pair.receiver).lightSet,
                                       mesh_.domainOf(pair.sender).light);
}

/// Of two that seem turned away from each other, the one whose nodes cannot know.
int ElementOracle::bentEnd(const Pair &pair) const {
    for (const int e : {pair.sender, pair.receiver})
        if (isBent(mesh_, e) && isDivisible(e))
            return e;
    return Verdict::none;
}

/// Even if they faced each other all over.
bool ElementOracle::mayExchange(const Pair &pair, double exitance) const {
    const Element &a = mesh_.element(pair.receiver), &b = mesh_.element(pair.sender);
    const double distance = std::max(0.0f, length(b.centre - a.centre) - a.radius - b.radius);
    const double factor = b.area / (M_PI * distance * distance + b.area);
    return factor * exitance * a.area > settings_.tolerance;
}

void ElementOracle::judgeOccluded(const Pair &pair, const Visibility &visibility,
                                  Verdict &verdict) const {
    verdict.visibility = visibility.mean;
    const auto [a, b] = pair;
    const float exitance = rangeSent(seenOf(pair, verdict).sender).most;
    const double exchanged = double(verdict.transfer.largest) * exitance * mesh_.element(a).area;
    const bool mayDivide = isDivisible(a) || isDivisible(b);
    const float seen = brightest(visibility.mean);
    if (seen == 0) {
        verdict.kind = mayDivide && exchanged > closed * settings_.tolerance ? Verdict::Divided
                                                                             : Verdict::Nothing;
        return;
    }
    const double missed = exchanged * 2 * std::min(seen, 1 - seen);
    if (mayDivide && missed > partialShare * settings_.tolerance) {
        verdict.kind = Verdict::Divided;
        return;
    }
    verdict.isRough =
        double(errorAtBorder(mesh_, a, b, verdict.transfer)) * exitance > settings_.contrast;
    if (verdict.isRough && isDivisible(a) &&
        mesh_.element(a).radius > farLarger * mesh_.element(b).radius) {
        verdict.kind = Verdict::Divided, verdict.end = a;
        return;
    }
    if (verdict.donor < 0) {
        refineKernel(mesh_, a, b, verdict.transfer);
        completeKernel(mesh_, a, b, verdict.transfer);
    }
    if (seen < 1)
        for (std::size_t k = 0; k < visibility.share.size(); ++k)
            verdict.transfer.kernel[k] *= visibility.share[k];
}

} // namespace candela::radiosity
