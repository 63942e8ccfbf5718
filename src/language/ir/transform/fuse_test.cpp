// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/fuse.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/core/op_info.h"
#include "language/ir/core/regions.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"

#include <gtest/gtest.h>

#include <cmath>

namespace candela::ir {
namespace {

struct Inputs {
    ValueId x, y, z;
};

Function fusedFunction(const std::function<ValueId(Builder &, const Inputs &)> &write) {
    Function function;
    Builder b(function);
    const Inputs given{input(b, ShaderInput::s), input(b, ShaderInput::t),
                       input(b, ShaderInput::u)};
    output(b, "x", 0, write(b, given));
    b.finish();
    fuseProducts(function);
    EXPECT_EQ(verify(function), "");
    return function;
}

/// How many operations of each kind that matters here: products, sums, fused ones.
std::string tallyOf(const Function &function) {
    int products = 0, sums = 0, fused = 0;
    forEachInstruction(function.body, [&](const Instruction &i) {
        products += i.op == Op::Mul;
        sums += i.op == Op::Add || i.op == Op::Sub;
        fused += i.op == Op::MulAdd;
    });
    return std::to_string(products) + " " + std::to_string(sums) + " " + std::to_string(fused);
}

struct Row {
    const char *what;
    std::function<ValueId(Builder &, const Inputs &)> write;
    const char *left;
    /// In double precision; what is rounded once comes near to it.
    std::function<double(double, double, double)> value;
};

const Row rows[] = {
    {"a product first", [](Builder &b, const Inputs &i) { return add(b, mul(b, i.x, i.y), i.z); },
     "0 0 1", [](double x, double y, double z) { return x * y + z; }},
    {"a product last", [](Builder &b, const Inputs &i) { return add(b, i.z, mul(b, i.x, i.y)); },
     "0 0 1", [](double x, double y, double z) { return z + x * y; }},
    {"less a product", [](Builder &b, const Inputs &i) { return sub(b, i.z, mul(b, i.x, i.y)); },
     "0 0 1", [](double x, double y, double z) { return z - x * y; }},
    {"a product less something",
     [](Builder &b, const Inputs &i) { return sub(b, mul(b, i.x, i.y), i.z); }, "0 0 1",
     [](double x, double y, double z) { return x * y - z; }},
    {"a sum of squares",
     [](Builder &b, const Inputs &i) {
         return add(b, add(b, mul(b, i.x, i.x), mul(b, i.y, i.y)), mul(b, i.z, i.z));
     },
     "1 0 2", [](double x, double y, double z) { return x * x + y * y + z * z; }},
    {"a product of two uses",
     [](Builder &b, const Inputs &i) {
         const ValueId product = mul(b, i.x, i.y);
         return add(b, add(b, product, i.z), product);
     },
     "1 2 0", [](double x, double y, double z) { return x * y + z + x * y; }},
    {"twice a product",
     [](Builder &b, const Inputs &i) {
         const ValueId product = mul(b, i.x, i.y);
         return add(b, product, product);
     },
     "1 1 0", [](double x, double y, double) { return 2 * x * y; }},
    {"a difference of products",
     [](Builder &b, const Inputs &i) { return sub(b, mul(b, i.x, i.y), mul(b, i.y, i.z)); },
     "2 1 0", [](double x, double y, double z) { return x * y - y * z; }},
    {"a product and one turned round",
     [](Builder &b, const Inputs &i) { return add(b, mul(b, i.x, i.y), neg(b, mul(b, i.y, i.z))); },
     "2 1 0", [](double x, double y, double z) { return x * y - y * z; }},
    {"a product outside of the branch that adds it",
     [](Builder &b, const Inputs &i) {
         const ValueId product = mul(b, i.x, i.y);
         return ifElse(
             b, less(b, i.x, i.y), [&] { return Values{add(b, product, i.z)}; },
             [&] { return Values{i.z}; })[0];
     },
     "1 1 0", [](double x, double y, double z) { return x < y ? x * y + z : z; }},
    {"both within a branch",
     [](Builder &b, const Inputs &i) {
         return ifElse(
             b, less(b, i.x, i.y), [&] { return Values{add(b, mul(b, i.x, i.y), i.z)}; },
             [&] { return Values{i.z}; })[0];
     },
     "0 0 1", [](double x, double y, double z) { return x < y ? x * y + z : z; }},
};

TEST(Fuse, MakesOneOfAProductAndASum) {
    for (const Row &row : rows) {
        const Function function = fusedFunction(row.write);
        EXPECT_EQ(tallyOf(function), row.left) << row.what;
        TestBatch batch(function, 256, 7);
        const auto found = batch.run(function, interpret)[0];
        for (int k = 0; k < batch.count; ++k) {
            const auto at = [&](ShaderInput input) { return double(batch.inputs[int(input)][k]); };
            EXPECT_NEAR(found[k],
                        row.value(at(ShaderInput::s), at(ShaderInput::t), at(ShaderInput::u)), 2e-7)
                << row.what;
        }
    }
}

/// x x - 1 next to 1 has no correct digit left where the product is rounded first.
TEST(Fuse, RoundsOnce) {
    const Function function = fusedFunction([](Builder &b, const Inputs &i) {
        const ValueId near = add(b, number(b, 1), mul(b, i.x, number(b, 0x1p-13f)));
        return sub(b, mul(b, near, near), number(b, 1));
    });
    TestBatch batch(function, 256, 3);
    const auto found = batch.run(function, interpret)[0];
    for (int k = 0; k < batch.count; ++k) {
        const float near = 1 + batch.inputs[int(ShaderInput::s)][k] * 0x1p-13f;
        EXPECT_EQ(found[k], float(double(near) * near - 1));
    }
}

/// Vectors along each other have no cross product, whatever their lengths.
TEST(Fuse, LeavesCrossProductsOfEqualVectorsAtZero) {
    const Function function = fusedFunction([](Builder &b, const Inputs &i) {
        const Triple v{i.x, i.y, i.z};
        const Triple across = cross(b, v, v);
        return add(b, add(b, unary(b, Op::Abs, across[0]), unary(b, Op::Abs, across[1])),
                   unary(b, Op::Abs, across[2]));
    });
    TestBatch batch(function, 256, 5);
    const auto sizes = batch.run(function, interpret)[0];
    for (const float size : sizes)
        EXPECT_EQ(size, 0);
}

} // namespace
} // namespace candela::ir
