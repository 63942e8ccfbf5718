// SPDX-License-Identifier: Apache-2.0
// The lowering at work: what its parts (statements, expressions, built-ins, light, spaces) share.
//
// Variables are cells: every scalar component of a variable is a number in `cells`, whose entry is
// its present value. A branch lowers both sides from the same cells and yields those that differ;
// a loop carries those that its text assigns. Break, continue and return set cells of type bool,
// and what follows them in the text is put under the condition that none is set.
#pragma once

#include "language/ir/builder.h"
#include "language/ir/lower.h"
#include "language/ir/lower_scan.h"
#include "language/semantics/typed_ast.h"

#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace candela::ir {

/// The scalar components of a value; an array's elements one after another.
using Components = Values;

int componentCount(sl::BaseType);
Triple tripleOf(const Components &);
Matrix matrixOf(const Components &);
Components componentsOf(const Triple &);
Components componentsOf(const Matrix &);

/// Where a variable lives.
struct Storage {
    sl::BaseType base = sl::BaseType::Float;
    int length = 0;  ///< 0 = a single value.
    int cell = -1;   ///< Its first cell; -1 if it is memory.
    int memory = -1; ///< First of Function::arrays, one a component.
};

/// Something that can be assigned to, its indices evaluated.
struct Target {
    Storage storage;
    std::optional<ValueId> element, component; ///< Float indices.
};

/// A Loop or light statement that is being lowered.
struct OpenLoop {
    const sl::Stmt *statement = nullptr;
    int broken = 0, continued = 0; ///< Cells.
};

/// The shader or a function that is being inlined.
struct Frame {
    const sl::Function *function = nullptr;
    int returned = 0; ///< Cell.
    int result = 0;   ///< First cell of its value.
    std::vector<OpenLoop> loops;
};

class Lowering {
public:
    Lowering(const sl::TypedShader &shader, Function &function, DiagnosticSink &sink);

    // lower.cpp
    /// Gives each parameter its cells: values of the parameter block, planes of overriding
    /// variables, or strings.
    void declareParameters(LoweredShader &, const std::vector<StringValue> &strings,
                           const std::vector<std::string> &variables);
    /// Predefined variables get what the renderer gives, outputs their starting values.
    void declarePredefined();
    void lowerBody();
    void writeOutputs(const LoweredShader &);

    // lower_cells.cpp
    int newCells(const Components &values);
    Storage declare(const sl::Symbol &, const Components &initial);
    /// What no text has declared yet (a default may name a later parameter) is zero.
    const Storage &storageOf(const sl::Symbol &symbol);
    void bind(const sl::Symbol &symbol, const Storage &storage) { storage_[&symbol] = storage; }
    Components zero(sl::BaseType, int length = 0);
    Components load(const Storage &);
    Components load(const Target &, const sl::Place &);
    void store(const Target &, const Components &, const sl::Place &);
    Target resolve(const sl::Expr &);
    /// Component `index` (a float, clamped) of a value.
    ValueId component(const Components &, ValueId index);
    Components replaceComponent(Components, ValueId index, ValueId value);
    /// The cells of a variable that a loop carries.
    void appendCells(const sl::Symbol &, std::vector<int> &cells);

    // lower_control.cpp
    /// Lowers both sides and merges the cells. `clear` names flags that are known to be false if
    /// the condition holds.
    void branch(ValueId condition, const std::function<void()> &then,
                const std::function<void()> &otherwise, const std::vector<int> &clear = {});
    /// All flags that may keep the text from going on, and whether none is set.
    std::vector<int> liveFlags();
    ValueId isLive();
    /// Runs it where no break, continue or return has happened.
    void whereLive(const std::function<void()> &);
    void lowerLoop(const sl::Stmt &);

    // lower_statement.cpp
    void lower(const std::vector<sl::StmtPtr> &, size_t first = 0);
    void lower(const sl::Stmt &);
    void lowerIlluminance(const sl::Stmt &);
    void lowerIlluminate(const sl::Stmt &);
    void lowerSolar(const sl::Stmt &);

    // lower_expression.cpp
    Components evaluate(const sl::Expr &);
    ValueId evaluateFloat(const sl::Expr &expr) { return evaluate(expr)[0]; }
    ValueId condition(const sl::Expr &);
    Components call(const sl::Expr &);

    // lower_spaces.cpp
    Components fromSpace(sl::BaseType, const Components &, const std::string &space,
                         const sl::Place &);
    /// currentFromSpace and spaceFromCurrent; nothing for the identity.
    struct SpaceMatrices {
        Matrix toCurrent, fromCurrent;
    };
    std::optional<SpaceMatrices> space(const std::string &name, const sl::Place &);

    // lower_builtins.cpp
    Components builtin(const sl::Expr &);

    /// A string that has to be known when the shader is compiled; reports that it is not.
    std::string requiredText(ValueId, const sl::Place &, const std::string &what);

    void error(const sl::Place &, const std::string &message);
    bool failed() const { return failed_; }

    /// The cells of a predefined variable, as Components; declarePredefined() must have run.
    Components predefined(sl::PredefinedId id) { return load(predefined_.at(id)); }
    void setPredefined(sl::PredefinedId, const Components &);

    Builder b;
    const sl::TypedShader &shader;
    std::vector<ValueId> cells;
    std::vector<Frame> frames;
    LightClass lightClass = LightClass::Ambient;
    std::optional<Triple> lightDirection; ///< L of the light's first illuminate or solar.
    /// Default values are evaluated where "current" is unknown: "shader" is the identity then.
    bool onlyShaderSpace = false;

private:
    Function &function_;
    DiagnosticSink &sink_;
    bool failed_ = false;
    std::set<std::string> reported_;
    std::map<const sl::Symbol *, Storage> storage_;
    std::map<sl::PredefinedId, Storage> predefined_;
    std::set<const sl::Symbol *> inMemory_;
    std::vector<Components> targetValues_;
    int shaderSpaceSlot_ = -1;
};

/// A call of a built-in function, its arguments evaluated.
struct BuiltinCall {
    Lowering &lowering;
    Builder &b;
    const sl::Expr &expr;
    std::vector<Components> arguments;

    sl::BuiltinId id() const { return expr.overload->function->id; }
    sl::BaseType result() const { return expr.overload->result; }
    size_t count() const { return arguments.size(); }
    ValueId number(size_t i) const { return arguments[i][0]; }
    Triple triple(size_t i) const { return tripleOf(arguments[i]); }
    bool isText(size_t i) const { return expr.operands[i]->type.base == sl::BaseType::String; }
    std::string text(size_t i, const char *what) const;
    /// Assigns to an output argument.
    void assign(size_t i, const Components &) const;
};

using BuiltinLowering = Components (*)(BuiltinCall &);

// Each gives the lowering of the functions that are its subject, null for others.
BuiltinLowering mathsBuiltin(sl::BuiltinId);
BuiltinLowering geometryBuiltin(sl::BuiltinId);
BuiltinLowering spaceBuiltin(sl::BuiltinId);
BuiltinLowering colorBuiltin(sl::BuiltinId);
BuiltinLowering matrixBuiltin(sl::BuiltinId);
BuiltinLowering noiseBuiltin(sl::BuiltinId);
BuiltinLowering splineBuiltin(sl::BuiltinId);
BuiltinLowering lightBuiltin(sl::BuiltinId);
BuiltinLowering derivativeBuiltin(sl::BuiltinId);
BuiltinLowering textBuiltin(sl::BuiltinId);

// Matrices in IR arithmetic (lower_matrix.cpp).
Matrix identityMatrix(Builder &);
Matrix multiply(Builder &, const Matrix &, const Matrix &);
ValueId determinant(Builder &, const Matrix &);
/// Not finite if the matrix is singular.
Matrix inverse(Builder &, const Matrix &);

/// Colour from the named colour space to another (lower_color.cpp); reports unknown names.
Components convertColor(Lowering &, const Components &, const std::string &from,
                        const std::string &to, const sl::Place &);

// Derivatives (lower_derivatives.cpp): placeholders in place of values by u and v, replaced once
// the whole text stands.
inline constexpr int derivativeByU = -1, derivativeByV = -2;
Components derivative(Builder &, const Components &, int direction);
void expandDerivatives(Function &);

/// Drops what no effect needs, and the parameter slots, planes and spaces that nothing reads
/// (lower_cleanup.cpp).
void removeUnused(Function &, std::vector<ShaderParameter> &);

/// The power of |L| that output Cl is proportional to if only the distance changes, the direction
/// of L kept (lower_falloff.cpp); nothing if that cannot be proved.
std::optional<float> powerOfDistance(const Function &, const Triple &L);

} // namespace candela::ir
