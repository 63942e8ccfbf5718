// SPDX-License-Identifier: Apache-2.0
// A shader file as its author wrote it: names are unresolved, types unchecked. The type checker
// (language/semantics) reads it and makes the typed tree.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "language/syntax/base_type.h"
#include "language/syntax/source.h"
#include "language/syntax/take_apart.h"

namespace candela::sl::ast {

struct Expr;
struct Stmt;
using ExprPtr = std::unique_ptr<Expr>;
using StmtPtr = std::unique_ptr<Stmt>;

enum class ExprKind {
    Number,
    Text, ///< Adjacent strings are one already.
    Name,
    Tuple, ///< 3 or 16 operands
    Index, ///< operands[0] [ operands[1] ]
    Call,  ///< name(operands)
    Negate,
    Not,
    Binary,      ///< operands[0] op operands[1]
    Conditional, ///< operands[0] ? operands[1] : operands[2]
    Assign,      ///< operands[0] = operands[1], or op= if `compound`
    Cast         ///< type operands[0], or type "space" operands[0] with the space in operands[1]
};

struct Expr {
    Expr() = default;
    Expr(Expr &&) = default;
    Expr &operator=(Expr &&) = default;
    ~Expr() { takeApart(*this, &Expr::operands); }

    ExprKind kind = ExprKind::Number;
    Place where; ///< Of Binary, Conditional and Assign: the operator; else the first word.
    std::vector<ExprPtr> operands;
    double number = 0;
    std::string text; ///< Text: its value; Name and Call: the name.
    BinaryOp op = BinaryOp::Add;
    bool compound = false;
    BaseType type = BaseType::Void;
    int depth = 1; ///< Height of the tree below, limited by the parser.
};

/// One variable: of a declaration, a parameter of a shader, or a formal of a function.
struct Variable {
    BaseType type = BaseType::Float;
    std::optional<Detail> detail; ///< As stated, if stated.
    bool output = false;
    bool external = false;
    std::string name;
    Place where; ///< Of the name.
    bool isArray = false;
    ExprPtr length; ///< Of an array; may be missing for formals and where there are initialisers.
    bool initialised = false;
    bool braced = false; ///< { a, b, c }
    std::vector<ExprPtr> initial;
    std::string doc; ///< Parameters: the comment that belongs to it.
};

enum class StmtKind {
    Empty,
    Block,       ///< body
    Declare,     ///< variables
    Function,    ///< function: nested definition
    Evaluate,    ///< value
    If,          ///< value, body[0], body[1] if there is an else
    While,       ///< value, body[0]
    For,         ///< first, value (may be null), steps, body[0]
    Break,       ///< levels
    Continue,    ///< levels
    Return,      ///< value (may be null)
    Illuminance, ///< arguments, body[0]
    Illuminate,  ///< arguments, body[0]
    Solar,       ///< arguments, body[0]
    Gather       ///< arguments, body[0], body[1] if there is an else
};

struct Function {
    std::optional<BaseType> result; ///< Nothing: untyped, the return statements decide.
    std::string name;
    Place where;
    std::vector<Variable> formals;
    StmtPtr body;
};

struct Stmt {
    Stmt() = default;
    Stmt(Stmt &&) = default;
    Stmt &operator=(Stmt &&) = default;
    ~Stmt() { takeApart(*this, &Stmt::body); }

    StmtKind kind = StmtKind::Empty;
    Place where; ///< The first word.
    ExprPtr value;
    StmtPtr first;
    std::vector<ExprPtr> steps;
    std::vector<ExprPtr> arguments;
    std::vector<StmtPtr> body;
    std::vector<Variable> variables;
    std::unique_ptr<Function> function;
    int levels = 1;
};

struct Shader {
    ShaderKind kind = ShaderKind::Surface;
    std::string name;
    Place where; ///< Of the name.
    std::string doc;
    std::vector<Variable> parameters;
    StmtPtr body;
};

using Item = std::variant<Shader, Function>;

/// A file: its shaders and functions in their order.
struct File {
    std::vector<Item> items;
};

/// The expression with all its brackets, for tests: "(a + (b * c))".
std::string print(const Expr &);

} // namespace candela::sl::ast
