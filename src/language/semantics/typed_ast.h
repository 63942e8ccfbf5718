// SPDX-License-Identifier: Apache-2.0
// A shader after the type checker: what the lowering to IR reads. All names are resolved, all
// conversions are explicit nodes, all overloads are chosen, and every construct is legal.
//
// Detail. The `detail` of a type is what the language's rules say (parameters default to uniform,
// locals to varying). It is a bound, not the last word: a varying local that only ever holds
// uniform values may be lowered as uniform, and a uniform variable that is assigned under varying
// control has to be lowered as varying, or the result would depend on the number of lanes. A value
// passes from uniform to varying without a node.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "language/semantics/builtins.h"
#include "language/semantics/predefined.h"
#include "language/semantics/type.h"
#include "language/syntax/source.h"
#include "language/syntax/take_apart.h"

namespace candela::sl {

struct Expr;
struct Stmt;
struct Function;
using ExprPtr = std::unique_ptr<Expr>;
using StmtPtr = std::unique_ptr<Stmt>;

struct Symbol {
    enum class Kind { Parameter, Local, Formal, Predefined };
    Kind kind = Kind::Local;
    std::string name;
    Type type;
    Place where;
    /// Parameter: handed back to the caller (AOVs). Formal: assignments reach the argument.
    bool output = false;
    bool detailStated = false; ///< "uniform" or "varying" stands in its declaration.
    const PredefinedVariable *predefined = nullptr; ///< For Kind::Predefined.
    /// A local of a function instance or a formal: the instance it belongs to, else null.
    const Function *owner = nullptr;
    bool read = false;    ///< Somewhere in the shader.
    bool written = false; ///< Somewhere in the shader; initialisation of a local does not count.
};

enum class ExprKind {
    Number,      ///< `number`; float, uniform
    Text,        ///< `text`; string, uniform
    Tuple,       ///< operands: 3 floats for a triple, 16 (row by row) for a matrix
    Variable,    ///< `symbol`; may be a whole array as an argument of a call
    Element,     ///< operands[0][operands[1]]: array Variable and float index (truncated to an
                 ///< integer; out of range is clamped to the array by the lowering)
    Component,   ///< operands[0][operands[1]]: component of a triple; index as for Element
    Negate,      ///< -operands[0]; float, triple or matrix
    Not,         ///< !operands[0]; 1 if the float is 0, else 0
    Binary,      ///< operands[0] `op` operands[1]; see BinaryOp rules below
    Conditional, ///< operands[0] ? operands[1] : operands[2], of the same type; any side effects
                 ///< belong to the chosen branch alone
    Assign,      ///< operands[0] = operands[1], of the same shape; its value is the new value.
                 ///< operands[0] is a Variable, an Element, or a Component of one of these
    TargetValue, ///< Inside the right side of a compound Assign: the target's value before it.
                 ///< `a[i] += x` is Assign(a[i], Binary(Add, TargetValue, x)), so that i is
                 ///< evaluated once. Belongs to the innermost Assign whose right side holds it.
    Convert,     ///< operands[0] as `type`: float -> triple (all three), float -> matrix
                 ///< (f * identity), triple -> triple (components kept)
    FromSpace,   ///< operands[0] was given in the space named by operands[1] (string): a point is
                 ///< transformed from there to "current", likewise a vector and a normal, each by
                 ///< its own rule; a colour is converted to "rgb"; a matrix becomes the one
                 ///< that takes points from current space to the named one and then acts there:
                 ///< matrix "shader" 1 does what transform("shader", p) does (RI 3.2)
    Call,        ///< `function` applied to operands, one a formal; output formals get Variable,
                 ///< Element or Component operands (by reference); arrays are passed whole
    Builtin      ///< `overload` applied to operands, converted to its parameters' types; further
                 ///< operands if it repeats its last parameter or is open-ended (any type)
};

// Binary rules, with both operands already of the types named here:
//   Add, Subtract       same type both: float, triple, matrix
//   Multiply, Divide    float/float, triple/triple (by components), matrix/matrix (a/b = a*inv b);
//                       Multiply also triple*float, float*triple, matrix*float, float*matrix;
//                       Divide also triple/float, matrix/float (scaling)
//   Dot                 triple.triple of type vector; float result
//   Cross               vector^vector; vector result
//   Less ... NotEqual   float/float; result float 1 or 0. Also triples: Less and its kin hold if
//                       they do in all components. Equal and NotEqual also matrices (equal if all
//                       components are) and strings
//   And, Or             floats, true if not 0; result float 1 or 0. RI leaves open whether the
//                       right side runs if the left decides: side effects there run only if needed
// Point, vector and normal count as one type here: the operands of Add may be point and vector.

struct Expr {
    Expr() = default;
    Expr(Expr &&) = default;
    Expr &operator=(Expr &&) = default;
    ~Expr() { takeApart(*this, &Expr::operands); }

    ExprKind kind = ExprKind::Number;
    Type type;
    Place where;
    std::vector<ExprPtr> operands;

    double number = 0;
    std::string text;
    Symbol *symbol = nullptr;
    BinaryOp op = BinaryOp::Add;
    const Function *function = nullptr;
    const BuiltinOverload *overload = nullptr;
};

enum class StmtKind {
    Block,       ///< body
    Declare,     ///< `symbol` comes to life: `values` are its initial value (an array: one each,
                 ///< fewer leave the rest zero); none: zero, or "" for strings
    Evaluate,    ///< value, for its effect
    If,          ///< value ? body : otherwise
    Loop,        ///< while (value) { body; steps } — value null means forever; an initialiser
                 ///< of `for` has become a statement before the loop
    Break,       ///< leaves `target`, a Loop or a light statement
    Continue,    ///< next round of `target` (a Loop runs its steps)
    Return,      ///< value, or null in void functions and shaders
    Illuminance, ///< `light`; the body runs once a light sample with L, Cl, Ol set
    Illuminate,  ///< `light`; light shaders: a local emitter; the body sets Cl
    Solar        ///< `light`; light shaders: a distant emitter; the body sets Cl
};

// Behind its cones illuminance has names and values: "light:NAME", v has become a call of
// lightsource("NAME", v) that begins the body; others are advice to a renderer, and gone.
//
// gather(category, p, axis, angle, samples, ...) has become a Loop of `samples` turns around an If
// whose condition is a call of the built-in function gather, which follows a ray.

/// One cone of the extended forms (ALGORITHMS 0 and 1). All are evaluated before the loop.
struct Cone {
    ExprPtr axis;       ///< vector
    ExprPtr angle;      ///< float: full opening angle in degrees
    ExprPtr exponent;   ///< float; 0 = uniform
    ExprPtr importance; ///< float, or a color whose luminance counts
};

enum class ConeForm {
    Everywhere, ///< No cone: illuminance(P), illuminate(P), solar().
    Classic,    ///< axis, angle: half angle in radians.
    Extended    ///< coneCount and cones: full angles in degrees, exponents, importances.
};

/// What stands in the parentheses of illuminance, illuminate and solar.
struct LightArguments {
    ConeForm form = ConeForm::Everywhere;
    ExprPtr category;  ///< string, uniform; illuminance only; null if not given
    ExprPtr position;  ///< point; null for solar
    ExprPtr axis;      ///< vector; Classic
    ExprPtr angle;     ///< float, radians; Classic
    ExprPtr coneCount; ///< float; Extended. At run time, may be fewer than cones.size()
    std::vector<Cone> cones;
};

struct Stmt {
    Stmt() = default;
    Stmt(Stmt &&) = default;
    Stmt &operator=(Stmt &&) = default;
    ~Stmt() { takeApart(*this, &Stmt::body, &Stmt::otherwise); }

    StmtKind kind = StmtKind::Block;
    Place where;
    std::vector<StmtPtr> body;
    std::vector<StmtPtr> otherwise; ///< If
    std::vector<ExprPtr> steps;     ///< Loop: of `for`, in order
    ExprPtr value;
    std::vector<ExprPtr> values;
    Symbol *symbol = nullptr;
    const Stmt *target = nullptr; ///< Break, Continue
    std::unique_ptr<LightArguments> light;
};

/// A user's function for one combination of detail (and array lengths) of its arguments: a
/// function whose formals state no detail is checked anew for each. There is no recursion, so the
/// lowering may inline all calls. Nested functions and extern refer to outer symbols directly;
/// such an instance belongs to one instance of the function around it.
struct Function {
    std::string name;
    Place where;
    Type result; ///< Void if it returns nothing.
    std::vector<Symbol *> formals;
    std::vector<StmtPtr> body; ///< A non-void function that ends without Return gives zero.
    /// It, or a function that it calls, has an illuminance, illuminate or solar statement. Such a
    /// function is never called inside another light statement.
    bool hasLightStatement = false;
};

struct Parameter {
    Symbol *symbol = nullptr;
    /// The default: one expression of the parameter's type (an array: one an element, fewer
    /// leave the rest zero; none: zero or ""). May call functions, name spaces, and read parameters
    /// that stand before it; evaluated by the lowering once an instance.
    std::vector<ExprPtr> defaults;
    std::string doc; ///< The comment on its line, or else on the line above it.
};

struct TypedShader {
    ShaderKind kind = ShaderKind::Surface;
    std::string name;
    Place where;
    std::string doc; ///< The comment that stands before the shader.
    std::vector<Parameter> parameters;
    std::vector<StmtPtr> body;

    std::vector<std::unique_ptr<Symbol>> symbols; ///< All symbols of the shader, owned.
    /// All instances that the shader's code calls, directly or not, and perhaps some that it does
    /// not call; callees come first.
    std::vector<std::unique_ptr<Function>> functions;
    std::shared_ptr<const SourceSet> sources; ///< Keeps the places alive.
};

/// The tree as indented text, one node a line, for tests and debugging.
std::string print(const TypedShader &);
std::string print(const Expr &);

} // namespace candela::sl
