// SPDX-License-Identifier: Apache-2.0
#include "foundation/base/deep_stack.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace candela {
namespace {

/// A kilobyte a level, at least.
int levels(int n) {
    volatile char room[1024] = {};
    room[n % 1024] = 1;
    return n == 0 ? 0 : levels(n - 1) + room[n % 1024];
}

TEST(DeepStack, IsDeeperThanOthers) {
    int reached = 0;
    onDeepStack([&] { reached = levels(100'000); });
    EXPECT_EQ(reached, 100'000);
}

TEST(DeepStack, HandsOutWhatIsThrown) {
    EXPECT_THROW(onDeepStack([] { throw std::runtime_error("no"); }), std::runtime_error);
    // Within deep work there is one stack.
    int reached = 0;
    onDeepStack([&] {
        EXPECT_THROW(onDeepStack([] { throw std::bad_alloc(); }), std::bad_alloc);
        onDeepStack([&] { reached = levels(10); });
    });
    EXPECT_EQ(reached, 10);
}

} // namespace
} // namespace candela
