// SPDX-License-Identifier: Apache-2.0
// illuminance, illuminate and solar (RI 3.2 section 12.5; the paper's sections 5.2 and 5.4).
#pragma once

#include "language/ir/lower/lowering.h"

namespace candela::ir {

/// A request for light that the text makes there; of too many it makes an error.
int addRequest(Lowering &, const LightRequest &, const sl::Place &where);
void lowerIlluminance(Lowering &, const sl::Stmt &);
/// A local emitter: L runs from the light to Ps. Light leaves within the cone of the classic form
/// alone; the cones of the extended form say where to send it, and cull nothing.
void lowerIlluminate(Lowering &, const sl::Stmt &);
/// A distant emitter: the direction of its light is the axis, or one of the cone about it by
/// lightSample; without any arguments one of the sphere. Of several cones of the extended form
/// lightSample takes one, by importance, and Cl counts as if it had been the widest.
void lowerSolar(Lowering &, const sl::Stmt &);

} // namespace candela::ir
