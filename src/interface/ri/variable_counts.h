// SPDX-License-Identifier: Apache-2.0
// How many values a primitive variable has on a shape (RI 3.2, section 5), and what is wrong
// with a shape as such.
#pragma once

#include "interface/ri/primitive_record.h"

#include <cstdint>
#include <optional>
#include <string>

namespace candela {

struct VariableCounts {
    int uniform = 1, varying = 4, vertex = 4, faceVarying = 4, faceVertex = 4;
    /// Four varying values may be those of the corners of all of it: files have NURBS so.
    bool mayHaveFourCorners = false;

    int of(StorageClass) const;
};

/// What makes the shape unusable or invisible, as a sentence; empty if nothing does.
std::string defectOf(const ShapeRecord &, const Attributes &);
/// For a shape without defect. `vertexCount` is that of the given P, at least that which the
/// polygons' indices need; other shapes know theirs.
VariableCounts countsOf(const ShapeRecord &, const Attributes &, int vertexCount);
/// The number of values that P must have at least.
std::int64_t verticesNeeded(const ShapeRecord &, const Attributes &);

} // namespace candela
