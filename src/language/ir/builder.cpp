// SPDX-License-Identifier: Apache-2.0
#include "language/ir/builder.h"

#include "foundation/units/color.h"
#include "language/ir/builder_fold.h"
#include "language/ir/op_info.h"
#include "language/ir/rates.h"
#include "language/runtime/runtime_functions.h"

#include <bit>
#include <iterator>

namespace candela::ir {

Builder::Builder(Function &function) : function_(function) {
    scopes_.push_back({&function.body, {}});
}

void Builder::finish() {
    auto &body = function_.body.body;
    body.insert(body.begin(), std::make_move_iterator(constants_.begin()),
                std::make_move_iterator(constants_.end()));
    inferRates(function_);
    markInputsRead(function_);
}

ValueId Builder::constant(Op op, Type type, int immediate, float number) {
    Key key{op, {}, immediate, std::bit_cast<std::uint32_t>(number)};
    auto [it, isNew] = constantKeys_.try_emplace(key);
    if (isNew) {
        ValueId v = newValue(type, Rate::Uniform);
        it->second = {v};
        constantIndex_.resize(v + 1, -1);
        constantIndex_[v] = int(constants_.size());
        constants_.push_back({op, {}, {v}, {}, immediate, number, 0});
    }
    return it->second[0];
}

ValueId Builder::number(float x) { return constant(Op::ConstFloat, Type::Float, 0, x); }
ValueId Builder::boolean(bool b) { return constant(Op::ConstBool, Type::Bool, b, 0); }
ValueId Builder::integer(int i) { return constant(Op::ConstInteger, Type::Integer, i, 0); }
ValueId Builder::text(const std::string &s) {
    return constant(Op::ConstString, Type::String, intern(function_.strings, s), 0);
}

const Instruction *Builder::constantOf(ValueId v) const {
    int index = v < constantIndex_.size() ? constantIndex_[v] : -1;
    return index < 0 ? nullptr : &constants_[index];
}

const float *Builder::constantFloat(ValueId v) const {
    const Instruction *c = constantOf(v);
    return c && c->op == Op::ConstFloat ? &c->number : nullptr;
}

std::optional<bool> Builder::constantBool(ValueId v) const {
    const Instruction *c = constantOf(v);
    return c && c->op == Op::ConstBool ? std::optional(c->immediate != 0) : std::nullopt;
}

const std::string *Builder::constantText(ValueId v) const {
    const Instruction *c = constantOf(v);
    return c && c->op == Op::ConstString ? &function_.strings[c->immediate] : nullptr;
}

int Builder::intern(std::vector<std::string> &pool, const std::string &s) {
    for (std::size_t i = 0; i < pool.size(); ++i)
        if (pool[i] == s)
            return int(i);
    pool.push_back(s);
    return int(pool.size()) - 1;
}

const Builder::Values *Builder::find(const Key &key) const {
    for (auto scope = scopes_.rbegin(); scope != scopes_.rend(); ++scope)
        if (auto it = scope->known.find(key); it != scope->known.end())
            return &it->second;
    return nullptr;
}

Builder::Values Builder::emit(Op op, const Values &operands, int immediate, float number) {
    switch (op) {
    case Op::ConstFloat: return {this->number(number)};
    case Op::ConstBool: return {boolean(immediate != 0)};
    case Op::ConstInteger: return {integer(immediate)};
    case Op::ConstString: return {text(function_.strings[immediate])};
    default: break;
    }
    if (auto folded = foldOperation(*this, op, operands))
        return {*folded};
    Key key{op, operands, immediate, std::bit_cast<std::uint32_t>(number)};
    if (isPure(op))
        if (const Values *known = find(key))
            return *known;
    Values results = makeResults(op, operands, immediate);
    append({op, operands, results, {}, immediate, number, line_, file_});
    if (isPure(op))
        scopes_.back().known[key] = results;
    return results;
}

Builder::Values Builder::makeResults(Op op, const Values &operands, int immediate) {
    const OpInfo &table = info(op);
    Rate rate = table.varying ? Rate::Varying : Rate::Uniform;
    for (ValueId v : operands)
        if (this->rate(v) == Rate::Varying)
            rate = Rate::Varying;
    Values results;
    if (op == Op::Call) {
        int count = runtime::info(runtime::RuntimeFunction(immediate)).outputs;
        for (int k = 0; k < count; ++k)
            results.push_back(newValue(Type::Float, rate));
    } else if (op == Op::Answer || op == Op::Ambient || op == Op::Irradiance) {
        for (int k = 0; k < colorSamples; ++k)
            results.push_back(newValue(Type::Float, rate));
    } else {
        for (char letter : table.results) {
            Type same = op == Op::ArrayLoad ? function_.arrays[immediate].type
                        : operands.empty()  ? Type::Float
                                            : type(operands.back());
            results.push_back(newValue(letter == 'f'   ? Type::Float
                                       : letter == 'b' ? Type::Bool
                                       : letter == 'i' ? Type::Integer
                                       : letter == 's' ? Type::String
                                                       : same,
                                       rate));
        }
    }
    return results;
}

void Builder::append(Instruction instruction) {
    scopes_.back().region->body.push_back(std::move(instruction));
}

Region Builder::region(const Values &arguments, const std::function<Values()> &body) {
    Region result;
    result.arguments = arguments;
    scopes_.push_back({&result, {}});
    result.yields = body();
    scopes_.pop_back();
    return result;
}

ValueId Builder::input(ShaderInput plane, int component) {
    return emit1(Op::Input, {}, int(plane) + component);
}
Triple Builder::input3(ShaderInput plane) {
    return {input(plane, 0), input(plane, 1), input(plane, 2)};
}
ValueId Builder::parameter(int slot) { return emit1(Op::Parameter, {}, slot); }
ValueId Builder::variable(int plane) { return emit1(Op::Variable, {}, plane); }

Matrix Builder::matrixOf(Op op, int immediate) {
    Values v = emit(op, {}, immediate);
    Matrix m;
    std::copy(v.begin(), v.end(), m.begin());
    return m;
}
Matrix Builder::space(const std::string &name) {
    return matrixOf(Op::Space, intern(function_.spaces, name));
}
Matrix Builder::spaceInverse(const std::string &name) {
    return matrixOf(Op::SpaceInverse, intern(function_.spaces, name));
}
Matrix Builder::object() { return matrixOf(Op::Object, 0); }
Matrix Builder::objectInverse() { return matrixOf(Op::ObjectInverse, 0); }

int Builder::addArray(Type type, int size) {
    function_.arrays.push_back({type, Rate::Uniform, size});
    return int(function_.arrays.size()) - 1;
}
void Builder::arrayStore(int array, ValueId index, ValueId value) {
    emit(Op::ArrayStore, {index, value}, array);
}
Builder::Values Builder::call(int runtimeFunction, const Values &inputs) {
    return emit(Op::Call, inputs, runtimeFunction);
}
ValueId Builder::random() { return emit1(Op::Random, {}, randoms_++); }

int Builder::addRequest(const LightRequest &request) {
    function_.requests.push_back(request);
    return int(function_.requests.size()) - 1;
}
int Builder::category(const std::string &name) {
    return name.empty() ? -1 : intern(function_.categories, name);
}

void Builder::output(const std::string &slot, int component, ValueId value) {
    auto &slots = function_.outputs;
    std::size_t index = 0;
    while (index < slots.size() &&
           (slots[index].name != slot || slots[index].component != component))
        ++index;
    if (index == slots.size())
        slots.push_back({slot, component});
    emit(Op::Output, {value}, int(index));
}

void Builder::printValues(const std::string &format, const Values &values) {
    Values operands{text(format)};
    operands.insert(operands.end(), values.begin(), values.end());
    emit(Op::Print, operands);
}

} // namespace candela::ir
