// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/make_subdivision.h"

#include "world/geometry/make_loop.h"
#include "world/geometry/subdivision_surface.h"

#include <cmath>
#include <optional>
#include <vector>

namespace candela {

/// Around a vertex of so many faces, and in the middle of a face of so many corners, each patch of
/// the limit hangs on all others.
static bool canBeSmoothed(const SubdivisionRecord &mesh, std::size_t vertices) {
    constexpr double most = 8e6; // Of pairs: some gigabytes.
    std::vector<double> faces(vertices);
    for (int vertex : mesh.vertices)
        ++faces[std::size_t(vertex)];
    double pairs = 0;
    const auto add = [&](double count) { pairs += count > 16 ? count * count : 0; };
    for (double count : faces)
        add(count);
    for (int corners : mesh.vertexCounts)
        add(corners);
    return pairs <= most;
}

void reportStrayCreases(int strays, const SourceLocation &where, DiagnosticSink &diagnostics) {
    if (strays > 0)
        diagnostics.warning(where, "creases of the subdivision mesh run " + std::to_string(strays) +
                                       " times between vertices that no edge joins; they have no "
                                       "effect there");
}

void reportNothingDrawn(const SourceLocation &where, DiagnosticSink &diagnostics) {
    diagnostics.warning(where,
                        "nothing of the subdivision mesh is drawn: all of its faces are holes or "
                        "at its boundary, and \"interpolateboundary\" is not asked for");
}

SurfaceList makeSubdivision(const SubdivisionRecord &given, const PrimitiveRecord &record,
                            const Attributes &attributes, DiagnosticSink &diagnostics) {
    auto refuse = [&](const std::string &why) {
        diagnostics.error(record.where, "the subdivision mesh " + why + "; it is dropped");
        return SurfaceList{};
    };
    const Parameter *points = record.variables.find("P");
    if (!points)
        return refuse("has no \"P\"");
    std::optional<SubdivisionRecord> flat;
    if (given.scheme != SubdivisionRecord::Scheme::Bilinear &&
        !canBeSmoothed(given, points->floats.size() / 3)) {
        diagnostics.warning(record.where,
                            "the subdivision mesh has vertices in too many faces, or faces of too "
                            "many corners, to be smoothed: its faces are drawn as they are");
        flat = given;
        flat->scheme = SubdivisionRecord::Scheme::Bilinear;
    }
    const SubdivisionRecord &mesh = flat ? *flat : given;
    if (mesh.scheme == SubdivisionRecord::Scheme::Loop)
        return makeLoop(mesh, record, attributes, diagnostics);
    std::string why;
    const auto refinement = SubdivisionRefinement::of(mesh, int(points->floats.size() / 3), why);
    if (!refinement)
        return refuse(why);
    reportStrayCreases(refinement->strayCreases(), record.where, diagnostics);
    const auto tree = std::make_shared<const SubdivisionTree>(refinement->tree());
    SubdivisionShape shape;
    for (std::uint32_t k = 0; k < refinement->pieces().size(); ++k)
        if (tree->has(k)) {
            shape.pieces.push_back(refinement->pieces()[k]);
            shape.numbers.push_back(k);
        }
    if (shape.pieces.empty()) {
        reportNothingDrawn(record.where, diagnostics);
        return {};
    }
    PatchPolynomials positions = refinement->convert(points->floats, 3);
    std::vector<PatchBounds> bounds;
    Box3 box;
    for (std::size_t leaf = 0; leaf < tree->leaves().size(); ++leaf) {
        bounds.push_back(patchBounds(positions, int(leaf)));
        box.add(bounds.back().box);
    }
    if (!hasUsableSize(box))
        return refuse("is too large or too small to be computed with");
    PatchPositions limit(std::move(positions), bounds);
    shape.edges = refinement->edges();
    shape.tree = tree;
    shape.errors = SubdivisionErrors(*tree, limit, bounds);
    SubdivisionVariables variables(mesh, record, attributes, *refinement, shape.numbers, tree,
                                   diagnostics);
    auto surface = std::make_shared<SubdivisionSurface>(std::move(shape), std::move(limit), bounds,
                                                        std::move(variables));
    if (!surface->hasArea())
        return refuse("has no area");
    return {surface};
}

} // namespace candela
