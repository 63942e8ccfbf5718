// SPDX-License-Identifier: Apache-2.0
// From the typed syntax tree to the IR: the whole text of one shader as one function.
#pragma once

#include "foundation/base/diagnostics.h"
#include "language/ir/core/ir.h"
#include "language/ir/core/pass_listener.h"
#include "language/syntax/base_type.h"

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace candela {

namespace sl {
struct TypedShader; // language/semantics
}

namespace ir {

/// How a light shader lights (RI 3.2 section 10.3; paper 5.4).
enum class LightClass : std::uint8_t {
    Ambient, ///< Neither illuminate() nor solar().
    Local,   ///< illuminate(): from a position, or from the surface of an area light.
    Distant, ///< solar(): from a direction.
};

/// A shader parameter with its default.
struct ShaderParameter {
    std::string name;
    /// "float", "color", "point", "vector", "normal", "matrix", "string".
    std::string type;
    int arraySize = 1;
    bool output = false;
    bool varying = false;
    /// Into Function::parameters; -1 for what nothing reads, and for strings that are constants.
    int firstSlot = -1;
    /// Default value, components in row; points, vectors and normals in the space `defaultSpace`
    /// ("shader" unless the text says otherwise), matrices from there ("current" unless the text
    /// says otherwise), colors in the rendering colour space.
    std::vector<float> defaults;
    std::string defaultSpace = "shader";
    std::vector<std::string> stringDefaults;
    /// The default depends on the point or on other parameters: the shader computes it, unless the
    /// hidden parameter givenName(name) is not 0. `defaults` are zeros then.
    bool computed = false;
};

/// The hidden parameter that says whether an instance gives a parameter a value.
inline std::string givenName(const std::string &parameter) { return "given " + parameter; }
/// What surface(), displacement(), atmosphere(), incident() and opposite() ask goes by such a name:
/// `whose` shader ("surface", "displacement", "atmosphere", "interior", "exterior"), the shape of
/// the value ("float", "color[3]"; "string") and the parameter's name there.
std::string toldName(const std::string &whose, const std::string &shape, const std::string &name);
/// The text asks other shaders of its primitive something.
bool asksOtherShaders(const sl::TypedShader &);

/// The value of a string parameter. Strings are constants of the code, but for those that are left
/// to run time: only names of pictures, printf() and comparisons with strings of the text
/// (textsOf()), none of which they are, can do with those.
struct StringValue {
    std::string name;
    std::vector<std::string> value;
    std::vector<bool> leftToRunTime{}; ///< By element; none where it is empty.

    bool isLeft(size_t element) const {
        return element < leftToRunTime.size() && leftToRunTime[element];
    }
    bool isLeft() const { return std::ranges::count(leftToRunTime, true) > 0; }
};
/// The strings that stand in the shader's text, in order, each once.
std::vector<std::string> textsOf(const sl::TypedShader &);

/// The hidden parameter that holds an attribute of the primitive, which the shader asks for: 1 and
/// the value, or zeros if there is none of that type.
inline std::string attributeParameter(const std::string &name, const std::string &type) {
    return "attribute " + type + " " + name;
}

struct LoweredShader {
    std::string name;
    sl::ShaderKind kind = sl::ShaderKind::Surface;
    std::vector<ShaderParameter> parameters;
    Function whole;
    LightClass lightClass = LightClass::Ambient;
    /// Light shaders: Cl falls off as 1/(L.L) for Local (or is constant for Distant), provably.
    bool inverseSquare = false;
    /// Light shaders: Cl depends on the direction of L alone, not on its length, provably: the
    /// emitted radiance of an area light.
    bool directionOnly = false;
};

/// What a text leaves open.
struct LoweringOptions {
    /// specular() and specularbrdf() have this over the roughness as their exponent. RI 3.1 says 1
    /// (section 15.6); production renderers, and the pictures that files were made by, have 8.
    float highlightScale = 8;
    int mostTurns = mostLoopTurns; ///< As Function has it; > 0.
    /// Lookups of textures are told how far their coordinates reach over a point's footprint.
    bool footprints = true;
    /// indirectdiffuse() follows rays: nothing else brings that light (LightRule::Classic).
    bool indirectByRays = false;
    /// What the samples of colours stand for.
    ColorBasis colors{};
    /// Is told of "lower", "derivatives" and "clean up"; may be empty.
    PassListener listener{};
};

/// Lowers a checked shader. Output slots: those of its kind (syntax/kinds.def); then the paper's
/// bounds ("DCiDu"...) and the P of surfaces that the text sets, then output parameters. Oi starts
/// as Os, Ci and Cl as black. Parameters and Space matrices are as of current space: whoever fills
/// the parameter block transforms. Hidden parameter slots are appended after the declared ones:
/// "shader" (32 floats: currentFromShader, shaderFromCurrent) if the text uses that space;
/// givenName(p) of each parameter p whose default is computed; attributeParameter()s; and what it
/// asks of other shaders, by toldName(): 1 or 0, whether they have it, and its numbers (colours in
/// red, green and blue). Strings that they tell it are among `strings`, by toldName() too.
/// Function::spaces holds names as the text has them, and "depth" for depth(): camera space with z
/// from 0 at the near to 1 at the far clipping plane. What transform/jet.h takes not to change is
/// warned of. What semantics could not refuse (a space name that is not constant, a default that is
/// none, derivatives that are not to be had) is reported; nothing is returned then. `variables`
/// names the parameters that primitive variables override.
///
/// A string that is left to run time has a slot, with its number in ShaderServices::strings. Where
/// the text turns out to need one after all, it is a constant, and no longer left in `strings`.
std::optional<LoweredShader> lower(const sl::TypedShader &, std::vector<StringValue> &strings,
                                   const std::vector<std::string> &variables, DiagnosticSink &,
                                   const LoweringOptions & = {});
/// The same for those who need not know what is left.
std::optional<LoweredShader> lower(const sl::TypedShader &, const std::vector<StringValue> &strings,
                                   const std::vector<std::string> &variables, DiagnosticSink &,
                                   const LoweringOptions & = {});

} // namespace ir
} // namespace candela
