// SPDX-License-Identifier: Apache-2.0
#include "language/ir/analyse/cones.h"

#include "foundation/units/color.h"
#include "language/ir/analyse/cone_lobes.h"

#include <algorithm>

namespace candela::ir {

namespace {

/// Which values of a light loop's body depend on Cl, by data or control.
class LightTaint {
public:
    LightTaint(const Function &text, const Instruction &loop)
        : text_(text), tainted_(text.values.size()) {
        for (int k = 0; k < colorSamples; ++k)
            tainted_[loop.regions[0].arguments[3 + k]] = true;
        do {
            changed_ = false;
            sweepCarried(loop, 3 + colorSamples);
        } while (changed_);
    }
    bool has(ValueId v) const { return tainted_[v]; }

private:
    bool any(const std::vector<ValueId> &values) const {
        for (ValueId v : values)
            if (tainted_[v])
                return true;
        return false;
    }
    void taint(ValueId v) {
        if (!tainted_[v])
            tainted_[v] = changed_ = true;
    }
    void sweepCarried(const Instruction &i, int firstArgument) {
        const Region &region = i.regions[0];
        sweep(region);
        bool condition = i.op == Op::Loop && tainted_[region.arguments[0]];
        for (std::size_t k = 0; k < i.results.size(); ++k)
            if (condition || tainted_[region.yields[k]]) {
                taint(region.arguments[firstArgument + k]);
                taint(i.results[k]);
            }
    }
    void sweep(const Region &region) {
        for (const Instruction &i : region.body) {
            if (i.op == Op::Loop || i.op == Op::LightLoop)
                sweepCarried(i, i.op == Op::Loop ? 0 : 3 + colorSamples);
            bool from = any(i.operands) || (i.op == Op::ArrayLoad && arraysTainted_);
            arraysTainted_ |= i.op == Op::ArrayStore && from;
            for (std::size_t k = 0; k < i.results.size(); ++k) {
                bool yielded = false;
                if (i.op == Op::If)
                    for (const Region &inner : i.regions)
                        yielded |= tainted_[inner.yields[k]];
                if (from || yielded)
                    taint(i.results[k]);
            }
            if (i.op == Op::If)
                for (const Region &inner : i.regions)
                    sweep(inner);
        }
    }

    const Function &text_;
    std::vector<bool> tainted_;
    bool arraysTainted_ = false;
    bool changed_ = false;
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
        if (text.values[loop.results[k]].type == Type::Float &&
            taint.has(loop.regions[0].yields[k]))
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
