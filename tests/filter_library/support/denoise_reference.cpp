// SPDX-License-Identifier: Apache-2.0
#include "tests/filter_library/support/denoise_reference.h"

#include <algorithm>
#include <cmath>

namespace candela::filters {

namespace {

double squaredDistance(const Rgb &a, const Rgb &b) {
    double sum = 0;
    for (int c = 0; c < 3; ++c)
        sum += (a[c] - b[c]) * (a[c] - b[c]);
    return sum;
}

bool inside(const Picture &picture, int x, int y) {
    return x >= 0 && x < picture.width && y >= 0 && y < picture.height;
}

/// Over three by three pixels, and no less than a pixel's own.
Picture smoothed(const Picture &variance) {
    return makePicture(variance.width, variance.height, [&](int x, int y) {
        Rgb sum{};
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
                sum = sum + variance.clamped(x + i, y + j);
        const Rgb &own = variance.at(x, y);
        return Rgb{std::max(sum[0] / 9, own[0]), std::max(sum[1] / 9, own[1]),
                   std::max(sum[2] / 9, own[2])};
    });
}

/// How much patches differ, noise apart: two pictures and their variances at an offset.
struct Patches {
    const Picture &color, &variance;
    int patch;
    double tolerance;

    double pixel(int x, int y, int i, int j) const {
        const Rgb &a = color.at(x, y), &b = color.at(x + i, y + j);
        const Rgb &va = variance.at(x, y), &vb = variance.at(x + i, y + j);
        double sum = 0;
        for (int c = 0; c < 3; ++c) {
            const double d = a[c] - b[c], both = va[c] + vb[c];
            sum += (d * d - both) / (tolerance * tolerance * both + 1e-12);
        }
        return sum / 3;
    }
    /// Pairs that are not both in the picture differ by nothing.
    double operator()(int x, int y, int i, int j) const {
        double sum = 0;
        for (int v = -patch; v <= patch; ++v)
            for (int u = -patch; u <= patch; ++u)
                if (inside(color, x + u, y + v) && inside(color, x + u + i, y + v + j))
                    sum += pixel(x + u, y + v, i, j);
        return std::max(0., sum / ((2 * patch + 1) * (2 * patch + 1)));
    }
};

} // namespace

// --- Non-local means -----------------------------------------------------------------------------

Picture nonLocalMeans(const NoisyScene &scene, const MeansSettings &s) {
    const Picture spread = smoothed(scene.variance);
    const Patches patches{scene.color, spread, s.patch, s.tolerance};
    return makePicture(scene.color.width, scene.color.height, [&](int x, int y) {
        Rgb sum = scene.color.at(x, y);
        double weights = 1;
        for (int j = -s.search; j <= s.search; ++j)
            for (int i = -s.search; i <= s.search; ++i) {
                if ((i == 0 && j == 0) || !inside(scene.color, x + i, y + j))
                    continue;
                double apart = patches(x, y, i, j);
                if (s.bend > 0)
                    apart += squaredDistance(scene.normal.at(x, y), scene.normal.at(x + i, y + j)) /
                             (s.bend * s.bend);
                if (s.shade > 0)
                    apart += squaredDistance(scene.albedo.at(x, y), scene.albedo.at(x + i, y + j)) /
                             (s.shade * s.shade);
                sum = sum + std::exp(-apart) * scene.color.at(x + i, y + j);
                weights += std::exp(-apart);
            }
        return 1 / weights * sum;
    });
}

// --- Regression ----------------------------------------------------------------------------------

namespace {

constexpr double albedoFloor = .0002;

struct Pilot {
    Picture value, variance;
};

Pilot pilotOf(const NoisyScene &scene, const RegressionSettings &s) {
    const int width = scene.color.width, height = scene.color.height;
    Picture light(width, height), error(width, height);
    for (std::size_t k = 0; k < light.pixels.size(); ++k)
        for (int c = 0; c < 3; ++c) {
            const double seen = scene.albedo.pixels[k][c] + albedoFloor;
            light.pixels[k][c] = scene.color.pixels[k][c] / seen;
            error.pixels[k][c] = scene.variance.pixels[k][c] / (seen * seen);
        }
    const Picture spread = smoothed(error);
    const Patches patches{light, spread, s.patch, s.tolerance};
    Pilot pilot{light, spread};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            double weights = 0;
            Rgb sum{}, variance{};
            for (int j = -s.search; j <= s.search; ++j)
                for (int i = -s.search; i <= s.search; ++i) {
                    if (!inside(light, x + i, y + j))
                        continue;
                    const double turn =
                        squaredDistance(scene.normal.at(x, y), scene.normal.at(x + i, y + j));
                    const double weight =
                        i == 0 && j == 0
                            ? 1
                            : std::exp(-patches(x, y, i, j) - turn / (s.bend * s.bend));
                    weights += weight;
                    sum = sum + weight * light.at(x + i, y + j);
                    variance = variance + weight * weight * spread.at(x + i, y + j);
                }
            pilot.value.at(x, y) = 1 / weights * sum;
            pilot.variance.at(x, y) = 1 / (weights * weights) * variance;
        }
    return pilot;
}

/// Where colour falls as albedo rises.
bool isOutline(const NoisyScene &scene, int x, int y) {
    double covariance = 0, colors = 0, albedos = 0, level = 0, albedoLevel = 0;
    for (int channel = 0; channel < 3; ++channel) {
        double c = 0, a = 0, cc = 0, ca = 0, aa = 0;
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i) {
                const double color = scene.color.clamped(x + i, y + j)[channel];
                const double albedo = scene.albedo.clamped(x + i, y + j)[channel];
                c += color, a += albedo;
                cc += color * color, ca += color * albedo, aa += albedo * albedo;
            }
        covariance += 9 * ca - c * a;
        colors += 9 * cc - c * c;
        albedos += 9 * aa - a * a;
        level += c * c;
        albedoLevel += a * a;
    }
    return covariance < 0 && covariance * covariance > .5 * colors * albedos &&
           colors > .1 * level && albedos > .01 * albedoLevel;
}

/// Symmetric equations in three unknowns by elimination; the first unknown.
double firstUnknown(const double (&a)[3][3], const double (&b)[3]) {
    const auto determinant = [](const double(&m)[3][3]) {
        return m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1]) -
               m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0]) +
               m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0]);
    };
    double first[3][3];
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
            first[r][c] = c == 0 ? b[r] : a[r][c];
    return determinant(first) / determinant(a);
}

class Fit {
public:
    Fit(const NoisyScene &scene, const RegressionSettings &settings)
        : scene_(scene), settings_(settings), pilot_(pilotOf(scene, settings)) {}

    Rgb at(int x, int y) const {
        const bool outline = isOutline(scene_, x, y);
        Rgb found{};
        for (int channel = 0; channel < 3; ++channel) {
            double a[3][3] = {}, b[3] = {};
            const int r = settings_.radius;
            for (int j = -r; j <= r; ++j)
                for (int i = -r; i <= r; ++i)
                    add(a, b, {x, y, i, j, channel, outline});
            const double mean = b[0] / a[0][0];
            const double ridge = (outline ? .18 : .001 * r * r) * a[0][0];
            a[1][1] += ridge;
            a[2][2] += ridge;
            found[channel] = std::clamp(firstUnknown(a, b), .5 * mean, 2 * mean);
        }
        return found;
    }

private:
    struct Neighbor {
        int x, y, i, j, channel;
        bool outline;
    };

    void add(double (&a)[3][3], double (&b)[3], const Neighbor &n) const {
        const double w = weight(n);
        const auto seen = [&](int x, int y) {
            return scene_.albedo.clamped(x, y)[n.channel] + albedoFloor;
        };
        const double basis = n.outline ? 1 : seen(n.x + n.i, n.y + n.j) / seen(n.x, n.y);
        const double row[3] = {basis, basis * n.i, basis * n.j};
        for (int p = 0; p < 3; ++p) {
            b[p] += w * row[p] * scene_.color.clamped(n.x + n.i, n.y + n.j)[n.channel];
            for (int q = 0; q < 3; ++q)
                a[p][q] += w * row[p] * row[q];
        }
    }

    double weight(const Neighbor &n) const {
        const int x = n.x + n.i, y = n.y + n.j;
        double apart = 0;
        for (int c = 0; c < 3; ++c) {
            const double own = pilot_.value.at(n.x, n.y)[c];
            const double d = n.outline
                                 ? scene_.color.clamped(x, y)[c] - scene_.color.at(n.x, n.y)[c]
                                 : pilot_.value.clamped(x, y)[c] - own;
            const Picture &variance = n.outline ? scene_.variance : pilot_.variance;
            const double both = variance.at(n.x, n.y)[c] + variance.clamped(x, y)[c];
            const double allowed = n.outline
                                       ? .3 * both
                                       : settings_.fitTolerance * settings_.fitTolerance * both +
                                             settings_.contrast * settings_.contrast * own * own;
            apart += d * d / (allowed + 1e-12) / 3;
        }
        apart += squaredDistance(scene_.normal.at(n.x, n.y), scene_.normal.clamped(x, y)) /
                 (settings_.bend * settings_.bend);
        if (!n.outline)
            apart += double(n.i * n.i + n.j * n.j) / (settings_.radius * settings_.radius);
        return std::exp(-apart);
    }

    const NoisyScene &scene_;
    RegressionSettings settings_;
    Pilot pilot_;
};

} // namespace

Picture regression(const NoisyScene &scene, const RegressionSettings &settings) {
    const Fit fit(scene, settings);
    return makePicture(scene.color.width, scene.color.height,
                       [&](int x, int y) { return fit.at(x, y); });
}

// --- Energy preserving ---------------------------------------------------------------------------

namespace {

class Preserving {
public:
    Preserving(const NoisyScene &scene, const PreservingSettings &settings)
        : scene_(scene), settings_(settings), result_(scene.color), visible_(step()) {}

    Picture run() {
        for (int y = 0; y < result_.height; ++y)
            for (int x = 0; x < result_.width; ++x)
                if (object(x, y) >= 0 && (!settings_.byVariance || noisy(x, y)))
                    spread(x, y);
        return result_;
    }

private:
    struct Place {
        int x, y;
        double weight;
    };

    /// A grey step: of the average without what is more than four times as bright.
    double step() const {
        const double bound = 4 * meanOf(scene_.color, luminanceOf);
        double sum = 0;
        int count = 0;
        for (const Rgb &c : scene_.color.pixels)
            if (luminanceOf(c) <= bound)
                sum += luminanceOf(c), ++count;
        return sum / count / settings_.levels;
    }
    Rgb seen(int x, int y) const {
        const Rgb &albedo = scene_.albedo.at(x, y);
        return {albedo[0] + albedoFloor, albedo[1] + albedoFloor, albedo[2] + albedoFloor};
    }
    Rgb light(int x, int y) const {
        const Rgb &c = scene_.color.at(x, y), s = seen(x, y);
        return {c[0] / s[0], c[1] / s[1], c[2] / s[2]};
    }
    /// -1: at an outline.
    double object(int x, int y) const {
        const double own = scene_.id.at(x, y)[0];
        for (int j = -1; j <= 1; ++j)
            for (int i = -1; i <= 1; ++i)
                if (scene_.id.clamped(x + i, y + j)[0] != own)
                    return -1;
        return own;
    }
    bool noisy(int x, int y) const {
        const Rgb &v = scene_.variance.at(x, y);
        const Rgb deviation{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2])};
        return 1.96 * luminanceOf(deviation) >= settings_.steps * visible_;
    }
    bool receives(int fromX, int fromY, int x, int y) const {
        return inside(result_, x, y) && object(x, y) == object(fromX, fromY) &&
               squaredDistance(scene_.normal.at(x, y), scene_.normal.at(fromX, fromY)) < .09;
    }

    /// The mean light of neighbours, weighed by their distance; false if there are none.
    template <typename Weight> bool mean(int x, int y, Weight weight, double least, Rgb &found) {
        Rgb sum{};
        double weights = 0;
        for (int j = -2; j <= 2; ++j)
            for (int i = -2; i <= 2; ++i)
                if ((i != 0 || j != 0) && receives(x, y, x + i, y + j)) {
                    const double w = weight(i, j);
                    sum = sum + w * light(x + i, y + j);
                    weights += w;
                }
        if (weights < least || weights == 0)
            return false;
        found = 1 / weights * sum;
        return true;
    }

    void spread(int x, int y) {
        Rgb about{};
        const auto calm = [&](int i, int j) { return noisy(x + i, y + j) ? 0. : 1.; };
        const auto near = [&](int i, int j) {
            return std::max(std::abs(i), std::abs(j)) < 2 ? calm(i, j) : 0;
        };
        const auto all = [](int, int) { return 1.; };
        const auto ring = [](int i, int j) { return std::exp(-(i * i + j * j) / 2.); };
        const bool found = settings_.byVariance
                               ? mean(x, y, near, 3, about) || mean(x, y, all, 1, about)
                               : mean(x, y, ring, 0, about);
        if (!found || luminanceOf(about) <= 0)
            return;
        const Rgb own = scene_.color.at(x, y), s = seen(x, y);
        const Rgb goes = own + -1. * Rgb{about[0] * s[0], about[1] * s[1], about[2] * s[2]};
        const double q = luminanceOf(light(x, y)) / luminanceOf(about);
        scatter(x, y, goes,
                settings_.byVariance ? disc(x, y, goes)
                                     : gaussian(x, y, q + std::abs(q - 1) / settings_.fraction));
    }

    /// So many places that each gets less than a grey step; the nearest.
    std::vector<Place> disc(int x, int y, const Rgb &goes) const {
        auto left = std::max(1., std::ceil(std::abs(luminanceOf(goes)) / visible_));
        std::vector<Place> places;
        for (int square = 0; square <= 32 * 32 && left > 0; ++square)
            for (int j = 0; j * j <= square; ++j) {
                const int i = int(std::lround(std::sqrt(square - j * j)));
                if (i * i + j * j != square)
                    continue;
                std::vector<std::array<int, 2>> turns{{i, j}};
                if (square > 0)
                    turns.push_back({-i, -j});
                if (i != 0 && j != 0)
                    turns.insert(turns.end(), {{-i, j}, {i, -j}});
                for (const auto &[u, v] : turns)
                    if (left > 0 && receives(x, y, x + u, y + v))
                        places.push_back({x + u, y + v, 1}), --left;
            }
        return places;
    }

    std::vector<Place> gaussian(int x, int y, double widenSquared) const {
        const double deviation = std::clamp(.3 * std::sqrt(widenSquared), .3, settings_.radius / 3);
        const int out = int(3 * deviation) + 1;
        std::vector<Place> places;
        for (int j = -out; j <= out; ++j)
            for (int i = -out; i <= out; ++i)
                if (i * i + j * j <= 9 * deviation * deviation && receives(x, y, x + i, y + j))
                    places.push_back(
                        {x + i, y + j, std::exp(-.5 * (i * i + j * j) / (deviation * deviation))});
        return places;
    }

    void scatter(int x, int y, const Rgb &goes, const std::vector<Place> &places) {
        result_.at(x, y) = result_.at(x, y) + -1. * goes;
        Rgb shares{};
        for (const Place &p : places)
            shares = shares + p.weight * seen(p.x, p.y);
        for (const Place &p : places)
            for (int c = 0; c < 3; ++c)
                result_.at(p.x, p.y)[c] += goes[c] * p.weight * seen(p.x, p.y)[c] / shares[c];
    }

    const NoisyScene &scene_;
    PreservingSettings settings_;
    Picture result_;
    double visible_;
};

} // namespace

Picture energyPreserving(const NoisyScene &scene, const PreservingSettings &settings) {
    return Preserving(scene, settings).run();
}

} // namespace candela::filters
