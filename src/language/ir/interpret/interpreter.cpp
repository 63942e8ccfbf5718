// SPDX-License-Identifier: Apache-2.0
#include "language/ir/interpret/interpreter.h"

#include "language/ir/core/evaluate.h"
#include "language/ir/core/op_info.h"
#include "language/ir/interpret/lane_arguments.h"
#include "language/ir/interpret/lane_service.h"
#include "language/runtime/runtime_functions.h"
#include "language/runtime/scalar_math.h"

#include <algorithm>
#include <cmath>

namespace candela::ir {

namespace {

float dot(const Vector &a, const Vector &b, bool isFused) {
    const auto plus = [&](float sum, int k) {
        return isFused ? std::fma(a[k], b[k], sum) : sum + a[k] * b[k];
    };
    return plus(plus(a[0] * b[0], 1), 2);
}

Vector normalize(const Vector &a, bool isFused) {
    float size = std::sqrt(dot(a, a, isFused));
    float inverse = 1 / (size == 0 ? 1 : size);
    return {a[0] * inverse, a[1] * inverse, a[2] * inverse};
}

/// How long the loops of a lane may still run: each outermost one begins anew.
class Turns {
public:
    explicit Turns(int most) : most_(most) {}

    void enter(bool counts) {
        if (counts && open_++ == 0)
            taken_ = 0;
    }
    void leave(bool counts) { open_ -= counts ? 1 : 0; }
    /// False if there is none left: then all loops of the lane have ended.
    bool take() {
        ended_ = taken_ == most_;
        ++taken_;
        return !ended_;
    }
    bool ended() const { return ended_; }

private:
    int most_, taken_ = 0, open_ = 0;
    bool ended_ = false;
};

/// Runs the function in one lane.
class Lane {
public:
    Lane(const Function &function, const ShaderArgs &args, int lane)
        : function_(function), args_(args, function, lane), cells_(function.values.size()),
          turns_(function.mostTurns) {
        for (const Array &array : function.arrays) {
            arrays_.emplace_back(array.size, Cell{0});
            for (int k = 0; array.captured >= 0 && k < array.size; ++k)
                arrays_.back()[std::size_t(k)].number = args.capturedArrays[array.captured][k];
        }
    }

    void run(const Region &region) {
        for (const Instruction &i : region.body)
            run(i);
    }

private:
    void run(const Instruction &i) {
        if (isFloatArithmetic(i.op))
            return cells_.set(i,
                              evaluateFloat(i.op, number(i, 0), cells_.number(i.operands.back())));
        if (!runSource(i) && !runLogic(i) && !runMemory(i) && !runLight(i))
            runControl(i);
    }

    float number(const Instruction &i, int operand) const {
        return cells_.number(i.operands[operand]);
    }
    bool truth(const Instruction &i, int operand) const {
        return cells_.truth(i.operands[operand]);
    }
    /// Strings are indices of the function's own, or below 0.
    bool sameText(int a, int b) const {
        return a < 0 || b < 0
                   ? a == b
                   : function_.strings[std::size_t(a)] == function_.strings[std::size_t(b)];
    }

    bool runSource(const Instruction &i) {
        switch (i.op) {
        case Op::ConstFloat: cells_.set(i, i.number); return true;
        case Op::ConstBool: cells_.setInteger(i, i.immediate != 0); return true;
        case Op::ConstInteger:
        case Op::ConstString: cells_.setInteger(i, i.immediate); return true;
        case Op::Input: cells_.set(i, args_.input(i.immediate)); return true;
        case Op::Parameter: cells_.set(i, args_.parameter(i.immediate)); return true;
        case Op::Captured: cells_.set(i, args_.all().captured[i.immediate]); return true;
        case Op::Variable: cells_.set(i, args_.variable(i.immediate)); return true;
        case Op::Space: cells_.setAll(i, args_.space(i.immediate)); return true;
        case Op::SpaceInverse: cells_.setAll(i, args_.space(i.immediate) + 16); return true;
        case Op::Object: cells_.setAll(i, args_.object()); return true;
        case Op::ObjectInverse: cells_.setAll(i, args_.object() + 16); return true;
        case Op::Random: cells_.set(i, args_.random(i.immediate, number(i, 0))); return true;
        case Op::MulAdd:
            cells_.set(i, std::fma(number(i, 0), number(i, 1), number(i, 2)));
            return true;
        default: return false;
        }
    }

    bool runLogic(const Instruction &i) {
        switch (i.op) {
        case Op::Less:
        case Op::LessEqual:
        case Op::Equal:
        case Op::NotEqual:
            cells_.setInteger(i, evaluateCompare(i.op, number(i, 0), number(i, 1)));
            return true;
        case Op::StringEqual:
            cells_.setInteger(
                i, sameText(cells_.integer(i.operands[0]), cells_.integer(i.operands[1])));
            return true;
        case Op::And: cells_.setInteger(i, truth(i, 0) && truth(i, 1)); return true;
        case Op::Or: cells_.setInteger(i, truth(i, 0) || truth(i, 1)); return true;
        case Op::Not: cells_.setInteger(i, !truth(i, 0)); return true;
        case Op::Select:
            cells_[i.results[0]] = cells_[i.operands[truth(i, 0) ? 1 : 2]];
            return true;
        case Op::FloatFromBool: cells_.set(i, truth(i, 0) ? 1.0f : 0.0f); return true;
        case Op::IntegerFromFloat:
            cells_.setInteger(i, integerFromFloat(number(i, 0)));
            return true;
        case Op::StringFromFloat:
            cells_.setInteger(i, stringOfNumber(integerFromFloat(number(i, 0))));
            return true;
        case Op::Call: runCall(i); return true;
        default: return false;
        }
    }

    void runCall(const Instruction &i) {
        std::array<const float *, runtime::maxRuntimeInputs> inputs;
        std::array<float *, runtime::maxRuntimeOutputs> outputs;
        for (std::size_t k = 0; k < i.operands.size(); ++k)
            inputs[k] = &cells_[i.operands[k]].number;
        for (std::size_t k = 0; k < i.results.size(); ++k)
            outputs[k] = &cells_[i.results[k]].number;
        runtime::callScalar(runtime::RuntimeFunction(i.immediate), inputs.data(), outputs.data());
    }

    bool runMemory(const Instruction &i) {
        switch (i.op) {
        case Op::ArrayLoad: cells_[i.results[0]] = element(i); return true;
        case Op::ArrayStore: element(i) = cells_[i.operands[1]]; return true;
        case Op::FrameLoad: cells_.set(i, args_.load(i.immediate)); return true;
        case Op::FrameStore: {
            bool isBool = function_.values[i.operands[0]].type == Type::Bool;
            float value = isBool ? float(truth(i, 0)) : number(i, 0);
            args_.save(i.immediate, turns_.ended() ? 0 : value);
            return true;
        }
        case Op::Output:
            args_.output(i.immediate) =
                turns_.ended() ? function_.outputs[i.immediate].whenEnded : number(i, 0);
            return true;
        case Op::Query:
        case Op::Command: ask(i); return true;
        case Op::ImageLoad:
        case Op::ImageStore:
        case Op::PixelLoop: runImage(i); return true;
        case Op::EmissionCone: return true; // For Question::Emission.
        default: return false;
        }
    }

    Cell &element(const Instruction &i) {
        auto &array = arrays_[i.immediate];
        int index = cells_.integer(i.operands[0]);
        const int inside = std::clamp(index, 0, int(array.size()) - 1);
        const ShaderCallbacks *callbacks = args_.callbacks();
        if (inside != index && callbacks && callbacks->indexOutside && !turns_.ended())
            callbacks->indexOutside(callbacks->context, fileOf(i), i.line);
        return array[inside];
    }

    const char *fileOf(const Instruction &i) const {
        return function_.files.empty() ? "" : function_.files[i.file].c_str();
    }

    /// Where a loop has been ended nobody is asked.
    void ask(const Instruction &i) {
        LaneService service(function_, i);
        for (ValueId v : i.operands)
            service.add(function_.values[v].type, {.integer = cells_.integer(v)});
        const std::vector<float> answer = turns_.ended() ? std::vector<float>(i.results.size())
                                                         : service.ask(args_.all(), args_.lane());
        cells_.setAll(i, answer.data());
    }

    void runImage(const Instruction &i) {
        std::vector<float> operands, results(i.results.size());
        for (ValueId v : i.operands)
            operands.push_back(cells_.number(v));
        const ShaderArgs &args = args_.all();
        if (i.op == Op::PixelLoop) {
            runPixelLoop(i, operands, results);
        } else if (i.op == Op::ImageLoad) {
            const ImageUse &use = function_.images[std::size_t(i.immediate)];
            runtime::lookUpImage(args.maps[use.map], use.filter, use.values, 1, 1, operands.data(),
                                 results.data());
        } else if (!turns_.ended()) {
            const ImageUse &use = function_.images[std::size_t(i.immediate)];
            runtime::setImage(args.maps[use.map], use.values, 1, 1, operands.data());
        }
        cells_.setAll(i, results.data());
    }

    void runPixelLoop(const Instruction &i, const std::vector<float> &given,
                      std::vector<float> &results) {
        std::vector<std::vector<float>> copies;
        std::vector<const float *> arrays;
        for (int array : function_.pixelLoops[std::size_t(i.immediate)].arrays) {
            copies.emplace_back();
            for (const Cell &cell : arrays_[std::size_t(array)])
                copies.back().push_back(cell.number);
        }
        for (const std::vector<float> &copy : copies)
            arrays.push_back(copy.data());
        runtime::runPixelLoop(&args_.all(), i.immediate, int(results.size()), given.data(),
                              arrays.data(), results.data());
    }

    bool runLight(const Instruction &i) {
        switch (i.op) {
        case Op::AnsweredRequest: cells_.setInteger(i, args_.hasAnswered(i.immediate)); return true;
        case Op::CategoryAccepts: cells_.setInteger(i, args_.accepts(i.immediate)); return true;
        case Op::SampleLight: cells_.set(i, float(args_.light())); return true;
        case Op::Answer: cells_.setAll(i, args_.answer(i.immediate).data()); return true;
        case Op::Ambient: cells_.setAll(i, args_.ambient().data()); return true;
        case Op::Irradiance: cells_.setAll(i, args_.irradiance().data()); return true;
        case Op::LightLoop: runLightLoop(i); return true;
        default: return false;
        }
    }

    void runLightLoop(const Instruction &i) {
        const LightRequest &request = function_.requests[i.immediate];
        std::size_t carried = i.operands.size() - i.results.size();
        cells_.copy({i.operands.begin() + carried, i.operands.end()}, i.results);
        bool extended = request.form == ConeForm::Extended && request.coneCount > 0;
        if (extended && number(i, 6) <= 0)
            return runLightBody(i, {cells_.vector(i, 3), args_.answer(i.immediate)});
        args_.forEachSample(request.category, [&](const LaneArguments::LightSample &sample) {
            if (request.form != ConeForm::Classic || isInsideCone(i, sample.L))
                runLightBody(i, sample);
        });
    }

    /// Of a classic loop.
    bool isInsideCone(const Instruction &i, const Vector &L) const {
        const bool isFused = function_.isFused;
        float cosine = dot(normalize(L, isFused), cells_.vector(i, 3), isFused);
        return cosine >= runtime::cos(number(i, 6));
    }

    void runLightBody(const Instruction &i, const LaneArguments::LightSample &sample) {
        if (sample.Cl == Color{})
            return;
        const Region &region = i.regions[0];
        for (int k = 0; k < 3; ++k)
            cells_[region.arguments[k]].number = sample.L[k];
        const int samples = function_.colors.samples;
        for (int k = 0; k < samples; ++k)
            cells_[region.arguments[3 + k]].number = sample.Cl[k];
        cells_[region.arguments[3 + samples]].number = float(sample.light);
        cells_.copy(i.results, {region.arguments.begin() + 4 + samples, region.arguments.end()});
        run(region);
        cells_.copy(region.yields, i.results);
    }

    /// If and Loop.
    void runControl(const Instruction &i) {
        if (i.op == Op::If) {
            const Region &region = i.regions[truth(i, 0) ? 0 : 1];
            run(region);
            return cells_.copy(region.yields, i.results);
        }
        const bool counts = i.immediate == 0;
        cells_.copy(i.operands, i.results);
        turns_.enter(counts);
        while (cells_.truth(i.results[0]) && (!counts || takeTurn(i))) {
            const Region &region = i.regions[0];
            cells_.copy(i.results, region.arguments);
            run(region);
            cells_.copy(region.yields, i.results);
        }
        turns_.leave(counts);
    }

    bool takeTurn(const Instruction &loop) {
        if (turns_.ended() || turns_.take())
            return !turns_.ended();
        if (const ShaderCallbacks *callbacks = args_.callbacks(); callbacks && callbacks->loopEnded)
            callbacks->loopEnded(callbacks->context, fileOf(loop), loop.line);
        return false;
    }

    const Function &function_;
    LaneArguments args_;
    Cells cells_;
    std::vector<std::vector<Cell>> arrays_;
    Turns turns_;
};

} // namespace

void interpret(const Function &function, const ShaderArgs &args) {
    for (int i = 0; i < args.count; ++i)
        if (!args.active || (args.active[i / 16] >> (i % 16) & 1))
            Lane(function, args, i).run(function.body);
}

} // namespace candela::ir
