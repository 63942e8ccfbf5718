// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/patch_basis.h"

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
    topology.grid = {patchesAlong(mesh.uVertices, mesh.bicubic, mesh.uPeriodic, topology.uStep),
                     patchesAlong(mesh.vVertices, mesh.bicubic, mesh.vPeriodic, topology.vStep),
                     mesh.uPeriodic, mesh.vPeriodic};
    if (topology.grid.patchesU < 1 || topology.grid.patchesV < 1) {
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

/// b_k = sum over i <= k of C(k,i)/C(3,i) c_i.
constexpr double fromPower[4][4] = {
    {1, 0, 0, 0}, {1, 1.0 / 3, 0, 0}, {1, 2.0 / 3, 1.0 / 3, 0}, {1, 1, 1, 1}};

} // namespace

PatchPolynomials convertVertices(const PatchTopology &topology, std::span<const float> values,
                                 int components) {
    PatchPolynomials result{topology.degree(), components, false, {}};
    result.coefficients.reserve(std::size_t(topology.grid.patches()) * components *
                                result.coefficientCount());
    int stepU = topology.bicubic ? topology.uStep : 1,
        stepV = topology.bicubic ? topology.vStep : 1;
    auto at = [&](int column, int row, int component) {
        int vertex = row % topology.vVertices * topology.uVertices + column % topology.uVertices;
        return values[std::size_t(vertex) * components + component];
    };
    for (int row = 0; row < topology.grid.patchesV; ++row)
        for (int column = 0; column < topology.grid.patchesU; ++column)
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

BezierNet bezierNet(const PatchPolynomials &polynomials, int patch, int component) {
    const float *c = polynomials.of(patch, component);
    int size = polynomials.degree + 1;
    BezierNet net{};
    for (int k = 0; k < 4; ++k)
        for (int l = 0; l < 4; ++l)
            for (int i = 0; i < size; ++i)
                for (int j = 0; j < size; ++j)
                    net[k][l] += fromPower[k][i] * fromPower[l][j] * c[i * size + j];
    return net;
}

namespace {

/// Greatest length over a net of a difference of its points, n components.
template <class Difference>
double greatest(std::span<const BezierNet> nets, int countU, int countV, Difference difference) {
    double most = 0;
    for (int i = 0; i < countU; ++i)
        for (int j = 0; j < countV; ++j) {
            double squared = 0;
            for (const BezierNet &b : nets) {
                double d = difference(b, i, j);
                squared += d * d;
            }
            most = std::max(most, squared);
        }
    return std::sqrt(most);
}

/// Derivatives of a Bezier patch are Bezier patches of its differences: the hull bounds them.
DerivativeBounds derivativeBounds(std::span<const BezierNet> nets) {
    DerivativeBounds bounds;
    bounds.skew = true;
    bounds.du =
        3 * greatest(nets, 3, 4, [](auto &b, int i, int j) { return b[i + 1][j] - b[i][j]; });
    bounds.dv =
        3 * greatest(nets, 4, 3, [](auto &b, int i, int j) { return b[i][j + 1] - b[i][j]; });
    bounds.duu = 6 * greatest(nets, 2, 4, [](auto &b, int i, int j) {
                     return b[i + 2][j] - 2 * b[i + 1][j] + b[i][j];
                 });
    bounds.dvv = 6 * greatest(nets, 4, 2, [](auto &b, int i, int j) {
                     return b[i][j + 2] - 2 * b[i][j + 1] + b[i][j];
                 });
    bounds.duv = 9 * greatest(nets, 3, 3, [](auto &b, int i, int j) {
                     return b[i + 1][j + 1] - b[i + 1][j] - b[i][j + 1] + b[i][j];
                 });
    return bounds;
}

/// P = H/w gives w P_u = H_u - w_u P and so on; `radius` bounds |P| about the origin of H.
DerivativeBounds rationalBounds(const DerivativeBounds &h, const DerivativeBounds &w,
                                double leastWeight, double radius) {
    DerivativeBounds p;
    p.skew = true;
    p.du = (h.du + w.du * radius) / leastWeight;
    p.dv = (h.dv + w.dv * radius) / leastWeight;
    p.duu = (h.duu + 2 * w.du * p.du + w.duu * radius) / leastWeight;
    p.dvv = (h.dvv + 2 * w.dv * p.dv + w.dvv * radius) / leastWeight;
    p.duv = (h.duv + w.du * p.dv + w.dv * p.du + w.duv * radius) / leastWeight;
    return p;
}

double coefficientSum(const PatchPolynomials &positions, int patch) {
    double most = 0;
    for (int component = 0; component < 3; ++component) {
        double sum = 0;
        const float *c = positions.of(patch, component);
        for (int i = 0; i < positions.coefficientCount(); ++i)
            sum += std::abs(c[i]);
        most = std::max(most, sum);
    }
    return most;
}

} // namespace

/// Which sides are a point, by the ordinates along them.
static std::array<bool, 4> collapsedSides(std::span<const BezierNet> nets, bool rational,
                                          double tolerance) {
    auto spread = [&](auto ordinate) {
        double most = 0;
        for (int c = 0; c < 3; ++c)
            for (int k = 1; k < 4; ++k) {
                auto place = [&](int i) {
                    return ordinate(nets[c], i) / (rational ? ordinate(nets[3], i) : 1);
                };
                most = std::max(most, std::abs(place(k) - place(0)));
            }
        return most <= tolerance;
    };
    return {spread([](const BezierNet &b, int k) { return b[k][0]; }),
            spread([](const BezierNet &b, int k) { return b[k][3]; }),
            spread([](const BezierNet &b, int k) { return b[0][k]; }),
            spread([](const BezierNet &b, int k) { return b[3][k]; })};
}

PatchBounds patchBounds(const PatchPolynomials &positions, int patch) {
    std::array<BezierNet, 4> nets{};
    for (int c = 0; c < positions.components; ++c)
        nets[c] = bezierNet(positions, patch, c);
    bool rational = positions.components == 4;
    PatchBounds bounds;
    bounds.coefficientSum = coefficientSum(positions, patch);
    double leastWeight = 1e300;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            double w = rational ? nets[3][i][j] : 1;
            leastWeight = std::min(leastWeight, w);
            bounds.box.add(
                Vec3{float(nets[0][i][j] / w), float(nets[1][i][j] / w), float(nets[2][i][j] / w)});
        }
    std::span<const BezierNet> homogeneous = std::span(nets).first(3);
    bounds.collapsed =
        collapsedSides(nets, rational, 4e-7 * bounds.coefficientSum / std::min(leastWeight, 1.0));
    if (!rational) {
        bounds.derivatives = derivativeBounds(homogeneous);
        bounds.derivatives.ruled = positions.degree == 1;
        return bounds;
    }
    bounds.valid = leastWeight > 0;
    // About the middle of the box, where the quotient's terms are smallest.
    Vec3 centre = bounds.box.centre();
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            for (int c = 0; c < 3; ++c)
                nets[c][i][j] -= nets[3][i][j] * centre[c];
    bounds.derivatives =
        rationalBounds(derivativeBounds(homogeneous), derivativeBounds(std::span(nets).last(1)),
                       leastWeight, 0.5 * length(bounds.box.extent()));
    bounds.coefficientSum *= 1 / leastWeight;
    return bounds;
}

Vec3 SideCurve::at(int step, int steps) const {
    double w = double(step) / steps, r = double(steps - step) / steps;
    double place[4];
    for (int c = 0; c < 4; ++c) {
        double first = ordinates[0][c], last = ordinates[3][c];
        // The same sums whichever end comes first.
        place[c] = degree == 1
                       ? first * r + last * w
                       : (first * (r * r * r) + last * (w * w * w)) +
                             3 * (ordinates[1][c] * (r * r * w) + ordinates[2][c] * (w * w * r));
    }
    return {float(place[0] / place[3]), float(place[1] / place[3]), float(place[2] / place[3])};
}

/// Of the patch that begins at a control point: its four sides.
static std::array<SideCurve, 4> sidesOf(const PatchTopology &topology,
                                        std::span<const float> points, int column, int row) {
    std::array<SideCurve, 4> sides;
    int last = topology.degree();
    for (SideCurve &side : sides)
        side.degree = last;
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
                            ordinates[k][l] += fromPower[k][i] * fromPower[l][j] * power[i][j];
        } else {
            ordinates[0][0] = net[0][0], ordinates[3][0] = net[1][0];
            ordinates[0][3] = net[0][1], ordinates[3][3] = net[1][1];
        }
        for (int k = 0; k < 4; ++k) {
            sides[0].ordinates[k][c] = float(ordinates[k][0]);
            sides[1].ordinates[k][c] = float(ordinates[k][3]);
            sides[2].ordinates[k][c] = float(ordinates[0][k]);
            sides[3].ordinates[k][c] = float(ordinates[3][k]);
        }
    }
    return sides;
}

std::array<std::vector<SideCurve>, 4> sideCurves(const PatchTopology &topology,
                                                 std::span<const float> points) {
    std::array<std::vector<SideCurve>, 4> curves;
    const PatchGrid &grid = topology.grid;
    int stepU = topology.bicubic ? topology.uStep : 1;
    int stepV = topology.bicubic ? topology.vStep : 1;
    auto add = [&](int side, int column, int row) {
        curves[side].push_back(sidesOf(topology, points, column * stepU, row * stepV)[side]);
    };
    for (int column = 0; column < grid.patchesU; ++column)
        add(0, column, 0), add(1, column, grid.patchesV - 1);
    for (int row = 0; row < grid.patchesV; ++row)
        add(2, 0, row), add(3, grid.patchesU - 1, row);
    return curves;
}

/// Do the last ordinates of one net along u (or v) equal the first of the next?
static bool netsMeet(const BezierNet &here, const BezierNet &next, bool alongU, double tolerance) {
    for (int k = 0; k < 4; ++k) {
        double end = alongU ? here[3][k] : here[k][3], start = alongU ? next[0][k] : next[k][0];
        if (!(std::abs(end - start) <= tolerance))
            return false;
    }
    return true;
}

bool patchesMeet(const PatchGrid &grid, const PatchPolynomials &positions, double tolerance) {
    for (int patch = 0; patch < grid.patches(); ++patch)
        for (int c = 0; c < positions.components; ++c) {
            BezierNet here = bezierNet(positions, patch, c);
            bool lastColumn = (patch + 1) % grid.patchesU == 0;
            bool lastRow = patch + grid.patchesU >= grid.patches();
            if (!lastColumn && !netsMeet(here, bezierNet(positions, patch + 1, c), true, tolerance))
                return false;
            if (!lastRow &&
                !netsMeet(here, bezierNet(positions, patch + grid.patchesU, c), false, tolerance))
                return false;
        }
    return true;
}

} // namespace candela
