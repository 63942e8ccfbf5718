// SPDX-License-Identifier: Apache-2.0
#include "language/ir/core/builder_light.h"

#include "foundation/units/color.h"

namespace candela::ir {

int addRequest(Builder &b, const LightRequest &request) {
    auto &requests = b.function().requests;
    requests.push_back(request);
    return int(requests.size()) - 1;
}
int categoryIndex(Builder &b, const std::string &name) {
    return name.empty() ? -1 : intern(b.function().categories, name);
}

Values lightLoop(Builder &b, int request, const Triple &position, const Values &cones,
                 const Values &initial, const LightBody &body) {
    Instruction instruction{Op::LightLoop, {position.begin(), position.end()}, {}, {}, request, 0,
                            b.line()};
    instruction.operands.insert(instruction.operands.end(), cones.begin(), cones.end());
    instruction.operands.insert(instruction.operands.end(), initial.begin(), initial.end());
    Values carried, arguments;
    const auto given = [&](Type type) {
        arguments.push_back(b.newValue(type, Uniformity::Varying));
        return arguments.back();
    };
    LoopLight light;
    for (ValueId &v : light.L)
        v = given(Type::Float);
    for (int k = 0; k < b.colors().samples; ++k)
        light.Cl.push_back(given(Type::Float));
    light.number = given(Type::Float);
    for (ValueId v : initial)
        carried.push_back(given(b.type(v)));
    instruction.regions.push_back(b.region(arguments, [&] { return body(light, carried); }));
    for (ValueId v : initial)
        instruction.results.push_back(b.newValue(b.type(v), Uniformity::Varying));
    Values results = instruction.results;
    b.append(std::move(instruction));
    return results;
}

namespace {

Values ask(Builder &b, Op op, const Triple &position, const Triple &direction, int request = 0) {
    Values operands(position.begin(), position.end());
    operands.insert(operands.end(), direction.begin(), direction.end());
    return b.emit(op, operands, request);
}

} // namespace

Values trace(Builder &b, int request, const Triple &position, const Triple &direction) {
    return ask(b, Op::Answer, position, direction, request);
}
ValueId sampleLight(Builder &b) { return b.emit(Op::SampleLight, {})[0]; }
Values ambient(Builder &b) { return b.emit(Op::Ambient, {}); }
Values irradiance(Builder &b, const Triple &position, const Triple &omega) {
    return ask(b, Op::Irradiance, position, omega);
}

} // namespace candela::ir
