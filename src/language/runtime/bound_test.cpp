// SPDX-License-Identifier: Apache-2.0
// Arithmetic of affine forms: of random forms and random members of them, no result lies outside.
#include "language/runtime/level_code.h"
#include "language/runtime/runtime_functions.h"
#include "language/runtime/scalar_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace candela::runtime {
namespace {

constexpr float endless = std::numeric_limits<float>::infinity();

struct Form {
    float middle, alongU, alongV, off, least, greatest;

    std::vector<float> numbers() const { return {middle, alongU, alongV, off, least, greatest}; }
    bool has(float x, double a, double b) const {
        if (std::isnan(x))
            return least == -endless && greatest == endless;
        const double plane = double(middle) + a * double(alongU) + b * double(alongV);
        return least <= x && x <= greatest &&
               (off == endless || x == middle || std::fabs(double(x) - plane) <= double(off));
    }
};

Form call(RuntimeFunction function, float middle, const std::vector<float> &inputs) {
    const float *in[maxRuntimeInputs] = {};
    float result[maxRuntimeOutputs], *out[maxRuntimeOutputs];
    for (std::size_t k = 0; k < inputs.size(); ++k)
        in[k] = &inputs[k];
    for (int k = 0; k < maxRuntimeOutputs; ++k)
        out[k] = &result[k];
    callScalar(function, in, out);
    return {middle, result[0], result[1], result[2], result[3], result[4]};
}

std::vector<float> joined(std::vector<float> x, const std::vector<float> &y) {
    x.insert(x.end(), y.begin(), y.end());
    return x;
}

class Random {
public:
    explicit Random(unsigned seed) : bits_(seed) {}

    int below(int n) { return int(bits_() % unsigned(n)); }
    float within(float a, float b) { return std::uniform_real_distribution<float>(a, b)(bits_); }
    float sized() { return below(4) ? within(-3, 3) : std::ldexp(within(-1, 1), below(60) - 30); }

    Form form() {
        Form f{sized(), 0, 0, 0, 0, 0};
        const float spread = below(6) ? std::ldexp(within(0, 1), -below(12)) * 4 : 0;
        f.alongU = within(-spread, spread), f.alongV = within(-spread, spread);
        f.off = below(3) ? within(0, spread) : 0;
        const float reach = std::fabs(f.alongU) + std::fabs(f.alongV) + f.off;
        f.least = f.middle - reach, f.greatest = f.middle + reach;
        if (below(2)) { // A range that says more.
            f.least = within(f.least, f.middle);
            f.greatest = within(f.middle, f.greatest);
        }
        return f;
    }
    /// The value at (a, b), one of those that the form allows; none if there is none.
    bool member(const Form &f, double a, double b, float &x) {
        const double plane = double(f.middle) + a * double(f.alongU) + b * double(f.alongV);
        const double low = std::max(plane - double(f.off), double(f.least));
        const double high = std::min(plane + double(f.off), double(f.greatest));
        if (low > high)
            return false;
        const double at = low + (high - low) * (below(3) ? double(within(0, 1)) : below(2));
        x = float(at);
        return f.has(x, a, b);
    }

private:
    std::mt19937 bits_;
};

using Binary = float (*)(float, float);
struct BinaryCase {
    const char *name;
    RuntimeFunction function;
    Binary value;
};
const BinaryCase binaries[] = {
    {"sum", RuntimeFunction::bound_sum, [](float x, float y) { return x + y; }},
    {"difference", RuntimeFunction::bound_difference, [](float x, float y) { return x - y; }},
    {"product", RuntimeFunction::bound_product, [](float x, float y) { return x * y; }},
    {"quotient", RuntimeFunction::bound_quotient, [](float x, float y) { return x / y; }},
    {"greatest", RuntimeFunction::bound_greatest, [](float x, float y) { return x > y ? x : y; }},
    {"least", RuntimeFunction::bound_least, [](float x, float y) { return x < y ? x : y; }}};

TEST(Bounds, HoldForAllMembersOfTwoForms) {
    for (const BinaryCase &c : binaries) {
        Random random(3);
        int finite = 0;
        for (int round = 0; round < 20000; ++round) {
            const Form x = random.form(), y = random.form();
            const Form result =
                call(c.function, c.value(x.middle, y.middle), joined(x.numbers(), y.numbers()));
            finite += result.off < endless;
            for (int n = 0; n < 8; ++n) {
                const double a = double(random.within(-1, 1)), b = double(random.within(-1, 1));
                float p, q;
                if (random.member(x, a, b, p) && random.member(y, a, b, q)) {
                    ASSERT_TRUE(result.has(c.value(p, q), a, b))
                        << c.name << " of " << p << " and " << q << " is " << c.value(p, q)
                        << ", round " << round;
                }
            }
        }
        EXPECT_GT(finite, 10000) << c.name;
    }
}

TEST(Bounds, HoldForAllMembersOfOneForm) {
    const std::array<std::pair<RuntimeFunction, float (*)(float)>, 2> cases{
        {{RuntimeFunction::bound_square, [](float x) { return x * x; }},
         {RuntimeFunction::bound_magnitude, [](float x) { return std::fabs(x); }}}};
    Random random(4);
    for (const auto &[function, value] : cases)
        for (int round = 0; round < 20000; ++round) {
            const Form x = random.form(), result = call(function, value(x.middle), x.numbers());
            for (int n = 0; n < 8; ++n) {
                const double a = double(random.within(-1, 1)), b = double(random.within(-1, 1));
                float p;
                if (random.member(x, a, b, p)) {
                    ASSERT_TRUE(result.has(value(p), a, b)) << p;
                }
            }
        }
}

TEST(Bounds, AUnionHasTheMembersOfBoth) {
    Random random(5);
    for (int round = 0; round < 20000; ++round) {
        const Form x = random.form(), y = random.form();
        const float middle = random.below(2) ? x.middle : y.middle;
        const Form result = call(RuntimeFunction::bound_union, middle,
                                 joined({middle}, joined(x.numbers(), y.numbers())));
        for (const Form &f : {x, y}) {
            const double a = double(random.within(-1, 1)), b = double(random.within(-1, 1));
            float p;
            if (random.member(f, a, b, p)) {
                ASSERT_TRUE(result.has(p, a, b));
            }
        }
    }
}

TEST(Bounds, ChainsHoldForConvexAndForOddFunctions) {
    struct Case {
        float (*value)(float);
        float (*slope)(float);
        bool isOdd;
    };
    const Case cases[] = {
        {[](float x) { return runtime::exp(x); }, [](float x) { return runtime::exp(x); }, false},
        {[](float x) { return runtime::atan(x); }, [](float x) { return 1 / (1 + x * x); }, true}};
    Random random(6);
    for (const Case &c : cases)
        for (int round = 0; round < 20000; ++round) {
            const Form x = random.form();
            const float middle = c.value(x.middle);
            const float place = c.isOdd ? -x.middle : x.middle;
            const Form result =
                call(RuntimeFunction::bound_chain, middle,
                     joined(x.numbers(), {middle, c.slope(x.middle), c.value(x.least),
                                          c.value(x.greatest), place, c.value(place)}));
            for (int n = 0; n < 8; ++n) {
                const double a = double(random.within(-1, 1)), b = double(random.within(-1, 1));
                float p;
                if (random.member(x, a, b, p)) {
                    ASSERT_TRUE(result.has(c.value(p), a, b)) << p << " about " << x.middle;
                }
            }
        }
}

TEST(Bounds, WhatIsTheSameAllOverStaysSo) {
    const Form two{2, 0, 0, 0, 2, 2}, three{3, 0, 0, 0, 3, 3};
    for (const BinaryCase &c : binaries) {
        const float value = c.value(2, 3);
        const Form result = call(c.function, value, joined(two.numbers(), three.numbers()));
        EXPECT_EQ(result.off, 0) << c.name;
        EXPECT_EQ(result.least, value) << c.name;
        EXPECT_EQ(result.greatest, value) << c.name;
    }
}

TEST(Bounds, NothingIsKnownOfAQuotientByWhatMayBe0AndClampsKnowSomethingAgain) {
    const Form one{1, 0, 0, 0, 1, 1}, small{.5f, 1, 0, 0, -.5f, 1.5f};
    const Form ratio =
        call(RuntimeFunction::bound_quotient, 2, joined(one.numbers(), small.numbers()));
    EXPECT_EQ(ratio.off, endless);
    const Form clamped =
        call(RuntimeFunction::bound_least, 1, joined(ratio.numbers(), one.numbers()));
    EXPECT_NEAR(clamped.greatest, 1, 1e-6);
    EXPECT_EQ(clamped.least, -endless);
    const Form both = call(RuntimeFunction::bound_greatest, 1,
                           joined(clamped.numbers(), Form{0, 0, 0, 0, 0, 0}.numbers()));
    EXPECT_LE(both.off, 1.001f);
    // Max gives its second operand where one is no number.
    const Form unsure =
        call(RuntimeFunction::bound_greatest, 2, joined(one.numbers(), ratio.numbers()));
    EXPECT_EQ(unsure.off, endless);
}

TEST(Bounds, WidthsAndLevelsAgreeBitByBit) {
    const float special[] = {NAN, endless, -endless, 3e38f, 1e-40f, -0.0f, 0, 1, -1};
    Random random(8);
    for (int k = int(firstBound); k < int(RuntimeFunction::Count); ++k) {
        const auto function = RuntimeFunction(k);
        const int inputs = info(function).inputs, outputs = info(function).outputs;
        for (int round = 0; round < 300; ++round) {
            float in[16][maxRuntimeInputs];
            for (auto &point : in)
                for (float &x : point)
                    x = random.below(5) ? random.sized() : special[random.below(9)];
            for (IsaLevel level : {IsaLevel::V2, IsaLevel::V3, IsaLevel::V4}) {
                const int width = registerLanes(level);
                for (int lane = 0; lane < 16 && level <= hostIsaLevel(); ++lane) {
                    alignas(64) float block[maxRuntimeInputs * 16], wide[maxRuntimeOutputs * 16];
                    const int first = lane - lane % width;
                    for (int n = 0; n < inputs * width; ++n)
                        block[n] = in[first + n % width][n / width];
                    code(function, width, level)(block, wide);
                    float narrow[maxRuntimeOutputs], least[maxRuntimeOutputs];
                    code(function, 1, level)(in[lane], narrow);
                    code(function, 1, IsaLevel::V2)(in[lane], least);
                    for (int n = 0; n < outputs; ++n) {
                        ASSERT_EQ(std::bit_cast<std::uint32_t>(narrow[n]),
                                  std::bit_cast<std::uint32_t>(wide[n * width + lane % width]))
                            << info(function).name << " at level " << int(level);
                        ASSERT_EQ(std::bit_cast<std::uint32_t>(narrow[n]),
                                  std::bit_cast<std::uint32_t>(least[n]));
                    }
                }
            }
        }
    }
}

} // namespace
} // namespace candela::runtime
