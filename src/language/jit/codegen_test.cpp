// SPDX-License-Identifier: Apache-2.0
// Compiled code against the interpreter, all lanes, bit by bit, on several CPU names.
#include "foundation/base/campaign.h"
#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_control.h"
#include "language/ir/core/builder_effects.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/transform/fuse.h"
#include "language/jit/jit.h"
#include "language/jit/random_program.h"
#include "language/runtime/scalar_math.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <set>

namespace candela {
namespace {

using ir::Op;
using ir::TestBatch;

/// NaNs are equal whatever their bits, which IEEE leaves open.
bool sameBits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

/// How many floats lie between two; 0 for two NaNs.
double ulpsApart(float a, float b) {
    if (sameBits(a, b) || a == b)
        return 0;
    if (!std::isfinite(a) || !std::isfinite(b))
        return std::numeric_limits<double>::infinity();
    const auto rank = [](float x) {
        const auto bits = std::bit_cast<std::int32_t>(x);
        return double(bits < 0 ? std::numeric_limits<std::int32_t>::min() - std::int64_t(bits)
                               : std::int64_t(bits));
    };
    return std::abs(rank(a) - rank(b));
}

/// What outputs hold that no lane has written.
constexpr float unreached = -123;

struct Result {
    std::vector<TestBatch::Plane> outputs;
    ir::TestFrames frames;
    std::vector<std::string> printed; ///< Sorted: widths print in different orders.
};

void collectPrint(void *context, const ServiceCall &call) {
    for (std::string &line : ir::printedLines(call))
        static_cast<std::vector<std::string> *>(context)->push_back(std::move(line));
}

template <typename Runner>
Result run(TestBatch &batch, const ir::Function &function, Runner &&runner) {
    Result result;
    batch.frames.clear(function, batch.padded(), 0.25f);
    batch.services.context = &result.printed;
    batch.services[Service::print] = collectPrint;
    batch.services[Service::option] = [](void *, const ServiceCall &call) {
        ir::answerService(nullptr, call);
    };
    result.outputs = batch.run(function, runner, unreached);
    result.frames = batch.frames;
    std::sort(result.printed.begin(), result.printed.end());
    return result;
}

/// Where a lane's loop is ended, it is not said which way it takes at branches from there on: what
/// random programs write in them is not compared, what they write at the end is.
void forgetBranches(const ir::Function &function, Result &result) {
    result.frames = {};
    for (std::size_t k = 0; k < result.outputs.size(); ++k)
        if (function.outputs[k].name == "side")
            result.outputs[k].clear();
}

void expectSame(const Result &expected, const Result &found, const std::string &what) {
    const auto same = [&](const TestBatch::Plane &a, const TestBatch::Plane &b) {
        return std::equal(a.begin(), a.end(), b.begin(), b.end(), sameBits);
    };
    for (std::size_t k = 0; k < expected.outputs.size(); ++k)
        for (std::size_t i = 0; i < expected.outputs[k].size(); ++i)
            ASSERT_TRUE(sameBits(expected.outputs[k][i], found.outputs[k][i]))
                << what << ": output " << k << " lane " << i << ": " << expected.outputs[k][i]
                << " expected, " << found.outputs[k][i] << " found";
    EXPECT_TRUE(same(expected.frames.surface, found.frames.surface)) << what << ": surface frame";
    EXPECT_TRUE(same(expected.frames.view, found.frames.view)) << what << ": view frame";
    EXPECT_EQ(expected.printed, found.printed) << what;
}

/// Masks, counts, light samples, instances and nulls as the seed says.
TestBatch randomBatch(const ir::Function &function, unsigned seed) {
    std::mt19937 bits(seed);
    TestBatch batch(function, 1 + int(bits() % 50), seed);
    const int rows = int(bits() % 4);
    batch.setSamples(rows, seed);
    for (std::size_t i = 0; i < batch.samples.Cl[0].size(); ++i)
        if (bits() % 4 == 0)
            for (auto &plane : batch.samples.Cl)
                plane[i] = 0;
    for (int word = 0; word < batch.padded() / 16 && seed % 3; ++word)
        batch.active.push_back(std::uint16_t(bits() % 4 ? bits() : 0));
    if (seed % 2)
        batch.parameterOffset.assign(batch.padded(), 0);
    batch.objects.insert(batch.objects.end(), batch.objects.rbegin(), batch.objects.rend());
    for (int &index : batch.objectIndex)
        index = seed % 4 < 2 ? int(bits() % 2) : 1;
    for (int &request : batch.answeredRequest)
        request = int(bits() % 3) - 1;
    batch.answers.givesTraced = bits() % 2;
    batch.answers.givesAmbient = bits() % 2;
    batch.samples.lightCount = 2;
    if (bits() % 3)
        batch.samples.categoryAccepts = {1, 0, 1, 0, 1, 0};
    if (bits() % 3) {
        batch.samples.light.resize(std::size_t(rows) * batch.padded());
        for (int &light : batch.samples.light)
            light = int(bits() % 3);
    }
    for (auto *lanes : {&batch.surfaceLane, &batch.viewLane})
        for (int i = 0, named = int(bits() % 2); i < batch.padded() && named; ++i)
            lanes->push_back(int(bits() % unsigned(batch.count)));
    return batch;
}

struct CodeFor {
    const char *name;
    std::optional<runtime::IsaLevel> level;
    const char *cpu = "";

    /// Only levels that both have or lack fused sums round noise and transcendentals alike.
    bool roundsAsHost() const {
        using runtime::IsaLevel;
        return (level == IsaLevel::V2) == (runtime::hostIsaLevel() == IsaLevel::V2);
    }
    bool hostRuns() const { return level ? Jit::hostRuns(*level) : Jit::hostRuns(cpu); }
    JitOptions options(int width) const {
        JitOptions options;
        options.cpu = cpu;
        options.level = level;
        options.width = width;
        options.useCache = false;
        return options;
    }
};

JitOptions optionsFor(const std::string &cpu, int width) {
    JitOptions options;
    options.cpu = cpu;
    options.width = width;
    options.useCache = false;
    return options;
}

class Codegen : public testing::TestWithParam<CodeFor> {
protected:
    bool roundsAsHost() const { return GetParam().roundsAsHost(); }
    bool runs() const { return GetParam().hostRuns(); }
    void compareRandomPrograms(int longestFunction, unsigned share);
    void countFinite(const Result &result) {
        for (const auto &plane : result.outputs)
            for (float x : plane) {
                ++numbers_;
                finite_ += std::isfinite(x) && x != 0 && x != unreached;
            }
    }
    DiagnosticList diagnostics_;
    int numbers_ = 0, finite_ = 0;
};

void Codegen::compareRandomPrograms(int longestFunction, unsigned share) {
    const auto options = [&](int width) {
        JitOptions options = GetParam().options(width);
        options.longestFunction = longestFunction;
        return options;
    };
    Jit wide(options(16), diagnostics_), narrow(options(1), diagnostics_);
    const bool runs = this->runs();
    // Code without masked memory operations takes LLVM long.
    const unsigned programs = (!runs ? 5 : roundsAsHost() ? 40 : 20) * campaignFactor() / share;
    for (unsigned seed = 1; seed <= programs && !HasFailure(); ++seed) {
        ir::Function function = randomProgram(seed, roundsAsHost(), ir::colorSamplesOf(seed));
        if (seed % 2)
            ir::fuseProducts(function);
        ASSERT_EQ(ir::verify(function), "") << "seed " << seed;
        const bool limited = seed % 4 == 3; // Some lanes' loops are ended then, others' not.
        if (limited)
            function.mostTurns = 1 + int(seed / 4 % 7);
        for (ir::OutputSlot &slot : function.outputs)
            slot.whenEnded = 0.5f;
        const ShaderFunction wideCode = wide.compile(function);
        const ShaderFunction narrowCode = narrow.compile(function);
        ASSERT_TRUE(wideCode && narrowCode) << diagnostics_.text();
        for (unsigned variant = 0; variant < 4 && runs; ++variant) {
            const std::string name =
                "seed " + std::to_string(seed) + " variant " + std::to_string(variant);
            TestBatch batch = randomBatch(function, seed * 4 + variant);
            const auto answer = [&](const auto &runner) {
                Result result = run(batch, function, runner);
                if (limited)
                    forgetBranches(function, result);
                return result;
            };
            const Result expected = answer(ir::interpret);
            countFinite(expected);
            const auto call = [](ShaderFunction code) {
                return [code](const ir::Function &, const ShaderArgs &args) { code(&args); };
            };
            expectSame(expected, answer(call(wideCode)), name + " W=16");
            expectSame(expected, answer(call(narrowCode)), name + " W=1");
        }
    }
    // Programs that give nothing but NaN or nothing at all would prove little.
    EXPECT_GE(finite_, numbers_ / 5);
    if (!runs)
        GTEST_SKIP() << "compiled for " << GetParam().name << ", which this machine can't execute";
}

TEST_P(Codegen, RandomProgramsEqualTheInterpreterInAllLanes) { compareRandomPrograms(0, 1); }

/// Cut wherever it can be, and in pieces that hold control flow.
TEST_P(Codegen, SoDoRandomProgramsInPieces) {
    for (int longest : {1, 40})
        compareRandomPrograms(longest, 4);
}

/// One operation on many numbers: ordinary ones, huge, tiny, and the special ones.
TEST_P(Codegen, TranscendentalsAgreeAtBothWidthsAndWithTheInterpreter) {
    if (!runs())
        GTEST_SKIP() << "this machine can't execute code for " << GetParam().name;
    Jit wide(GetParam().options(16), diagnostics_), narrow(GetParam().options(1), diagnostics_);
    for (int op = int(Op::Sin); op <= int(Op::Pow); ++op) {
        ir::Function function;
        ir::Builder b(function);
        const ir::ValueId x = input(b, ShaderInput::P), y = input(b, ShaderInput::N);
        const bool two = Op(op) == Op::Atan2 || Op(op) == Op::Pow;
        output(b, "y", 0, two ? binary(b, Op(op), x, y) : unary(b, Op(op), x));
        b.finish();
        TestBatch batch(function, 20000, 5);
        std::mt19937 bits(op);
        const auto fill = [&](TestBatch::Plane &plane) {
            for (float &v : plane)
                v = bits() % 4 ? v * 20 : v * std::exp2(float(int(bits() % 60) - 30));
            const float special[] = {0, -0.0f, INFINITY, -INFINITY, NAN, 1, -1, 1e-40f, 3e38f};
            for (int k = 0; k < 81; ++k)
                plane[k] = special[&plane == &batch.inputs[int(ShaderInput::P)] ? k % 9 : k / 9];
        };
        fill(batch.inputs[int(ShaderInput::P)]);
        fill(batch.inputs[int(ShaderInput::N)]);
        const auto expected = batch.run(function, ir::interpret)[0];
        const auto outputOf = [&](Jit &jit) {
            const ShaderFunction code = jit.compile(function);
            return batch.run(function,
                             [&](const ir::Function &, const ShaderArgs &args) { code(&args); })[0];
        };
        const auto fromWide = outputOf(wide), fromNarrow = outputOf(narrow);
        for (int i = 0; i < batch.count; ++i) {
            ASSERT_TRUE(sameBits(fromWide[i], fromNarrow[i])) << "op " << op << " lane " << i;
            ASSERT_LE(ulpsApart(expected[i], fromWide[i]), roundsAsHost() ? 0 : 4)
                << "op " << op << " of " << batch.inputs[int(ShaderInput::P)][i] << ", "
                << batch.inputs[int(ShaderInput::N)][i];
        }
    }
}

/// for (i = 0; i < P.x; ++i) for (j = 0; j < N.x; ++j) ++sum, with the inner loop on line 5.
ir::Function loopNest(int mostTurns) {
    ir::Function function;
    function.mostTurns = mostTurns;
    ir::Builder b(function);
    b.setFile(ir::intern(b.function().files, "a.sl"));
    const ir::ValueId zero = number(b, 0), one = number(b, 1);
    const ir::ValueId outer = input(b, ShaderInput::P), inner = input(b, ShaderInput::N);
    const auto counted = [&](ir::ValueId end, ir::ValueId sum,
                             const std::function<ir::ValueId(ir::ValueId)> &body) {
        return loop(b, {less(b, zero, end), zero, sum}, [&](const ir::Values &carried) {
            const ir::ValueId next = add(b, carried[1], one);
            return ir::Values{less(b, next, end), next, body(carried[2])};
        })[2];
    };
    b.setLine(4);
    const ir::ValueId sum = counted(outer, zero, [&](ir::ValueId outside) {
        b.setLine(5);
        return counted(inner, outside, [&](ir::ValueId inside) { return add(b, inside, one); });
    });
    b.setLine(6);
    output(b, "sum", 0, sum);
    function.outputs[0].whenEnded = -1;
    b.finish();
    return function;
}

/// A lane is ended by its own turns: i + 1 of the outer loop and the inner loop's, whatever the
/// other lanes of its batch do.
TEST_P(Codegen, LoopsEndByTheTurnsOfTheirOwnLane) {
    if (!runs())
        GTEST_SKIP() << "this machine can't execute code for " << GetParam().name;
    constexpr int most = 60;
    const ir::Function function = loopNest(most);
    Jit wide(GetParam().options(16), diagnostics_), narrow(GetParam().options(1), diagnostics_);
    TestBatch batch(function, 400, 3);
    for (int lane = 0; lane < batch.padded(); ++lane) {
        batch.inputs[int(ShaderInput::P)][lane] = float(lane % 20);
        batch.inputs[int(ShaderInput::N)][lane] = float(lane / 20);
    }
    const auto check = [&](auto &&runner, const char *name) {
        std::set<std::pair<std::string, int>> said;
        batch.callbacks.context = &said;
        batch.callbacks.loopEnded = [](void *context, const char *file, std::int32_t line) {
            static_cast<decltype(said) *>(context)->emplace(file, line);
        };
        const auto sum = batch.run(function, runner)[0];
        int ended = 0;
        for (int lane = 0; lane < batch.count; ++lane) {
            const int outer = lane % 20, inner = lane / 20, turns = outer + outer * inner;
            EXPECT_EQ(sum[lane], turns > most ? -1 : outer * inner) << name << " lane " << lane;
            ended += turns > most;
        }
        EXPECT_GT(ended, 100);
        EXPECT_EQ(said, (decltype(said){{"a.sl", 4}, {"a.sl", 5}})) << name;
    };
    check(ir::interpret, "interpreter");
    for (auto *jit : {&wide, &narrow}) {
        const ShaderFunction code = jit->compile(function);
        ASSERT_TRUE(code) << diagnostics_.text();
        check([code](const ir::Function &, const ShaderArgs &args) { code(&args); },
              jit == &wide ? "W = 16" : "W = 1");
    }
}

/// Element access with indices inside and outside, NaN and huge ones among them, uniform ones and
/// varying ones, some under a condition. Which places are reported must not depend on the code.
struct Places {
    std::set<std::pair<std::string, int>> said;
    static void note(void *context, const char *file, std::int32_t line) {
        static_cast<Places *>(context)->said.emplace(file, line);
    }
};

ir::ValueId indexFrom(ir::Builder &b, ir::ValueId x) {
    return select(b, equal(b, x, x), unary(b, Op::IntegerFromFloat, x), integer(b, -1));
}

ir::Function arrayAccesses() {
    ir::Function function;
    ir::Builder b(function);
    b.setFile(ir::intern(b.function().files, "a.sl"));
    const int before = addArray(b, ir::Type::Float, 2), array = addArray(b, ir::Type::Float, 4),
              after = addArray(b, ir::Type::Float, 2);
    for (int k = 0; k < 2; ++k) {
        arrayStore(b, before, integer(b, k), number(b, 7));
        arrayStore(b, after, integer(b, k), number(b, 7));
    }
    const ir::ValueId x = input(b, ShaderInput::P), y = input(b, ShaderInput::N);
    for (int k = 0; k < 4; ++k)
        arrayStore(b, array, integer(b, k), add(b, y, number(b, float(k))));
    b.setLine(10);
    output(b, "read", 0, arrayLoad(b, array, indexFrom(b, x)));
    b.setLine(11);
    arrayStore(b, array, indexFrom(b, y), x);
    b.setLine(12); // Guarded: never outside.
    const ir::ValueId inside = both(b, lessEqual(b, number(b, 0), x), less(b, x, number(b, 4)));
    output(b, "guarded", 0,
           ifElse(
               b, inside, [&] { return ir::Values{arrayLoad(b, array, indexFrom(b, x))}; },
               [&] { return ir::Values{number(b, -1)}; })[0]);
    b.setLine(13);
    const ir::Matrix m = currentFromSpace(b, "uniform");
    output(b, "uniform", 0, arrayLoad(b, array, indexFrom(b, m[0])));
    b.setLine(14);
    arrayStore(b, array, indexFrom(b, m[1]), y);
    for (int k = 0; k < 4; ++k)
        output(b, "array", k, arrayLoad(b, array, integer(b, k)));
    for (int k = 0; k < 2; ++k) {
        output(b, "before", k, arrayLoad(b, before, integer(b, k)));
        output(b, "after", k, arrayLoad(b, after, integer(b, k)));
    }
    b.finish();
    return function;
}

TEST_P(Codegen, IndicesOutsideAreClampedAndReportedAtEveryWidth) {
    if (!runs())
        GTEST_SKIP() << "this machine can't execute code for " << GetParam().name;
    Jit wide(GetParam().options(16), diagnostics_), narrow(GetParam().options(1), diagnostics_);
    const ir::Function function = arrayAccesses();
    ASSERT_EQ(ir::verify(function), "");
    const ShaderFunction codes[] = {wide.compile(function), narrow.compile(function)};
    const float indices[] = {0, 3.5f, -0.5f, 4, -1, 1e30f, -1e30f, INFINITY, -INFINITY, NAN};
    const auto isOutside = [](float x) { return !(x > -1 && x < 4); };
    for (float x : indices)
        for (float y : indices)
            for (bool onlyOneLane : {false, true}) {
                TestBatch batch(function, 21, 3);
                // Elsewhere indices are fine; a lane that doesn't run may hold anything.
                for (int i = 0; i < 21; ++i) {
                    batch.inputs[int(ShaderInput::P)][i] = onlyOneLane && i != 17 ? 1 : x;
                    batch.inputs[int(ShaderInput::N)][i] = onlyOneLane && i != 17 ? 2 : y;
                }
                batch.spaces[0][0] = x, batch.spaces[0][1] = y;
                batch.inputs[int(ShaderInput::P)][3] = NAN;
                batch.active = {std::uint16_t(~(1u << 3)), 0xffff};
                std::set<std::pair<std::string, int>> expected;
                for (auto [line, index] : {std::pair(10, x), {11, y}, {13, x}, {14, y}})
                    if (isOutside(index))
                        expected.emplace("a.sl", line);
                const auto runWith = [&](auto &&runner) {
                    Places places;
                    batch.callbacks = {&places, Places::note};
                    auto outputs = batch.run(function, runner, unreached);
                    EXPECT_EQ(places.said, expected) << x << " " << y;
                    return outputs;
                };
                const auto reference = runWith(ir::interpret);
                for (std::size_t k = 7; k < 11; ++k) // before, after
                    EXPECT_EQ(reference[k][17], 7) << function.outputs[k].name.text();
                for (ShaderFunction code : codes) {
                    const auto found =
                        runWith([&](const ir::Function &, const ShaderArgs &args) { code(&args); });
                    for (std::size_t k = 0; k < found.size(); ++k)
                        EXPECT_TRUE(std::equal(found[k].begin(), found[k].end(),
                                               reference[k].begin(), sameBits))
                            << function.outputs[k].name.text() << " " << x << " " << y;
                }
            }
}

INSTANTIATE_TEST_SUITE_P(Cpus, Codegen,
                         testing::Values(CodeFor{"v2", runtime::IsaLevel::V2},
                                         CodeFor{"v3", runtime::IsaLevel::V3},
                                         CodeFor{"v4", runtime::IsaLevel::V4},
                                         CodeFor{"znver4", {}, "znver4"}, CodeFor{"host", {}}),
                         [](const auto &info) { return std::string(info.param.name); });

TEST(Jit, SaysThatACpuIsUnknown) {
    DiagnosticList diagnostics;
    Jit jit(optionsFor("no-such-cpu", 16), diagnostics);
    EXPECT_EQ(jit.compile(ir::Function()), nullptr);
    EXPECT_EQ(diagnostics.count(Severity::Error), 1);
    EXPECT_FALSE(Jit::hostRuns("no-such-cpu"));
}

TEST(Jit, EmitsTextThatNamesTheOperations) {
    DiagnosticList diagnostics;
    Jit jit(optionsFor("x86-64-v4", 16), diagnostics);
    ir::Function function;
    ir::Builder b(function);
    output(b, "y", 0, unary(b, Op::Sin, input(b, ShaderInput::P)));
    b.finish();
    EXPECT_NE(jit.emit(function, false).find("<16 x float> @Sleef_finz_sinf16"), std::string::npos);
    EXPECT_NE(jit.emit(function, true).find("zmm"), std::string::npos);
    // How vectors are passed must not be left to a CPU's preferences (README.md).
    for (const char *attribute : {"prefer-vector-width", "min-legal-vector-width"})
        EXPECT_NE(jit.emit(function, false).find(std::string(attribute) + "\"=\"512\""),
                  std::string::npos);
}

} // namespace
} // namespace candela
