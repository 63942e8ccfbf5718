// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/motion_steps.h"

#include "foundation/base/matrix_blend.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candela {

namespace {

/// The ray tracer takes 129 matrices at most.
constexpr int stepCounts[] = {1,  2,  3,  4,  5,  6,  7,  8,  9,  10, 12, 14, 15, 16,  18,
                              20, 24, 25, 30, 32, 36, 40, 48, 50, 60, 64, 80, 96, 100, 128};

/// The largest difference of an entry of the linear parts, and of the translations.
struct Difference {
    double linear = 0, translation = 0;

    void include(const Matrix4d &a, const Matrix4d &b) {
        for (int row = 0; row < 4; ++row)
            for (int column = 0; column < 3; ++column) {
                double &largest = row < 3 ? linear : translation;
                largest = std::max(largest, std::fabs(a.at(row, column) - b.at(row, column)));
            }
    }
};

class Sampler {
public:
    Sampler(const std::function<Matrix4d(double)> &at, std::vector<double> knots,
            const Shutter &shutter)
        : at_(at), open_(shutter.open), length_(double(shutter.close) - shutter.open) {
        for (double &knot : knots)
            knot = std::clamp((knot - open_) / length_, 0.0, 1.0);
        knots.insert(knots.end(), {0, 1});
        std::ranges::sort(knots);
        for (std::size_t k = 0; k < knots.size(); ++k) {
            if (k > 0 && knots[k] > knots[k - 1])
                for (double share : {0.25, 0.5, 0.75})
                    check(knots[k - 1] + share * (knots[k] - knots[k - 1]));
            if (k == 0 || knots[k] > knots[k - 1])
                check(knots[k]);
        }
    }

    bool standsStill() const { return way_.linear == 0 && way_.translation == 0; }
    Matrix4d matrix(double share) const { return at_(open_ + share * length_); }

    /// Whether so many steps are near enough to the truth: at the checks, and between steps.
    bool suffice(int steps) const {
        std::vector<Matrix4d> known;
        for (int k = 0; k <= steps; ++k)
            known.push_back(matrix(double(k) / steps));
        for (const Check &check : checks_)
            if (!isNear(known, check))
                return false;
        for (int k = 0; k < steps; ++k)
            if (const double share = (k + 0.5) / steps; !isNear(known, {share, matrix(share)}))
                return false;
        return true;
    }

private:
    struct Check {
        double share;
        Matrix4d truth;
    };

    void check(double share) {
        checks_.push_back({share, matrix(share)});
        way_.include(checks_.front().truth, checks_.back().truth);
    }

    bool isNear(const std::vector<Matrix4d> &known, const Check &check) const {
        const double place = check.share * double(known.size() - 1);
        const std::size_t step = std::min(std::size_t(place), known.size() - 2);
        const double to = place - double(step);
        Difference off;
        off.include(check.truth, straight(known[step], known[step + 1], to));
        constexpr double tolerance = 1 / 2000.0;
        return off.linear <= tolerance * way_.linear + 1e-7 * largest(check.truth, 0, 3) &&
               off.translation <= tolerance * way_.translation + 1e-7 * largest(check.truth, 3, 4);
    }

    /// Of the entries of some rows.
    static double largest(const Matrix4d &matrix, int first, int last) {
        double size = 0;
        for (int row = first; row < last; ++row)
            for (int column = 0; column < 3; ++column)
                size = std::max(size, std::fabs(matrix.at(row, column)));
        return size;
    }

    const std::function<Matrix4d(double)> &at_;
    const double open_, length_;
    std::vector<Check> checks_;
    Difference way_;
};

} // namespace

std::vector<Matrix4> motionSteps(const std::function<Matrix4d(double)> &currentFromSpace,
                                 std::vector<double> knots, const Shutter &shutter) {
    if (!shutter.hasInterval())
        return {currentFromSpace(shutter.open).rounded()};
    const Sampler sampler(currentFromSpace, std::move(knots), shutter);
    if (sampler.standsStill())
        return {sampler.matrix(0).rounded()};
    const int most = stepCounts[std::size(stepCounts) - 1];
    const int steps = *std::ranges::find_if(
        stepCounts, [&](int count) { return count == most || sampler.suffice(count); });
    std::vector<Matrix4> result;
    for (int k = 0; k <= steps; ++k)
        result.push_back(sampler.matrix(double(k) / steps).rounded());
    return result;
}

Matrix4 matrixAt(std::span<const Matrix4> steps, float share) {
    const float place = share * float(steps.size() - 1);
    const std::size_t step = std::min(std::size_t(place), steps.size() - 2);
    const float to = place - float(step), from = 1 - to;
    Matrix4 result;
    for (std::size_t entry = 0; entry < 16; ++entry)
        result.m[entry] = steps[step].m[entry] * from + steps[step + 1].m[entry] * to;
    return result;
}

void matricesAt(std::span<const Matrix4> steps, float share, float *matrices) {
    const Matrix4 matrix = matrixAt(steps, share);
    std::ranges::copy(matrix.m, matrices);
    std::ranges::copy(inverse(matrix).value_or(Matrix4{}).m, matrices + 16);
}

} // namespace candela
