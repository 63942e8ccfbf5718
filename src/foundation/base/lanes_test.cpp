// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/lanes.h"

#include "foundation/base/planes.h"

#include <gtest/gtest.h>
#include <random>
#include <vector>

using namespace candela;

namespace {

/// Increasing numbers below `lanes`, each with a probability.
std::vector<int> someOf(int lanes, double share, int seed) {
    std::mt19937 random(seed);
    std::vector<int> chosen;
    for (int i = 0; i < lanes; ++i)
        if (std::uniform_real_distribution<>(0, 1)(random) < share)
            chosen.push_back(i);
    return chosen;
}

} // namespace

TEST(Lanes, TakesWhatTheOrderNamesAndNoMore) {
    const int lanes = 1000;
    std::vector<float> floats(lanes);
    std::vector<int> integers(lanes);
    for (int i = 0; i < lanes; ++i)
        floats[i] = float(i) + 0.5f, integers[i] = -i;
    int seed = 0;
    // Dense, so that sixteen lie within one load, two, or further apart.
    for (double share : {1.0, 0.9, 0.6, 0.3, 0.02})
        for (int first : {0, 1, 7, 970, 984, 990, 999}) {
            std::vector<int> order;
            for (int i : someOf(lanes, share, ++seed))
                if (i >= first)
                    order.push_back(i);
            const int count = int(order.size());
            std::vector<float> someFloats(count + 1, 7);
            std::vector<int> someIntegers(count + 1, 7);
            lanes::take(
                count, order.data(),
                {{floats.data(), someFloats.data()}, {integers.data(), someIntegers.data()}});
            for (int i = 0; i < count; ++i) {
                EXPECT_EQ(someFloats[i], floats[order[i]]);
                EXPECT_EQ(someIntegers[i], integers[order[i]]);
            }
            EXPECT_EQ(someFloats[count], 7);
            EXPECT_EQ(someIntegers[count], 7);
        }
}

TEST(Lanes, GathersTheColumnsThatAreWanted) {
    const int columns = 16, rows = 50, count = 37;
    std::vector<float> table(columns * rows);
    for (int i = 0; i < columns * rows; ++i)
        table[i] = float(i);
    std::vector<int> row(count);
    for (int i = 0; i < count; ++i)
        row[i] = columns * (i * 7 % rows);
    // One column of four and all of four; all four left out; the last group cut short.
    for (std::vector<int> wanted : {std::vector<int>{2, 4, 5, 6, 7, 13}, {0}, {12}, {}}) {
        Planes<float> planes(columns, count);
        float *to[columns] = {};
        for (int column : wanted)
            to[column] = planes[column];
        lanes::gatherRows(count, table.data(), row.data(), 14, to);
        for (int column = 0; column < 14; ++column)
            for (int i = 0; i < count; ++i)
                EXPECT_EQ(planes[column][i], to[column] ? table[row[i] + column] : 0);
    }
}

TEST(Lanes, FillsAllAndNoMore) {
    for (int count : {0, 1, 15, 16, 17, 100}) {
        std::vector<float> floats(count + 1, 7);
        std::vector<int> integers(count + 1, 7);
        lanes::fill(count, 1.5f, floats.data());
        lanes::fill(count, -3, integers.data());
        for (int i = 0; i <= count; ++i) {
            EXPECT_EQ(floats[i], i < count ? 1.5f : 7.0f);
            EXPECT_EQ(integers[i], i < count ? -3 : 7);
        }
    }
}
