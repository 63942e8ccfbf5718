// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/assemble_patches.h"

#include <algorithm>
#include <cmath>

namespace candela {

PatchPolynomials fromHomogeneous(const std::vector<float> &points, const VertexBasis &basis) {
    bool rational = false;
    for (std::size_t i = 3; i < points.size(); i += 4)
        rational |= points[i] != 1;
    if (rational)
        return basis.convert(points, 4);
    std::vector<float> plain;
    plain.reserve(points.size() / 4 * 3);
    for (std::size_t i = 0; i < points.size(); i += 4)
        plain.insert(plain.end(), {points[i], points[i + 1], points[i + 2]});
    return basis.convert(plain, 3);
}

std::shared_ptr<const PatchSurface> assemblePatches(const PatchOrder &order,
                                                    PatchPolynomials positions, MeshSides sides,
                                                    DiagnosticSink &diagnostics) {
    auto refuse = [&](const std::string &why) {
        diagnostics.error(order.record.where,
                          "the " + std::string(order.name) + " " + why + "; it is dropped");
        return nullptr;
    };
    std::vector<PatchBounds> bounds;
    for (int patch = 0; patch < order.grid.patches(); ++patch) {
        bounds.push_back(patchBounds(positions, patch));
        if (!bounds.back().valid)
            return refuse("has weights in \"Pw\" that are not positive under its basis");
        if (!hasUsableSize(bounds.back().box) && !(length(bounds.back().box.extent()) == 0))
            return refuse("is too large or too small to be computed with");
    }
    GridVariables variables(order.record, order.attributes, order.grid, order.basis, diagnostics);
    auto surface =
        std::make_shared<PatchSurface>(order.grid, std::move(positions), std::move(bounds),
                                       std::move(sides), std::move(variables));
    if (!surface->hasArea())
        return refuse("has no area");
    return surface;
}

} // namespace candela
