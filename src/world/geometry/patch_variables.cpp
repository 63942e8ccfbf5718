// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_variables.h"

#include <algorithm>

namespace candela {

void PatchVariables::add(const NumericVariable &variable, PatchPolynomials polynomials, int space) {
    if (variable.name == "N" || (variable.name == "Np" && !normal_)) {
        normal_ = {std::move(polynomials), space};
    } else if (variable.name != "Np") {
        infos_.push_back({variable.name, variable.declaration});
        values_.push_back({std::move(polynomials), space});
    }
}

void PatchVariables::addTextureCoordinates(const std::array<float, 8> &corners) {
    addTextureCoordinate("s", corners, 0);
    addTextureCoordinate("t", corners, 1);
}

void PatchVariables::addTextureCoordinate(const char *name, const std::array<float, 8> &corners,
                                          int offset) {
    if (std::ranges::find(infos_, name, &VariableInfo::name) != infos_.end())
        return;
    PatchPolynomials polynomials{1, 1, true};
    appendBilinear(polynomials.coefficients, corners[offset], corners[2 + offset],
                   corners[4 + offset], corners[6 + offset]);
    infos_.push_back({name, {StorageClass::Varying, ValueType::Float, 1}});
    values_.push_back({std::move(polynomials)});
}

void PatchVariables::evaluate(int index, int first, int count, const Locate &locate,
                              float *const *value, float *const *valueDu,
                              float *const *valueDv) const {
    const auto &[polynomials, space] = values_[index];
    PatchPoints points;
    for (int start = 0; start < count; start += PatchPoints::capacity) {
        locate(space, start, std::min(count - start, points.capacity), points);
        for (int c = 0; c < polynomials.components; ++c)
            polynomials.evaluate(points, c, value ? value[c] + first + start : nullptr,
                                 valueDu ? valueDu[c] + first + start : nullptr,
                                 valueDv ? valueDv[c] + first + start : nullptr);
    }
}

void PatchVariables::overrideNormals(int count, const Locate &locate, Vec3Planes N, Vec3Planes dNdu,
                                     Vec3Planes dNdv) const {
    if (!normal_)
        return;
    PatchPoints points;
    std::array<float, PatchPoints::capacity> value[3], du[3], dv[3];
    for (int start = 0; start < count; start += PatchPoints::capacity) {
        locate(normal_->space, start, std::min(count - start, points.capacity), points);
        for (int c = 0; c < 3; ++c)
            normal_->polynomials.evaluate(points, c, value[c].data(), du[c].data(), dv[c].data());
        for (int k = 0; k < points.count; ++k) {
            Vec3 n{value[0][k], value[1][k], value[2][k]};
            if (!(dot(n, n) > 0))
                continue;
            if (N.x)
                N.set(start + k, n);
            if (dNdu.x)
                dNdu.set(start + k, unitDerivative(n, {du[0][k], du[1][k], du[2][k]}));
            if (dNdv.x)
                dNdv.set(start + k, unitDerivative(n, {dv[0][k], dv[1][k], dv[2][k]}));
        }
    }
}

} // namespace candela
