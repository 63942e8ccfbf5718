// SPDX-License-Identifier: Apache-2.0
// Writes IR functions: typed helpers that infer types and rates, pool constants, fold what can be
// folded without changing a bit of any result, and reuse values that stand already.
//
//     Builder b(function);
//     auto [lit] = b.lightLoop(request, operands, {b.number(0)}, [&](auto L, auto Cl, auto carried)
//     {
//         return Builder::Values{b.add(carried[0], b.mul(Cl[0], b.dot(N, L)))};
//     });
//     b.output("Ci", 0, lit);
//     b.finish();
#pragma once

#include "language/ir/ir.h"

#include <array>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

namespace candela::ir {

/// A point, vector, normal or color, component by component.
using Triple = std::array<ValueId, 3>;
/// Row-major as the RI has it: a row vector times the matrix; element [4 * row + column].
using Matrix = std::array<ValueId, 16>;

class Builder {
public:
    using Values = std::vector<ValueId>;

    /// Appends to the function's body. finish() must be called before the function is used.
    explicit Builder(Function &);
    Builder(const Builder &) = delete;
    Builder &operator=(const Builder &) = delete;

    /// Puts the constants at the body's head and infers all rates once more (a loop may have made
    /// its carried values varying after they were used). Nothing may be added after it.
    void finish();

    Function &function() { return function_; }
    Type type(ValueId v) const { return function_.values[v].type; }
    /// What is known so far; a loop's carried values may turn out varying later.
    Rate rate(ValueId v) const { return function_.values[v].rate; }

    /// The source line that following instructions belong to.
    void setLine(int line) { line_ = line; }
    int line() const { return line_; }
    /// The source file of array accesses, for messages at run time.
    void setFile(int file) { file_ = file; }
    int file(const std::string &name) { return intern(function_.files, name); }

    // Constants and sources.
    ValueId number(float);
    ValueId boolean(bool);
    ValueId integer(int);
    ValueId text(const std::string &);
    Triple triple(float x, float y, float z);
    ValueId input(ShaderInput, int component = 0);
    Triple input3(ShaderInput);
    ValueId parameter(int slot);
    ValueId variable(int plane);
    Matrix space(const std::string &name);        ///< currentFromSpace.
    Matrix spaceInverse(const std::string &name); ///< spaceFromCurrent.
    Matrix object();                              ///< currentFromObject.
    Matrix objectInverse();
    /// Constant values, if they are: for callers that decide at compile time.
    const float *constantFloat(ValueId) const;
    std::optional<bool> constantBool(ValueId) const;
    const std::string *constantText(ValueId) const;

    // Floats.
    ValueId add(ValueId a, ValueId b) { return emit1(Op::Add, {a, b}); }
    ValueId sub(ValueId a, ValueId b) { return emit1(Op::Sub, {a, b}); }
    ValueId mul(ValueId a, ValueId b) { return emit1(Op::Mul, {a, b}); }
    ValueId div(ValueId a, ValueId b) { return emit1(Op::Div, {a, b}); }
    ValueId neg(ValueId a) { return emit1(Op::Neg, {a}); }
    ValueId min(ValueId a, ValueId b) { return emit1(Op::Min, {a, b}); }
    ValueId max(ValueId a, ValueId b) { return emit1(Op::Max, {a, b}); }
    ValueId sqrt(ValueId a) { return emit1(Op::Sqrt, {a}); }
    ValueId pow(ValueId a, ValueId b) { return emit1(Op::Pow, {a, b}); }
    /// Any operation of one operand: unary(Op::Sin, x).
    ValueId unary(Op op, ValueId a) { return emit1(op, {a}); }
    ValueId binary(Op op, ValueId a, ValueId b) { return emit1(op, {a, b}); }

    // Truth and choice.
    ValueId less(ValueId a, ValueId b) { return emit1(Op::Less, {a, b}); }
    ValueId lessEqual(ValueId a, ValueId b) { return emit1(Op::LessEqual, {a, b}); }
    ValueId equal(ValueId a, ValueId b) { return emit1(Op::Equal, {a, b}); }
    ValueId notEqual(ValueId a, ValueId b) { return emit1(Op::NotEqual, {a, b}); }
    ValueId both(ValueId a, ValueId b) { return emit1(Op::And, {a, b}); }
    ValueId either(ValueId a, ValueId b) { return emit1(Op::Or, {a, b}); }
    ValueId negate(ValueId a) { return emit1(Op::Not, {a}); }
    ValueId select(ValueId condition, ValueId a, ValueId b) {
        return emit1(Op::Select, {condition, a, b});
    }
    Triple select(ValueId condition, const Triple &, const Triple &);

    // Triples.
    Triple add(const Triple &, const Triple &);
    Triple sub(const Triple &, const Triple &);
    Triple mul(const Triple &, const Triple &);
    Triple div(const Triple &, const Triple &);
    Triple scale(const Triple &, ValueId);
    Triple neg(const Triple &);
    ValueId dot(const Triple &, const Triple &); ///< (x x' + y y') + z z'
    Triple cross(const Triple &, const Triple &);
    ValueId length(const Triple &);
    /// Of unit length; a zero vector stays zero.
    Triple normalize(const Triple &);
    /// I - 2 (I.N) N, with N as it is.
    Triple reflect(const Triple &I, const Triple &N);
    /// N, or -N where I.reference > 0.
    Triple faceforward(const Triple &N, const Triple &I, const Triple &reference);
    Triple transformPoint(const Matrix &, const Triple &); ///< Divides by w.
    Triple transformVector(const Matrix &, const Triple &);
    /// By the transpose of the inverse: pass the inverse of the matrix that takes points.
    Triple transformNormal(const Matrix &inverse, const Triple &);

    // Memory, runtime functions.
    int addArray(Type, int size);
    ValueId arrayLoad(int array, ValueId index) { return emit1(Op::ArrayLoad, {index}, array); }
    void arrayStore(int array, ValueId index, ValueId value);
    Values call(int runtimeFunction, const Values &inputs);
    /// A new random number at each call site.
    ValueId random();

    // Control. Callbacks build the regions and return what they yield; a call gives the results.
    // A constant condition builds only its branch.
    Values ifElse(ValueId condition, const std::function<Values()> &then,
                  const std::function<Values()> &otherwise);
    void ifThen(ValueId condition, const std::function<void()> &then);
    /// While carried[0] (a bool) holds. The callback gets the carried values, returns the next.
    Values loop(const Values &initial, const std::function<Values(const Values &)> &body);
    /// A light loop over a request from addRequest(). `position` and `cones` as LightRequest says.
    Values
    lightLoop(int request, const Triple &position, const Values &cones, const Values &initial,
              const std::function<Values(const Triple &L, const Values &Cl, const Values &carried)>
                  &body);
    int addRequest(const LightRequest &);
    /// -1 for no category; pools equal ones.
    int category(const std::string &);
    Values trace(int request, const Triple &position, const Triple &direction);
    Values ambient();
    Values irradiance(const Triple &position, const Triple &omega);

    // Effects.
    void output(const std::string &slot, int component, ValueId);
    void printValues(const std::string &format, const Values &);

    /// The general way in: any operation but those with regions. Folds, reuses, infers.
    Values emit(Op, const Values &operands, int immediate = 0, float number = 0);
    /// Adds an instruction as it is (its regions built elsewhere); gives nothing new.
    void append(Instruction);
    /// Builds a region apart, to be given to append(). Values made in it are visible only there.
    Region region(const Values &arguments, const std::function<Values()> &body);
    ValueId newValue(Type t, Rate r) { return function_.addValue(t, r); }

private:
    using Key = std::tuple<Op, Values, int, std::uint32_t>;
    struct Scope {
        Region *region;
        std::map<Key, Values> known;
    };
    ValueId emit1(Op op, const Values &operands, int immediate = 0, float number = 0) {
        return emit(op, operands, immediate, number)[0];
    }
    ValueId constant(Op, Type, int immediate, float number);
    const Values *find(const Key &) const;
    const Instruction *constantOf(ValueId) const;
    Values makeResults(Op, const Values &operands, int immediate);
    int intern(std::vector<std::string> &, const std::string &);
    Matrix matrixOf(Op, int immediate);

    Function &function_;
    std::vector<Scope> scopes_;
    std::vector<Instruction> constants_;
    std::map<Key, Values> constantKeys_;
    std::vector<int> constantIndex_; ///< By value: index into constants_, -1 = not constant.
    int line_ = 0, file_ = 0;
    int randoms_ = 0;
};

} // namespace candela::ir
