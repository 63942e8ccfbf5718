// SPDX-License-Identifier: Apache-2.0
// What a surface shader is worth over a piece of surface: its directional-hemispherical
// reflectance, emission and opacity projected on a basis, by quadrature that its bounds certify. A
// piece is cut until the bounds say that no coefficient is off by more than a tolerance; so a
// stripe between two samples is not missed, and where a shader is smooth few boxes do.
#pragma once

#include "world/shading/shader_bounds.h"

#include <array>
#include <functional>
#include <vector>

namespace candela {

/// A box of surface parameters, by its middle and its extents.
struct ParameterBox {
    double u = .5, v = .5, Du = 1, Dv = 1;
};

/// A surface: tells a shader what it reads of the middle of a box, and what that does over the box
/// (shader_bounds.h). I is set afterwards, I's derivatives being zero: the viewer is far away.
using BoxPlacer = std::function<void(BoxBounds &, int lane, const ParameterBox &)>;

struct ProjectionSettings {
    /// Legendre polynomials along u and along v up to this degree: 0 to 2 for M1 to M3.
    int degree = 0;
    float tolerance = 1e-3f; ///< Of each coefficient of each quantity.
    /// Reflectance and emission are means over this many views, spread as the cosine over the side
    /// that fieldAxis points to; 1: along it.
    int views = 1;
    int mostBoxes = 1 << 17; ///< The projection is as good as it is when these are used up.
};

struct Projection {
    using Coefficient = std::array<double, colorSamples>;
    /// By j (degree + 1) + i, polynomial i along u and j along v; orthonormal over the box taken as
    /// the unit square.
    std::vector<Coefficient> reflectance, emission, opacity;
    /// No coefficient is farther off, but for how the field and the views are summed
    /// (ir/transform/uniform_field.h). Infinite, if the shader has no bounds somewhere.
    double error = 0;
    long boundCalls = 0; ///< Boxes that the shader was asked about, each view by itself.
    /// What plain refinement would ask: the whole in boxes as narrow and as low as any was needed.
    double plainCalls = 0;
};

Projection project(const ShaderInstance &, const BoxPlacer &, const ParameterBox &,
                   const ProjectionSettings &);

/// Legendre polynomial of degree 0 to 2, orthonormal on [0, 1].
double legendre(int degree, double x);

} // namespace candela
