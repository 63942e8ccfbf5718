// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_projection.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace candela {

double legendre(int degree, double x) {
    switch (degree) {
    case 0: return 1;
    case 1: return std::sqrt(3.0) * (2 * x - 1);
    default: return std::sqrt(5.0) * (6 * x * x - 6 * x + 1);
    }
}

namespace {

constexpr std::size_t quantityCount = 3, channels = std::size_t(colorSamples);
constexpr int batch = 512;
constexpr int mostHalvings = 48;
/// Where nothing is known boxes are halved this often, for want of anything better.
constexpr int halvingsInTheDark = 12;

/// A plane, and how far it may be off.
struct Plane {
    double value = 0, byU = 0, byV = 0, tolerance = 0;
};

/// How a part is best cut: an edge along v wants halves along u alone.
enum class Cut { Untried, AlongU, AlongV, Both };

/// A part of the box, in its own coordinates from 0 to 1.
struct Part {
    double x = .5, y = .5, wide = 1, high = 1;
    int halvings = 0;
    Cut cut = Cut::Untried;
    std::array<std::array<Plane, channels>, quantityCount> planes{};
    double worst = 0;  ///< Greatest tolerance.
    double weight = 0; ///< What it may add to a coefficient's error, whichever it is.

    double area() const { return wide * high; }
};

/// What it becomes; not yet asked about.
std::vector<Part> piecesOf(const Part &whole, Cut cut) {
    const bool alongU = cut != Cut::AlongV, alongV = cut != Cut::AlongU;
    std::vector<Part> pieces;
    for (int k = 0; k < (alongU ? 2 : 1); ++k)
        for (int n = 0; n < (alongV ? 2 : 1); ++n) {
            Part piece;
            piece.wide = whole.wide / (alongU ? 2 : 1), piece.high = whole.high / (alongV ? 2 : 1);
            piece.x = whole.x + (alongU ? (k - .5) * piece.wide : 0);
            piece.y = whole.y + (alongV ? (n - .5) * piece.high : 0);
            piece.halvings = whole.halvings + alongU + alongV;
            pieces.push_back(piece);
        }
    return pieces;
}

/// Of a polynomial over an interval: its integral, that of its product with the way from the
/// middle, and at least that of its size.
struct Moments {
    double plain = 0, first = 0, size = 0;
};

Moments momentsOf(int degree, double middle, double side) {
    // Gauss' three points: exact up to degree 5.
    const double place = std::sqrt(0.6) / 2 * side;
    Moments m;
    for (const auto &[offset, weight] :
         {std::pair(-place, 5.0 / 18), std::pair(0.0, 8.0 / 18), std::pair(place, 5.0 / 18)}) {
        const double value = legendre(degree, middle + offset) * weight * side;
        m.plain += value, m.first += value * offset;
    }
    double most = 0;
    for (double x : {middle - side / 2, middle + side / 2,
                     std::clamp(.5, middle - side / 2, middle + side / 2)})
        most = std::max(most, std::abs(legendre(degree, x)));
    m.size = most * side;
    return m;
}

/// Directions to the viewer, spread as the cosine about an axis: in the axis' own frame.
std::vector<std::array<double, 3>> viewsOf(int count) {
    if (count <= 1)
        return {{0, 0, 1}};
    std::vector<std::array<double, 3>> views;
    for (int k = 0; k < count; ++k) {
        const double squared = (k + .5) / count, angle = k * 2.399963229728653;
        views.push_back({std::sqrt(squared) * std::cos(angle), std::sqrt(squared) * std::sin(angle),
                         std::sqrt(1 - squared)});
    }
    return views;
}

class Projector {
public:
    Projector(const ShaderInstance &instance, const BoxPlacer &place, const ParameterBox &box,
              const ProjectionSettings &settings)
        : boxes_(instance, batch), place_(place), box_(box), settings_(settings),
          views_(viewsOf(settings.views)) {}

    Projection run() {
        std::vector<Part> first(1);
        askAll(first);
        parts_ = std::move(first);
        for (std::vector<Part> wholes = takeWorst(); !wholes.empty(); wholes = takeWorst())
            refine(wholes);
        return sum();
    }

private:
    /// Takes out the parts that the error comes from mostly; none, if it is small enough.
    std::vector<Part> takeWorst() {
        const double tolerance = double(settings_.tolerance);
        double error = 0;
        std::vector<std::pair<double, std::size_t>> byWeight;
        for (const Part &part : parts_) {
            error += part.weight;
            if (part.weight > 0 && part.halvings < mostHalvings)
                byWeight.push_back({-part.weight, std::size_t(&part - parts_.data())});
        }
        if (error <= tolerance || parts_.size() * views_.size() > std::size_t(settings_.mostBoxes))
            return {};
        std::ranges::sort(byWeight);
        std::vector<bool> isTaken(parts_.size());
        std::vector<Part> worst;
        double taken = 0;
        for (const auto &[weight, k] : byWeight) {
            if (taken >= error - tolerance / 2)
                break;
            taken -= weight;
            isTaken[k] = true;
            worst.push_back(parts_[k]);
        }
        std::size_t kept = 0;
        for (std::size_t k = 0; k < parts_.size(); ++k)
            if (!isTaken[k]) {
                if (kept != k)
                    parts_[kept] = parts_[k];
                ++kept;
            }
        parts_.resize(kept);
        return worst;
    }

    /// Puts pieces in their places; of those whose best cut is not known, both are tried.
    void refine(const std::vector<Part> &wholes) {
        std::vector<Part> asked;
        for (const Part &whole : wholes) {
            const bool isUntried = whole.cut == Cut::Untried;
            std::ranges::move(piecesOf(whole, isUntried ? Cut::AlongU : whole.cut),
                              std::back_inserter(asked));
            if (isUntried)
                std::ranges::move(piecesOf(whole, Cut::AlongV), std::back_inserter(asked));
        }
        askAll(asked);
        auto next = asked.begin();
        const auto take = [&](int count, Cut cut) {
            for (int k = 0; k < count; ++k) {
                parts_.push_back(std::move(next[k]));
                parts_.back().cut = cut;
            }
        };
        const auto weight = [&](int first) { return next[first].weight + next[first + 1].weight; };
        for (const Part &whole : wholes) {
            const double before = whole.weight;
            switch (whole.cut) {
            case Cut::Untried: {
                const double alongU = weight(0), alongV = weight(2);
                const bool isEven = std::max(alongU, alongV) < 1.25 * std::min(alongU, alongV);
                const bool takesU = isEven ? whole.wide >= whole.high : alongU < alongV;
                if (!takesU)
                    std::swap_ranges(next, next + 2, next + 2);
                take(2, isEven ? Cut::Both : takesU ? Cut::AlongU : Cut::AlongV);
                next += 4;
                break;
            }
            case Cut::Both: {
                const bool helps = weight(0) + weight(2) < .35 * before;
                take(4, helps ? Cut::Both : Cut::Untried);
                next += 4;
                break;
            }
            default: take(2, weight(0) < .75 * before ? whole.cut : Cut::Untried); next += 2;
            }
        }
    }

    /// Where nothing is known a part is cut a few times as if much were off, and then taken as it
    /// is.
    double weightOf(const Part &part) const {
        if (part.worst < std::numeric_limits<float>::max())
            return part.worst * part.area() * mostOf(part);
        return part.halvings < halvingsInTheDark ? part.area() : 0;
    }
    double mostOf(const Part &part) const {
        double along[2] = {0, 0};
        for (int i = 0; i <= settings_.degree; ++i) {
            along[0] = std::max(along[0], momentsOf(i, part.x, part.wide).size / part.wide);
            along[1] = std::max(along[1], momentsOf(i, part.y, part.high).size / part.high);
        }
        return along[0] * along[1];
    }

    void askAll(std::vector<Part> &parts) {
        const int views = int(views_.size());
        const std::size_t together = std::size_t(std::max(1, batch / views));
        for (std::size_t first = 0; first < parts.size(); first += together) {
            const std::size_t count = std::min(together, parts.size() - first);
            int lane = 0;
            for (std::size_t k = 0; k < count; ++k)
                for (int view = 0; view < views; ++view)
                    placeLane(lane++, parts[first + k], views_[std::size_t(view)]);
            boxes_.ask(lane);
            calls_ += lane;
            lane = 0;
            for (std::size_t k = 0; k < count; ++k) {
                Part &part = parts[first + k];
                for (int view = 0; view < views; ++view)
                    take(lane++, part);
                part.weight = weightOf(part);
            }
        }
    }

    void placeLane(int lane, const Part &part, const std::array<double, 3> &view) {
        const ParameterBox box{box_.u + (part.x - .5) * box_.Du, box_.v + (part.y - .5) * box_.Dv,
                               box_.Du * part.wide, box_.Dv * part.high};
        place_(boxes_, lane, box);
        boxes_.set(ShaderInput::Du, lane, {float(box.Du)});
        boxes_.set(ShaderInput::Dv, lane, {float(box.Dv)});
        const float *axis[3];
        for (int c = 0; c < 3; ++c)
            axis[c] = boxes_.plane(ShaderInput(int(ShaderInput::fieldAxis) + c));
        const double n[3] = {double(axis[0][lane]), double(axis[1][lane]), double(axis[2][lane])};
        const double sign = n[2] < 0 ? -1 : 1, a = -1 / (sign + n[2]), b = n[0] * n[1] * a;
        const double x[3] = {1 + sign * n[0] * n[0] * a, sign * b, -sign * n[0]};
        const double y[3] = {b, sign + n[1] * n[1] * a, -n[1]};
        float I[3];
        for (int c = 0; c < 3; ++c)
            I[c] = -float(view[0] * x[c] + view[1] * y[c] + view[2] * n[c]);
        boxes_.set(ShaderInput::I, lane, {I[0], I[1], I[2]});
    }

    /// Adds a view's share.
    void take(int lane, Part &part) {
        const BoundPlanes bounds[] = {boxes_.reflectance(), boxes_.emission(), boxes_.opacity()};
        const double share = 1.0 / double(views_.size());
        for (std::size_t q = 0; q < quantityCount; ++q)
            for (std::size_t c = 0; c < channels; ++c) {
                Plane &plane = part.planes[q][c];
                plane.value += share * double(bounds[q].value[c][lane]);
                plane.byU += share * double(bounds[q].byU[c][lane]);
                plane.byV += share * double(bounds[q].byV[c][lane]);
                plane.tolerance += share * double(bounds[q].tolerance[c][lane]);
                part.worst = std::max(part.worst, plane.tolerance);
            }
    }

    Projection sum() const {
        const int terms = settings_.degree + 1;
        Projection result;
        std::vector<Projection::Coefficient> *lists[] = {&result.reflectance, &result.emission,
                                                         &result.opacity};
        for (auto *list : lists)
            list->assign(std::size_t(terms * terms), {});
        std::vector<double> errors(std::size_t(terms * terms) * quantityCount * channels);
        double narrowest = 1, lowest = 1;
        for (const Part &part : parts_) {
            narrowest = std::min(narrowest, part.wide), lowest = std::min(lowest, part.high);
            for (int j = 0; j < terms; ++j)
                for (int i = 0; i < terms; ++i) {
                    const Moments along = momentsOf(i, part.x, part.wide);
                    const Moments across = momentsOf(j, part.y, part.high);
                    const std::size_t k = std::size_t(j * terms + i);
                    for (std::size_t q = 0; q < quantityCount; ++q)
                        for (std::size_t c = 0; c < channels; ++c) {
                            const Plane &plane = part.planes[q][c];
                            (*lists[q])[k][c] += plane.value * along.plain * across.plain +
                                                 plane.byU * box_.Du * along.first * across.plain +
                                                 plane.byV * box_.Dv * along.plain * across.first;
                            errors[(k * quantityCount + q) * channels + c] +=
                                plane.tolerance * along.size * across.size;
                        }
                }
        }
        result.error = *std::ranges::max_element(errors);
        result.boundCalls = calls_;
        result.plainCalls = double(views_.size()) / (narrowest * lowest);
        return result;
    }

    BoxBounds boxes_;
    const BoxPlacer &place_;
    ParameterBox box_;
    ProjectionSettings settings_;
    std::vector<std::array<double, 3>> views_;
    std::vector<Part> parts_;
    long calls_ = 0;
};

} // namespace

Projection project(const ShaderInstance &instance, const BoxPlacer &place, const ParameterBox &box,
                   const ProjectionSettings &settings) {
    return Projector(instance, place, box, settings).run();
}

} // namespace candela
