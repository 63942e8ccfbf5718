// SPDX-License-Identifier: Apache-2.0
#include "language/runtime/runtime_functions.h"

#include <gtest/gtest.h>

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
bool isPeriodic(RuntimeFunction f) {
    return std::string(info(f).name).find("pnoise") != std::string::npos;
}

class EachFunction : public testing::TestWithParam<int> {
protected:
    RuntimeFunction which() const { return function(GetParam()); }
    int dimensions() const { return info(which()).inputs / (isPeriodic(which()) ? 2 : 1); }
    std::vector<float> point(std::mt19937 &bits, float extent, float period) const {
        std::uniform_real_distribution<float> number(-extent, extent);
        std::vector<float> inputs;
        for (int k = 0; k < info(which()).inputs; ++k)
            inputs.push_back(k < dimensions() ? number(bits) : period);
        return inputs;
    }
};

TEST_P(EachFunction, AllLevelsAndWidthsAgreeBitByBitOnAnyInput) {
    const auto [name, inputs, outputs] = info(which());
    const float special[] = {NAN,    INFINITY, -INFINITY, 3e38f,       -3e38f, 1e-40f, -0.0f,
                             0,      1e9f,     -1e9f,     16777216.0f, -1,     1,      0.999999940f,
                             -1e-8f, 2.5e9f};
    std::mt19937 bits(7);
    std::uniform_real_distribution<float> number(-300, 300);
    for (int round = 0; round < 200; ++round) {
        alignas(64) float in[maxRuntimeInputs * 16], wide[maxRuntimeOutputs * 16];
        for (float &x : in)
            x = round < 40 && bits() % 2 ? special[bits() % 16] : number(bits);
        for (IsaLevel level : {IsaLevel::V2, IsaLevel::V3, IsaLevel::V4}) {
            if (level > hostIsaLevel())
                continue;
            code(which(), 16, level)(in, wide);
            for (int lane = 0; lane < 16; ++lane) {
                std::vector<float> lanes;
                for (int k = 0; k < inputs; ++k)
                    lanes.push_back(in[k * 16 + lane]);
                float narrow[maxRuntimeOutputs];
                code(which(), 1, level)(lanes.data(), narrow);
                const auto reference = at(which(), lanes);
                for (int k = 0; k < outputs; ++k) {
                    const auto expected = std::bit_cast<std::uint32_t>(reference[k]);
                    ASSERT_EQ(expected, std::bit_cast<std::uint32_t>(narrow[k])) << name;
                    ASSERT_EQ(expected, std::bit_cast<std::uint32_t>(wide[k * 16 + lane]))
                        << name << " lane " << lane << " at level " << int(level);
                    ASSERT_TRUE(reference[k] >= 0 && reference[k] <= 1) << name;
                }
            }
        }
    }
}

TEST_P(EachFunction, HasMeanOneHalfAndIndependentComponents) {
    std::mt19937 bits(11);
    const int count = 40000, outputs = info(which()).outputs;
    std::vector<double> sum(3), squares(3);
    double product = 0;
    for (int i = 0; i < count; ++i) {
        const auto value = at(which(), point(bits, 500, 1000));
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
        GTEST_SKIP() << "cell noise jumps there, which another test looks at";
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
        GTEST_SKIP() << "has no period";
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

INSTANTIATE_TEST_SUITE_P(Runtime, EachFunction, testing::Range(0, int(RuntimeFunction::Count)),
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
