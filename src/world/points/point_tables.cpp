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

SurfaceCode surfaceCode(std::shared_ptr<ShaderCode> code, const ir::Function *asked) {
    SurfaceCode result;
    const ir::Function &function = asked ? *asked : code->shader().whole;
    for (const ir::ParameterSlot &slot : function.variables) {
        auto known = std::ranges::find(result.variableNames, slot.name);
        result.variableName.push_back(int(known - result.variableNames.begin()));
        result.variableComponent.push_back(slot.component);
        result.variableSlope.push_back(slot.slope ? 1 + int(*slot.slope) : 0);
        if (known == result.variableNames.end())
            result.variableNames.push_back(slot.name);
    }
    result.wanted.add(function.inputsRead);
    result.readsObjectSpace = usesObjectSpace(function.body);
    result.movesPoints = !asked && code->displacement().movesP;
    result.code = std::move(code);
    return result;
}

void addNeeds(const ShaderCode &other, SurfaceCode &surface) {
    surface.wanted.add(other.shader().whole.inputsRead);
    surface.readsObjectSpace |= usesObjectSpace(other.shader().whole.body);
}

std::set<std::string> overridingNames(const Surface &surface) {
    const std::set<std::string> inputs{"Cs", "Os", "s", "t"};
    std::set<std::string> names;
    for (const VariableInfo &variable : surface.variables())
        if (variable.declaration.type != ValueType::String && !inputs.contains(variable.name))
            names.insert(variable.name);
    return names;
}

void WantedInputs::add(const std::vector<bool> &inputsRead) {
    // Any component of consecutive inputs.
    auto reads = [&](ShaderInput first, ShaderInput last) {
        bool any = false;
        for (int plane = int(first); plane <= int(last); ++plane)
            any |= inputsRead[std::size_t(plane)];
        return any;
    };
    dPd |= reads(ShaderInput::dPdu, ShaderInput::dPdvLast_);
    dNd |= reads(ShaderInput::dNdu, ShaderInput::dNdvLast_);
    dNg |= reads(ShaderInput::dNgdu, ShaderInput::dNgdvLast_);
    dCs |= reads(ShaderInput::dCsdu, ShaderInput::dCsdvLast_);
    dOs |= reads(ShaderInput::dOsdu, ShaderInput::dOsdvLast_);
    uv |= reads(ShaderInput::u, ShaderInput::v);
    footprint |=
        reads(ShaderInput::du, ShaderInput::vShift) || reads(ShaderInput::Du, ShaderInput::Dv);
    stDerivatives |= reads(ShaderInput::dsdu, ShaderInput::dtdv);
    st |= stDerivatives || reads(ShaderInput::s, ShaderInput::t);
    Cs |= dCs || reads(ShaderInput::Cs, ShaderInput::CsLast_);
    Os |= dOs || reads(ShaderInput::Os, ShaderInput::OsLast_);
    orientation |= reads(ShaderInput::orientation, ShaderInput::orientation);
    E |= reads(ShaderInput::E, ShaderInput::ELast_);
    dPd |= footprint;
}

Matrix4 PointTables::currentFromShape(std::uint32_t instance, std::uint32_t shape,
                                      float time) const {
    const Matrix4 &outerFromShape = shapes[shape].outerFromShape;
    if (instance == noHit)
        return outerFromShape;
    if (instances[instance].steps > 0)
        return outerFromShape * matrixAt(stepsOf(instance), shutter.share(time));
    Matrix4 currentFromOuter;
    std::copy_n(matricesOf(instance), 16, currentFromOuter.m.begin());
    return outerFromShape * currentFromOuter;
}

void PointTables::placeAt(std::uint32_t instance, float time, float *matrices) const {
    if (instances[instance].steps > 0)
        matricesAt(stepsOf(instance), shutter.share(time), matrices);
    else
        std::copy_n(matricesOf(instance), 32, matrices);
}

} // namespace candela
