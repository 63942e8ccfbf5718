// SPDX-License-Identifier: Apache-2.0
#include "language/ir/interpreter.h"

#include "foundation/units/color.h"
#include "language/ir/op_info.h"
#include "language/ir/print_format.h"
#include "language/runtime/runtime_functions.h"
#include "language/runtime/scalar_math.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace candela::ir {

namespace {

/// A value of any type; bools are integers 0 and 1, strings indices into Function::strings.
union Cell {
    float number;
    std::int32_t integer;
};

using Vector = std::array<float, 3>;

float dot(const Vector &a, const Vector &b) { return (a[0] * b[0] + a[1] * b[1]) + a[2] * b[2]; }

Vector normalize(const Vector &a) {
    float size = std::sqrt(dot(a, a));
    float inverse = 1 / (size == 0 ? 1 : size);
    return {a[0] * inverse, a[1] * inverse, a[2] * inverse};
}

class Lane {
public:
    Lane(const Function &function, const ShaderArgs &args)
        : function_(function), args_(args), cells_(function.values.size()) {
        for (const Array &array : function.arrays)
            arrays_.emplace_back(array.size);
    }

    void run(int lane) {
        lane_ = lane;
        for (auto &array : arrays_)
            std::fill(array.begin(), array.end(), Cell{0});
        run(function_.body);
    }

private:
    float number(ValueId v) const { return cells_[v].number; }
    bool truth(ValueId v) const { return cells_[v].integer != 0; }
    Vector vector(const Instruction &i, int first) const {
        return {number(i.operands[first]), number(i.operands[first + 1]),
                number(i.operands[first + 2])};
    }
    void set(const Instruction &i, float x, int result = 0) {
        cells_[i.results[result]].number = x;
    }
    void setInteger(const Instruction &i, int x) { cells_[i.results[0]].integer = x; }

    void run(const Region &region) {
        for (const Instruction &i : region.body)
            run(i);
    }

    void run(const Instruction &i) {
        if (isFloatArithmetic(i.op))
            return set(i, evaluateFloat(i.op, number(i.operands[0]), number(i.operands.back())));
        if (!runSource(i) && !runLogic(i) && !runEffect(i))
            runControl(i);
    }

    bool runSource(const Instruction &i) {
        switch (i.op) {
        case Op::ConstFloat: set(i, i.number); return true;
        case Op::ConstBool: setInteger(i, i.immediate != 0); return true;
        case Op::ConstInteger:
        case Op::ConstString: setInteger(i, i.immediate); return true;
        case Op::Input: set(i, args_.inputs[i.immediate][lane_]); return true;
        case Op::Parameter:
            set(i, args_.parameters[args_.parameterOffset[lane_] + i.immediate]);
            return true;
        case Op::Variable: set(i, args_.variables[i.immediate][lane_]); return true;
        case Op::Space: setMatrix(i, args_.spaces[i.immediate]); return true;
        case Op::SpaceInverse: setMatrix(i, args_.spaces[i.immediate] + 16); return true;
        case Op::Object: setMatrix(i, object()); return true;
        case Op::ObjectInverse: setMatrix(i, object() + 16); return true;
        case Op::Random: {
            float seed = args_.inputs[int(ShaderInput::seed)][lane_];
            set(i, randomNumber(std::bit_cast<std::uint32_t>(seed), i.immediate));
            return true;
        }
        case Op::FrameLoad: set(i, frame(i.immediate)); return true;
        case Op::AnsweredRequest:
            setInteger(i, args_.answeredRequest[lane_] == i.immediate);
            return true;
        case Op::CategoryAccepts: setInteger(i, accepts(i.immediate, lane_)); return true;
        default: return false;
        }
    }

    const float *object() const { return args_.objectMatrices + 32 * args_.objectIndex[lane_]; }
    void setMatrix(const Instruction &i, const float *m) {
        for (int k = 0; k < 16; ++k)
            set(i, m[k], k);
    }
    float &frame(int slot) {
        auto block = std::size_t(lane_ / laneBlock) * function_.frameSlots + slot;
        return args_.frame[block * laneBlock + lane_ % laneBlock];
    }

    bool runLogic(const Instruction &i) {
        switch (i.op) {
        case Op::Less:
        case Op::LessEqual:
        case Op::Equal:
        case Op::NotEqual:
            setInteger(i, evaluateCompare(i.op, number(i.operands[0]), number(i.operands[1])));
            return true;
        case Op::StringEqual:
            setInteger(i, text(i.operands[0]) == text(i.operands[1]));
            return true;
        case Op::And: setInteger(i, truth(i.operands[0]) && truth(i.operands[1])); return true;
        case Op::Or: setInteger(i, truth(i.operands[0]) || truth(i.operands[1])); return true;
        case Op::Not: setInteger(i, !truth(i.operands[0])); return true;
        case Op::Select:
            cells_[i.results[0]] = cells_[i.operands[truth(i.operands[0]) ? 1 : 2]];
            return true;
        case Op::FloatFromBool: set(i, truth(i.operands[0]) ? 1.0f : 0.0f); return true;
        case Op::IntegerFromFloat:
            setInteger(i, integerFromFloat(number(i.operands[0])));
            return true;
        case Op::ArrayLoad: cells_[i.results[0]] = element(i); return true;
        case Op::Call: runCall(i); return true;
        default: return false;
        }
    }

    const std::string &text(ValueId v) const { return function_.strings[cells_[v].integer]; }
    Cell &element(const Instruction &i) {
        auto &array = arrays_[i.immediate];
        int index = cells_[i.operands[0]].integer;
        const int inside = std::clamp(index, 0, int(array.size()) - 1);
        if (inside != index && args_.callbacks && args_.callbacks->indexOutside)
            args_.callbacks->indexOutside(args_.callbacks->context, fileOf(i), i.line);
        return array[inside];
    }
    const char *fileOf(const Instruction &i) const {
        return function_.files.empty() ? "" : function_.files[i.file].c_str();
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

    bool runEffect(const Instruction &i) {
        switch (i.op) {
        case Op::ArrayStore: element(i) = cells_[i.operands[1]]; return true;
        case Op::Output: args_.outputs[i.immediate][lane_] = number(i.operands[0]); return true;
        case Op::FrameStore: {
            ValueId v = i.operands[0];
            bool isBool = function_.values[v].type == Type::Bool;
            frame(i.immediate) = isBool ? float(truth(v)) : number(v);
            return true;
        }
        case Op::Print: print(i); return true;
        default: return false;
        }
    }

    void print(const Instruction &i) const {
        if (!args_.callbacks || !args_.callbacks->print)
            return;
        std::vector<PrintArgument> values;
        for (std::size_t k = 1; k < i.operands.size(); ++k) {
            ValueId v = i.operands[k];
            switch (function_.values[v].type) {
            case Type::Float: values.push_back({number(v), nullptr}); break;
            case Type::String: values.push_back({0, &text(v)}); break;
            default: values.push_back({float(cells_[v].integer), nullptr}); break;
            }
        }
        std::string line = formatPrint(text(i.operands[0]), values);
        args_.callbacks->print(args_.callbacks->context, line.c_str());
    }

    void runControl(const Instruction &i) {
        switch (i.op) {
        case Op::If: {
            const Region &region = i.regions[truth(i.operands[0]) ? 0 : 1];
            run(region);
            copy(region.yields, i.results);
            break;
        }
        case Op::Loop: {
            const Region &region = i.regions[0];
            copy(i.operands, i.results);
            while (truth(i.results[0])) {
                copy(i.results, region.arguments);
                run(region);
                copy(region.yields, i.results);
            }
            break;
        }
        case Op::LightLoop: runLightLoop(i); break;
        case Op::Answer: {
            Plane answers(args_.answers, i.immediate);
            for (int k = 0; k < colorSamples; ++k)
                set(i, answers.at(k, lane_), k);
            break;
        }
        case Op::Ambient:
        case Op::Irradiance: {
            Plane plane(i.op == Op::Ambient ? args_.ambient : args_.irradiance, 0);
            for (int k = 0; k < colorSamples; ++k)
                set(i, plane.at(k, lane_), k);
            break;
        }
        default: break;
        }
    }

    /// A color a lane, black where the caller gave none.
    struct Plane {
        const float *const *planes;
        Plane(const float *const *all, int index)
            : planes(all ? all + index * colorSamples : nullptr) {}
        float at(int channel, int lane) const { return planes ? planes[channel][lane] : 0; }
    };

    /// Copies as one step: no target is read after it was written.
    void copy(const std::vector<ValueId> &from, const std::vector<ValueId> &to) {
        std::vector<Cell> kept;
        for (std::size_t k = 0; k < to.size(); ++k)
            kept.push_back(cells_[from[k]]);
        for (std::size_t k = 0; k < to.size(); ++k)
            cells_[to[k]] = kept[k];
    }

    void runLightLoop(const Instruction &i) {
        const LightRequest &request = function_.requests[i.immediate];
        std::size_t carried = i.operands.size() - i.results.size();
        copy({i.operands.begin() + carried, i.operands.end()}, i.results);
        bool extended = request.form == ConeForm::Extended && request.coneCount > 0;
        if (extended && number(i.operands[6]) <= 0) {
            Plane answers(args_.answers, i.immediate);
            float Cl[colorSamples];
            for (int k = 0; k < colorSamples; ++k)
                Cl[k] = answers.at(k, lane_);
            return runLightBody(i, vector(i, 3), Cl);
        }
        for (int s = 0; s < args_.sampleCount; ++s) {
            std::size_t row = std::size_t(s) * args_.sampleStride + lane_;
            Vector L{args_.sampleL[0][row], args_.sampleL[1][row], args_.sampleL[2][row]};
            float Cl[colorSamples];
            for (int k = 0; k < colorSamples; ++k)
                Cl[k] = args_.sampleCl[k][row];
            if (accepts(request.category, row) && insideCone(i, request, L))
                runLightBody(i, L, Cl);
        }
    }

    bool accepts(int category, std::size_t row) const {
        if (category < 0 || !args_.categoryAccepts)
            return true;
        int light = args_.sampleLight ? args_.sampleLight[row] : 0;
        return args_.categoryAccepts[category * (args_.lightCount + 1) + light] != 0;
    }

    bool insideCone(const Instruction &i, const LightRequest &request, const Vector &L) const {
        if (request.form != ConeForm::Classic)
            return true;
        float cosine = dot(normalize(L), normalize(vector(i, 3)));
        return cosine >= runtime::cos(number(i.operands[6]));
    }

    void runLightBody(const Instruction &i, const Vector &L, const float *Cl) {
        if (std::all_of(Cl, Cl + colorSamples, [](float c) { return c == 0; }))
            return;
        const Region &region = i.regions[0];
        for (int k = 0; k < 3; ++k)
            cells_[region.arguments[k]].number = L[k];
        for (int k = 0; k < colorSamples; ++k)
            cells_[region.arguments[3 + k]].number = Cl[k];
        copy(i.results, {region.arguments.begin() + 3 + colorSamples, region.arguments.end()});
        run(region);
        copy(region.yields, i.results);
    }

    const Function &function_;
    const ShaderArgs &args_;
    std::vector<Cell> cells_;
    std::vector<std::vector<Cell>> arrays_;
    int lane_ = 0;
};

} // namespace

void interpret(const Function &function, const ShaderArgs &args) {
    Lane lane(function, args);
    for (int i = 0; i < args.count; ++i)
        if (!args.active || (args.active[i / 16] >> (i % 16) & 1))
            lane.run(i);
}

} // namespace candela::ir
