// SPDX-License-Identifier: Apache-2.0
// Directions that fill a cone evenly.
#pragma once

#include "foundation/base/vec3.h"

namespace candela {

/// Two numbers in [0,1).
struct ConeSample {
    float x, y;
};
/// The numbers of sample `turn`, which fill the square evenly (Roberts' sequence), shifted.
ConeSample coneSample(int turn, float shiftX, float shiftY);
/// From 1 to 4096, whatever a shader asks for.
int sampleCount(float wanted);

/// The cosine of an angle up to `angle` (radians), `x` of the way; `weighted`: as likely as its
/// cosine, and up to a right angle.
float cosineInCone(float x, float angle, bool weighted);
/// A unit direction at `cosine` from the unit axis, turned by `turn` of a full circle (Duff et al.
/// 2017).
Vec3 directionAbout(Vec3 axis, float cosine, float turn);

} // namespace candela
