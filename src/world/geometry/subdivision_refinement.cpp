// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_refinement.h"

#include "world/geometry/subdivision_refiner.h"

#include <opensubdiv/far/patchTableFactory.h>
#include <opensubdiv/far/primvarRefiner.h>
#include <opensubdiv/far/ptexIndices.h>

#include <algorithm>

namespace candela {

namespace {

/// How often faces are split at most where the surface is not regular. What is left is a patch
/// with the limit's own points and tangents at its corners.
int levelsFor(const SubdivisionRecord &mesh) {
    const std::size_t faces = mesh.vertexCounts.size();
    const int least = faces < 20000 ? 6 : faces < 200000 ? 4 : 3;
    return std::max(least, levelsOfCreases(mesh));
}

/// A leaf's cubic in each direction: its values and slopes at the corners say all.
class LeafWeights {
public:
    /// Places of the values that the patch is made from; places of the weights.
    std::vector<int> vertices;

    LeafWeights(const Far::PatchTable &table, const Far::PatchTable::PatchHandle &handle,
                const SubdivisionLeaf &leaf) {
        // Derivatives are by the base face's coordinates, of which corners' pieces are a half.
        const Far::PatchParam param = table.GetPatchParamTable()[std::size_t(handle.patchIndex)];
        const double scale = 1.0 / (1 << param.GetDepth());
        const auto points = table.GetPatchVertices(handle);
        vertices.assign(points.begin(), points.end());
        const double side = leaf.side();
        for (int corner = 0; corner < 4; ++corner) {
            const double u = (leaf.u + corner % 2) * side, v = (leaf.v + corner / 2) * side;
            auto &[value, du, dv, duv] = at_[corner];
            std::array<double, mostPoints> duu, dvv;
            table.EvaluateBasis(handle, u, v, value.data(), du.data(), dv.data(), duu.data(),
                                duv.data(), dvv.data());
            for (std::size_t i = 0; i < vertices.size(); ++i)
                du[i] *= scale, dv[i] *= scale, duv[i] *= scale * scale;
        }
    }

    /// Bezier ordinates of these values, [along u][along v].
    std::array<std::array<double, 4>, 4> ordinates(std::span<const Sum> values) const {
        std::array<std::array<double, 4>, 4> net{};
        for (int corner = 0; corner < 4; ++corner) {
            std::array<double, 4> sum{};
            for (int kind = 0; kind < 4; ++kind)
                for (std::size_t i = 0; i < vertices.size(); ++i)
                    sum[kind] += at_[corner][kind][i] * values[std::size_t(vertices[i])].value;
            const int right = corner % 2, up = corner / 2;
            const double u = (right ? -1 : 1) * sum[1] / 3, v = (up ? -1 : 1) * sum[2] / 3;
            const double twist = (right == up ? 1 : -1) * sum[3] / 9;
            const int i = 3 * right, j = 3 * up, besideI = 1 + right, besideJ = 1 + up;
            net[i][j] = sum[0];
            net[besideI][j] = sum[0] + u;
            net[i][besideJ] = sum[0] + v;
            net[besideI][besideJ] = sum[0] + u + v + twist;
        }
        return net;
    }

private:
    static constexpr int mostPoints = 20; // Of a Gregory patch.
    /// Value and derivatives by u, v and both, at each corner.
    std::array<std::array<std::array<double, mostPoints>, 4>, 4> at_;
};

void appendPowers(std::vector<float> &coefficients,
                  const std::array<std::array<double, 4>, 4> &net) {
    static constexpr double powers[4][4] = {
        {1, 0, 0, 0}, {-3, 3, 0, 0}, {3, -6, 3, 0}, {-1, 3, -3, 1}};
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            double sum = 0;
            for (int k = 0; k < 4; ++k)
                for (int l = 0; l < 4; ++l)
                    sum += powers[i][k] * powers[j][l] * net[k][l];
            coefficients.push_back(float(sum));
        }
}

class FarRefinement final : public SubdivisionRefinement {
public:
    FarRefinement(std::unique_ptr<Far::TopologyRefiner> refiner, const SubdivisionRecord &mesh)
        : refiner_(std::move(refiner)) {
        strayCreases_ = strayCreasesOf(mesh, *refiner_);
        Far::PatchTableFactory::Options options((unsigned(levelsFor(mesh))));
        options.SetEndCapType(Far::PatchTableFactory::Options::ENDCAP_GREGORY_BASIS);
        options.useInfSharpPatch = true;
        options.generateLegacySharpCornerPatches = false;
        options.generateVaryingTables = options.generateVaryingLocalPoints = false;
        options.SetPatchPrecision<double>();
        addPieces();
        refiner_->RefineAdaptive(options.GetRefineAdaptiveOptions());
        table_.reset(Far::PatchTableFactory::Create(*refiner_, options));
        addLeaves();
    }

    PatchPolynomials convert(std::span<const float> values, int components) const override {
        std::vector<std::vector<Sum>> all;
        for (int c = 0; c < components; ++c)
            all.push_back(refined(values, components, c));
        PatchPolynomials result{3, components};
        result.coefficients.reserve(handles_.size() * std::size_t(components) * 16);
        for (std::size_t k = 0; k < handles_.size(); ++k) {
            const LeafWeights weights(*table_, handles_[k], tree_.leaves()[k]);
            for (const std::vector<Sum> &component : all)
                appendPowers(result.coefficients, weights.ordinates(component));
        }
        return result;
    }

private:
    void addPieces() {
        const Far::TopologyLevel &base = refiner_->GetLevel(0);
        edges_.vertices = std::uint32_t(base.GetNumVertices());
        edges_.faces = std::uint32_t(base.GetNumFaces());
        for (int edge = 0; edge < base.GetNumEdges(); ++edge) {
            const auto ends = base.GetEdgeVertices(edge);
            edges_.edges.push_back({std::uint32_t(std::min(ends[0], ends[1])),
                                    std::uint32_t(std::max(ends[0], ends[1]))});
        }
        for (int face = 0; face < base.GetNumFaces(); ++face) {
            const auto vertices = base.GetFaceVertices(face);
            const auto edges = base.GetFaceEdges(face);
            if (vertices.size() == 4)
                addQuad(std::uint32_t(face), vertices, edges);
            else
                addCorners(std::uint32_t(face), vertices, edges);
        }
    }

    SubdivisionSide sideOf(int edge, int from) const {
        const bool isForward = edges_.edges[std::size_t(edge)][0] == std::uint32_t(from);
        return {std::uint32_t(edge), isForward ? 0 : 2, isForward ? 2 : 0};
    }

    void addQuad(std::uint32_t face, const Far::ConstIndexArray &vertices,
                 const Far::ConstIndexArray &edges) {
        pieces_.push_back({face,
                           -1,
                           {sideOf(edges[0], vertices[0]), sideOf(edges[2], vertices[3]),
                            sideOf(edges[3], vertices[0]), sideOf(edges[1], vertices[1])}});
    }

    void addCorners(std::uint32_t face, const Far::ConstIndexArray &vertices,
                    const Far::ConstIndexArray &edges) {
        const int count = vertices.size();
        const std::uint32_t firstSpoke = std::uint32_t(edges_.edges.size() + edges_.spokes.size());
        for (int corner = 0; corner < count; ++corner) {
            const int before = (corner + count - 1) % count;
            const auto half = [&](int edge) {
                SubdivisionSide side = sideOf(edge, vertices[corner]);
                side.toHalf = 1;
                return side;
            };
            const auto spoke = [&](int k) {
                return SubdivisionSide{firstSpoke + std::uint32_t(k), 0, 2};
            };
            pieces_.push_back(
                {face,
                 corner,
                 {half(edges[corner]), spoke(before), half(edges[before]), spoke(corner)}});
            edges_.spokes.push_back({std::uint32_t(edges[corner]), face});
        }
    }

    void addLeaves() {
        struct Found {
            SubdivisionLeaf leaf;
            Far::PatchTable::PatchHandle handle;
        };
        std::vector<Found> found;
        for (int array = 0; array < table_->GetNumPatchArrays(); ++array) {
            const int size = table_->GetPatchArrayDescriptor(array).GetNumControlVertices();
            for (int patch = 0; patch < table_->GetNumPatches(array); ++patch) {
                Far::PatchTable::PatchHandle handle;
                handle.arrayIndex = array;
                handle.patchIndex = int(found.size());
                handle.vertIndex = patch * size;
                const Far::PatchParam param = table_->GetPatchParam(array, patch);
                found.push_back(
                    {{std::uint32_t(param.GetFaceId()), param.GetDepth() - int(param.NonQuadRoot()),
                      param.GetU(), param.GetV()},
                     handle});
            }
        }
        std::ranges::stable_sort(found, {}, [](const Found &f) { return f.leaf.piece; });
        std::vector<SubdivisionLeaf> leaves;
        for (const Found &each : found) {
            leaves.push_back(each.leaf);
            handles_.push_back(each.handle);
        }
        tree_ = SubdivisionTree(std::move(leaves), std::uint32_t(pieces_.size()));
    }

    /// One component at the vertices of all levels and the points that patches have besides.
    std::vector<Sum> refined(std::span<const float> values, int components, int component) const {
        const int vertices = refiner_->GetNumVerticesTotal();
        std::vector<Sum> all(std::size_t(vertices + table_->GetNumLocalPoints()));
        for (std::size_t i = 0; i < edges_.vertices; ++i)
            all[i].value = values[i * std::size_t(components) + std::size_t(component)];
        const Far::PrimvarRefinerReal<double> refiner(*refiner_);
        Sum *from = all.data();
        for (int level = 1; level <= refiner_->GetMaxLevel(); ++level) {
            Sum *to = from + refiner_->GetLevel(level - 1).GetNumVertices();
            refiner.Interpolate(level, from, to);
            from = to;
        }
        if (const auto *stencils = table_->GetLocalPointStencilTable<double>())
            stencils->UpdateValues(all.data(), all.data() + vertices);
        return all;
    }

    std::unique_ptr<Far::TopologyRefiner> refiner_;
    std::unique_ptr<const Far::PatchTable> table_;
    std::vector<Far::PatchTable::PatchHandle> handles_; ///< Of leaves.
};

} // namespace

std::unique_ptr<SubdivisionRefinement> SubdivisionRefinement::of(const SubdivisionRecord &mesh,
                                                                 int vertices, std::string &why) {
    auto refiner = refinerOf(mesh, vertices, why);
    if (!refiner)
        return nullptr;
    return std::make_unique<FarRefinement>(std::move(refiner), mesh);
}

} // namespace candela
