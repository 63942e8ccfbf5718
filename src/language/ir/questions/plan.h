// SPDX-License-Identifier: Apache-2.0
// What slicing must know of a text before it answers any question: shared by all slices and by
// surfaceFacts(), so that they agree.
#pragma once

#include "language/ir/analyse/cones.h"
#include "language/ir/questions/questions.h"
#include "language/ir/transform/specialize.h"

#include <array>
#include <map>
#include <memory>

namespace candela::ir {

/// Spill slots of the values that later binding times need, numbered as Function has them. The slot
/// of Ce's channel k, which is the view's, has the key text.values.size() + k.
struct FramePlan {
    int surfaceSlots = 0, viewSlots = 0;
    std::map<ValueId, int> all;     ///< For Surface and View.
    std::map<ValueId, int> scatter; ///< For Prepare and Scatter: those that Scatter loads.
};

/// Holds pointers into its own text and stays where it is.
struct Plan {
    Function whole; ///< As it was given.
    Function text;  ///< Without dead code, with cone tests, equal values shared.
    Dependence dependence;
    std::vector<ConeTest> coneTests;
    std::vector<Cone> cones;
    std::vector<bool> emits;   ///< By channel: Ce is not provably zero.
    bool readsAmbient = false; ///< Ci does.
    bool readsIrradiance = false; ///< Likewise, by irradiance().
    bool framed = false;       ///< Requests are static; the binding times are told apart.
    FramePlan frame;           ///< Empty if not framed.
};

/// Outputs of a surface's Ci under an assumption, in one binding time, as output `to`.
Function specializeUnder(const Plan &, const Assumption &, OutputKind from, OutputKind to);

FramePlan planFrame(const Plan &);
/// Output slots of Prepare, in order: cones, Ce, Ca, Oi, and Completed where a loop may be ended.
std::vector<OutputSlot> prepareOutputs(const Plan &);

} // namespace candela::ir
