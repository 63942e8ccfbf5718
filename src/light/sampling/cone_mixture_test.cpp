// SPDX-License-Identifier: Apache-2.0
#include "light/sampling/cone_mixture.h"

#include "foundation/base/vec3.h"
#include "light/sampling/sobol.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <vector>

namespace candela {
namespace {

struct Stated {
    Vec3 axis;
    float angle, exponent, importance;
};

/// The same mixture in every lane of a batch, about the facing normal (0,0,1).
class Batch {
public:
    Batch(int count, const std::vector<Stated> &cones, bool transmits = false, bool exact = false)
        : count_(count), mixture_(count) {
        constant(0), constant(0), constant(1);
        ConstVec3Planes facing{plane(0), plane(1), plane(2)};
        const float *passes = constant(transmits ? 1.0f : 0.0f);
        std::vector<ConePlanes> planes;
        for (const Stated &cone : cones) {
            const float *x = constant(cone.axis.x), *y = constant(cone.axis.y);
            const float *z = constant(cone.axis.z), *angle = constant(cone.angle);
            const float *exponent = constant(cone.exponent);
            planes.push_back({{x, y, z},
                              angle,
                              exponent,
                              constant(cone.importance),
                              angle,
                              int(planes.size()),
                              true,
                              exact});
        }
        mixture_.state(count, planes, facing, passes);
    }

    std::vector<double> pdf(const std::vector<Vec3> &directions) {
        std::vector<float> x(count_), y(count_), z(count_), result(count_);
        std::vector<double> all;
        for (std::size_t first = 0; first < directions.size(); first += count_) {
            int n = int(std::min<std::size_t>(count_, directions.size() - first));
            for (int i = 0; i < n; ++i)
                x[i] = directions[first + i].x, y[i] = directions[first + i].y,
                z[i] = directions[first + i].z;
            mixture_.pdf({x.data(), y.data(), z.data()}, result.data());
            all.insert(all.end(), result.begin(), result.begin() + n);
        }
        return all;
    }

    std::vector<Vec3> sample(std::uint32_t key) {
        std::vector<std::uint32_t> keys(count_, key), index(count_);
        for (int i = 0; i < count_; ++i)
            index[i] = i;
        std::vector<float> u(count_), v(count_), x(count_), y(count_), z(count_);
        sobolPairs(count_, keys.data(), index.data(), 0, u.data(), v.data());
        mixture_.sample(u.data(), v.data(), {x.data(), y.data(), z.data()});
        std::vector<Vec3> directions;
        for (int i = 0; i < count_; ++i)
            directions.push_back({x[i], y[i], z[i]});
        return directions;
    }

private:
    const float *constant(float value) {
        planes_.emplace_back(std::vector<float>(count_, value));
        return planes_.back().data();
    }
    const float *plane(int i) { return planes_[i].data(); }

    int count_;
    std::vector<std::vector<float>> planes_;
    ConeMixture mixture_;
};

const std::vector<std::vector<Stated>> mixtures = {
    {{{0, 0, 1}, 180, 1, .7f}},
    {{{0, 0, 1}, 180, 0, .7f}},
    {{{0, 0, 2}, 180, 1, .3f}, {{0, 0, 1}, 180, 0, .2f}},
    {{{0, 0, 3}, 180, 1, .3f}, {{1, 0, 1}, 180, 20, .6f}},
    {{{1, 1, 1}, 60, 2, .2f}, {{0, 0, 1}, 180, 1, .1f}, {{0, 1, .2f}, 90, 10, .3f}},
    {{{0, 0, -1}, 120, 3, 1}},
};

constexpr int rows = 512, columns = 1024;

/// Centres of equal-area cells of the sphere: rows in z, columns in azimuth.
std::vector<Vec3> sphere() {
    std::vector<Vec3> directions;
    for (int row = 0; row < rows; ++row)
        for (int column = 0; column < columns; ++column) {
            double z = 1 - 2 * (row + .5) / rows, phi = 2 * M_PI * (column + .5) / columns;
            double r = std::sqrt(1 - z * z);
            directions.push_back({float(r * std::cos(phi)), float(r * std::sin(phi)), float(z)});
        }
    return directions;
}

TEST(ConeMixture, densityIntegratesToOne) {
    for (bool transmits : {false, true})
        for (bool exact : {false, true})
            for (const auto &cones : mixtures) {
                double sum = 0;
                for (double p : Batch(1024, cones, transmits, exact).pdf(sphere()))
                    sum += p * 4 * M_PI / (rows * columns);
                EXPECT_NEAR(sum, 1, 2e-3);
            }
}

/// A lobe that is known to be exact stands alone: what it is asked for, it gives.
TEST(ConeMixture, exactLobesNeedNoDefence) {
    for (const Stated &cone : {Stated{{0, 0, 1}, 180, 1, .7f}, Stated{{0, 0, 2}, 180, 20, .1f},
                               Stated{{1, 0, 1}, 180, 1, 3}}) {
        Batch batch(1024, {cone}, false, true);
        const std::vector<Vec3> directions = batch.sample(pixelKey(5, 17, 3));
        const std::vector<double> density = batch.pdf(directions);
        const Vec3 axis = normalize(cone.axis);
        for (std::size_t i = 0; i < directions.size(); ++i) {
            const double mu = dot(axis, directions[i]);
            EXPECT_GE(mu, -1e-6);
            const double expected = (cone.exponent + 1) / (2 * M_PI) * std::pow(mu, cone.exponent);
            EXPECT_NEAR(density[i], expected, 1e-5 + 1e-4 * expected);
        }
    }
}

TEST(ConeMixture, samplesFollowTheDensity) { // I7: chi-square on 32 x 64 cells.
    for (const auto &cones : mixtures) {
        std::vector<double> expected(32 * 64), found(32 * 64);
        const int keys = 200, batch = 1024;
        std::vector<double> density = Batch(1024, cones).pdf(sphere());
        for (int row = 0; row < rows; ++row)
            for (int column = 0; column < columns; ++column)
                expected[row / (rows / 32) * 64 + column / (columns / 64)] +=
                    density[row * columns + column] * 4 * M_PI / (rows * columns) * keys * batch;
        Batch sampler(batch, cones);
        for (int key = 0; key < keys; ++key)
            for (Vec3 w : sampler.sample(pixelKey(key, 17, 3))) {
                EXPECT_NEAR(length(w), 1, 1e-5);
                double phi = std::atan2(w.y, w.x);
                int column = int((phi < 0 ? phi + 2 * M_PI : phi) / (2 * M_PI) * 64);
                int row = std::clamp(int((1 - w.z) / 2 * 32), 0, 31);
                ++found[row * 64 + std::min(column, 63)];
            }
        // Stratified samples spread less than independent ones, so the bound is one-sided.
        double chiSquare = 0;
        int freedom = 0;
        for (std::size_t cell = 0; cell < expected.size(); ++cell)
            if (expected[cell] > 20) {
                chiSquare += std::pow(found[cell] - expected[cell], 2) / expected[cell];
                ++freedom;
            }
        EXPECT_LT(chiSquare, freedom + 5 * std::sqrt(2.0 * freedom));
    }
}

/// What a point gets must not depend on the others of its batch.
TEST(ConeMixture, pointsDoNotDependOnTheirNeighbours) {
    constexpr int count = 64;
    std::vector<float> zero(count, 0), one(count, 1), flat(count, 180), tilt(count, 0),
        narrow = flat;
    std::vector<float> u(count), v(count);
    for (int i = 0; i < count; ++i) {
        u[i] = (float(i) + 0.5f) / count, v[i] = float(i * 37 % count) / count;
        if (i % 4 == 1)
            tilt[i] = 0.5f;
        if (i % 4 == 2)
            narrow[i] = 40;
    }
    auto answer = [&](const std::vector<float> &axisX, const std::vector<float> &angle,
                      const std::vector<float> &exponent) {
        ConeMixture mixture(count);
        ConstVec3Planes facing{zero.data(), zero.data(), one.data()};
        ConePlanes cone{{axisX.data(), zero.data(), one.data()},
                        angle.data(),
                        exponent.data(),
                        one.data(),
                        angle.data(),
                        0,
                        true};
        mixture.state(count, {cone}, facing, nullptr);
        std::vector<float> x(count), y(count), z(count), pdf(count);
        mixture.sample(u.data(), v.data(), {x.data(), y.data(), z.data()});
        mixture.pdf({x.data(), y.data(), z.data()}, pdf.data());
        return std::array{x, y, z, pdf};
    };
    for (float e : {0.f, 1.f, 7.5f, 3000.f})
        for (float others : {e, 1.f, 20.f}) {
            std::vector<float> same(count, e), varied(count, e);
            for (int i = 3; i < count; i += 4)
                varied[i] = others;
            auto alike = answer(zero, flat, same), mixed = answer(tilt, narrow, varied);
            for (int i = 0; i < count; ++i)
                for (int plane = 0; plane < 4; ++plane)
                    if (tilt[i] == 0 && narrow[i] == 180 && varied[i] == e) {
                        EXPECT_EQ(alike[plane][i], mixed[plane][i]) << i << " exponent " << e;
                    }
        }
}

/// Points taken from a mixture, some again and again, keep their densities.
TEST(ConeMixture, isTakenPointByPoint) {
    constexpr int count = 5, taken = 7;
    const std::vector<float> zero(count, 0), one(count, 1), angle{180, 40, 180, 90, 180};
    const std::vector<float> exponent{1, 1, 30, 0, 1}, tilt{0, .2f, .5f, -.4f, 0};
    const std::vector<float> importance{1, 2, 3, 4, 0}, transmits{0, 0, 1, 0, 0};
    ConePlanes narrow{{tilt.data(), zero.data(), one.data()},
                      angle.data(),
                      exponent.data(),
                      importance.data(),
                      angle.data(),
                      0,
                      true};
    ConePlanes base{{zero.data(), zero.data(), one.data()},
                    one.data(),
                    one.data(),
                    one.data(),
                    one.data(),
                    1,
                    true};
    ConeMixture whole(count), part(16);
    whole.state(count, {narrow, base}, {zero.data(), zero.data(), one.data()}, transmits.data());
    const std::vector<std::int32_t> lane{3, 0, 2, 2, 4, 1, 3};
    part.take(whole, taken, lane.data());
    for (const Vec3 &w : {Vec3{0, 0, 1}, normalize(Vec3{.3f, .1f, 1}), normalize(Vec3{1, 0, -1})}) {
        const std::vector<float> x(16, w.x), y(16, w.y), z(16, w.z);
        std::vector<float> ofWhole(count), ofPart(16);
        whole.pdf({x.data(), y.data(), z.data()}, ofWhole.data());
        part.pdf({x.data(), y.data(), z.data()}, ofPart.data());
        for (int k = 0; k < taken; ++k) {
            EXPECT_EQ(ofPart[k], ofWhole[lane[k]]) << k;
            EXPECT_EQ(part.total()[k], whole.total()[lane[k]]);
        }
    }
}

TEST(ConeMixture, defensiveShareKeepsTheVarianceFinite) { // I8
    // The Lambert integrand cos / pi (mean 1) under a lobe of exponent e: without the defensive
    // share the relative variance is 4 / ((e + 1)(3 - e)) - 1 and has no bound from e = 3 on.
    for (float e : {0.f, 1.f, 2.f, 2.5f, 2.9f, 4.f, 50.f, 1000.f}) {
        Batch batch(1024, {{{0, 0, 1}, 180, e, 1}});
        std::vector<Vec3> directions = sphere();
        std::vector<double> density = batch.pdf(directions);
        double second = 0;
        for (std::size_t i = 0; i < directions.size(); ++i)
            if (directions[i].z > 0)
                second +=
                    std::pow(directions[i].z / M_PI, 2) / density[i] * 4 * M_PI / (rows * columns);
        // p' >= .05 cos / pi bounds f / p' by 20, and its mean square by 20.
        EXPECT_LT(second, 20) << e;
        if (e < 2.6f) {
            double without = 4 / ((e + 1) * (3 - e));
            EXPECT_LT(second, without / .9 + 1e-3) << e;
        }
        double mean = 0, square = 0;
        const int keys = 64;
        for (int key = 0; key < keys; ++key) {
            std::vector<Vec3> sampled = batch.sample(pixelKey(key, 5, 9));
            std::vector<double> p = batch.pdf(sampled);
            for (std::size_t i = 0; i < sampled.size(); ++i) {
                double ratio = std::max(0.f, sampled[i].z) / M_PI / p[i];
                mean += ratio / (keys * 1024.0), square += ratio * ratio / (keys * 1024.0);
            }
        }
        EXPECT_NEAR(mean, 1, 5 * std::sqrt(second / (keys * 1024.0))) << e;
        EXPECT_NEAR(square, second, 0.05 * second) << e;
    }
}

/// Directions of the narrowest lobe that there is are told apart by a float's last digits, but its
/// density is that of the direction that was drawn, whatever rounding has left of the lengths.
TEST(ConeMixture, NarrowLobesHaveTheDensityOfTheirDirections) {
    constexpr double exponent = 1e6;
    for (int k = 0; k < 40; ++k) {
        const float z = 0.999f - 0.02f * float(k), r = std::sqrt(1 - z * z), turn = 2.4f * float(k);
        const Vec3 axis{r * std::cos(turn), r * std::sin(turn), z};
        Batch batch(256, {{axis, 180, float(exponent), 1}});
        const std::vector<Vec3> directions = batch.sample(k);
        const std::vector<double> pdf = batch.pdf(directions);
        int narrow = 0;
        for (std::size_t i = 0; i < directions.size(); ++i) {
            double product = 0, lengths = 0, other = 0;
            for (int c = 0; c < 3; ++c) {
                product += double(axis[c]) * directions[i][c];
                lengths += double(axis[c]) * axis[c];
                other += double(directions[i][c]) * directions[i][c];
            }
            const double mu = product / std::sqrt(lengths * other);
            if (1 - mu > 8 / exponent)
                continue; // Of the defensive share.
            ++narrow;
            const double lobe = (exponent + 1) / (2 * M_PI) * std::pow(mu, exponent);
            EXPECT_NEAR(pdf[i] / (0.9 * lobe), 1, 2e-3) << k << " " << i;
        }
        EXPECT_GT(narrow, 200);
    }
}

} // namespace
} // namespace candela
