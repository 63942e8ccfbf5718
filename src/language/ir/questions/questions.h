// SPDX-License-Identifier: Apache-2.0
// One procedural text, many questions: how a lowered shader is sliced into the functions that
// answer them (data specialisation; DESIGN section 3).
//
// `Surface` runs what depends on the point alone and saves what is needed of it in the surface
// frame; `View`, what depends on the viewer too, once a view of the point, in the view frame;
// `Scatter` then runs once a light direction, for a view. A path's two ends ask so: one surface,
// viewed from both sides. `Prepare` is Surface and View in one, for who has one view of each point.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/ir/core/ir.h"
#include "language/syntax/base_type.h"

#include <memory>
#include <string>
#include <vector>

namespace candela::ir {

/// A surface shader's printf() (all of its services with effects) speaks in two questions: in Shade
/// as the text has it, and in Prepare (or View, which stands for it) as the text has it without any
/// light, so that what stands in light loops says nothing. Who asks both silences one
/// (silenced()), so that a point speaks once.
enum class Question : std::uint8_t {
#define QUESTION(name, ...) name,
#include "language/ir/questions/questions.def"
#undef QUESTION
};
inline constexpr int questionCount = 0
#define QUESTION(name, ...) +1
#include "language/ir/questions/questions.def"
#undef QUESTION
    ;
/// "shade", "surface", ...
const char *nameOf(Question);
/// The questions that texts of the kind answer, in order.
std::vector<Question> questionsOf(sl::ShaderKind);

/// Of the memories that ShaderArgs has for values between questions.
enum class FrameUse : std::uint8_t { None, Surface, View, Both };
constexpr bool uses(FrameUse frames, BindingTime frame) {
    return frames == FrameUse::Both ||
           frames == (frame == BindingTime::View ? FrameUse::View : FrameUse::Surface);
}
FrameUse framesReadBy(Question);
FrameUse framesWrittenBy(Question);
/// Whether a level that can may round products and sums in the answer once.
bool mayFuse(Question);
/// What a lane of the question's batches is: a point, a view of one, or a response for a view.
BindingTime lanesOf(Question);
/// Texts of the kind are planned: of some question to them the answer comes from a Plan.
bool isPlanned(sl::ShaderKind);

/// One importance cone that Prepare (or, of lights, Emission) states, by the planes that hold it
/// (outputs.def). The caller clears the importance plane first: lanes that do not reach the request
/// leave it.
struct ConeSlot {
    int request = 0;  ///< Of lights: which of Function::emissions.
    int axis = 0;     ///< The first of three.
    int position = 0; ///< Likewise; -1: surfaces state none.
    int angle = 0, exponent = 0, importance = 0;
    bool exact = false; ///< The answer to light is this lobe, up to a factor.
};

/// What is known of a surface shader without running it.
struct SurfaceFacts {
    std::vector<ConeSlot> cones;
    bool hasLoops = false;      ///< Any light loop, diffuse(), specular() and phong() included.
    bool readsAmbient = false;  ///< ambient() or irradiance() reaches Ci,
    bool readsIrradiance = false; ///< irradiance() does.
    bool emits = false;         ///< Ce is not provably zero.
    bool opaqueIfOsIs1 = false; ///< Oi is provably Os (or 1).
    bool affine = true;         ///< Ci is affine in the light, channel by channel.
    int notAffineLine = 0;      ///< The line that makes it not so.
    /// Requests are static: numbered, independent of each other's answers. If not, Prepare and
    /// Scatter re-run the text (no frame is saved), and the facts say so for the caller's warning.
    bool staticRequests = true;
    int notStaticLine = 0;
    /// The line of a printf() that light decides about: by what it prints, or whether; 0 = none.
    int printsLightLine = 0;
};

/// Something in the function is computed from light that is given to it.
bool asksForLight(const Function &);

/// The function without its services with effects.
Function silenced(Function);

/// What slicing must know of a planned text before it answers any question.
struct Plan;
/// Made once, for all questions to the shader. `whole` is a lowered shader to which folding and the
/// light rule have been applied.
std::shared_ptr<const Plan> makePlan(const Function &whole);

/// What is known of a light shader without running it.
struct LightFacts {
    std::vector<ConeSlot> cones; ///< Of Question::Emission, one each of Function::emissions.
    /// The cones depend on the light alone, not on Ps or anything else of the point that is lit.
    bool conesAreTheLights = true;
};
LightFacts lightFacts(const Function &whole);

/// What is known of a volume shader without running it.
struct VolumeFacts {
    /// Question::Segment and Transmission may be asked; else Volume alone, at known ends.
    bool affine = true;
    int notAffineLine = 0;     ///< The line that makes it not so.
    bool asksForLight = false; ///< It has light loops.
    bool readsAmbient = false; ///< It calls ambient().
    bool speaks = false;       ///< It has services with effects.
};
VolumeFacts volumeFacts(const Function &whole);

SurfaceFacts surfaceFacts(const Plan &);

/// Something in a text of which nothing is known over a box of surface.
struct Boundless {
    int line = 0;     ///< 0: none of its own.
    std::string what; ///< "texture()"
};

/// What Question::Bounds (of lights LightBounds) will answer.
struct BoundFacts {
    /// The shader sets TCiDu, TCiDv or TCiDw (a light TClDu...): these bounds are its own, but for
    /// that of its opacity.
    bool givenByShader = false;
    /// What is not known, in the order of the text: what it reaches has no bound.
    std::vector<Boundless> boundless;
};
BoundFacts boundFacts(const Plan &);
BoundFacts lightBoundFacts(const Function &whole);

/// What is known of a text that displaces: of displacement and transformation shaders, and of
/// surface shaders that set P.
struct DisplacementFacts {
    bool movesP = false;      ///< P is not provably as it was.
    bool setsN = false;       ///< N likewise; of surface shaders, if they set P, too.
    bool slopesKnown = false; ///< The derivatives in Displaced are there, and rest on no guess.
    /// What it makes of P and N may depend on where the object is placed beyond what its own space
    /// says: named spaces, "shader" space, the eye and the like are read.
    bool readsOtherSpaces = false;
};
/// Nothing if the text does not displace.
DisplacementFacts displacementFacts(const Function &whole);
/// The text without what it says of displacement: what shading asks.
Function withoutDisplacement(Function whole);

/// The function that answers the question, with dead code gone, ready to interpret or compile.
Function slice(const Plan &, Question);

/// The same with a plan of their own, if they need one.
SurfaceFacts surfaceFacts(const Function &whole);
BoundFacts boundFacts(const Function &whole);
Function slice(const Function &whole, Question);

} // namespace candela::ir
