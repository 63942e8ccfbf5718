// SPDX-License-Identifier: Apache-2.0
// Primitive variables that are patch polynomials, whatever the patches are.
#pragma once

#include "world/geometry/patch_polynomials.h"
#include "world/geometry/primitive_variables.h"
#include "world/geometry/surface.h"

#include <functional>
#include <optional>
#include <span>

namespace candela {

class PatchVariables {
public:
    /// Tells of a call's points from `start` on which patches of a space they lie on. A surface
    /// whose variables are known on patches of several kinds numbers these spaces as it likes.
    using Locate = std::function<void(int space, int start, int count, PatchPoints &)>;

    /// "N" becomes the shading normal; so does "Np" where there is no "N".
    void add(const NumericVariable &, PatchPolynomials, int space = 0);
    /// s and t, unless they are there: Attributes::textureCoordinates over (meshU, meshV).
    void addTextureCoordinates(const std::array<float, 8> &corners);

    std::span<const VariableInfo> infos() const { return infos_; }
    bool hasNormals() const { return normal_.has_value(); }
    /// Surface::evaluateVariable; answers begin at place `first`.
    void evaluate(int index, int first, int count, const Locate &, float *const *value,
                  float *const *valueDu, float *const *valueDv) const;
    /// Sets N to the normals that are given where they are not zero, and the derivatives to those
    /// of the unit normal along it; without them does nothing. Null planes are not wanted.
    void overrideNormals(int count, const Locate &, Vec3Planes N, Vec3Planes dNdu,
                         Vec3Planes dNdv) const;

private:
    struct Values {
        PatchPolynomials polynomials;
        int space = 0;
    };
    void addTextureCoordinate(const char *name, const std::array<float, 8> &corners, int offset);

    std::vector<VariableInfo> infos_;
    std::vector<Values> values_;
    std::optional<Values> normal_;
};

} // namespace candela
