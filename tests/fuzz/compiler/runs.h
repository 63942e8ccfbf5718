// SPDX-License-Identifier: Apache-2.0
// Functions run on a batch of random points, and what they leave there.
#pragma once

#include "chance.h"

#include "language/ir/interpret/interpreter.h"
#include "language/ir/interpret/test_batch.h"
#include "language/ir/lower/lower.h"

#include <functional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace candela::fuzz {

/// What outputs hold that no lane has reached.
inline constexpr float unreached = -123;

struct RunResult {
    using Plane = ir::TestBatch::Plane;

    std::vector<Plane> outputs;
    ir::TestFrames frames;
    /// Of what was printed, in any order: widths differ in theirs.
    std::uint64_t lines = 0, digest = 0;
    std::set<std::pair<std::string, int>> outside; ///< Where arrays are indexed outside.
    bool ended = false;                            ///< A loop has been ended somewhere.
};

/// What is equal in all bits, but for the bits of NaN, which IEEE leaves open.
bool sameBits(float, float);

/// Where two runs of a function differ; empty if nowhere.
std::string differenceOf(const RunResult &expected, const RunResult &found);

/// Where the output `name` of a slice differs from an output of the whole text. Zeros of either
/// sign are equal; numbers of the whole text that are not finite are not compared, since what is
/// without light need not be multiplied by none.
std::string differenceOfOutputs(const ir::Function &whole, const RunResult &expected,
                                const std::string &wholeName, const ir::Function &slice,
                                const RunResult &found, const std::string &name);

enum class Light : std::uint8_t {
    None,  ///< No samples; all answers are black.
    Given, ///< Samples, answers, ambient light, all random.
};

/// Random points, masks and light for a shader; parameters are at their defaults, or random.
class Batch {
public:
    using Code = std::function<void(const ir::Function &, const ShaderArgs &)>;

    Batch(const ir::LoweredShader &, Chance &);

    /// Gives a parameter slot one value in all lanes, and returns it.
    float makeEqual(int slot);
    /// Makes room for the requests of the function, which folding and the light rule add to.
    void fit(const ir::Function &);

    /// Starts from the frames that the last run has left.
    RunResult run(const ir::Function &, const Code &, Light);
    ir::TestFrames &frames() { return points_.frames; }

private:
    void fitVariables(const ir::Function &);
    ir::TestBatch points_;
    std::vector<ir::TestBatch::Plane> ambient_, answers_;
    std::uint64_t seed_;
    int parameterCount_;
};

} // namespace candela::fuzz
