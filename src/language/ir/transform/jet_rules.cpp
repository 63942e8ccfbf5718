// SPDX-License-Identifier: Apache-2.0
#include "language/ir/transform/jet_rules.h"

#include "language/ir/core/builder_arithmetic.h"
#include "language/ir/core/builder_sources.h"
#include "language/ir/core/op_info.h"
#include "language/ir/transform/jet_lattice.h"
#include "language/ir/transform/jet_series.h"
#include "language/ir/transform/jet_sources.h"
#include "language/ir/transform/jet_twins.h"
#include "language/runtime/runtime_functions.h"

#include <algorithm>

namespace candela::ir {

namespace {

using runtime::RuntimeFunction;

/// A plain operation of which derivatives are wanted; its result stands.
struct Operation {
    Jets &jets;
    std::vector<Jet> operands;
    Jet result;

    Jet x() const { return operands[0]; }
    Jet y() const { return operands[1]; }
    /// Another elementary function of x.
    Jet ofX(Op op) const {
        Builder &b = jets.b;
        return jets.standing(unary(b, op, valueOf(x())));
    }
};

/// The coefficients of the result.
using Rule = Jet (*)(const Operation &);

Jet ofSum(const Operation &o) { return sum(o.jets, o.x(), o.y()); }
Jet ofDifference(const Operation &o) { return difference(o.jets, o.x(), o.y()); }
Jet ofProduct(const Operation &o) { return product(o.jets, o.x(), o.y()); }
Jet ofQuotient(const Operation &o) {
    setQuotient(o.jets, o.result, o.x(), o.y());
    return o.result;
}
Jet ofNegative(const Operation &o) { return negative(o.jets, o.x()); }

Jet ofAbsolute(const Operation &o) {
    Builder &b = o.jets.b;
    return choice(o.jets, less(b, valueOf(o.x()), number(b, 0)), negative(o.jets, o.x()), o.x());
}
Jet ofMinimum(const Operation &o) {
    return choice(o.jets, less(o.jets.b, valueOf(o.x()), valueOf(o.y())), o.x(), o.y());
}
Jet ofMaximum(const Operation &o) {
    return choice(o.jets, less(o.jets.b, valueOf(o.y()), valueOf(o.x())), o.x(), o.y());
}
Jet ofSelect(const Operation &o) {
    return choice(o.jets, valueOf(o.operands[0]), o.operands[1], o.operands[2]);
}

Jet ofSecond(const Operation &o) {
    o.result->rule = [y = o.y()](Order order) { return coefficient(y, order); };
    return o.result;
}

Jet twice(Jets &jets, Jet x) { return product(jets, constant(jets, 2), x); }

/// At and below 0 the slope of a root is taken as 0.
Jet ofSquareRoot(const Operation &o) {
    Builder &b = o.jets.b;
    setIntegralOver(o.jets, o.result, o.x(), twice(o.jets, o.result));
    return where(o.jets, less(b, number(b, 0), valueOf(o.x())), o.result);
}

/// Sine and cosine of x, both of which stand, change by each other.
void turn(Jets &jets, Jet x, Jet sine, Jet cosine) {
    sine->rule = integral(jets, x, cosine)->rule;
    cosine->rule = negative(jets, integral(jets, x, sine))->rule;
}
Jet ofSine(const Operation &o) {
    turn(o.jets, o.x(), o.result, o.ofX(Op::Cos));
    return o.result;
}
Jet ofCosine(const Operation &o) {
    turn(o.jets, o.x(), o.ofX(Op::Sin), o.result);
    return o.result;
}

Jet onePlusSquare(Jets &jets, Jet x) { return sum(jets, constant(jets, 1), product(jets, x, x)); }

/// The derivative of the result is that of x times g.
Jet asIntegral(const Operation &o, Jet g) {
    o.result->rule = integral(o.jets, o.x(), g)->rule;
    return o.result;
}
/// The derivative of the result times h is that of x.
Jet asIntegralOver(const Operation &o, Jet x, Jet h) {
    setIntegralOver(o.jets, o.result, x, h);
    return o.result;
}

Jet ofTangent(const Operation &o) { return asIntegral(o, onePlusSquare(o.jets, o.result)); }

/// sqrt(1 - x^2), kept from 0 so that the ends of asin and acos give something finite.
Jet complement(Jets &jets, Jet x) {
    Builder &b = jets.b;
    Jet squared = difference(jets, constant(jets, 1), product(jets, x, x));
    Jet root = jets.standing(max(b, sqrt(b, valueOf(squared)), number(b, 1e-6f)));
    setIntegralOver(jets, root, squared, twice(jets, root));
    return root;
}
Jet ofArcSine(const Operation &o) { return asIntegralOver(o, o.x(), complement(o.jets, o.x())); }
Jet ofArcCosine(const Operation &o) {
    return asIntegralOver(o, negative(o.jets, o.x()), complement(o.jets, o.x()));
}
Jet ofArcTangent(const Operation &o) {
    return asIntegralOver(o, o.x(), onePlusSquare(o.jets, o.x()));
}
/// The angle of (y, x): atan(x, y).
Jet ofAngle(const Operation &o) {
    Jets &jets = o.jets;
    Jet swept = difference(jets, integral(jets, o.x(), o.y()), integral(jets, o.y(), o.x()));
    Jet squared = sum(jets, product(jets, o.x(), o.x()), product(jets, o.y(), o.y()));
    return asIntegralOver(o, swept, squared);
}

Jet ofExponential(const Operation &o) { return asIntegral(o, o.result); }
Jet ofLogarithm(const Operation &o) { return asIntegralOver(o, o.x(), o.x()); }

/// x^y: by x it changes like y x^(y-1), by y like x^y log x (of x above 0).
void setPower(Jets &jets, Jet result, Jet x, Jet y) {
    Builder &b = jets.b;
    const auto byBase = [&jets, x, y] {
        Jet less1 = difference(jets, y, constant(jets, 1));
        Jet lower = jets.standing(pow(jets.b, valueOf(x), valueOf(less1)));
        lower->rule = [&jets, lower, x, less1](Order order) { // Only if it is asked for.
            Jet whole = jets.standing(valueOf(lower));
            setPower(jets, whole, x, less1);
            return coefficient(whole, order);
        };
        return integral(jets, x, product(jets, y, lower));
    };
    const auto byExponent = [&jets, &b, result, x, y] {
        Jet logarithm = jets.standing(unary(b, Op::Log, valueOf(x)));
        setIntegralOver(jets, logarithm, x, x);
        return where(jets, less(b, number(b, 0), valueOf(x)),
                     integral(jets, y, product(jets, result, logarithm)));
    };
    const auto changes = [](Jet jet) { return jet->rule || jet->known.size() > 1; };
    Jet base = changes(x) ? byBase() : jets.series({});
    Jet exponent = changes(y) ? byExponent() : jets.series({});
    result->rule = sum(jets, base, exponent)->rule;
}
Jet ofPower(const Operation &o) {
    setPower(o.jets, o.result, o.x(), o.y());
    return o.result;
}

/// Of what has the rule Chain.
Rule chainRuleOf(Op op) {
    switch (op) {
    case Op::Sqrt: return ofSquareRoot;
    case Op::Sin: return ofSine;
    case Op::Cos: return ofCosine;
    case Op::Tan: return ofTangent;
    case Op::Asin: return ofArcSine;
    case Op::Acos: return ofArcCosine;
    case Op::Atan: return ofArcTangent;
    case Op::Exp: return ofExponential;
    case Op::Log: return ofLogarithm;
    default: return nullptr;
    }
}

/// Of floats with one result that follow from their operands alone.
Rule ruleOf(Op op) {
    switch (info(op).slope) {
    case SlopeRule::Sum: return ofSum;
    case SlopeRule::Difference: return ofDifference;
    case SlopeRule::Product: return ofProduct;
    case SlopeRule::Quotient: return ofQuotient;
    case SlopeRule::Negation: return ofNegative;
    case SlopeRule::Magnitude: return ofAbsolute;
    case SlopeRule::Least: return ofMinimum;
    case SlopeRule::Greatest: return ofMaximum;
    case SlopeRule::Choice: return ofSelect;
    case SlopeRule::Second: return ofSecond;
    case SlopeRule::Angle: return ofAngle;
    case SlopeRule::Power: return ofPower;
    case SlopeRule::Chain: return chainRuleOf(op);
    default: return nullptr;
    }
}

} // namespace

namespace {

SlopeKind kindOfSource(const Function &function, const Instruction &i) {
    if (i.op == Op::Variable)
        return function.variables[size_t(i.immediate)].slope ? SlopeKind::Held : SlopeKind::Rule;
    if (i.op != Op::Input) // Parameters are the same all over a surface.
        return SlopeKind::Zero;
    switch (inputSlope(i.immediate).kind) {
    case InputSlope::Still: return SlopeKind::Zero;
    case InputSlope::Unknown: return SlopeKind::Held;
    default: return SlopeKind::Rule;
    }
}

SlopeKind kindOfService(ServiceSlope slope) {
    switch (slope) {
    case ServiceSlope::Held: return SlopeKind::Held;
    case ServiceSlope::Twin: return SlopeKind::Rule;
    default: return SlopeKind::Zero;
    }
}

} // namespace

SlopeKind slopeKind(const Function &function, const Instruction &i) {
    switch (info(i.op).slope) {
    case SlopeRule::None:
    case SlopeRule::Step: return SlopeKind::Zero;
    case SlopeRule::Source: return kindOfSource(function, i);
    case SlopeRule::Held: return SlopeKind::Held;
    case SlopeRule::Refused: return SlopeKind::Refused;
    case SlopeRule::Service: return kindOfService(serviceOf(function, i).info->slope);
    case SlopeRule::Call:
        return runtime::coordinatesOf(RuntimeFunction(i.immediate)) > 0 ? SlopeKind::Rule
                                                                        : SlopeKind::Zero;
    default: return SlopeKind::Rule;
    }
}

namespace {

/// What an input holds, for people.
std::string inputName(int plane) {
    constexpr struct {
        const char *name;
        int components;
    } inputs[] = {
#define SHADER_INPUT(name, components, time, meaning) {#name, components},
#include "language/runtime/shader_inputs.def"
#undef SHADER_INPUT
    };
    for (const auto &input : inputs) {
        if (plane < input.components)
            return input.name;
        plane -= input.components;
    }
    return "input";
}

} // namespace

std::string slopeNote(const Function &function, const Instruction &i) {
    const auto stays = [](const std::string &what) {
        return what + " is taken not to change with u and v";
    };
    switch (i.op) {
    case Op::Input:
        return stays(inputSlope(i.immediate).kind == InputSlope::Plane
                         ? "the derivative of " + inputName(i.immediate)
                         : inputName(i.immediate));
    case Op::Variable:
        return stays("the derivative of " + function.variables[size_t(i.immediate)].name);
    case Op::FrameLoad: return "derivatives of values from a frame are not known";
    case Op::Call: return "there are no derivatives of noise beyond the second";
    case Op::Query: {
        const std::string service = std::string(serviceOf(function, i).info->name) + "()";
        return stays(slopeKind(function, i) == SlopeKind::Rule ? "the derivative of " + service
                                                               : "what " + service + " gives");
    }
    default: return stays("light");
    }
}

SlopeNote noteAt(const Instruction &i, const std::string &text) {
    return {i.line, i.op == Op::Slope ? i.file : -1, text};
}

int firstHeldOrder(const Instruction &i) {
    const bool hasFirst = i.op == Op::Variable || i.op == Op::Query ||
                          (i.op == Op::Input && inputSlope(i.immediate).kind == InputSlope::Plane);
    return hasFirst ? 2 : highestOrder + 1;
}

int firstRefusedOrder(const Instruction &i, size_t result) {
    return i.op == Op::Call ? firstRefusedOrder(RuntimeFunction(i.immediate), int(result))
                            : highestOrder + 1;
}

bool changesWith(const Function &function, const Instruction &i, Direction d) {
    const SlopeRule rule = info(i.op).slope;
    if (rule != SlopeRule::Source && rule != SlopeRule::Service)
        return rule == SlopeRule::Held || rule == SlopeRule::Refused;
    if (rule == SlopeRule::Service) // With a twin it changes as its operands do.
        return slopeKind(function, i) == SlopeKind::Held;
    if (i.op == Op::Input)
        if (const InputSlope slope = inputSlope(i.immediate); slope.kind == InputSlope::Parameter)
            return slope.by(d) != 0;
    return slopeKind(function, i) != SlopeKind::Zero;
}

std::vector<ValueId> differentiableOperands(const Function &function, const Instruction &i) {
    switch (info(i.op).slope) {
    case SlopeRule::Service:
        return slopeKind(function, i) == SlopeKind::Rule
                   ? std::vector<ValueId>{i.operands.begin(), i.operands.begin() + twinCoordinates}
                   : std::vector<ValueId>{};
    case SlopeRule::Choice: return {i.operands[1], i.operands[2]};
    case SlopeRule::Second: return {i.operands[1]};
    case SlopeRule::Raised: return i.operands;
    case SlopeRule::Call:
        return {i.operands.begin(),
                i.operands.begin() + runtime::coordinatesOf(RuntimeFunction(i.immediate))};
    default: return ruleOf(i.op) ? i.operands : std::vector<ValueId>{};
    }
}

namespace {

std::vector<int> listOf(const Parts &parts) {
    std::vector<int> result;
    for (int part = 1; part < partCount; ++part)
        if (parts[size_t(part)])
            result.push_back(part);
    return result;
}

/// The plane of the derivative of a variable, which the function gets if it has it not.
int slopePlane(Function &function, int plane, Direction d) {
    auto &variables = function.variables;
    ParameterSlot wanted = variables[size_t(plane)];
    wanted.slope = d;
    const auto found = std::ranges::find_if(variables, [&](const ParameterSlot &slot) {
        return slot.name == wanted.name && slot.component == wanted.component &&
               slot.slope == wanted.slope;
    });
    const int index = int(found - variables.begin());
    if (found == variables.end())
        variables.push_back(wanted);
    return index;
}

/// Inputs and variables.
Jet ofSource(Jets &jets, const Instruction &i) {
    return jets.series([&jets, &i](Order order) -> MaybeValue {
        if (order.total() > 1)
            return std::nullopt;
        const Direction d = order.u ? Direction::U : Direction::V;
        if (i.op == Op::Variable)
            return jets.b.function().variables[size_t(i.immediate)].slope
                       ? std::nullopt
                       : MaybeValue(
                             variable(jets.b, slopePlane(jets.b.function(), i.immediate, d)));
        const InputSlope slope = inputSlope(i.immediate);
        if (slope.kind == InputSlope::Plane)
            return input(jets.b, ShaderInput(slope.by(d)));
        if (slope.kind == InputSlope::Parameter && slope.by(d) != 0)
            return number(jets.b, float(slope.by(d)));
        return std::nullopt;
    });
}

} // namespace

JetRules::JetRules(std::vector<Parts> ofValue, std::vector<Parts> ofArray, int mostValues)
    : ofValue_(std::move(ofValue)), ofArray_(std::move(ofArray)), mostValues_(mostValues) {}

std::vector<int> JetRules::wanted(ValueId v) const { return listOf(ofValue_[v]); }
std::vector<int> JetRules::wantedOfArray(int array) const {
    return listOf(ofArray_[size_t(array)]);
}

void JetRules::write(Builder &b, const Instruction &i, WrittenValues &written) {
    if (i.op == Op::Slope)
        writeSlope(b, i, written);
    else
        writePlain(b, i, written);
    if (!fault_ && int(b.function().values.size()) > mostValues_)
        fault_ = noteAt(i, "with its derivatives the shader is too large to compile");
}

/// The coefficients of the operand, an order higher.
void JetRules::writeSlope(Builder &b, const Instruction &i, WrittenValues &written) {
    const auto direction = Direction(i.immediate);
    const Companions &known = written.beside[i.operands[0]];
    const ValueId result = i.results[0];
    const auto raised = [&](Order order) -> MaybeValue {
        const Order above = order.raised(direction);
        const auto found = known.find(partOf(above));
        if (found == known.end())
            return std::nullopt;
        const int factor = above.along(direction);
        return factor == 1 ? found->second : mul(b, number(b, float(factor)), found->second);
    };
    written.value[result] = raised({}).value_or(number(b, 0));
    for (int part : wanted(result))
        if (const MaybeValue coefficient = raised(orderOf(part)))
            written.beside[result][part] = *coefficient;
}

void JetRules::writePlain(Builder &b, const Instruction &i, WrittenValues &written) {
    const bool differentiates =
        !fault_ && slopeKind(b.function(), i) == SlopeKind::Rule &&
        std::ranges::any_of(i.results, [&](ValueId v) { return ofValue_[v].any(); });
    const Values operands = written.valuesOf(i.operands);
    const bool isLattice = differentiates && i.op == Op::Call;
    const bool isService = differentiates && i.op == Op::Query;
    const int immediate =
        isLattice ? int(latticeWithSlopes(RuntimeFunction(i.immediate))) : i.immediate;
    const Values results = isService ? askTwin(b, serviceOf(b.function(), i), operands)
                                     : b.emit(i.op, operands, immediate, i.number);
    for (size_t k = 0; k < i.results.size(); ++k)
        written.value[i.results[k]] = results[k];
    if (!differentiates)
        return;

    Jets jets(b);
    std::vector<Jet> given;
    for (size_t k = 0; k < operands.size(); ++k)
        given.push_back(jets.given(operands[k], written.beside[i.operands[k]]));
    std::vector<Jet> series;
    if (isLattice)
        series = ofLattice(jets, RuntimeFunction(immediate), given, results);
    else if (isService)
        series = ofTwin(jets, given, results);
    else if (i.op == Op::Input || i.op == Op::Variable)
        series = {ofSource(jets, i)};
    else
        series = {ruleOf(i.op)({jets, given, jets.standing(results[0])})};
    for (size_t k = 0; k < i.results.size(); ++k)
        for (int part : wanted(i.results[k]))
            if (const MaybeValue value = coefficient(series[k], orderOf(part)))
                written.beside[i.results[k]][part] = *value;
}

} // namespace candela::ir
