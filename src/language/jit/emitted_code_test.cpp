// SPDX-License-Identifier: Apache-2.0
// What code must look like to be fast; codegen_test says that it is right.
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_light.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/builder_vectors.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/jit/jit.h"
#include "language/runtime/runtime_functions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <functional>
#include <numbers>

namespace candela {
namespace {

using runtime::IsaLevel;
using runtime::RuntimeFunction;

constexpr IsaLevel levels[] = {IsaLevel::V2, IsaLevel::V3, IsaLevel::V4};

JitOptions optionsFor(IsaLevel level, int width) {
    JitOptions options;
    options.level = level;
    options.width = width;
    options.useCache = false;
    return options;
}

/// Only levels that both have or lack fused sums round noise and transcendentals alike.
bool roundsAsHost(IsaLevel level) {
    return (level == IsaLevel::V2) == (runtime::hostIsaLevel() == IsaLevel::V2);
}

std::string textOf(const ir::Function &function, IsaLevel level, bool assembly) {
    DiagnosticList diagnostics;
    return Jit(optionsFor(level, 16), diagnostics).emit(function, assembly);
}

int countIn(const std::string &text, const std::string &what) {
    int count = 0;
    for (std::size_t at = 0; (at = text.find(what, at)) != std::string::npos; ++at)
        ++count;
    return count;
}

/// Outputs, the frame, a condition with a jump, a loop over light of a quarter turn about N, of all
/// light or of a category.
ir::Function litSurface(int category = -1) {
    ir::Function function;
    function.viewSlots = 1;
    function.categories = {"key"};
    ir::Builder b(function);
    const ir::Triple N = normalize(b, input3(b, ShaderInput::N));
    ir::LightRequest request;
    request.form = ir::ConeForm::Classic;
    request.coneCount = 1;
    request.category = category;
    const ir::ValueId angle = number(b, std::numbers::pi_v<float> / 2);
    const ir::Values lit = lightLoop(
        b, addRequest(b, request), input3(b, ShaderInput::P), {N[0], N[1], N[2], angle},
        {number(b, 0)}, [&](const ir::LoopLight &light, const ir::Values &carried) {
            return ir::Values{add(b, carried[0], mul(b, light.Cl[0], dot(b, N, light.L)))};
        });
    b.emit(ir::Op::FrameStore, {lit[0]}, 0);
    output(b, "Ci", 0, lit[0]);
    output(b, "Ci", 1, add(b, lit[0], N[0]));
    b.finish();
    return function;
}

TEST(EmittedCode, HasNoMaskedStoreWhereThatIsMicrocode) {
    EXPECT_EQ(countIn(textOf(litSurface(), IsaLevel::V3, false), "llvm.masked.store"), 0);
    EXPECT_EQ(countIn(textOf(litSurface(), IsaLevel::V3, true), "vmaskmovps"), 0);
    EXPECT_GT(countIn(textOf(litSurface(), IsaLevel::V4, false), "llvm.masked.store"), 0);
}

TEST(EmittedCode, AsksNoCosineOfAnAngleThatIsKnown) {
    for (IsaLevel level : levels)
        if (roundsAsHost(level)) {
            EXPECT_EQ(countIn(textOf(litSurface(), level, false), "cosf"), 0) << int(level);
        }
}

/// Whether a sample reaches a lane: bits of colours, and words that are joined as words.
TEST(EmittedCode, FindsTheLanesOfASampleInFewInstructions) {
    const ir::Function function = litSurface(0);
    for (IsaLevel level : levels) {
        EXPECT_EQ(countIn(textOf(function, level, false), "fcmp une"), 0) << int(level);
        EXPECT_EQ(countIn(textOf(function, level, false), "extractelement"), 0) << int(level);
    }
    EXPECT_EQ(countIn(textOf(function, IsaLevel::V3, true), "vpsrad"), 0);
}

TEST(EmittedCode, TakesARegisterOfPointsAtATime) {
    const char *types[] = {"<4 x float>", "<8 x float>", "<16 x float>"};
    for (IsaLevel level : levels)
        for (IsaLevel other : levels)
            EXPECT_EQ(countIn(textOf(litSurface(), level, false), types[int(other)]) > 0,
                      level == other)
                << int(level) << " " << int(other);
}

/// A view of points: u, read twice, and a slot of theirs.
ir::Function viewOfPoints(BindingTime lanes) {
    ir::Function function;
    function.lanes = lanes;
    function.surfaceSlots = 2;
    ir::Builder b(function);
    const ir::ValueId u = input(b, ShaderInput::u), saved = b.emit(ir::Op::FrameLoad, {}, 1)[0];
    output(b, "a", 0, mul(b, add(b, u, input(b, ShaderInput::u)), input(b, ShaderInput::I)));
    output(b, "a", 1, saved);
    b.finish();
    return function;
}

/// Each plane and slot once, at the head of a block; where lanes are points, nowhere.
TEST(EmittedCode, LooksUpOtherLanesOnce) {
    const ir::Function view = viewOfPoints(BindingTime::View);
    const std::string text = textOf(view, IsaLevel::V4, false);
    EXPECT_EQ(countIn(text, "call <16 x float> @llvm.masked.gather"), 2);
    for (IsaLevel level : {IsaLevel::V2, IsaLevel::V3}) {
        const std::string loop = textOf(view, level, false);
        EXPECT_EQ(countIn(loop, "masked.gather"), 0);
        EXPECT_GT(countIn(loop, "look_up"), 0);
    }
    for (IsaLevel level : levels) {
        EXPECT_EQ(countIn(textOf(viewOfPoints(BindingTime::Surface), level, false), "look_up"), 0);
    }
}

/// Noise and its slopes at the same place, in either order, and at another place.
ir::Function noiseAndSlopes(RuntimeFunction plain, bool slopesFirst) {
    ir::Function function;
    ir::Builder b(function);
    ir::Values at;
    for (int k = 0; k < runtime::info(plain).inputs; ++k)
        at.push_back(input(b, ShaderInput(int(ShaderInput::P) + k)));
    ir::Values elsewhere = at;
    elsewhere[0] = add(b, at[0], number(b, 1));
    const int slopes = int(*runtime::withSlopes(plain));
    ir::Values results;
    const auto call = [&](int which, const ir::Values &where) {
        for (ir::ValueId v : callRuntime(b, which, where))
            results.push_back(v);
    };
    call(slopesFirst ? slopes : int(plain), at);
    call(slopesFirst ? int(plain) : slopes, at);
    call(int(plain), elsewhere);
    for (std::size_t k = 0; k < results.size(); ++k)
        output(b, "x", int(k), results[k]);
    b.finish();
    return function;
}

/// The code gives the interpreter's results, outputs and frame, with and without a mask, in a batch
/// that does not fill its last block.
void expectInterpreted(const ir::Function &function, const JitOptions &options) {
    DiagnosticList diagnostics;
    Jit jit(options, diagnostics);
    const ShaderFunction code = jit.compile(function);
    ASSERT_TRUE(code) << diagnostics.text();
    for (const int variant : {0, 1, 2, 3}) {
        ir::TestBatch batch(function, 37, 3);
        batch.setSamples(2, 5);
        if (variant & 1)
            batch.active = {0xffff, 0x3fc1, 0x0015};
        if (variant & 2) // One instance.
            batch.parameterOffset.assign(std::size_t(batch.padded()), 0);
        const auto results = [&](auto &&run) {
            batch.frames.clear(function, batch.padded(), 0.25f);
            auto planes = batch.run(function, run, -1.0f);
            planes.push_back(batch.frames.view);
            return planes;
        };
        const auto expected = results(ir::interpret);
        const auto found =
            results([&](const ir::Function &, const ShaderArgs &args) { code(&args); });
        for (std::size_t k = 0; k < expected.size(); ++k)
            for (std::size_t i = 0; i < expected[k].size(); ++i)
                ASSERT_EQ(std::bit_cast<std::uint32_t>(expected[k][i]),
                          std::bit_cast<std::uint32_t>(found[k][i]))
                    << k << " " << i << " W=" << options.width << " at level "
                    << int(*options.level) << " cut at " << options.longestFunction;
    }
}

/// The same at both widths and all levels that can be compared here.
void expectInterpreted(const ir::Function &function, int longestFunction) {
    for (IsaLevel level : levels)
        for (int width : {1, 16})
            if (roundsAsHost(level) && Jit::hostRuns(level)) {
                JitOptions options = optionsFor(level, width);
                options.longestFunction = longestFunction;
                expectInterpreted(function, options);
            }
}

TEST(EmittedCode, EvaluatesOnceWhereAValueAndItsSlopesAreWanted) {
    for (RuntimeFunction plain :
         {RuntimeFunction::noise3, RuntimeFunction::vnoise2, RuntimeFunction::pnoise1})
        for (bool slopesFirst : {false, true}) {
            const ir::Function function = noiseAndSlopes(plain, slopesFirst);
            const std::string text = textOf(function, runtime::hostIsaLevel(), false);
            EXPECT_EQ(countIn(text, "@candela_"), 2 + 2) << text; // Two declared and called.
            expectInterpreted(function, 0);
        }
}

/// Long sums before and after a noise and its slopes; values of the first are used for the last
/// time between the two, so their spill slots are free then.
ir::Function valuesThatEndBetween() {
    ir::Function function;
    ir::Builder b(function);
    const ir::Triple at = input3(b, ShaderInput::P);
    const ir::Values where(at.begin(), at.end());
    const auto longSum = [&](ir::ValueId x) {
        for (int k = 0; k < 15; ++k)
            x = add(b, mul(b, x, at[0]), at[1]);
        return x;
    };
    const ir::ValueId above[] = {mul(b, at[0], at[1]), mul(b, at[1], at[2]), longSum(at[2])};
    const int plain = int(RuntimeFunction::noise3), slopes = int(RuntimeFunction::noise3_slopes);
    ir::ValueId sum = callRuntime(b, plain, where)[0];
    for (ir::ValueId v : above)
        sum = add(b, mul(b, sum, sum), v);
    const ir::Values given = callRuntime(b, slopes, where);
    output(b, "x", 0, longSum(sum));
    for (std::size_t k = 0; k < given.size(); ++k)
        output(b, "x", 1 + int(k), given[k]);
    b.finish();
    return function;
}

TEST(EmittedCode, SharesNoEvaluationBetweenPieces) {
    const ir::Function between = valuesThatEndBetween();
    const ir::Function near = noiseAndSlopes(RuntimeFunction::vnoise2, false);
    for (int longest = 1; longest < 70; longest += 4) {
        expectInterpreted(between, longest);
        expectInterpreted(near, longest);
    }
    const auto named = [&](int longest) { // Each function called is declared, too.
        DiagnosticList diagnostics;
        JitOptions options = optionsFor(runtime::hostIsaLevel(), 16);
        options.longestFunction = longest;
        return countIn(Jit(options, diagnostics).emit(between, false), "@candela_");
    };
    EXPECT_EQ(named(1000), 1 + 1);
    EXPECT_EQ(named(1), 2 + 2);
}

TEST(EmittedCode, PiecesAskWhetherAllOfTheirLanesRun) {
    for (int longest : {1, 4, 8, 16, 60})
        expectInterpreted(litSurface(), longest);
    DiagnosticList diagnostics;
    JitOptions options = optionsFor(IsaLevel::V3, 16);
    options.longestFunction = 8;
    const std::string text = Jit(options, diagnostics).emit(litSurface(), false);
    EXPECT_GT(countIn(text, "@piece"), 0) << text;
    EXPECT_GT(countIn(text, "store_all:"), 0) << text;
}

/// Parameters, more than are kept alive, in arithmetic, in a branch of their own, and in an array
/// that numbers fill too; elements are chosen by the lanes.
ir::Function manyParameters(int count) {
    ir::Function function;
    ir::Builder b(function);
    const ir::ValueId x = input(b, ShaderInput::P);
    ir::Values given;
    for (int k = 0; k < count; ++k) {
        function.parameters.push_back({"p" + std::to_string(k), 0});
        given.push_back(parameter(b, k));
    }
    const int array = addArray(b, ir::Type::Float, count + 50);
    for (int k = 0; k < 50; ++k)
        arrayStore(b, array, integer(b, k), number(b, float(k) * 0.37f));
    const auto fill = [&] {
        for (int k = 0; k < count; ++k)
            arrayStore(b, array, integer(b, 50 + k % (count - 3)), given[std::size_t(k)]);
        return ir::Values{mul(b, given[3], given[std::size_t(count) - 1])};
    };
    const ir::ValueId chosen =
        ifElse(b, less(b, number(b, 0), x), fill, [&] { return ir::Values{given[7]}; })[0];
    ir::ValueId sum = chosen;
    for (ir::ValueId v : given)
        sum = add(b, mul(b, sum, x), v);
    output(b, "x", 0, sum);
    for (int k = 0; k < 4; ++k) {
        const ir::ValueId place =
            mul(b, unary(b, ir::Op::Abs, input(b, ShaderInput(int(ShaderInput::N) + k % 3))),
                number(b, float(count + 49 - 20 * k)));
        output(b, "x", 1 + k, arrayLoad(b, array, unary(b, ir::Op::IntegerFromFloat, place)));
    }
    b.finish();
    return function;
}

TEST(EmittedCode, HoldsManyParametersAndFillsArraysInLoops) {
    for (int longest : {0, 8, 100})
        expectInterpreted(manyParameters(100), longest);
    for (IsaLevel level : levels) { // A table is not code.
        const auto lines = [&](int count) {
            return countIn(textOf(manyParameters(count), level, false), "\n");
        };
        EXPECT_LT(lines(800) - lines(400), 5 * 400) << int(level);
    }
}

/// How much longer generating code for 4 n takes than for n; the least of some trials.
double growth(const std::function<ir::Function(int n)> &make, int n) {
    const auto seconds = [&](int count) {
        DiagnosticList diagnostics;
        Jit jit(optionsFor(runtime::hostIsaLevel(), 16), diagnostics);
        EXPECT_TRUE(jit.compile(make(count)));
        return jit.statistics().secondsOptimising + jit.statistics().secondsEmitting;
    };
    double least = 1e9;
    for (int trial = 0; trial < 3; ++trial)
        least = std::min(least, seconds(4 * n) / seconds(n));
    return least;
}

/// Sums, each of which goes to a plane of its own and to an array.
ir::Function manyStores(int count) {
    ir::Function function;
    ir::Builder b(function);
    const ir::ValueId x = input(b, ShaderInput::P), y = input(b, ShaderInput::N);
    const int array = addArray(b, ir::Type::Float, count);
    ir::ValueId sum = x;
    for (int k = 0; k < count; ++k) {
        sum = add(b, mul(b, sum, x), y);
        output(b, "x", k, sum);
        arrayStore(b, array, integer(b, k), sum);
    }
    output(b, "y", 0, arrayLoad(b, array, unary(b, ir::Op::IntegerFromFloat, sum)));
    b.finish();
    return function;
}

TEST(EmittedCode, TakesTimeInProportionToItsLength) {
    EXPECT_LT(growth(manyStores, 250), 8);
    EXPECT_LT(growth(manyParameters, 250), 8);
}

} // namespace
} // namespace candela
