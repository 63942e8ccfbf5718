// SPDX-License-Identifier: Apache-2.0
#include "filter_trial.h"

#include "runs.h"

#include "language/ir/filter/pixel_loops.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/fold.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace candela::fuzz {

namespace {

constexpr int width = 5, height = 3, channels = 3;
constexpr int mostTurns = 5000; ///< Filters may run for ever; trials do not.

/// The maps that a filter names, all of one size.
class Maps {
public:
    explicit Maps(std::size_t count) : memory_(count), planes_(count), views_(count) {
        constexpr int stride = width + 2 * imageHalo, plane = stride * height;
        for (std::size_t map = 0; map < count; ++map) {
            memory_[map].resize(plane * channels);
            for (int k = 0; k < plane * channels; ++k)
                memory_[map][std::size_t(k)] = float(std::abs(std::sin(k * 12.9898 + double(map))));
            for (int c = 0; c < channels; ++c)
                planes_[map][std::size_t(c)] = memory_[map].data() + c * plane + imageHalo;
            views_[map] = {width, height, channels, stride, planes_[map].data()};
        }
    }
    const ImageMap *views() const { return views_.data(); }
    const std::vector<std::vector<float>> &values() const { return memory_; }

private:
    std::vector<std::vector<float>> memory_;
    std::vector<std::array<float *, channels>> planes_;
    std::vector<ImageMap> views_;
};

/// A run of a filter by the interpreter, pixel loops pixel by pixel from the last to the first.
class Run {
public:
    explicit Run(const ir::Function &filter) : filter_(filter), maps_(filter.maps.size()) {
        callbacks_ = {this};
        callbacks_.loopEnded = [](void *self, const char *, std::int32_t) {
            static_cast<Run *>(self)->ended = true;
        };
        runner_ = {this, [](void *self, std::int32_t loop, const float *given,
                            const float *const *arrays, float *results) {
                       static_cast<Run *>(self)->run(loop, given, arrays, results);
                   }};
        inputs_.fill(zeros_.data());
        variables_.assign(filter.variables.size(), zeros_.data());
        parameters_.assign(filter.parameters.size(), 0);
        args_.count = 1;
        args_.inputs = inputs_.data();
        args_.parameters = parameters_.data();
        args_.parameterOffset = &parameterOffset_;
        args_.variables = variables_.data();
        args_.maps = maps_.views();
        args_.captured = size_.data();
        args_.callbacks = &callbacks_;
        args_.pixelLoops = &runner_;
    }
    void run() { ir::interpret(filter_, args_); }
    const Maps &maps() const { return maps_; }

    bool ended = false;

private:
    void run(int number, const float *given, const float *const *arrays, float *results) {
        const ir::PixelLoop &loop = filter_.pixelLoops[std::size_t(number)];
        const float *captured = given + ir::PixelLoop::bounds;
        std::copy_n(captured + loop.captured, loop.sums.size(), results);
        const std::vector<float> columns = turns(given[0], given[1], loop.closedColumns),
                                 rows = turns(given[2], given[3], loop.closedRows);
        std::vector<float> own(captured, captured + loop.captured), sums(loop.sums.size());
        own.insert(own.begin(), 0);
        std::vector<float *> outputs;
        for (float &sum : sums)
            outputs.push_back(&sum);
        ShaderArgs args = args_;
        args.captured = own.data();
        args.capturedArrays = arrays;
        args.outputs = outputs.data();
        auto inputs = inputs_;
        args.inputs = inputs.data();
        for (auto row = rows.rbegin(); row != rows.rend(); ++row)
            for (auto column = columns.rbegin(); column != columns.rend(); ++column) {
                own[0] = *row;
                inputs[std::size_t(ShaderInput::column)] = &*column;
                ir::interpret(*loop.body, args);
            }
    }
    std::vector<float> turns(float first, float end, bool isClosed) {
        std::vector<float> all;
        for (float x = first; isClosed ? x <= end : x < end; x += 1) {
            if (int(all.size()) == mostTurns) {
                ended = true;
                break;
            }
            all.push_back(x);
        }
        return all;
    }

    const ir::Function &filter_;
    Maps maps_;
    const std::array<float, 2> size_{width, height};
    const std::array<float, laneBlock> zeros_{};
    std::array<const float *, std::size_t(ShaderInput::Count)> inputs_;
    std::vector<const float *> variables_; ///< The trial has parameters that they override.
    std::vector<float> parameters_;        ///< Those that are not folded: computed defaults.
    const std::int32_t parameterOffset_ = 0;
    ShaderCallbacks callbacks_;
    PixelLoopRunner runner_;
    ShaderArgs args_;
};

/// The text with all parameters at their defaults.
ir::Function folded(const ir::LoweredShader &shader) {
    std::vector<ir::FoldedValue> values;
    for (const ir::ShaderParameter &parameter : shader.parameters)
        for (std::size_t c = 0; parameter.firstSlot >= 0 && c < parameter.defaults.size(); ++c)
            values.push_back({parameter.firstSlot + int(c), parameter.defaults[c]});
    return ir::fold(shader.whole, values);
}

std::string difference(const Maps &expected, const Maps &found) {
    for (std::size_t map = 0; map < expected.values().size(); ++map)
        for (std::size_t k = 0; k < expected.values()[map].size(); ++k)
            if (!sameBits(expected.values()[map][k], found.values()[map][k]))
                return "map " + std::to_string(map) + ", number " + std::to_string(k) + ": " +
                       std::to_string(expected.values()[map][k]) + ", in pixel loops " +
                       std::to_string(found.values()[map][k]);
    return {};
}

/// Sums are made in another order, and so have other values.
bool hasSums(const ir::Function &filter) {
    return std::ranges::any_of(filter.pixelLoops,
                               [](const ir::PixelLoop &loop) { return !loop.sums.empty(); });
}

} // namespace

std::string tryFilter(const ir::LoweredShader &shader, Monitor &monitor) {
    monitor.enter(Stage::Facts, "pixel loops");
    ir::Function whole = folded(shader);
    whole.mostTurns = std::min(whole.mostTurns, mostTurns);
    const ir::Function text = ir::slice(whole, ir::Question::Filter);
    const ir::Function filter = ir::extractPixelLoops(text);
    std::string problem = ir::verify(filter);
    for (const ir::PixelLoop &loop : filter.pixelLoops)
        if (problem.empty())
            problem = ir::verify(*loop.body);
    if (!problem.empty())
        return "makes an invalid function\n" + problem + "\n" + ir::print(filter);
    monitor.enter(Stage::Interpret, "filter");
    Run expected(text), found(filter);
    expected.run();
    found.run();
    ++monitor.tally().interpreted;
    if (expected.ended || found.ended || hasSums(filter))
        return {};
    problem = difference(expected.maps(), found.maps());
    return problem.empty() ? "" : "pixel loops do not make what the text does\n" + problem;
}

} // namespace candela::fuzz
