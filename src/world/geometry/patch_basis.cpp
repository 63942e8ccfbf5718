// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_basis.h"

#include "world/geometry/bezier_net.h"

#include <algorithm>
#include <cmath>

namespace candela {

/// Patches along one side of a mesh (RI 3.2, 5.2), or 0.
static int patchesAlong(int vertices, bool bicubic, bool periodic, int step) {
    if (!bicubic)
        return vertices < 2 ? 0 : periodic ? vertices : vertices - 1;
    if (step < 1 || vertices < 4)
        return 0;
    return periodic ? vertices / step : (vertices - 4) / step + 1;
}

static bool divides(int vertices, bool bicubic, bool periodic, int step) {
    return !bicubic || (periodic ? vertices : vertices - 4) % step == 0;
}

std::optional<PatchTopology> patchTopology(const PatchMeshRecord &mesh,
                                           const Attributes &attributes, std::string &why) {
    PatchTopology topology;
    topology.bicubic = mesh.bicubic;
    topology.uVertices = mesh.uVertices;
    topology.vVertices = mesh.vVertices;
    topology.uStep = attributes.uBasis.step;
    topology.vStep = attributes.vBasis.step;
    topology.uBasis = attributes.uBasis.matrix;
    topology.vBasis = attributes.vBasis.matrix;
    constexpr int mostVertices = 1 << 15; // A side; keeps products within int.
    if (mesh.uVertices > mostVertices || mesh.vVertices > mostVertices) {
        why = "has more than 32768 control points along a side";
        return std::nullopt;
    }
    PatchAxis &u = topology.grid.u, &v = topology.grid.v;
    u.patches = patchesAlong(mesh.uVertices, mesh.bicubic, mesh.uPeriodic, topology.uStep);
    v.patches = patchesAlong(mesh.vVertices, mesh.bicubic, mesh.vPeriodic, topology.vStep);
    u.periodic = mesh.uPeriodic, v.periodic = mesh.vPeriodic;
    if (topology.grid.u.patches < 1 || topology.grid.v.patches < 1) {
        why = "has too few control points for a patch under the present basis steps";
        return std::nullopt;
    }
    if (!divides(mesh.uVertices, mesh.bicubic, mesh.uPeriodic, topology.uStep) ||
        !divides(mesh.vVertices, mesh.bicubic, mesh.vPeriodic, topology.vStep)) {
        why = "has a number of control points that does not fit the present basis steps";
        return std::nullopt;
    }
    auto finite = [](float x) { return std::isfinite(x); };
    if (!std::ranges::all_of(topology.uBasis, finite) ||
        !std::ranges::all_of(topology.vBasis, finite)) {
        why = "has a basis that is not finite";
        return std::nullopt;
    }
    return topology;
}

namespace {

/// Control ordinates of one patch and component: [along u][along v].
using ControlNet = std::array<std::array<double, 4>, 4>;

/// coefficient[i][j] of u^i v^j: the rows of a basis go down from the third power.
ControlNet bicubicCoefficients(const PatchTopology &topology, const ControlNet &net) {
    ControlNet half{}, result{}; // Basis applied along u, then along v.
    for (int i = 0; i < 4; ++i)
        for (int b = 0; b < 4; ++b)
            for (int a = 0; a < 4; ++a)
                half[i][b] += double(topology.uBasis[(3 - i) * 4 + a]) * net[a][b];
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int b = 0; b < 4; ++b)
                result[i][j] += half[i][b] * topology.vBasis[(3 - j) * 4 + b];
    return result;
}

void appendBicubic(const PatchTopology &topology, const ControlNet &net,
                   std::vector<float> &coefficients) {
    for (const auto &row : bicubicCoefficients(topology, net))
        for (double coefficient : row)
            coefficients.push_back(float(coefficient));
}

} // namespace

PatchPolynomials convertVertices(const PatchTopology &topology, std::span<const float> values,
                                 int components) {
    PatchPolynomials result{topology.degree(), components};
    result.coefficients.reserve(std::size_t(topology.grid.patches()) * components *
                                result.coefficientCount());
    int stepU = topology.bicubic ? topology.uStep : 1,
        stepV = topology.bicubic ? topology.vStep : 1;
    auto at = [&](int column, int row, int component) {
        int vertex = row % topology.vVertices * topology.uVertices + column % topology.uVertices;
        return values[std::size_t(vertex) * components + component];
    };
    for (int row = 0; row < topology.grid.v.patches; ++row)
        for (int column = 0; column < topology.grid.u.patches; ++column)
            for (int c = 0; c < components; ++c) {
                int u = column * stepU, v = row * stepV;
                if (!topology.bicubic) {
                    appendBilinear(result.coefficients, at(u, v, c), at(u + 1, v, c),
                                   at(u, v + 1, c), at(u + 1, v + 1, c));
                    continue;
                }
                ControlNet net;
                for (int a = 0; a < 4; ++a)
                    for (int b = 0; b < 4; ++b)
                        net[a][b] = at(u + a, v + b, c);
                appendBicubic(topology, net, result.coefficients);
            }
    return result;
}

/// Of the patch that begins at a control point: its four sides.
static std::array<SideCurve, 4> sidesOf(const PatchTopology &topology,
                                        std::span<const float> points, int column, int row) {
    std::array<SideCurve, 4> sides;
    const int last = topology.degree();
    for (SideCurve &side : sides)
        side.ordinates.resize(std::size_t(last) + 1);
    for (int c = 0; c < 4; ++c) {
        ControlNet net{}, ordinates{};
        for (int a = 0; a <= last; ++a)
            for (int b = 0; b <= last; ++b) {
                int u = (column + a) % topology.uVertices, v = (row + b) % topology.vVertices;
                net[a][b] = points[(std::size_t(v) * topology.uVertices + u) * 4 + c];
            }
        if (topology.bicubic) {
            ControlNet power = bicubicCoefficients(topology, net);
            for (int k = 0; k < 4; ++k)
                for (int l = 0; l < 4; ++l)
                    for (int i = 0; i < 4; ++i)
                        for (int j = 0; j < 4; ++j)
                            ordinates[k][l] +=
                                ordinatesOfPowers[k][i] * ordinatesOfPowers[l][j] * power[i][j];
        } else {
            ordinates = net;
        }
        for (int k = 0; k <= last; ++k) {
            sides[0].ordinates[k][c] = float(ordinates[k][0]);
            sides[1].ordinates[k][c] = float(ordinates[k][last]);
            sides[2].ordinates[k][c] = float(ordinates[0][k]);
            sides[3].ordinates[k][c] = float(ordinates[last][k]);
        }
    }
    return sides;
}

MeshSides sideCurves(const PatchTopology &topology, std::span<const float> points) {
    MeshSides curves;
    const PatchGrid &grid = topology.grid;
    int stepU = topology.bicubic ? topology.uStep : 1;
    int stepV = topology.bicubic ? topology.vStep : 1;
    auto add = [&](int side, int column, int row) {
        curves[side].push_back(sidesOf(topology, points, column * stepU, row * stepV)[side]);
    };
    for (int column = 0; column < grid.u.patches; ++column)
        add(0, column, 0), add(1, column, grid.v.patches - 1);
    for (int row = 0; row < grid.v.patches; ++row)
        add(2, 0, row), add(3, grid.u.patches - 1, row);
    return curves;
}

} // namespace candela
