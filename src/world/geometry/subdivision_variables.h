// SPDX-License-Identifier: Apache-2.0
// Primitive variables of subdivision surfaces. Vertex ones are as smooth as the surface,
// "facevertex" ones within the regions over which they are continuous; varying and "facevarying"
// ones are bilinear on each piece.
#pragma once

#include "foundation/base/diagnostics.h"
#include "world/geometry/patch_variables.h"
#include "world/geometry/subdivision_refinement.h"

namespace candela {

class SubdivisionVariables {
public:
    /// `pieces` are those that the surface has, as it names them; `numbers` what trees call them.
    SubdivisionVariables(const SubdivisionRecord &, const PrimitiveRecord &, const Attributes &,
                         const SubdivisionRefinement &, std::span<const std::uint32_t> numbers,
                         std::shared_ptr<const SubdivisionTree>, DiagnosticSink &);

    std::span<const VariableInfo> infos() const { return variables_.infos(); }
    bool hasNormals() const { return variables_.hasNormals(); }
    void evaluate(int index, const SurfaceQuery &, float *const *value, float *const *valueDu,
                  float *const *valueDv) const;
    void overrideNormals(const SurfaceQuery &, const SurfaceAnswer &) const;

private:
    PatchVariables::Locate locator(const SurfaceQuery &) const;

    PatchVariables variables_;
    std::vector<std::uint32_t> numbers_;
    /// Spaces of patches (PatchVariables): 0 the pieces themselves, k the leaves of tree k - 1.
    std::vector<std::shared_ptr<const SubdivisionTree>> trees_;
};

} // namespace candela
