// SPDX-License-Identifier: Apache-2.0
// A surface as something else shows it: what is not said anew is that of the surface behind it.
#pragma once

#include "world/geometry/surface.h"

#include <memory>

namespace candela {

class SurfaceView : public Surface {
public:
    explicit SurfaceView(std::shared_ptr<const Surface> behind) : behind_(std::move(behind)) {}

    const Surface &behind() const { return *behind_; }

    SurfaceDomain domain() const override { return behind_->domain(); }
    Box3 bound() const override { return behind_->bound(); }
    DicedMesh dice(const DiceRate &rate) const override { return behind_->dice(rate); }
    double triangleCount(const DiceRate &rate) const override {
        return behind_->triangleCount(rate);
    }
    float area() const override { return behind_->area(); }
    void evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const override {
        behind_->evaluate(query, answer);
    }
    bool isRound() const override { return behind_->isRound(); }
    bool isStroke() const override { return behind_->isStroke(); }
    RoundElements roundElements() const override { return behind_->roundElements(); }
    void nameRound(int count, const Vec3Planes &P, const float *share, std::uint32_t *piece,
                   float *u, float *v) const override {
        behind_->nameRound(count, P, share, piece, u, v);
    }
    bool isFlat() const override { return behind_->isFlat(); }
    bool hasOwnNormals() const override { return behind_->hasOwnNormals(); }
    std::span<const VariableInfo> variables() const override { return behind_->variables(); }
    void evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                          float *const *valueDu, float *const *valueDv) const override {
        behind_->evaluateVariable(index, query, value, valueDu, valueDv);
    }

private:
    std::shared_ptr<const Surface> behind_;
};

} // namespace candela
