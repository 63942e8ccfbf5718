// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/dependence.h"

#include <algorithm>

namespace candela::ir {

namespace {

bool viewDependent(int plane) {
    return (plane >= int(ShaderInput::I) && plane <= int(ShaderInput::ILast_)) ||
           (plane >= int(ShaderInput::E) && plane <= int(ShaderInput::ELast_));
}
bool sampleDependent(int plane) {
    return plane >= int(ShaderInput::sampleL) && plane <= int(ShaderInput::sampleLLast_);
}

/// Stages only rise, so sweeping until nothing rises ends.
class DependenceSweep {
public:
    DependenceSweep(const Function &function, Dependence &result)
        : function_(function), result_(result) {
        result.stage.assign(function.values.size(), Stage::Surface);
        result.arrayStage.assign(function.arrays.size(), Stage::Surface);
        result.definition.resize(function.values.size());
        result.request.assign(function.requests.size(), nullptr);
    }

    void run() {
        do {
            changed_ = false;
            sweep(function_.body, Context{});
        } while (changed_);
    }

private:
    struct Context {
        Stage condition = Stage::Surface; ///< The latest condition that we stand under.
        Stage loop = Stage::Surface;      ///< The latest value that a loop around us carries.
        bool repeated = false;            ///< Within a Loop or another light loop.
    };

    Stage stage(ValueId v) const { return result_.stage[v]; }
    Stage latest(const std::vector<ValueId> &values, Stage start = Stage::Surface) const {
        for (ValueId v : values)
            start = std::max(start, stage(v));
        return start;
    }
    void raise(Stage &known, Stage to) {
        if (known < to) {
            known = to;
            changed_ = true;
        }
    }
    void raise(ValueId v, Stage to) { raise(result_.stage[v], to); }
    /// A frame slot holds a float; integers and strings that control flow chooses are chosen anew.
    bool canBeSaved(ValueId v) const {
        Type type = function_.values[v].type;
        return type == Type::Float || type == Type::Bool;
    }

    void sweep(const Region &region, Context context) {
        for (const Instruction &i : region.body)
            sweep(i, context);
    }

    void sweep(const Instruction &i, Context context) {
        for (std::size_t k = 0; k < i.results.size(); ++k)
            result_.definition[i.results[k]] = {&i, int(k)};
        switch (i.op) {
        case Op::If: return sweepIf(i, context);
        case Op::Loop: return sweepLoop(i, context);
        case Op::LightLoop: return sweepLightLoop(i, context);
        case Op::ArrayLoad:
        case Op::ArrayStore: {
            Stage &array = result_.arrayStage[i.immediate];
            raise(array, std::max(latest(i.operands, context.condition), context.loop));
            for (ValueId v : i.results)
                raise(v, array);
            return;
        }
        case Op::Answer: noteRequest(i, latest(i.operands), context); [[fallthrough]];
        case Op::Ambient:
        case Op::Irradiance:
            for (ValueId v : i.results)
                raise(v, Stage::Response);
            return;
        case Op::Input:
            raise(i.results[0], sampleDependent(i.immediate) ? Stage::Response
                                : viewDependent(i.immediate) ? Stage::View
                                                             : Stage::Surface);
            return;
        default:
            for (ValueId v : i.results)
                raise(v, latest(i.operands));
        }
    }

    void sweepIf(const Instruction &i, Context context) {
        Stage condition = stage(i.operands[0]);
        context.condition = std::max(context.condition, condition);
        for (const Region &region : i.regions) {
            sweep(region, context);
            for (std::size_t k = 0; k < i.results.size(); ++k)
                raise(i.results[k], canBeSaved(i.results[k])
                                        ? std::max(condition, stage(region.yields[k]))
                                        : Stage::Response);
        }
    }

    void sweepLoop(const Instruction &i, Context context) {
        const Region &region = i.regions[0];
        context.condition = std::max(context.condition, stage(region.arguments[0]));
        for (std::size_t k = 0; k < i.results.size(); ++k) {
            Stage to = std::max({stage(i.operands[k]), stage(region.yields[k]), context.condition});
            raise(region.arguments[k], canBeSaved(i.results[k]) ? to : Stage::Response);
            raise(i.results[k], stage(region.arguments[k]));
        }
        context.loop = std::max(context.loop, latest(region.arguments));
        context.repeated = true;
        sweep(region, context);
    }

    void sweepLightLoop(const Instruction &i, Context context) {
        std::size_t fixed = i.operands.size() - i.results.size();
        noteRequest(i, latest({i.operands.begin() + 3, i.operands.begin() + fixed}), context);
        const Region &region = i.regions[0];
        for (ValueId v : region.arguments)
            raise(v, Stage::Response);
        for (ValueId v : i.results)
            raise(v, Stage::Response);
        context.condition = Stage::Response;
        context.repeated = true;
        sweep(region, context);
    }

    void noteRequest(const Instruction &i, Stage asked, Context context) {
        result_.request[i.immediate] = &i;
        bool isStatic =
            !context.repeated && asked < Stage::Response && context.condition < Stage::Response;
        if (!isStatic && result_.staticRequests) {
            result_.staticRequests = false;
            result_.notStaticLine = i.line;
        }
    }

    const Function &function_;
    Dependence &result_;
    bool changed_ = false;
};

} // namespace

Dependence analyzeDependence(const Function &function) {
    Dependence result;
    DependenceSweep(function, result).run();
    return result;
}

} // namespace candela::ir
