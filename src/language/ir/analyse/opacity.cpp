// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/opacity.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// Values of the function that are surely 1 if all Os are.
class OpacitySweep {
public:
    explicit OpacitySweep(const Function &function) : sure_(function.values.size()) {
        sweep(function.body, function);
    }
    bool opaque_ = true;

private:
    struct Known {
        bool one = false;
        int component = -1; ///< Of Os; -1 = the constant 1.
    };

    void sweep(const Region &region, const Function &function) {
        for (const Instruction &i : region.body) {
            for (const Region &inner : i.regions)
                sweep(inner, function);
            switch (i.op) {
            case Op::ConstFloat: sure_[i.results[0]] = {i.number == 1, -1}; break;
            case Op::Input:
                if (i.immediate >= int(ShaderInput::Os) && i.immediate <= int(ShaderInput::OsLast_))
                    sure_[i.results[0]] = {true, i.immediate - int(ShaderInput::Os)};
                break;
            case Op::Select:
                sure_[i.results[0]] = join(sure_[i.operands[1]], sure_[i.operands[2]]);
                break;
            case Op::If:
                for (std::size_t k = 0; k < i.results.size(); ++k)
                    sure_[i.results[k]] =
                        join(sure_[i.regions[0].yields[k]], sure_[i.regions[1].yields[k]]);
                break;
            case Op::Output: {
                const Known &known = sure_[i.operands[0]];
                int component = function.outputs[i.immediate].component;
                opaque_ &= known.one && (known.component < 0 || known.component == component);
                break;
            }
            default: break;
            }
        }
    }

    static Known join(const Known &a, const Known &b) {
        bool agree = a.component == b.component || a.component < 0 || b.component < 0;
        return {a.one && b.one && agree, std::max(a.component, b.component)};
    }

    std::vector<Known> sure_;
};

} // namespace

bool opaqueIfOsIs1(const Function &opacity) { return OpacitySweep(opacity).opaque_; }

} // namespace candela::ir
