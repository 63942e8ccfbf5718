// SPDX-License-Identifier: Apache-2.0
// What slicing must know of a text before it answers any question: shared by slice() and
// surfaceFacts(), so that they agree.
#pragma once

#include "language/ir/analyse/cones.h"
#include "language/ir/transform/specialize.h"

#include <array>
#include <map>
#include <memory>

namespace candela::ir {

struct Plan {
    Function text; ///< Without dead code, with cone tests, equal values shared.
    Dependence dependence;
    std::vector<ConeTest> coneTests;
    std::vector<Cone> cones;
    std::array<bool, 3> emits{}; ///< By channel: Ce is not provably zero.
    bool readsAmbient = false;   ///< Ci does.
    bool framed = false;         ///< Requests are static; the stages are told apart.
};

/// The plan holds pointers into its own text and stays where it is.
std::unique_ptr<Plan> makePlan(const Function &whole);

/// Outputs of a surface's Ci under an assumption, in one stage, as output slot `slot`.
Function specializeUnder(const Plan &, const Assumption &, const std::string &from,
                         const std::string &slot);

/// Frame slots of the values that later stages need. The slot of Ce's channel k has the key
/// text.values.size() + k.
struct FramePlan {
    std::map<ValueId, int> all;     ///< For Surface and View.
    std::map<ValueId, int> scatter; ///< For Prepare and Scatter: those that Scatter loads.
};
FramePlan planFrame(const Plan &);

/// The framed functions. Loads and stores that `slots` does not name are numbered by ValueId.
Function specializePrepare(const Plan &, Stage first, const std::map<ValueId, int> &slots);
Function specializeSurface(const Plan &, const std::map<ValueId, int> &slots);
Function specializeScatter(const Plan &, const std::map<ValueId, int> &slots);
/// Output slots of Prepare, in order: cones, Ce, Ca, Oi.
std::vector<OutputSlot> prepareOutputs(const Plan &);

} // namespace candela::ir
