// SPDX-License-Identifier: Apache-2.0
// What a shader does over pieces of surface: bounds of a surface's reflectance, emission and
// opacity, or of a light's emission, over boxes of (u, v), a batch of boxes a call
// (docs/bounds.md).
//
//     BoxBounds boxes(instance, 512);
//     for (int i = 0; i < count; ++i)
//         boxes.set(ShaderInput::P, i, {x, y, z}); // and all else that the caller knows
//     boxes.ask(count);
//     const BoundPlanes rho = boxes.reflectance();
//     // of box i, channel c, for all |du| <= Du/2, |dv| <= Dv/2 about its middle:
//     // |f(u+du, v+dv) - rho.value[c][i] - rho.byU[c][i] du - rho.byV[c][i] dv|
//     //     <= rho.tolerance[c][i]
#pragma once

#include "foundation/base/planes.h"
#include "world/shading/shader_code.h"

#include <array>
#include <initializer_list>
#include <vector>

namespace candela {

/// Planes of one quantity, by colour sample; a number a box.
struct BoundPlanes {
    std::array<const float *, colorSamples> value{};      ///< In the middle of the box.
    std::array<const float *, colorSamples> byU{}, byV{}; ///< Slopes about it.
    /// How far the quantity may lie from the plane that value and slopes say, anywhere in the box,
    /// and seen from anywhere in the cone. Infinity: no bound is known.
    std::array<const float *, colorSamples> tolerance{};
};

/// A batch of boxes of one surface or light shader, and what the shader answers of them. Of no use
/// to two threads at once.
///
/// Inputs are those of the middle of the box, zero at first: ShaderInput's, in current space. What
/// they do over the box say their derivatives (dPdu, dPdv, dNdu, dNdv, dNgdu, dNgdv, dsdu... and,
/// of where the point is seen from, dIdu, dIdv: zero for an eye far away) and, for what derivatives
/// leave out, the Rest planes: runtime/shader_inputs.def. `Du` and `Dv` are the box's extents, `Dw`
/// the solid angle of the cone about -I. `fieldAxis` turns the set of directions that the uniform
/// field is summed over: the surface's normal, of unit length.
class BoxBounds {
public:
    BoxBounds(const ShaderInstance &, int mostBoxes);

    void set(ShaderInput, int box, std::initializer_list<float> components);
    /// The first plane of an input.
    float *plane(ShaderInput input) { return inputs_[int(input)]; }
    /// "object" space of all boxes: currentFromObject and its inverse, 16 floats each, row-major;
    /// at first current space itself.
    void setObject(const float *twoMatrices);

    /// Asks about the first so many boxes.
    void ask(int count);
    /// Asks for the values in the middles alone, which is faster; slopes and tolerances stay.
    void askValues(int count);

    /// Answer to a field of radiance 1 from all directions: what the shader's light loops and
    /// traced rays make of it, without its emission.
    BoundPlanes reflectance() const { return planes_[0]; }
    /// Ci without any light; of lights Cl toward Ps, the cone Dw being about that direction. A
    /// light has nothing else.
    BoundPlanes emission() const { return planes_[1]; }
    BoundPlanes opacity() const { return planes_[2]; }

private:
    void ask(const QuestionCode &, const std::vector<float *> &outputs, int count);

    ShaderInstance instance_;
    const QuestionCode *boundsCode_, *valuesCode_;
    Planes<float> inputs_, outputs_;
    Planes<std::int32_t> integers_;
    Planes<float> unwanted_;
    std::array<float, 32> object_{};
    std::vector<const float *> inputTable_;
    std::vector<float *> bounds_, values_; ///< Output tables of the two questions.
    std::array<BoundPlanes, 3> planes_;
};

} // namespace candela
