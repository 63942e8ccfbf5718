// SPDX-License-Identifier: Apache-2.0
#include "light/sampling/cone_mixture.h"

#include "foundation/base/hot.h"
#include "foundation/base/lanes.h"
#include "foundation/base/vec3.h"
#include "light/sampling/power.h"
#include "light/sampling/sincos.h"
#include "world/lights/cone_lobe.h"

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

constexpr float pi = float(M_PI);

/// How far a cone may reach below the hemisphere, as a cosine, before it counts as leaving it.
constexpr float rimTolerance = 1e-4f;

CANDELA_HOT void normalizeAxes(int count, const float *__restrict x, const float *__restrict y,
                               const float *__restrict z, float *__restrict ax,
                               float *__restrict ay, float *__restrict az) {
    for (int i = 0; i < count; ++i) {
        float squared = x[i] * x[i] + y[i] * y[i] + z[i] * z[i];
        float scale = squared > 0 ? 1 / std::sqrt(squared) : 0;
        ax[i] = x[i] * scale;
        ay[i] = y[i] * scale;
        az[i] = squared > 0 ? z[i] * scale : 1.0f;
    }
}

/// What some of the cones are not.
struct Others {
    bool simple, hemisphere;
};

/// share = the importance where the cone is finite, else 0.
CANDELA_HOT Others takeImportance(int count, const float *__restrict importance,
                                  const float *__restrict kindAngle, const float *__restrict angle,
                                  const float *__restrict exponent, float *__restrict share) {
    int notSimple = 0, notHemisphere = 0;
    for (int i = 0; i < count; ++i) {
        float r = importance[i];
        int finite = (kindAngle[i] > 0) & (angle[i] > 0) & (r > 0) & (r * 0 == 0);
        int hemisphere = angle[i] == 180;
        int simple = hemisphere & ((exponent[i] == 0) | (exponent[i] == 1));
        share[i] = finite ? r : 0.0f;
        notSimple |= finite & (simple ^ 1);
        notHemisphere |= finite & (hemisphere ^ 1);
    }
    return {notSimple != 0, notHemisphere != 0};
}

CANDELA_HOT void markLeavingHemispheres(int count, const float *__restrict share,
                                        const float *__restrict ax, const float *__restrict ay,
                                        const float *__restrict az, const float *__restrict nx,
                                        const float *__restrict ny, const float *__restrict nz,
                                        float *__restrict full) {
    for (int i = 0; i < count; ++i) {
        float mu = ax[i] * nx[i] + ay[i] * ny[i] + az[i] * nz[i];
        int leaves = (share[i] > 0) & (mu < 1 - rimTolerance);
        full[i] = leaves ? 1.0f : full[i];
    }
}

/// Gathers the shares of cosine lobes about the facing normal, and marks with -1 the points that
/// have cones of any other kind. What differs from the normal by rounding counts as the normal.
CANDELA_HOT void lookForRadial(int count, const float *__restrict share,
                               const float *__restrict angle, const float *__restrict exponent,
                               const float *__restrict nx, const float *__restrict ny,
                               const float *__restrict nz, float *__restrict ax,
                               float *__restrict ay, float *__restrict az,
                               float *__restrict cosineLobes) {
    for (int i = 0; i < count; ++i) {
        float mu = ax[i] * nx[i] + ay[i] * ny[i] + az[i] * nz[i];
        bool aboutNormal = mu >= 1 - 1e-6f;
        bool simple = (angle[i] == 180) & ((exponent[i] == 0) | (exponent[i] == 1));
        bool other = (share[i] > 0) & !(simple & aboutNormal);
        float sum = cosineLobes[i] + (exponent[i] == 1 ? share[i] : 0.0f);
        cosineLobes[i] = other | (cosineLobes[i] < 0) ? -1.0f : sum;
        ax[i] = aboutNormal ? nx[i] : ax[i];
        ay[i] = aboutNormal ? ny[i] : ay[i];
        az[i] = aboutNormal ? nz[i] : az[i];
    }
}

/// Adds the defensive lobe. True if every point has cones about its normal alone.
CANDELA_HOT bool finishRadial(int count, const float *__restrict full, float cosineShare,
                              float *__restrict cosineLobes) {
    int others = 0;
    for (int i = 0; i < count; ++i) {
        bool other = (full[i] > 0) | (cosineLobes[i] < 0);
        float sum = cosineLobes[i] + cosineShare;
        cosineLobes[i] = other ? -1.0f : sum < 1 ? sum : 1.0f;
        others |= other;
    }
    return others == 0;
}

/// Where all lobes lie about the normal the density depends on the height mu alone: with a the
/// share of cosine lobes and b that of uniform ones, a mu^2 + b mu = 1 - xi finds mu for the
/// whole mixture at once. (xi, turn) come from the area-preserving map of the square to the disc
/// (Shirley and Chiu 1997), so that samples stratified over the square stay so.
CANDELA_HOT void radialHeights(int count, const float *__restrict cosineLobes,
                               const float *__restrict u, const float *__restrict v,
                               float *__restrict tau, float *__restrict turn) {
    for (int i = 0; i < count; ++i) {
        float x = 2 * u[i] - 1, y = 2 * v[i] - 1;
        bool wide = std::fabs(x) > std::fabs(y);
        float r = wide ? x : y, other = wide ? y : x;
        float eighths = r != 0 ? other / (r != 0 ? r : 1.0f) * 0.125f : 0.0f;
        float angle = wide ? eighths : 0.25f - eighths;
        angle += r < 0 ? 0.5f : 0.0f;
        angle += angle < 0 ? 1.0f : 0.0f;

        float a = cosineLobes[i], b = 1 - a, rest = 1 - r * r;
        float divisor = b + std::sqrt(b * b + 4 * a * rest);
        float mu = divisor > 0 ? 2 * rest / (divisor > 0 ? divisor : 1.0f) : 0.0f;
        tau[i] = a >= 0 ? 1 - mu : tau[i];
        turn[i] = a >= 0 ? angle : turn[i];
    }
}

CANDELA_HOT void radialPdf(int count, const float *__restrict cosineLobes,
                           const float *__restrict nx, const float *__restrict ny,
                           const float *__restrict nz, const float *__restrict x,
                           const float *__restrict y, const float *__restrict z,
                           float *__restrict pdf) {
    for (int i = 0; i < count; ++i) {
        float mu = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i], a = cosineLobes[i];
        float density = a * mu * (1 / pi) + (1 - a) * (1 / (2 * pi));
        pdf[i] = a >= 0 ? (mu > 0 ? density : 0.0f) : pdf[i];
    }
}

CANDELA_HOT void chooseNormals(int count, const float *__restrict cosineLobes,
                               const float *__restrict normal, float *__restrict axis) {
    for (int i = 0; i < count; ++i)
        axis[i] = cosineLobes[i] >= 0 ? normal[i] : axis[i];
}

CANDELA_HOT void scaleToShares(int count, const float *__restrict total, float coneShare,
                               float *__restrict share) {
    for (int i = 0; i < count; ++i)
        share[i] = total[i] > 0 ? share[i] * (coneShare / total[i]) : 0.0f;
}

/// Lanes whose `u` falls into [low, low + share) take the lobe; low moves on.
CANDELA_HOT void takeLobe(int count, const float *__restrict u, const float *__restrict share,
                          const float *__restrict ax, const float *__restrict ay,
                          const float *__restrict az, const float *__restrict angle,
                          const float *__restrict exponent, float *__restrict low,
                          float *__restrict x, float *__restrict y, float *__restrict z,
                          float *__restrict xi, float *__restrict chosenAngle,
                          float *__restrict chosenExponent) {
    for (int i = 0; i < count; ++i) {
        float from = low[i], to = from + share[i];
        bool take = u[i] >= from && u[i] < to;
        float within = (u[i] - from) / (take ? share[i] : 1.0f);
        x[i] = take ? ax[i] : x[i];
        y[i] = take ? ay[i] : y[i];
        z[i] = take ? az[i] : z[i];
        xi[i] = take ? std::min(within, 0x1.fffffep-1f) : xi[i];
        chosenAngle[i] = take ? angle[i] : chosenAngle[i];
        chosenExponent[i] = take ? exponent[i] : chosenExponent[i];
        low[i] = to;
    }
}

/// The defensive lobes take what is left of the unit interval. Over the full sphere each half
/// gets half of the lobe.
CANDELA_HOT void takeDefensiveLobes(int count, const float *__restrict u,
                                    const float *__restrict low, const float *__restrict full,
                                    const float *__restrict nx, const float *__restrict ny,
                                    const float *__restrict nz, float *__restrict x,
                                    float *__restrict y, float *__restrict z, float *__restrict xi,
                                    float *__restrict angle, float *__restrict exponent) {
    for (int i = 0; i < count; ++i) {
        bool take = u[i] >= low[i];
        float rest = std::min((u[i] - low[i]) / (1 - low[i]), 0x1.fffffep-1f);
        bool uniform = rest < 0.5f;
        float within = uniform ? 2 * rest : 2 * rest - 1;
        bool below = full[i] > 0 && within >= 0.5f;
        float half = full[i] > 0 ? (below ? 2 * within - 1 : 2 * within) : within;
        float sign = below ? -1.0f : 1.0f;
        x[i] = take ? sign * nx[i] : x[i];
        y[i] = take ? sign * ny[i] : y[i];
        z[i] = take ? sign * nz[i] : z[i];
        xi[i] = take ? half : xi[i];
        angle[i] = take ? 180.0f : angle[i];
        exponent[i] = take ? (uniform ? 0.0f : 1.0f) : exponent[i];
    }
}

CANDELA_HOT void simpleHeights(int count, const float *__restrict xi,
                               const float *__restrict exponent, float *__restrict tau) {
    for (int i = 0; i < count; ++i)
        tau[i] = exponent[i] == 1 ? 1 - std::sqrt(1 - xi[i]) : xi[i];
}

/// The largest exponent that lobes have, as ConeLobe limits it.
constexpr float largestExponent = 1e6f;

/// Of lobes over hemispheres, the others' exponents having any value.
CANDELA_HOT void powerHeights(int count, const float *__restrict xi, const float *__restrict angle,
                              const float *__restrict exponent, float *__restrict tau) {
    for (int i = 0; i < count; ++i) {
        const bool simple = (exponent[i] == 0) | (exponent[i] == 1);
        double e = exponent[i] > 0 ? exponent[i] : 0.0f;
        e = e < largestExponent ? e : largestExponent;
        const float height = float(1 - expOf(logOf(1 - double(xi[i])) / (e + 1)));
        tau[i] = simple | (angle[i] != 180) ? tau[i] : height;
    }
}

/// Lobes over hemispheres; the simple ones as addSimplePdf has them. Leaves out all others.
CANDELA_HOT void addPowerPdf(int count, const float *__restrict ax, const float *__restrict ay,
                             const float *__restrict az, const float *__restrict share,
                             const float *__restrict angle, const float *__restrict exponent,
                             const float *__restrict x, const float *__restrict y,
                             const float *__restrict z, float *__restrict pdf) {
    for (int i = 0; i < count; ++i) {
        const float cosine = ax[i] * x[i] + ay[i] * y[i] + az[i] * z[i];
        const float simple = exponent[i] == 1 ? cosine * (1 / pi) : 1 / (2 * pi);
        // By the chord: the product would show how far from 1 the lengths are, as which narrow
        // lobes would take a tenth of their density.
        const double dx = double(ax[i]) - x[i], dy = double(ay[i]) - y[i];
        const double dz = double(az[i]) - z[i];
        const double mu = 1 - (dx * dx + dy * dy + dz * dz) / 2;
        double e = exponent[i] > 0 ? exponent[i] : 0.0f;
        e = e < largestExponent ? e : largestExponent;
        const double power = e * logOf(mu > 1e-30 ? mu : 1e-30);
        const double lobe = (e + 1) * (0.5 / M_PI) * expOf(power > -80 ? power : -80.0);
        const float raised = (mu > 0) & (power > -80) ? float(lobe) : 0.0f;
        const float plain = cosine > 0 ? simple : 0.0f;
        const float density = (exponent[i] == 0) | (exponent[i] == 1) ? plain : raised;
        pdf[i] += angle[i] == 180 ? share[i] * density : 0.0f;
    }
}

CANDELA_HOT void directionsAbout(int count, const float *__restrict ax, const float *__restrict ay,
                                 const float *__restrict az, const float *__restrict tau,
                                 const float *__restrict v, float *__restrict x,
                                 float *__restrict y, float *__restrict z) {
    for (int i = 0; i < count; ++i) {
        float sine, cosine;
        sinCosTurns(v[i], sine, cosine);
        float radius = std::sqrt(std::max(0.0f, tau[i] * (2 - tau[i])));
        float s = radius * cosine, t = radius * sine, n = 1 - tau[i];
        // The frame of orthonormalBasis(), spelled out for the vectoriser.
        float sign = az[i] >= 0 ? 1.0f : -1.0f;
        float a = -1 / (sign + az[i]), b = ax[i] * ay[i] * a;
        x[i] = s * (1 + sign * ax[i] * ax[i] * a) + t * b + n * ax[i];
        y[i] = s * sign * b + t * (sign + ay[i] * ay[i] * a) + n * ay[i];
        z[i] = -s * sign * ax[i] - t * ay[i] + n * az[i];
    }
}

CANDELA_HOT void defensivePdf(int count, const float *__restrict nx, const float *__restrict ny,
                              const float *__restrict nz, const float *__restrict full,
                              const float *__restrict x, const float *__restrict y,
                              const float *__restrict z, float uniformShare, float cosineShare,
                              float *__restrict pdf) {
    for (int i = 0; i < count; ++i) {
        float mu = nx[i] * x[i] + ny[i] * y[i] + nz[i] * z[i];
        float above = mu > 0 ? 1.0f : 0.0f;
        float covered = full[i] > 0 ? 0.5f : above;
        float height = full[i] > 0 ? 0.5f * std::fabs(mu) : std::max(mu, 0.0f);
        pdf[i] = covered * (uniformShare / (2 * pi)) + height * (cosineShare / pi);
    }
}

CANDELA_HOT void addSimplePdf(int count, const float *__restrict ax, const float *__restrict ay,
                              const float *__restrict az, const float *__restrict share,
                              const float *__restrict exponent, const float *__restrict x,
                              const float *__restrict y, const float *__restrict z,
                              float *__restrict pdf) {
    for (int i = 0; i < count; ++i) {
        float mu = ax[i] * x[i] + ay[i] * y[i] + az[i] * z[i];
        float density = exponent[i] == 1 ? mu * (1 / pi) : 1 / (2 * pi);
        pdf[i] += mu > 0 ? share[i] * density : 0.0f;
    }
}

} // namespace

ConeMixture::ConeMixture(int capacity)
    : total_(1, capacity), fullSphere_(1, capacity), cosineLobes_(1, capacity), chosen_(capacity) {}

void ConeMixture::state(int count, const std::vector<ConePlanes> &cones,
                        const ConstVec3Planes &facing, const float *transmits) {
    count_ = count;
    coneCount_ = int(cones.size());
    const bool exact = coneCount_ == 1 && cones[0].exact;
    shares_ = exact ? Shares{1, 0, 0} : Shares{0.9f, 0.05f, 0.05f};
    while (int(cones_.size()) < coneCount_)
        cones_.emplace_back(total_.lanes());
    facing_ = facing;
    if (transmits)
        std::copy_n(transmits, count, fullSphere_[0]);
    else
        std::fill_n(fullSphere_[0], count, 0.0f);
    std::fill_n(total_[0], count, 0.0f);
    for (int k = 0; k < coneCount_; ++k)
        stateCone(k, cones[k]);
    for (int k = 0; k < coneCount_; ++k) {
        markLeavingCones(k);
        scaleToShares(count, total_[0], shares_.cones, cones_[k].share());
    }
    std::fill_n(cosineLobes_[0], count, 0.0f);
    for (int k = 0; k < coneCount_; ++k) {
        const Cone &cone = cones_[k];
        lookForRadial(count, cone.share(), cone.angle(), cone.exponent(), facing[0], facing[1],
                      facing[2], cone.axis(0), cone.axis(1), cone.axis(2), cosineLobes_[0]);
    }
    allRadial_ = finishRadial(count, fullSphere_[0], shares_.cosine, cosineLobes_[0]);
}

void ConeMixture::take(const ConeMixture &from, int count, const int *lane) {
    count_ = count, coneCount_ = from.coneCount_;
    shares_ = from.shares_, allRadial_ = from.allRadial_;
    while (int(cones_.size()) < coneCount_)
        cones_.emplace_back(total_.lanes());
    if (takenFacing_.planes() == 0)
        takenFacing_ = Planes<float>(3, total_.lanes());
    for (int c = 0; c < 3; ++c) {
        lanes::gather(count, lane, from.facing_[c], takenFacing_[c]);
        facing_[c] = takenFacing_[c];
    }
    lanes::gather(count, lane, from.total_[0], total_[0]);
    lanes::gather(count, lane, from.fullSphere_[0], fullSphere_[0]);
    lanes::gather(count, lane, from.cosineLobes_[0], cosineLobes_[0]);
    for (int k = 0; k < coneCount_; ++k) {
        cones_[k].shape = from.cones_[k].shape;
        for (int plane = 0; plane < cones_[k].planes.planes(); ++plane)
            lanes::gather(count, lane, from.cones_[k].planes[plane], cones_[k].planes[plane]);
    }
}

void ConeMixture::stateCone(int index, const ConePlanes &stated) {
    Cone &cone = cones_[index];
    normalizeAxes(count_, stated.axis[0], stated.axis[1], stated.axis[2], cone.axis(0),
                  cone.axis(1), cone.axis(2));
    std::copy_n(stated.angle, count_, cone.angle());
    std::copy_n(stated.exponent, count_, cone.exponent());
    const Others others = takeImportance(count_, stated.importance, stated.kindAngle, stated.angle,
                                         stated.exponent, cone.share());
    cone.shape = others.hemisphere ? LobeShape::Any
                 : others.simple   ? LobeShape::Hemisphere
                                   : LobeShape::Simple;
    lanes::add(count_, cone.share(), total_[0]);
}

/// A cone that reaches below the facing hemisphere asks for a defensive lobe there too.
void ConeMixture::markLeavingCones(int index) {
    const Cone &cone = cones_[index];
    if (cone.shape != LobeShape::Any) {
        markLeavingHemispheres(count_, cone.share(), cone.axis(0), cone.axis(1), cone.axis(2),
                               facing_[0], facing_[1], facing_[2], fullSphere_[0]);
        return;
    }
    for (int i = 0; i < count_; ++i) {
        float mu = cone.axis(0)[i] * facing_[0][i] + cone.axis(1)[i] * facing_[1][i] +
                   cone.axis(2)[i] * facing_[2][i];
        float reach = std::sin(std::min(cone.angle()[i], 180.0f) * (pi / 360));
        if (cone.share()[i] > 0 && (cone.angle()[i] > 180 || mu < reach - rimTolerance))
            fullSphere_[0][i] = 1;
    }
}

void ConeMixture::sample(const float *u, const float *v, const MutableVec3Planes &direction) {
    float *tau = chosen_.tau, *turn = chosen_.turn;
    ConstVec3Planes axis = facing_;
    if (!allRadial_) {
        chooseLobe(u);
        lobeHeights();
        std::copy_n(v, count_, turn);
        for (int c = 0; c < 3; ++c)
            chooseNormals(count_, cosineLobes_[0], facing_[c], chosen_.axis[c]);
        axis = {chosen_.axis[0], chosen_.axis[1], chosen_.axis[2]};
    }
    radialHeights(count_, cosineLobes_[0], u, v, tau, turn);
    directionsAbout(count_, axis[0], axis[1], axis[2], tau, turn, direction[0], direction[1],
                    direction[2]);
}

void ConeMixture::chooseLobe(const float *u) {
    float *low = chosen_.low;
    std::fill_n(low, count_, 0.0f);
    for (int k = 0; k < coneCount_; ++k) {
        const Cone &cone = cones_[k];
        takeLobe(count_, u, cone.share(), cone.axis(0), cone.axis(1), cone.axis(2), cone.angle(),
                 cone.exponent(), low, chosen_.axis[0], chosen_.axis[1], chosen_.axis[2],
                 chosen_.xi, chosen_.angle, chosen_.exponent);
    }
    takeDefensiveLobes(count_, u, low, fullSphere_[0], facing_[0], facing_[1], facing_[2],
                       chosen_.axis[0], chosen_.axis[1], chosen_.axis[2], chosen_.xi, chosen_.angle,
                       chosen_.exponent);
}

void ConeMixture::lobeHeights() {
    const float *xi = chosen_.xi, *angle = chosen_.angle, *exponent = chosen_.exponent;
    float *tau = chosen_.tau;
    simpleHeights(count_, xi, exponent, tau);
    auto some = [&](LobeShape shape) {
        return std::any_of(cones_.begin(), cones_.begin() + coneCount_,
                           [shape](const Cone &cone) { return cone.shape == shape; });
    };
    if (some(LobeShape::Hemisphere) || some(LobeShape::Any))
        powerHeights(count_, xi, angle, exponent, tau);
    if (some(LobeShape::Any))
        for (int i = 0; i < count_; ++i)
            if (angle[i] != 180)
                tau[i] = float(ConeLobe(angle[i], exponent[i]).sampleOneMinusMu(xi[i]));
}

void ConeMixture::pdf(const ConstVec3Planes &w, float *pdf) {
    if (!allRadial_)
        lobesPdf(w, pdf);
    radialPdf(count_, cosineLobes_[0], facing_[0], facing_[1], facing_[2], w[0], w[1], w[2], pdf);
}

/// The sum of all lobes, one by one.
void ConeMixture::lobesPdf(const ConstVec3Planes &w, float *pdf) {
    defensivePdf(count_, facing_[0], facing_[1], facing_[2], fullSphere_[0], w[0], w[1], w[2],
                 shares_.uniform, shares_.cosine, pdf);
    for (int k = 0; k < coneCount_; ++k) {
        const Cone &cone = cones_[k];
        if (cone.shape == LobeShape::Simple) {
            addSimplePdf(count_, cone.axis(0), cone.axis(1), cone.axis(2), cone.share(),
                         cone.exponent(), w[0], w[1], w[2], pdf);
            continue;
        }
        addPowerPdf(count_, cone.axis(0), cone.axis(1), cone.axis(2), cone.share(), cone.angle(),
                    cone.exponent(), w[0], w[1], w[2], pdf);
        if (cone.shape == LobeShape::Hemisphere)
            continue;
        for (int i = 0; i < count_; ++i) {
            if (cone.share()[i] == 0 || cone.angle()[i] == 180)
                continue;
            double chord2 = 0;
            for (int c = 0; c < 3; ++c) {
                const double across = double(cone.axis(c)[i]) - w[c][i];
                chord2 += across * across;
            }
            const double mu = 1 - chord2 / 2;
            pdf[i] +=
                cone.share()[i] * float(ConeLobe(cone.angle()[i], cone.exponent()[i]).pdf(mu));
        }
    }
}

} // namespace candela
