// SPDX-License-Identifier: Apache-2.0
// One procedural text, many questions: how a lowered shader is sliced into the functions that
// answer them (data specialisation; DESIGN section 3).
//
// `Prepare` runs the Surface and View stages (analyse/dependence.h) once a point and view and saves
// in the frame what `Scatter` needs; `Scatter` then runs once a light direction.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/ir/core/ir.h"

#include <memory>
#include <string>
#include <vector>

namespace candela::ir {

/// A surface shader's printf() speaks in Prepare alone (or in View, which stands for it), so that a
/// point prints once, whatever else it is asked; what stands in light loops prints nothing.
enum class Question : std::uint8_t {
    Shade,   ///< Everything, all light given. Outputs "Ci", "Oi".
    Surface, ///< The Surface stage alone: fills its part of the frame.
    View,    ///< The View stage on the frame of Surface. Outputs as Prepare.
    Prepare, ///< Surface and View in one. Outputs "cone k axis|angle|exponent|importance",
             ///< "Ce" (emission), "Ca" (answer to ambient and irradiance as given, without Ce;
             ///< only if SurfaceFacts::readsAmbient), "Oi".
    Scatter, ///< On the frame: the linear response. Output "g": for answeredRequest =
             ///< finiteRequests, pi f_r cos for the direction sampleL; for a delta request, the
             ///< factor on the radiance from its direction.
    Emit,    ///< Output "Ce": Ci with every light request, ambient() and irradiance() zero.
    Opacity, ///< Output "Oi".
    Light,   ///< Light shaders: outputs "L" (from the light to Ps) and "Cl".
};
inline constexpr int questionCount = int(Question::Light) + 1;
/// "shade", "surface", ...
const char *nameOf(Question);

/// One importance cone that Prepare states. Its six outputs (axis x y z in current space and of
/// any length, full angle in degrees, exponent, importance >= 0) start at output slot `output`.
/// The caller clears the importance plane first: lanes that do not reach the request leave it.
struct ConeSlot {
    int request = 0;
    int output = 0;
    bool exact = false; ///< The answer to light is this lobe, up to a factor.
};

/// What is known of a surface shader without running it.
struct SurfaceFacts {
    std::vector<ConeSlot> cones;
    bool hasLoops = false;      ///< Any light loop, diffuse(), specular() and phong() included.
    bool readsAmbient = false;  ///< ambient() or irradiance() reaches Ci.
    bool emits = false;         ///< Ce is not provably zero.
    bool opaqueIfOsIs1 = false; ///< Oi is provably Os (or 1).
    bool affine = true;         ///< Ci is affine in the light, channel by channel.
    int notAffineLine = 0;      ///< The line that makes it not so.
    /// Requests are static: numbered, independent of each other's answers. If not, Prepare and
    /// Scatter re-run the text (no frame is saved), and the facts say so for the caller's warning.
    bool staticRequests = true;
    int notStaticLine = 0;
};

/// A function's facts; `path` rule as for slice().
SurfaceFacts surfaceFacts(const Function &whole);

/// The function that answers the question, with dead code gone, ready to interpret or compile.
/// `whole` is a lowered shader to which folding and the light rule have been applied.
Function slice(const Function &whole, Question);

} // namespace candela::ir
