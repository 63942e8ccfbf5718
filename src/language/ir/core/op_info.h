// SPDX-License-Identifier: Apache-2.0
// What ops.def says, as data. An operation that lacks a fact does not compile: passes ask here and
// have no lists of operations of their own.
#pragma once

#include "language/ir/core/ir.h"

#include <string_view>

namespace candela::ir {

enum class OpClass : std::uint8_t {
    Constant,
    Source,         ///< What the caller gives.
    Arithmetic,     ///< Floats to float, exactly as IEEE 754 has it.
    Fused,          ///< Several of those, rounded once.
    Transcendental, ///< Floats to float, by a library.
    Comparison,
    Logic,
    Choice,
    Conversion,
    Memory, ///< Local arrays.
    Image,  ///< Reads the maps of filters.
    Call,   ///< Runtime functions.
    Random,
    Service, ///< Asks the renderer.
    Control, ///< Owns regions.
    Light,   ///< Asks for light, or about it.
    Frame,   ///< Takes from the frame of an earlier function.
    Effect,  ///< Leaves something behind.
    Derivative,
};

/// What Instruction::immediate is: an index into a table of the function or of the runtime, or a
/// number.
enum class Immediate : std::uint8_t {
    None,
    Number,
    String,
    Input, ///< A plane, counted over the components of shader_inputs.def.
    Parameter,
    Variable,
    Captured,
    Space,
    Array,
    Image,
    PixelLoop,
    RuntimeFunction,
    Service,
    Site, ///< Tells places in the text apart.
    Request,
    RequestOrFinite, ///< A request, or finiteRequests.
    Category,
    Emission,
    Output,
    Frame,
    Direction,
};

/// Where results vary from lane to lane.
enum class ResultUniformity : std::uint8_t {
    Uniform,
    Operands, ///< Where an operand does.
    Varying,
    Array,   ///< Where an operand or the array does.
    Service, ///< services.def.
    Regions, ///< Where what the regions yield does, or what decides among them.
};

enum class Purity : std::uint8_t {
    Pure,    ///< Same operands, same results, nothing else: may be shared, moved and left out.
    Reads,   ///< May be left out, but not moved across effects.
    Effect,  ///< Stays even if nobody uses its results.
    Regions, ///< As what its regions hold.
};

/// Whether it may be computed though nobody may want the result.
enum class Speculation : std::uint8_t {
    Always, ///< Costs less than a branch around it.
    Cheap,  ///< May leave its branch, but does not replace one.
    Never,  ///< Stays behind its conditions.
};

/// How a derivative follows from the operands' derivatives.
enum class SlopeRule : std::uint8_t {
    None,   ///< No number that changes smoothly.
    Step,   ///< 0 almost everywhere.
    Source, ///< What the caller says of the source.
    Sum,
    Difference,
    Product,
    Quotient,
    Negation,
    Magnitude,
    Least,
    Greatest,
    Choice, ///< That of the chosen operand.
    Second, ///< The second operand's.
    Chain,  ///< The one operand's, times a factor of operand and result.
    Angle,  ///< Of atan2.
    Power,
    Memory,  ///< An array of slopes beside the array.
    Call,    ///< functions.def names a function that gives slopes.
    Service, ///< services.def.
    Control,
    Raised,  ///< The operand's of an order higher.
    Held,    ///< Not known: counts as 0, of which users are told.
    Refused, ///< Not known: cannot be differentiated.
};

/// How a range follows from the operands' ranges.
enum class BoundRule : std::uint8_t {
    Unknown, ///< Anything.
    Constant,
    Source, ///< What the caller says of the source.
    Sum,
    Difference,
    Product,
    Quotient,
    Negation,
    Magnitude,
    Least,
    Greatest,
    First,      ///< The first operand's.
    Increasing, ///< Of one operand, never falls.
    Decreasing, ///< Of one operand, never rises.
    Periodic,
    Angle, ///< Of atan2.
    Power,
    Comparison, ///< Known only if the ranges do not overlap.
    Logic,
    Union,    ///< Of all that may be chosen, stored or converted.
    Fraction, ///< [0,1).
    Call,     ///< functions.def.
    Service,  ///< services.def.
    Control,
    Effect, ///< No results.
};

struct OpInfo {
    const char *name;
    std::string_view operands, results; ///< Letters of ops.def.
    int regions;
    OpClass kind;
    Immediate immediate;
    ResultUniformity uniformity;
    Purity purity;
    Speculation speculation;
    /// Of computing it again where its operands stand, in units of an addition. 0: nothing to
    /// compute, or (Call, Query) functions.def or services.def says.
    int cost;
    SlopeRule slope;
    BoundRule bound;
};

inline constexpr OpInfo opTable[] = {
#define IR_OP(name, operands, results, regions, kind, immediate, uniformity, purity, speculation,  \
              cost, slope, bound, meaning)                                                         \
    {#name,                                                                                        \
     operands,                                                                                     \
     results,                                                                                      \
     regions,                                                                                      \
     OpClass::kind,                                                                                \
     Immediate::immediate,                                                                         \
     ResultUniformity::uniformity,                                                                 \
     Purity::purity,                                                                               \
     Speculation::speculation,                                                                     \
     cost,                                                                                         \
     SlopeRule::slope,                                                                             \
     BoundRule::bound},
#include "language/ir/core/ops.def"
#undef IR_OP
};
inline constexpr int opCount = int(std::size(opTable));

constexpr const OpInfo &info(Op op) { return opTable[int(op)]; }

/// What a letter of ops.def stands for; not of "*" and ".".
constexpr Type typeOf(char letter) {
    return letter == 'b'   ? Type::Bool
           : letter == 'i' ? Type::Integer
           : letter == 's' ? Type::String
                           : Type::Float;
}
/// How many values a letter stands for in a function with so many color samples; not of "*".
constexpr int countOf(char letter, int colorSamples) {
    return letter == 'c' ? colorSamples : letter == 'm' ? 16 : 1;
}

constexpr bool isConstant(Op op) { return info(op).kind == OpClass::Constant; }
constexpr bool isPure(Op op) { return info(op).purity == Purity::Pure; }
constexpr bool hasEffect(Op op) { return info(op).purity == Purity::Effect; }
/// Float to float, one or two operands: evaluateFloat() has it.
constexpr bool isFloatArithmetic(Op op) {
    return info(op).kind == OpClass::Arithmetic || info(op).kind == OpClass::Transcendental;
}
/// Two floats to bool: evaluateCompare() has it.
constexpr bool isFloatComparison(Op op) {
    return info(op).kind == OpClass::Comparison && info(op).operands == "ff";
}
/// Loads and stores of local arrays.
constexpr bool isArrayAccess(Op op) { return info(op).kind == OpClass::Memory; }

/// Light that comes from outside of the text: answers, ambient(), irradiance().
constexpr bool isAnswer(Op op) {
    return info(op).kind == OpClass::Light && info(op).results == "c";
}

/// As OpInfo::cost, with that of the runtime function or the service that is called.
int costOf(const Function &, const Instruction &);
/// The service that a Query or a Command asks.
inline const ServiceUse &serviceOf(const Function &function, const Instruction &i) {
    return function.services[std::size_t(i.immediate)];
}
constexpr bool isService(Op op) { return info(op).immediate == Immediate::Service; }
/// Does a query's answer vary though no operand does?
inline bool variesByItself(const ServiceUse &use) {
    return use.info->uniformity == ServiceUniformity::Varying;
}

} // namespace candela::ir
