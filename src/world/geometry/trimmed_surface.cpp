// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/trimmed_surface.h"

#include "world/geometry/cut_along_trim.h"

#include <algorithm>

namespace candela {

static double sizeOf(const Surface &surface) {
    const Vec3 extent = surface.bound().extent();
    return std::max({extent.x, extent.y, extent.z});
}

TrimmedSurface::TrimmedSurface(std::shared_ptr<const Surface> whole, TrimRecord curves,
                               const PatchGrid &grid, TrimOutline::Place longest, bool trimsInside)
    : SurfaceView(std::move(whole)), curves_(std::move(curves)), grid_(grid), longest_(longest),
      size_(sizeOf(behind())), fine_(outlineAt(1e-4 * size_)), rule_(fine_, trimsInside) {
    const DicedMesh mesh = cutAt({float(4 * size_), float(1e-3 * size_)});
    for (int c : {0, 1}) {
        float low = 1, high = 0;
        for (const auto &uv : mesh.vertexUv)
            low = std::min(low, uv[c]), high = std::max(high, uv[c]);
        // What is diced more finely may reach a little farther.
        const float margin = 2e-3f;
        begin_[c] = std::max(low - margin, 0.0f);
        extent_[c] = std::max(std::min(high + margin, 1.0f) - begin_[c], margin);
    }
    double area = 0;
    for (const auto &[a, b, c] : mesh.triangles)
        area += 0.5 * length(cross(mesh.positions[b] - mesh.positions[a],
                                   mesh.positions[c] - mesh.positions[a]));
    area_ = float(area);
}

/// Curves are followed to within the chord error; never so coarsely that small loops vanish.
TrimOutline TrimmedSurface::outlineAt(double chord) const {
    const double near = std::clamp(chord, 1e-6 * size_, 1e-3 * size_);
    return {curves_, grid_, {near / longest_[0] / 2, near / longest_[1] / 2}};
}

DicedMesh TrimmedSurface::cutAt(const DiceRate &rate) const {
    return cutAlongTrim(behind().dice(rate), outlineAt(rate.chordError), rule_, behind());
}

DicedMesh TrimmedSurface::dice(const DiceRate &rate) const {
    DicedMesh mesh = cutAt(rate);
    for (auto &uv : mesh.vertexUv)
        for (int c : {0, 1})
            uv[c] = (uv[c] - begin_[c]) / extent_[c];
    return mesh;
}

double TrimmedSurface::triangleCount(const DiceRate &rate) const {
    return double(dice(rate).triangles.size());
}

/// What the whole surface calls the points.
class TrimmedSurface::Names {
public:
    Names(const TrimmedSurface &surface, const SurfaceQuery &query)
        : query_(query), u_(std::size_t(query.count)), v_(std::size_t(query.count)) {
        for (int k = 0; k < query.count; ++k) {
            u_[k] = surface.begin_[0] + query.u[k] * surface.extent_[0];
            v_[k] = surface.begin_[1] + query.v[k] * surface.extent_[1];
        }
        query_.u = u_.data(), query_.v = v_.data();
    }
    const SurfaceQuery &query() const { return query_; }

private:
    SurfaceQuery query_;
    std::vector<float> u_, v_;
};

void TrimmedSurface::evaluate(const SurfaceQuery &query, const SurfaceAnswer &answer) const {
    const Names names(*this, query);
    behind().evaluate(names.query(), answer);
    for (int k = 0; answer.areaScale && k < query.count; ++k) {
        const bool isKept = rule_.keeps(fine_.winding({names.query().u[k], names.query().v[k]}));
        answer.areaScale[k] *= isKept ? extent_[0] * extent_[1] : 0;
    }
}

void TrimmedSurface::evaluateVariable(int index, const SurfaceQuery &query, float *const *value,
                                      float *const *valueDu, float *const *valueDv) const {
    behind().evaluateVariable(index, Names(*this, query).query(), value, valueDu, valueDv);
}

} // namespace candela
