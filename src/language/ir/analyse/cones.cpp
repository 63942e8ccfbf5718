// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/cones.h"

#include "language/ir/analyse/cone_lobes.h"
#include "language/ir/core/dataflow.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// Which values of a light loop's body depend on its Cl, by data or control.
struct LightTaint : ForwardAnalysis<bool> {
    LightTaint(const Function &text, const Instruction &loop) : ForwardAnalysis(text), loop(loop) {
        Dataflow(*this).run(loop);
    }

    bool any(std::span<const ValueId> all) const {
        return std::any_of(all.begin(), all.end(), [&](ValueId v) { return at(v); });
    }
    bool result(const Instruction &i, std::size_t, const Enclosing *) const {
        return any(i.operands) || (isArrayAccess(i.op) && arrayOf(i));
    }
    bool array(const Instruction &i, const Enclosing *) const {
        return arrayOf(i) || (hasEffect(i.op) && any(i.operands));
    }
    bool flow(const ValueFlow &flow, const Enclosing *) const {
        const auto condition = conditionOf(flow.owner);
        return any(flow.from) || (condition && at(*condition));
    }
    bool given(const Instruction &i, std::size_t k) const {
        return &i == &loop && sampleOfCl(function, k);
    }

    const Instruction &loop;
};

Cone wholeLoop(const Function &text, const Instruction &loop) {
    Cone cone;
    cone.request = loop.immediate;
    if (text.requests[loop.immediate].form == ConeForm::Classic) {
        cone.kind = Cone::Kind::Classic;
        std::copy_n(loop.operands.begin() + 3, 3, cone.axis.begin());
    }
    LightTaint taint(text, loop);
    for (std::size_t k = 0; k < loop.results.size(); ++k)
        if (text.values[loop.results[k]].type == Type::Float && taint.at(loop.regions[0].yields[k]))
            cone.weights.push_back({int(k), {}});
    return cone;
}

void addLoopCones(const Function &text, const Dependence &dependence, bool recognize,
                  const Instruction &loop, std::vector<Cone> &cones) {
    const LightRequest &request = text.requests[loop.immediate];
    if (request.form == ConeForm::Extended && request.coneCount > 0) {
        for (int k = 0; k < request.coneCount; ++k) {
            Cone cone;
            cone.request = loop.immediate;
            cone.kind = Cone::Kind::Stated;
            cone.index = k;
            cones.push_back(cone);
        }
        return;
    }
    Cone whole = wholeLoop(text, loop);
    std::vector<Cone> lobes;
    if (recognize)
        lobes = recognizeLobes(text, dependence, loop, whole);
    if (lobes.empty())
        lobes.push_back(whole);
    cones.insert(cones.end(), lobes.begin(), lobes.end());
}

} // namespace

std::vector<Cone> conesOf(const Function &text, const Dependence &dependence, bool recognize) {
    std::vector<Cone> cones;
    for (std::size_t r = 0; r < text.requests.size(); ++r) {
        const Instruction *i = dependence.request[r];
        if (!i)
            continue;
        if (i->op == Op::LightLoop) {
            addLoopCones(text, dependence, recognize, *i, cones);
            continue;
        }
        Cone cone;
        cone.request = int(r);
        cone.kind = Cone::Kind::Delta;
        cones.push_back(cone);
    }
    return cones;
}

} // namespace candela::ir
