// SPDX-License-Identifier: Apache-2.0
// Where a function asks for light.
#pragma once

#include "language/ir/core/builder.h"

#include <string>

namespace candela::ir {

/// Numbers a request, for lightLoop() or trace().
int addRequest(Builder &, const LightRequest &);
/// For LightRequest::category: -1 for no category; pools equal ones.
int categoryIndex(Builder &, const std::string &);

/// What a light loop knows of the light of one turn.
struct LoopLight {
    Triple L;
    Values Cl;
    ValueId number; ///< As ShaderArgs::sampleLight has it, a float: index + 1, 0 = indirect light.
};
using LightBody = std::function<Values(const LoopLight &, const Values &carried)>;
/// In sliced functions: LoopLight::number of the sample that is answered.
ValueId sampleLight(Builder &);
/// A loop over the light of a request. `position` and `cones` as LightRequest says.
Values lightLoop(Builder &, int request, const Triple &position, const Values &cones,
                 const Values &initial, const LightBody &);
Values trace(Builder &, int request, const Triple &position, const Triple &direction);
Values ambient(Builder &);
Values irradiance(Builder &, const Triple &position, const Triple &omega);

} // namespace candela::ir
