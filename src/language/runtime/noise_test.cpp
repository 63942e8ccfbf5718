// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/level_code.h"
#include "language/runtime/register_code.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace candela::runtime {
namespace {

std::vector<float> at(RuntimeFunction function, const std::vector<float> &inputs) {
    const float *in[maxRuntimeInputs] = {};
    float result[maxRuntimeOutputs], *out[maxRuntimeOutputs];
    for (std::size_t k = 0; k < inputs.size(); ++k)
        in[k] = &inputs[k];
    for (int k = 0; k < maxRuntimeOutputs; ++k)
        out[k] = &result[k];
    callScalar(function, in, out);
    return std::vector<float>(result, result + info(function).outputs);
}

RuntimeFunction function(int k) { return RuntimeFunction(k); }
bool isCell(RuntimeFunction f) {
    return std::string(info(f).name).find("cell") != std::string::npos;
}
bool givesSlopes(RuntimeFunction f) {
    return std::string(info(f).name).find("slopes") != std::string::npos;
}
bool isPeriodic(RuntimeFunction f) {
    return std::string(info(f).name).find("pnoise") != std::string::npos;
}

class EachFunction : public testing::TestWithParam<int> {
protected:
    RuntimeFunction which() const { return function(GetParam()); }
    bool hasSlopes() const { return givesSlopes(which()); }
    int components() const { return info(which()).outputs / (hasSlopes() ? 1 + dimensions() : 1); }
    int dimensions() const { return info(which()).inputs / (isPeriodic(which()) ? 2 : 1); }
    std::vector<float> point(std::mt19937 &bits, float extent, float period) const {
        std::uniform_real_distribution<float> number(-extent, extent);
        std::vector<float> inputs;
        for (int k = 0; k < info(which()).inputs; ++k)
            inputs.push_back(k < dimensions() ? number(bits) : period);
        return inputs;
    }
};

TEST_P(EachFunction, WidthsAgreeBitByBitOnAnyInputAndV3WithV4) {
    const char *const name = info(which()).name;
    const int inputs = info(which()).inputs, outputs = info(which()).outputs;
    const float special[] = {NAN,    INFINITY, -INFINITY, 3e38f,       -3e38f, 1e-40f, -0.0f,
                             0,      1e9f,     -1e9f,     16777216.0f, -1,     1,      0.999999940f,
                             -1e-8f, 2.5e9f};
    std::mt19937 bits(7);
    std::uniform_real_distribution<float> number(-300, 300);
    for (int round = 0; round < 200; ++round) {
        float in[16][maxRuntimeInputs], v3[16][maxRuntimeOutputs];
        for (auto &point : in)
            for (float &x : point)
                x = round < 40 && bits() % 2 ? special[bits() % 16] : number(bits);
        for (IsaLevel level : {IsaLevel::V2, IsaLevel::V3, IsaLevel::V4}) {
            const int width = registerLanes(level);
            for (int lane = 0; lane < 16 && level <= hostIsaLevel(); ++lane) {
                alignas(64) float inputBlock[maxRuntimeInputs * 16];
                alignas(64) float wide[maxRuntimeOutputs * 16];
                const int first = lane - lane % width;
                for (int k = 0; k < inputs * width; ++k)
                    inputBlock[k] = in[first + k % width][k / width];
                code(which(), width, level)(inputBlock, wide);
                float narrow[maxRuntimeOutputs];
                code(which(), 1, level)(in[lane], narrow);
                if (level == IsaLevel::V3)
                    std::copy(std::begin(narrow), std::end(narrow), v3[lane]);
                for (int k = 0; k < outputs; ++k) {
                    const auto expected = std::bit_cast<std::uint32_t>(narrow[k]);
                    ASSERT_EQ(expected,
                              std::bit_cast<std::uint32_t>(wide[k * width + lane % width]))
                        << name << " lane " << lane << " at level " << int(level);
                    if (level == IsaLevel::V4) {
                        ASSERT_EQ(expected, std::bit_cast<std::uint32_t>(v3[lane][k]));
                    }
                    ASSERT_TRUE(std::isfinite(narrow[k])) << name;
                    if (k < components()) {
                        ASSERT_TRUE(narrow[k] >= 0 && narrow[k] <= 1) << name;
                    }
                }
            }
        }
    }
}

TEST_P(EachFunction, LevelsDifferByRoundingAlone) {
    const char *const name = info(which()).name;
    const int outputs = info(which()).outputs;
    std::mt19937 bits(17);
    for (int i = 0; i < 500; ++i) {
        const auto lanes = point(bits, 100, 64);
        float least[maxRuntimeOutputs], most[maxRuntimeOutputs];
        code(which(), 1, IsaLevel::V2)(lanes.data(), least);
        code(which(), 1, hostIsaLevel())(lanes.data(), most);
        for (int k = 0; k < outputs; ++k)
            ASSERT_NEAR(least[k], most[k], 4e-6) << name;
    }
}

/// By differences over a step, which err by its square times a third derivative, and by rounding.
TEST_P(EachFunction, SlopesAreThoseOfTheValues) {
    if (!hasSlopes())
        return;
    std::mt19937 bits(19);
    const float h = 1.0f / 512;
    double squares = 0;
    for (int i = 0; i < 400; ++i) {
        auto inputs = point(bits, 20, 16);
        const auto here = at(which(), inputs);
        for (int axis = 0; axis < dimensions(); ++axis) {
            auto low = inputs, high = inputs;
            low[axis] -= h, high[axis] += h;
            const auto below = at(which(), low), above = at(which(), high);
            for (int c = 0; c < components(); ++c) {
                const double slope = here[components() + c * dimensions() + axis];
                const double step = double(high[axis]) - low[axis];
                EXPECT_NEAR(slope, (double(above[c]) - below[c]) / step, 1.5e-3);
                squares += slope * slope;
            }
        }
    }
    EXPECT_GT(squares / (400 * dimensions() * components()), 0.02);
}

TEST_P(EachFunction, SlopesStandBesideTheSameValues) {
    if (!hasSlopes())
        return;
    const auto plain =
        function(GetParam() - (int(RuntimeFunction::noise1_slopes) - int(RuntimeFunction::noise1)));
    std::mt19937 bits(23);
    for (int i = 0; i < 100; ++i) {
        const auto inputs = point(bits, 50, 8);
        const auto values = at(plain, inputs), both = at(which(), inputs);
        for (int c = 0; c < components(); ++c)
            EXPECT_EQ(values[c], both[c]);
    }
}

/// Directions of steepest ascent favour no axis: second moments of slopes are those of the sphere
/// in every dimension, fourth ones near them.
TEST_P(EachFunction, SlopesHaveNoPreferredDirection) {
    if (!hasSlopes() || dimensions() < 2)
        return;
    std::mt19937 bits(29);
    const int count = 60000, d = dimensions();
    std::vector<double> second(d * d), fourth(d);
    for (int i = 0; i < count; ++i) {
        const auto result = at(which(), point(bits, 300, 512));
        const float *slope = &result[components()];
        double length = 0;
        for (int k = 0; k < d; ++k)
            length += double(slope[k]) * slope[k];
        for (int k = 0; k < d; ++k) {
            for (int l = 0; l < d; ++l)
                second[k * d + l] += slope[k] * slope[l] / length / count;
            fourth[k] += std::pow(slope[k], 4) / (length * length) / count;
        }
    }
    for (int k = 0; k < d; ++k) {
        for (int l = 0; l < d; ++l)
            EXPECT_NEAR(second[k * d + l] * d, k == l ? 1 : 0, 0.05);
        EXPECT_NEAR(fourth[k] * d * (d + 2) / 3, 1, 0.12);
    }
}

/// Noise some cells away has nothing to do with what is here, along axes and diagonals.
TEST_P(EachFunction, DistantCellsAreUncorrelated) {
    if (isCell(which()) || isPeriodic(which()) || info(which()).outputs > 1)
        return;
    std::mt19937 bits(31);
    const int count = 20000;
    for (int direction = 1; direction < 1 << dimensions(); ++direction)
        for (int distance : {2, 16}) {
            double product = 0, squares = 0;
            for (int i = 0; i < count; ++i) {
                auto inputs = point(bits, 10000, 0);
                const double here = at(which(), inputs)[0] - 0.5;
                for (int k = 0; k < dimensions(); ++k)
                    inputs[k] += direction >> k & 1 ? float(distance) : 0;
                product += here * (at(which(), inputs)[0] - 0.5), squares += here * here;
            }
            EXPECT_NEAR(product / squares, 0, 5 / std::sqrt(double(count)));
        }
}

TEST_P(EachFunction, HasMeanOneHalfAndIndependentComponents) {
    std::mt19937 bits(11);
    const int count = 40000, outputs = components();
    std::vector<double> sum(3), squares(3);
    double product = 0;
    for (int i = 0; i < count; ++i) {
        const auto value = at(which(), point(bits, 100000, 1000));
        for (int k = 0; k < outputs; ++k) {
            sum[k] += value[k];
            squares[k] += (value[k] - 0.5) * (value[k] - 0.5);
        }
        product += (value[0] - 0.5) * (value[outputs - 1] - 0.5);
    }
    for (int k = 0; k < outputs; ++k) {
        EXPECT_NEAR(sum[k] / count, 0.5, isCell(which()) ? 0.01 : 0.012);
        const double deviation = std::sqrt(squares[k] / count);
        if (isCell(which())) {
            EXPECT_NEAR(deviation, std::sqrt(1.0 / 12), 0.005);
        } else { // Less with every dimension, but never flat.
            EXPECT_GT(deviation, 0.08);
            EXPECT_LT(deviation, 0.2);
        }
    }
    if (outputs == 3) {
        EXPECT_NEAR(product / squares[0], 0, 0.1);
    }
}

TEST_P(EachFunction, IsSmoothAcrossLatticeLines) {
    if (isCell(which()))
        return;
    std::mt19937 bits(3);
    const float h = 1.0f / 64;
    double largestInside = 0;
    for (int i = 0; i < 300; ++i) {
        auto inputs = point(bits, 20, 16);
        const auto along = [&](float x) {
            inputs[0] = x;
            return double(at(which(), inputs)[0]);
        };
        const float line = std::floor(inputs[0]);
        const double second = (along(line + h) - 2 * along(line) + along(line - h)) / (h * h);
        // Fading has no first and second derivative there: what is left is of third order.
        const double left = (along(line) - along(line - h)) / h;
        const double right = (along(line + h) - along(line)) / h;
        EXPECT_NEAR(left, right, 0.05);
        EXPECT_NEAR(second, 0, 2.5);
        const float middle = line + 0.25f;
        largestInside =
            std::max(largestInside,
                     std::abs(along(middle + h) - 2 * along(middle) + along(middle - h)) / (h * h));
        EXPECT_NEAR(along(line + 1 - 1e-4f), along(line + 1 + 1e-4f), 1e-3);
    }
    EXPECT_GT(largestInside, 1);
}

TEST_P(EachFunction, RepeatsWithItsPeriod) {
    if (!isPeriodic(which()))
        return;
    std::mt19937 bits(5);
    for (int i = 0; i < 200; ++i) {
        auto inputs = point(bits, 30, 7);
        for (int k = 0; k < dimensions(); ++k)
            inputs[k] = (std::floor(inputs[k] * 64) + 0.5f) / 64; // Shifting loses no bits then.
        const auto here = at(which(), inputs);
        auto shifted = inputs;
        shifted[i % dimensions()] += i % 2 ? 7 : -14;
        EXPECT_EQ(here, at(which(), shifted));
        shifted[i % dimensions()] = inputs[i % dimensions()] + 3;
        EXPECT_NE(here, at(which(), shifted));
    }
}

TEST_P(EachFunction, IsOneHalfOnTheLatticeOrConstantInCells) {
    std::mt19937 bits(9);
    for (int i = 0; i < 100; ++i) {
        auto inputs = point(bits, 50, 9);
        for (int k = 0; k < dimensions(); ++k)
            inputs[k] = std::floor(inputs[k]);
        const auto corner = at(which(), inputs);
        if (!isCell(which())) {
            EXPECT_EQ(corner[0], 0.5f);
            continue;
        }
        inputs[0] += 0.75f;
        EXPECT_EQ(corner, at(which(), inputs));
        inputs[0] += 0.5f;
        EXPECT_NE(corner, at(which(), inputs));
    }
}

INSTANTIATE_TEST_SUITE_P(Runtime, EachFunction, testing::Range(0, int(firstBound)),
                         [](const auto &info) {
                             return std::string(runtime::info(function(info.param)).name);
                         });

TEST(Noise, ReachesBothEndsOfItsRange) {
    std::mt19937 bits(13);
    std::uniform_real_distribution<float> number(-1000, 1000);
    float least = 1, most = 0;
    for (int i = 0; i < 400000; ++i) {
        const float value = at(RuntimeFunction::noise2, {number(bits), number(bits)})[0];
        least = std::min(least, value);
        most = std::max(most, value);
    }
    EXPECT_LT(least, 0.06f);
    EXPECT_GT(most, 0.94f);
}

} // namespace
} // namespace candela::runtime
