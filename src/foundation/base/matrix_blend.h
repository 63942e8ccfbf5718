// SPDX-License-Identifier: Apache-2.0
// What lies between two transformations.
#pragma once

#include "foundation/base/matrix4d.h"

namespace candela {

/// From `a` (share 0) to `b` (share 1), both affine. They are taken apart into a stretch, a
/// rotation and a translation (polar decomposition); stretch and translation go straight, the
/// rotation turns at an even rate, the short way round, so that what turns does not shrink. Where
/// one of the two mirrors, or is singular, all entries go straight.
Matrix4d blend(const Matrix4d &a, const Matrix4d &b, double share);

/// All entries go straight.
Matrix4d straight(const Matrix4d &a, const Matrix4d &b, double share);

} // namespace candela
