// SPDX-License-Identifier: Apache-2.0
// What LLVM would end the process with comes back as an error.
#include "language/jit/llvm_errors.h"

#include "language/jit/compiler.h"

#include <gtest/gtest.h>

#include <new>

namespace candela {
namespace {

TEST(LlvmErrors, AFatalErrorIsTheResultsError) {
    ir::Function function;
    function.name = "empty";
    CodeTarget impossible = *codeTarget("x86-64-v2", 16);
    impossible.features = "-64bit"; // In a process of 64 bits.
    for (int round = 0; round < 2; ++round) {
        const CompilerResult result =
            compileFunctions({{&function, "symbol"}}, impossible, EmitForm::Object);
        EXPECT_NE(result.error, "");
        EXPECT_EQ(result.bytes, "");
    }
    const CompilerResult good =
        compileFunctions({{&function, "symbol"}}, *codeTarget("x86-64-v2", 16), EmitForm::Object);
    EXPECT_EQ(good.error, "");
    EXPECT_NE(good.bytes, "");
}

TEST(LlvmErrors, SoIsWantOfMemory) {
    EXPECT_EQ(runGuarded([] { throw std::bad_alloc(); }), "out of memory");
    EXPECT_EQ(runGuarded([] {}), "");
}

} // namespace
} // namespace candela
