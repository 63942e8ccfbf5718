// SPDX-License-Identifier: Apache-2.0
// The intermediate representation of shaders: structured, scalar, static single assignment.
//
// - Scalar: colors, points and matrices are their components; a value is a float, a bool, an
//   integer or a string. Analyses (slicing, affinity, derivatives, bounds) go channel by channel.
// - Structured: control flow is If, Loop and LightLoop, which own regions. break, continue and
//   return have been turned into conditions by the lowering, so masks nest like the text does.
// - Uniformity: every value is uniform (the same in all lanes) or varying; it is inferred from the
//   operands, not from declarations. Instance parameters are varying: lanes of one batch may
//   belong to different instances.
// - Local arrays of static size that are indexed by computed indices are memory (ArrayLoad and
//   ArrayStore, in program order); all other variables are values.
#pragma once

#include "foundation/base/diagnostics.h"
#include "foundation/units/color_basis.h"
#include "language/ir/core/budget.h"
#include "language/ir/core/outputs.h"
#include "language/runtime/image_access.h"
#include "language/runtime/shader_abi.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela::ir {

using ValueId = std::uint32_t;

enum class Type : std::uint8_t { Float, Bool, Integer, String };
enum class Uniformity : std::uint8_t { Uniform, Varying };

struct Value {
    Type type = Type::Float;
    Uniformity uniformity = Uniformity::Uniform;
};

enum class Op : std::uint8_t {
#define IR_OP(name, ...) name,
#include "language/ir/core/ops.def"
#undef IR_OP
};

/// What Slope differentiates by: the surface parameters u and v.
enum class Direction : std::uint8_t { U, V };
inline constexpr int directionCount = 2;

struct Instruction;

/// A sequence of instructions with arguments at its head and values it yields at its end.
struct Region {
    std::vector<ValueId> arguments;
    std::vector<Instruction> body;
    std::vector<ValueId> yields;
};

struct Instruction {
    Op op{};
    std::vector<ValueId> operands;
    std::vector<ValueId> results;
    std::vector<Region> regions;
    /// What the operation needs beside operands; its meaning stands in ops.def. Of a Loop: 1 if it
    /// ends soon, which markShortLoops() proves: its turns are not counted.
    std::int32_t immediate = 0;
    float number = 0;
    int line = 0; ///< Of the shader's source, for messages; 0 = made by the compiler.
    /// Into Function::files, for messages at run time: of array accesses, loops and services.
    int file = 0;
};

/// How a light loop chooses its samples and states its importance.
enum class ConeForm : std::uint8_t {
    Everywhere, ///< illuminance(P): all directions; importance as a full sphere.
    Classic,    ///< illuminance(P, axis, angle): half angle in radians; culls outside samples.
    Extended,   ///< The paper's: cones with full angle in degrees; culls nothing.
};

/// A light request: a loop over incident light, or a question like trace(). Numbered in program
/// order; LightLoop and Answer carry the number as immediate.
struct LightRequest {
    enum class Kind : std::uint8_t { Loop, Trace };
    Kind kind = Kind::Loop;
    ConeForm form = ConeForm::Everywhere;
    /// Operands of a LightLoop: position (3), then cones: (axis 3, angle) for Classic, the axis
    /// normalised; (axis 3, angle, exponent, importance) each for Extended; then the initial
    /// carried values.
    int coneCount = 0;
    int category = -1; ///< Index into Function::categories, -1 = all.
    int line = 0;
};

/// Where illuminate() or solar() of a light shader's text sends light; EmissionCone carries its
/// number as immediate.
struct Emission {
    bool distant = false;  ///< solar(): light without a position, from its direction everywhere.
    bool repeated = false; ///< In a loop: it may be stated again and again.
    int line = 0;
};

/// What a Query or a Command asks, beside its operands; equal ones are one. Where it is asked, the
/// instruction says.
struct ServiceUse {
    const ServiceInfo *info = nullptr;
    static constexpr int atRunTime = -1;
    std::vector<int>
        texts;       ///< Into Function::strings; the first atRunTime: the last operand is it.
    int results = 0; ///< All of them floats.
    bool hasTextAtRunTime() const { return !texts.empty() && texts[0] == atRunTime; }
    bool operator==(const ServiceUse &) const = default;
};

/// A local array in memory.
struct Array {
    Type type = Type::Float;
    Uniformity uniformity = Uniformity::Varying;
    int size = 0;
    /// How many loops of the text its declaration stands in: each turn of them has its own.
    int loopDepth = 0;
    /// Not its own: entry of ShaderArgs::capturedArrays, from which it is only read; -1 = its own.
    int captured = -1;
};

/// How a map is looked up or set; what an ImageLoad or an ImageStore has beside its operands.
struct ImageUse {
    int map = 0;    ///< Into Function::maps.
    int values = 1; ///< Channels: 1, or a color's.
    runtime::ImageFilter filter = runtime::ImageFilter::Bilinear;
    bool operator==(const ImageUse &) const = default;
};

/// How the values of all turns of a loop become one.
enum class Reduction : std::uint8_t { Sum, Least, Greatest };

/// A loop over pixels whose turns do not see each other: a function of its own, whose lanes are
/// pixels (ir/filter/pixel_loops.h makes it). Its captured numbers are the row and then `captured`
/// of the operands of Op::PixelLoop; its outputs are what the sums are made of.
struct PixelLoop {
    std::shared_ptr<const struct Function> body;
    /// The operands of Op::PixelLoop: first column, end of the columns, first row, end of the rows
    /// (a column c from the first on belongs to it as long as c < end; or c <= end, if `closed`);
    /// then the captured numbers; then what the sums begin with.
    static constexpr int bounds = 4;
    int captured = 0;
    bool closedColumns = false, closedRows = false;
    std::vector<int> arrays; ///< Of the function around it, that the body captures.
    std::vector<Reduction> sums;
    std::vector<int> mapsRead, mapsSet; ///< Into Function::maps.
    std::vector<int> mapsReadAround;    ///< Those of mapsRead that are read at other columns, too.
    /// Sets every pixel of the columns and rows in these of mapsSet, before it reads them.
    std::vector<int> mapsCovered;

    int given() const { return bounds + captured + int(sums.size()); }
};

/// A float of the instance's parameter block, or a plane of a variable that overrides one.
struct ParameterSlot {
    std::string name; ///< The shader parameter it is a component of; or a hidden one ("shader"...).
    int component = 0;
    /// Variables: the plane holds not the component but its derivative.
    std::optional<Direction> slope = std::nullopt;
};

/// One function to interpret or compile: one question to one shader (or, before slicing, the
/// whole text).
struct Function {
    std::string name;
    ColorBasis colors;         ///< Every colour in it has these samples.
    std::vector<Value> values; ///< By ValueId.
    Region body;               ///< No arguments, no yields: results leave through Output.
    std::vector<Array> arrays;
    std::vector<LightRequest> requests;
    std::vector<Emission> emissions;       ///< Of light shaders, in the order of the text.
    std::vector<ServiceUse> services;      ///< By the immediate of Query and Command.
    std::vector<std::string> maps;         ///< Of filters: "Cs", "Ci" and what else it names.
    std::vector<ImageUse> images;          ///< By the immediate of ImageLoad and ImageStore.
    std::vector<PixelLoop> pixelLoops;     ///< By PixelLoop's immediate.
    std::vector<std::string> strings;      ///< By ConstString's immediate.
    std::vector<std::string> files;        ///< Source files, by Instruction::file.
    std::vector<std::string> spaces;       ///< Named coordinate systems, by Space's immediate.
    std::vector<std::string> categories;   ///< Of light loops: "a,-b", also "!diffuse", "!specular"
                                           ///< for what __nondiffuse, __nonspecular exclude.
    std::vector<ParameterSlot> parameters; ///< Floats of the parameter block, in order.
    std::vector<ParameterSlot> variables;  ///< Planes that override parameters.
    std::vector<OutputSlot> outputs;
    std::vector<bool> inputsRead; ///< By ShaderInput.
    /// What a lane of its batches is: a point, a view of one, or a response for a view.
    BindingTime lanes = BindingTime::Surface;
    /// Of the two frames. FrameStore and FrameLoad count the surface frame's slots first and then
    /// the view frame's.
    int surfaceSlots = 0, viewSlots = 0;
    /// Turns of a loop, those of the loops in it included, for a point: then the point's loop ends,
    /// and its outputs are as OutputSlot::whenEnded says.
    int mostTurns = mostLoopTurns;
    /// Vector registers of lanes that code takes at a time: several, where little is done with each
    /// lane and much for all of them. Then nobody is called but for what stands in
    /// runtime/image_access.h, and all lanes are active.
    int registersTogether = 1;
    /// fuseProducts() has been here: light loops test samples in such arithmetic, too.
    bool isFused = false;
    /// Loops may run for ever: after every mostTurns turns ShaderCallbacks::goOn is asked.
    bool isEndless = false;

    ValueId addValue(Type type, Uniformity uniformity) {
        values.push_back({type, uniformity});
        return ValueId(values.size() - 1);
    }
};

/// A slot of one of the frames.
struct SpillSlot {
    BindingTime frame; ///< Surface or View.
    int slot, slots;   ///< Which of how many.
};
inline SpillSlot spillSlot(const Function &function, int number) {
    if (number < function.surfaceSlots)
        return {BindingTime::Surface, number, function.surfaceSlots};
    return {BindingTime::View, number - function.surfaceSlots, function.viewSlots};
}

/// The function as text, for `--emit ir`, tests and people.
std::string print(const Function &);
/// What is wrong with it: types, uniformity, uses before definitions, arities; empty if nothing is.
/// Slopes are wrong in what is to be run: only texts whose derivatives are yet to be written may
/// have them.
std::string verify(const Function &, bool mayHaveSlopes = false);

} // namespace candela::ir
