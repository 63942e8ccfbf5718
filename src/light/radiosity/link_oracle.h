// SPDX-License-Identifier: Apache-2.0
// What becomes of a pair of elements: a link, or a finer pair of them (Hanrahan, Salzman and
// Aupperle 1991; the oracle is that of Gortler and others 1993: what the bases miss of the kernel).
#pragma once

#include "light/radiosity/cluster_links.h"
#include "light/radiosity/sources.h"
#include "light/radiosity/transfer.h"
#include "light/radiosity/visibility.h"

#include <climits>
#include <vector>

namespace candela::radiosity {

struct LinkSettings {
    double tolerance = 0; ///< Of the irradiance that a link gets wrong, times area: W.
    double contrast = 0;  ///< Irradiance that links may get wrong without being rough, W m^-2.
    float leastArea = 0;  ///< No element is divided below it.
    /// Elements that something stands on are divided down to it, so that either side gets its own.
    float cutArea = 0;
    std::size_t mostElements = 0, mostLinks = 0;
    SourceSettings sources; ///< For elements that refinement makes.
    /// Exchanged: exitance; or emission, of lamps that are on for the receiver.
    std::vector<Color> Fields::*sent = &Fields::exitance;
};

/// What becomes of a pair.
struct Verdict {
    enum Kind { Nothing, Linked, Divided } kind = Nothing; ///< Or its larger end is opened,
    int end = none;                                        ///< unless it has to be this one.
    static constexpr int none = INT_MAX;
    int donor = -1; ///< Knows what the sender sends: donors.h.
    Transfer transfer;
    Color visibility{};
    bool isRough = false;
};

/// Judges pairs of elements, from any thread.
class ElementOracle {
public:
    /// All must outlive it.
    ElementOracle(const Mesh &, const LinkSettings &, const Fields &);

    /// Elements have been added; `isFull`: and are to be divided no more.
    void beginRound(bool isFull);
    bool isDivisible(int e) const {
        return mesh_.element(e).firstChild >= 0 ||
               (mesh_.element(e).area > 4 * settings_.leastArea && !isFull_);
    }

    /// Before anything is known of what stands between.
    Verdict judge(const Pair &) const;
    /// The pair that the light of a verdict takes its way between.
    static Pair seenOf(const Pair &pair, const Verdict &verdict) {
        return {pair.receiver, verdict.donor >= 0 ? verdict.donor : pair.sender};
    }
    /// And then.
    void judgeOccluded(const Pair &, const Visibility &, Verdict &) const;

private:
    void measureRoughness();
    bool isTooCut(int e) const;
    void takeDonor(const Pair &, Verdict &) const;
    double outlineExcess(int e) const;
    bool isHeard(const Pair &) const;
    int bentEnd(const Pair &) const;
    bool mayExchange(const Pair &, double exitance) const;
    const Color *sentBy(int e) const {
        return (fields_.*settings_.sent).data() + std::size_t(e) * std::size_t(mesh_.stride());
    }
    /// Of the element's nodes.
    struct Range {
        float least, most;
    };
    Range rangeSent(int e) const;

    const Mesh &mesh_;
    const LinkSettings &settings_;
    const Fields &fields_;
    std::vector<float> roughness_; ///< By element.
    bool isFull_ = false;
};

} // namespace candela::radiosity
