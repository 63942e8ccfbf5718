// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/loop_refinement.h"

#include "world/geometry/subdivision_refiner.h"

#include <opensubdiv/far/primvarRefiner.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace candela {

namespace {

using Places = std::array<LoopRefinement::Place, 3>;

LoopRefinement::Place between(LoopRefinement::Place a, LoopRefinement::Place b) {
    return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2};
}

/// Places of the corners of a face's part, which are corners and middles of edges of the face.
Places placesOfPart(const Far::TopologyLevel &level, int face, const Places &places,
                    const Far::TopologyLevel &finer, int part) {
    const auto vertices = level.GetFaceVertices(face), edges = level.GetFaceEdges(face);
    const auto corners = finer.GetFaceVertices(part);
    Places result{};
    for (int corner = 0; corner < 3; ++corner)
        for (int k = 0; k < 3; ++k) {
            if (corners[corner] == level.GetVertexChildVertex(vertices[k]))
                result[corner] = places[k];
            else if (corners[corner] == level.GetEdgeChildVertex(edges[k]))
                result[corner] = between(places[k], places[(k + 1) % 3]);
        }
    return result;
}

/// The faces around a vertex, as creases part them: each one's sector.
class Sectors {
public:
    Sectors(const Far::TopologyLevel &level, int vertex) : faces_(level.GetVertexFaces(vertex)) {
        sector_.resize(std::size_t(faces_.size()));
        std::iota(sector_.begin(), sector_.end(), 0);
        for (const int edge : level.GetVertexEdges(vertex)) {
            const auto sides = level.GetEdgeFaces(edge);
            if (sides.size() == 2 && !(level.GetEdgeSharpness(edge) > 0))
                join(of(sides[0]), of(sides[1]));
        }
    }
    int of(int face) const {
        return sector_[std::size_t(std::find(faces_.begin(), faces_.end(), face) - faces_.begin())];
    }
    template <class Use> void forEachFaceOf(int sector, const Use &use) const {
        for (int k = 0; k < faces_.size(); ++k)
            if (sector_[std::size_t(k)] == sector)
                use(faces_[k]);
    }

private:
    void join(int a, int b) { std::ranges::replace(sector_, b, a); }

    Far::ConstIndexArray faces_;
    std::vector<int> sector_;
};

/// Whether one tangent plane serves all faces around a vertex.
bool isSmooth(const Far::TopologyLevel &level, int vertex) {
    const Sdc::Crease::Rule rule = level.GetVertexRule(vertex);
    if (rule == Sdc::Crease::RULE_SMOOTH || rule == Sdc::Crease::RULE_DART)
        return true;
    return rule == Sdc::Crease::RULE_CREASE && level.IsVertexBoundary(vertex);
}

class FarLoopRefinement final : public LoopRefinement {
public:
    FarLoopRefinement(std::unique_ptr<Far::TopologyRefiner> refiner, const SubdivisionRecord &mesh,
                      int levels)
        : refiner_(std::move(refiner)) {
        strayCreases_ = strayCreasesOf(mesh, *refiner_);
        Far::TopologyRefiner::UniformOptions options(levels);
        options.fullTopologyInLastLevel = true; // Limits need it.
        refiner_->RefineUniform(options);
        addTriangles();
    }

    std::vector<float> limit(std::span<const float> values, int components) const override {
        const auto count = std::size_t(finest().GetNumVertices());
        std::vector<float> result(count * std::size_t(components));
        std::vector<Sum> there(count);
        for (int c = 0; c < components; ++c) {
            const Far::PrimvarRefinerReal<double> refiner(*refiner_);
            refiner.Limit(refined(values, components, c), there);
            for (std::size_t i = 0; i < count; ++i)
                result[i * std::size_t(components) + std::size_t(c)] = float(there[i].value);
        }
        return result;
    }

    std::vector<Vec3> normals(std::span<const float> positions) const override {
        const std::vector<Vec3> smooth = crossedTangents(positions);
        const std::vector<Vec3> flat = normalsOfFaces(limit(positions, 3));
        std::vector<Vec3> result(3 * triangles_.size());
        const Far::TopologyLevel &level = finest();
        std::vector<std::uint8_t> serves(smooth.size());
        for (std::size_t v = 0; v < smooth.size(); ++v)
            serves[v] = isSmooth(level, int(v)) && dot(smooth[v], smooth[v]) > 0;
        for (std::size_t k = 0; k < triangles_.size(); ++k)
            for (std::size_t corner = 0; corner < 3; ++corner) {
                const int vertex = triangles_[k].vertices[corner];
                Vec3 &normal = result[3 * k + corner];
                if (serves[std::size_t(vertex)]) {
                    normal = smooth[std::size_t(vertex)];
                    continue;
                }
                const Sectors sectors(level, vertex);
                sectors.forEachFaceOf(sectors.of(faces_[k]),
                                      [&](int face) { normal += flat[std::size_t(face)]; });
            }
        return result;
    }

private:
    const Far::TopologyLevel &finest() const { return refiner_->GetLevel(refiner_->GetMaxLevel()); }

    void addTriangles() {
        struct Part {
            int number, face;
            Places places;
        };
        std::vector<Part> parts, finer;
        for (int face = 0; face < refiner_->GetLevel(0).GetNumFaces(); ++face)
            parts.push_back({face, face, {{{0, 0}, {1, 0}, {0, 1}}}});
        for (int depth = 0; depth < refiner_->GetMaxLevel(); ++depth) {
            const Far::TopologyLevel &level = refiner_->GetLevel(depth);
            const Far::TopologyLevel &next = refiner_->GetLevel(depth + 1);
            finer.clear();
            for (const Part &part : parts)
                for (const int child : level.GetFaceChildFaces(part.number))
                    finer.push_back({child, part.face,
                                     placesOfPart(level, part.number, part.places, next, child)});
            parts.swap(finer);
        }
        for (const Part &part : parts) {
            const auto vertices = finest().GetFaceVertices(part.number);
            triangles_.push_back({{vertices[0], vertices[1], vertices[2]},
                                  part.face,
                                  part.places,
                                  finest().IsFaceHole(part.number)});
            faces_.push_back(part.number);
        }
    }

    /// One component at the vertices of the finest level, before they go to their limit.
    std::vector<Sum> refined(std::span<const float> values, int components, int component) const {
        std::vector<Sum> from(std::size_t(refiner_->GetLevel(0).GetNumVertices()));
        for (std::size_t i = 0; i < from.size(); ++i)
            from[i].value = values[i * std::size_t(components) + std::size_t(component)];
        const Far::PrimvarRefinerReal<double> refiner(*refiner_);
        for (int level = 1; level <= refiner_->GetMaxLevel(); ++level) {
            std::vector<Sum> to(std::size_t(refiner_->GetLevel(level).GetNumVertices()));
            refiner.Interpolate(level, from, to);
            from.swap(to);
        }
        return from;
    }

    std::vector<Vec3> crossedTangents(std::span<const float> positions) const {
        const auto count = std::size_t(finest().GetNumVertices());
        std::vector<Vec3> first(count), second(count);
        std::vector<Sum> there(count), one(count), other(count);
        for (int axis = 0; axis < 3; ++axis) {
            const Far::PrimvarRefinerReal<double> refiner(*refiner_);
            refiner.Limit(refined(positions, 3, axis), there, one, other);
            for (std::size_t i = 0; i < count; ++i)
                first[i][axis] = float(one[i].value), second[i][axis] = float(other[i].value);
        }
        for (std::size_t i = 0; i < count; ++i)
            first[i] = cross(first[i], second[i]);
        return first;
    }

    /// By the numbers of the faces; as long as twice their areas.
    std::vector<Vec3> normalsOfFaces(const std::vector<float> &positions) const {
        const auto at = [&](int vertex) {
            const float *p = &positions[3 * std::size_t(vertex)];
            return Vec3{p[0], p[1], p[2]};
        };
        std::vector<Vec3> normals(triangles_.size());
        for (std::size_t k = 0; k < triangles_.size(); ++k) {
            const auto &[a, b, c] = triangles_[k].vertices;
            normals[std::size_t(faces_[k])] = cross(at(b) - at(a), at(c) - at(a));
        }
        return normals;
    }

    std::unique_ptr<Far::TopologyRefiner> refiner_;
    std::vector<int> faces_; ///< The numbers of triangles_ in the finest level.
};

} // namespace

int LoopRefinement::levelsFor(const SubdivisionRecord &mesh) {
    constexpr double usual = 5e5, most = 4e6; // Triangles.
    const int lasting = levelsOfCreases(mesh);
    const double faces = double(mesh.vertexCounts.size());
    const auto triangles = [&](int level) { return faces * std::exp2(2 * level); };
    int levels = 0;
    while (levels < 6 && triangles(levels + 1) <= usual)
        ++levels;
    while (levels < lasting && triangles(levels + 1) <= most)
        ++levels;
    return levels;
}

std::unique_ptr<LoopRefinement> LoopRefinement::of(const SubdivisionRecord &mesh, int vertices,
                                                   int levels, std::string &why) {
    auto refiner = refinerOf(mesh, vertices, why);
    if (!refiner)
        return nullptr;
    return std::make_unique<FarLoopRefinement>(std::move(refiner), mesh, levels);
}

} // namespace candela
