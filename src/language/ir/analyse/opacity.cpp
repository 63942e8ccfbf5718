// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/opacity.h"

#include "language/ir/core/dataflow.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// Surely 1 if all Os are.
struct Opaque {
    bool one = false;
    int component = -1; ///< Of Os; -1 = the constant 1.
    friend bool operator==(const Opaque &, const Opaque &) = default;
};

struct OpacityAnalysis : ForwardAnalysis<Opaque> {
    using ForwardAnalysis::ForwardAnalysis;

    static Opaque join(const Opaque &a, const Opaque &b) {
        const bool agree = a.component == b.component || a.component < 0 || b.component < 0;
        return {a.one && b.one && agree, std::max(a.component, b.component)};
    }

    Opaque result(const Instruction &i, std::size_t, const Enclosing *) const {
        const int plane = i.immediate;
        switch (i.op) {
        case Op::ConstFloat: return {i.number == 1, -1};
        case Op::Input:
            if (plane < int(ShaderInput::Os) || plane > int(ShaderInput::OsLast_))
                return {};
            return {true, plane - int(ShaderInput::Os)};
        case Op::Select: return join(at(i, 1), at(i, 2));
        default: return {};
        }
    }
    Opaque array(const Instruction &, const Enclosing *) const { return {}; }
    /// What loops carry is never sure.
    Opaque flow(const ValueFlow &flow, const Enclosing *) const {
        return flow.owner.op == Op::If ? join(at(flow.from[0]), at(flow.from[1])) : Opaque{};
    }
    Opaque given(const Instruction &, std::size_t) const { return {}; }
};

} // namespace

bool opaqueIfOsIs1(const Function &opacity) {
    OpacityAnalysis analysis(opacity);
    solve(analysis);
    return !anyInstruction(opacity.body, [&](const Instruction &i) {
        if (i.op != Op::Output)
            return false;
        const Opaque &known = analysis.at(i, 0);
        const int component = opacity.outputs[i.immediate].component;
        return !known.one || (known.component >= 0 && known.component != component);
    });
}

} // namespace candela::ir
