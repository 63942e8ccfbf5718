// SPDX-License-Identifier: Apache-2.0
// Displacement in several stages: what a surface says that is seen through all of them.
#pragma once

#include "world/geometry/displacement.h"

#include <memory>

namespace candela {

class MovedDisplacement final : public Displacement {
public:
    /// `moved`: the surface as all stages have it (moved_surface.h), under the names that it had
    /// before; `last` is the last stage.
    MovedDisplacement(std::shared_ptr<const Surface> moved,
                      std::shared_ptr<const Displacement> last, bool knowsSlopes)
        : moved_(std::move(moved)), last_(std::move(last)), knowsSlopes_(knowsSlopes) {}

    bool movesPoints() const override { return true; }
    bool setsNormals() const override { return last_->setsNormals(); }
    bool givesTrueNormals() const override { return last_->givesTrueNormals(); }
    bool isOfSurface() const override { return false; }
    bool knowsSlopes() const override { return knowsSlopes_; }
    float width(Vec3 P) const override { return last_->width(P); }
    void move(const SurfaceQuery &query, Vec3Planes P) const override {
        SurfaceAnswer answer;
        answer.P = P;
        moved_->evaluate(query, answer);
    }
    void displace(const SurfaceQuery &query, const SurfaceAnswer &answer) const override {
        SurfaceAnswer wanted;
        wanted.P = answer.P, wanted.N = answer.N;
        if (knowsSlopes_)
            wanted.dPdu = answer.dPdu, wanted.dPdv = answer.dPdv;
        moved_->evaluate(query, wanted);
    }

private:
    std::shared_ptr<const Surface> moved_;
    std::shared_ptr<const Displacement> last_;
    bool knowsSlopes_;
};

} // namespace candela
