// SPDX-License-Identifier: Apache-2.0
#include "world/points/point_tables.h"

#include <algorithm>

namespace candela {

namespace {

bool usesObjectSpace(const ir::Region &region) {
    return std::ranges::any_of(region.body, [](const ir::Instruction &i) {
        return i.op == ir::Op::Object || i.op == ir::Op::ObjectInverse ||
               std::ranges::any_of(i.regions, usesObjectSpace);
    });
}

} // namespace

SurfaceCode surfaceCode(std::shared_ptr<ShaderCode> code) {
    SurfaceCode result;
    for (const ir::ParameterSlot &slot : code->variables()) {
        auto known = std::ranges::find(result.variableNames, slot.name);
        result.variableName.push_back(int(known - result.variableNames.begin()));
        result.variableComponent.push_back(slot.component);
        if (known == result.variableNames.end())
            result.variableNames.push_back(slot.name);
    }
    result.wanted.add(*code);
    result.readsObjectSpace = usesObjectSpace(code->shader().whole.body);
    result.code = std::move(code);
    return result;
}

void WantedInputs::add(const ShaderCode &code) {
    auto reads = [&](std::initializer_list<ShaderInput> inputs) {
        return std::ranges::any_of(inputs, [&](ShaderInput input) { return code.reads(input); });
    };
    dPd |= reads({ShaderInput::dPdu, ShaderInput::dPdv});
    dNd |= reads({ShaderInput::dNdu, ShaderInput::dNdv});
    uv |= reads({ShaderInput::u, ShaderInput::v});
    footprint |= reads({ShaderInput::du, ShaderInput::dv});
    stDerivatives |=
        reads({ShaderInput::dsdu, ShaderInput::dsdv, ShaderInput::dtdu, ShaderInput::dtdv});
    st |= stDerivatives || reads({ShaderInput::s, ShaderInput::t});
    Cs |= code.reads(ShaderInput::Cs), Os |= code.reads(ShaderInput::Os);
    orientation |= code.reads(ShaderInput::orientation);
    E |= code.reads(ShaderInput::E);
    dPd |= footprint;
}

Matrix4 PointTables::currentFromShape(std::uint32_t instance, std::uint32_t shape) const {
    const Matrix4 &outerFromShape = shapes[shape].outerFromShape;
    if (instance == noHit)
        return outerFromShape;
    Matrix4 currentFromOuter;
    std::copy_n(matricesOf(instance), 16, currentFromOuter.m.begin());
    return outerFromShape * currentFromOuter;
}

} // namespace candela
