// SPDX-License-Identifier: Apache-2.0
// Subdivision surfaces against closed forms and against refinement by hand.
#include "world/geometry/test_support.h"

#include <cmath>
#include <map>

namespace candela {
namespace {

using namespace geometrytest;

struct Mesh {
    std::string name;
    SubdivisionRecord faces;
    std::vector<float> points;
    bool isClosed = true;
};

Mesh mesh(std::string name, std::vector<std::vector<int>> faces, std::vector<float> points,
          bool isClosed = true) {
    Mesh result{std::move(name), {}, std::move(points), isClosed};
    for (const auto &face : faces) {
        result.faces.vertexCounts.push_back(int(face.size()));
        result.faces.vertices.insert(result.faces.vertices.end(), face.begin(), face.end());
    }
    return result;
}

Mesh cube() {
    return mesh(
        "cube",
        {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}},
        {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1});
}

/// A prism over n corners: valence 3 everywhere; or, pointed, one vertex of valence n.
Mesh prism(int n, bool isPointed) {
    std::vector<std::vector<int>> faces(isPointed ? 1 : 2);
    std::vector<float> points;
    const auto angle = [&](int i) { return 2 * std::numbers::pi * i / n; };
    for (int i = 0; i < n; ++i) {
        const int next = (i + 1) % n;
        points.insert(points.end(), {float(std::cos(angle(i))), float(std::sin(angle(i))), 0.0f});
        faces[0].insert(faces[0].begin(), i);
        if (isPointed) {
            faces.push_back({i, next, n});
        } else {
            faces[1].push_back(n + i);
            faces.push_back({i, next, n + next, n + i});
        }
    }
    for (int i = 0; i < (isPointed ? 1 : n); ++i)
        points.insert(points.end(), {isPointed ? 0.1f : float(1.5 * std::cos(angle(i))),
                                     isPointed ? 0.2f : float(std::sin(angle(i))), 1.3f});
    return mesh((isPointed ? "pyramid over " : "prism over ") + std::to_string(n), faces, points);
}

Mesh grid(int columns, int rows, int interpolateBoundary) {
    std::vector<std::vector<int>> faces;
    std::vector<float> points;
    for (int j = 0; j <= rows; ++j)
        for (int i = 0; i <= columns; ++i) {
            const int at = j * (columns + 1) + i;
            points.insert(points.end(), {float(i) + 0.2f * float(j % 2), float(j),
                                         0.5f * std::sin(1.7f * float(i) + float(j * j))});
            if (i < columns && j < rows)
                faces.push_back({at, at + 1, at + columns + 2, at + columns + 1});
        }
    Mesh result = mesh("grid " + std::to_string(interpolateBoundary), faces, points, false);
    result.faces.interpolateBoundary = interpolateBoundary;
    return result;
}

std::vector<Mesh> meshes() {
    std::vector<Mesh> all{cube(), grid(5, 4, 0), grid(5, 4, 1), grid(3, 3, 2)};
    for (int n : {3, 4, 5, 8}) {
        all.push_back(prism(n, false));
        all.push_back(prism(n, true));
    }
    for (float sharpness : {0.7f, 2.5f, 10.0f}) {
        Mesh creased = cube();
        creased.name = "cube with creases of " + std::to_string(sharpness);
        creased.faces.creases = {{{0, 1, 3}, sharpness}, {{4, 5}, 1.5f * sharpness}};
        creased.faces.corners = {{6, sharpness}};
        all.push_back(creased);
    }
    Mesh holed = cube();
    holed.name = "cube with a hole", holed.isClosed = false;
    holed.faces.holes = {2};
    all.push_back(holed);
    Mesh bilinear = prism(5, false);
    bilinear.name = "bilinear prism";
    bilinear.faces.scheme = SubdivisionRecord::Scheme::Bilinear;
    all.push_back(bilinear);
    Mesh fins =
        mesh("three fins", {{0, 1, 3, 2}, {0, 1, 5, 4}, {0, 1, 7, 6}},
             {0, 0, 0, 0, 0, 1, 1, 0, 0, 1, 0, 1, -1, 1, 0, -1, 1, 1, -1, -1, 0, -1, -1, 1}, false);
    fins.faces.interpolateBoundary = 1;
    all.push_back(fins);
    return all;
}

std::shared_ptr<const Surface> made(const Mesh &mesh, std::vector<Parameter> more = {}) {
    more.push_back(parameter("P", StorageClass::Vertex, ValueType::Point, mesh.points));
    return surfaceOf(mesh.faces, std::move(more));
}

TEST(SubdivisionSurfaces, CubesHaveTheirClosedForm) {
    const auto surface = made(cube());
    ASSERT_EQ(surface->domain().pieces, 6u);
    for (std::uint32_t piece = 0; piece < 6; ++piece) {
        for (float u : {0.0f, 1.0f})
            for (float v : {0.0f, 1.0f}) {
                const Point p = at(*surface, u, v, piece);
                for (int axis = 0; axis < 3; ++axis) {
                    EXPECT_NEAR(std::abs(p.P[axis]), 0.5, 1e-6);
                    EXPECT_NEAR(std::abs(normalize(p.Ng)[axis]), std::sqrt(1 / 3.0), 1e-5);
                }
                EXPECT_GT(dot(p.P, p.Ng), 0);
            }
        EXPECT_NEAR(length(at(*surface, 0.5f, 0.5f, piece).P), 30.0 / 36 + 2.0 / 324, 1e-5);
    }
}

TEST(SubdivisionSurfaces, InfinitelySharpCubesAreCubes) {
    Mesh sharp = cube();
    sharp.faces.creases = {{{0, 1, 3, 2, 0}, 10}, {{4, 5, 7, 6, 4}, 10}, {{0, 4}, 10},
                           {{1, 5}, 12},          {{2, 6}, 1e9f},        {{3, 7}, 10}};
    const auto surface = made(sharp);
    EXPECT_NEAR(surface->area(), 24, 1e-4);
    for (Vec3 p : surface->dice({0.3f, 1e9f}).positions)
        EXPECT_NEAR(std::max({std::abs(p.x), std::abs(p.y), std::abs(p.z)}), 1, 1e-6);
}

/// Where all vertices have four neighbours the surface is a uniform B-spline.
TEST(SubdivisionSurfaces, RegularMeshesAreBSplines) {
    const Mesh sheet = grid(5, 4, 0);
    const auto surface = made(sheet);
    ASSERT_EQ(surface->domain().pieces, 6u); // Without the faces at the boundary.
    Attributes attributes;
    attributes.uBasis =
        attributes.vBasis = {{-1.f / 6, 3.f / 6, -3.f / 6, 1.f / 6, 3.f / 6, -6.f / 6, 3.f / 6, 0,
                              -3.f / 6, 0, 3.f / 6, 0, 1.f / 6, 4.f / 6, 1.f / 6, 0},
                             1};
    PatchMeshRecord patches;
    patches.bicubic = true, patches.uVertices = 6, patches.vVertices = 5;
    const auto spline =
        surfaceOf(patches, {parameter("P", StorageClass::Vertex, ValueType::Point, sheet.points)},
                  attributes);
    for (std::uint32_t piece = 0; piece < 6; ++piece)
        for (float u : {0.1f, 0.5f, 0.93f})
            for (float v : {0.2f, 0.66f}) {
                const Point here = at(*surface, u, v, piece);
                const Point there =
                    at(*spline, (float(piece % 3) + u) / 3, (float(piece / 3) + v) / 2);
                EXPECT_LT(length(here.P - there.P), 1e-5);
                EXPECT_LT(length(here.dPdu - there.dPdu / 3.0f), 1e-4);
                EXPECT_LT(length(here.dPdv - there.dPdv / 2.0f), 1e-4);
            }
}

/// Catmull and Clark's rules for closed meshes without creases, written down once more. Every
/// corner of a face knows where on which piece it is.
struct ByHand {
    struct Corner {
        int vertex;
        float u, v;
    };
    struct Face {
        std::vector<Corner> corners;
        std::uint32_t piece = 0; ///< The first, of a face that consists of several.
    };
    std::vector<Vec3> points;
    std::vector<Face> faces;

    explicit ByHand(const Mesh &mesh) {
        for (std::size_t i = 0; i < mesh.points.size(); i += 3)
            points.push_back({mesh.points[i], mesh.points[i + 1], mesh.points[i + 2]});
        std::size_t next = 0;
        std::uint32_t piece = 0;
        for (int count : mesh.faces.vertexCounts) {
            Face face{{}, piece};
            for (int k = 0; k < count; ++k)
                face.corners.push_back({mesh.faces.vertices[next++], float(k == 1 || k == 2),
                                        float(k == 2 || k == 3)});
            piece += count == 4 ? 1 : std::uint32_t(count);
            faces.push_back(std::move(face));
        }
    }

    Vec3 middle(const Face &face) const {
        Vec3 sum;
        for (const Corner &c : face.corners)
            sum += points[c.vertex];
        return sum / float(face.corners.size());
    }

    void refine() {
        std::map<std::pair<int, int>, Vec3> edgeSums; // Of the middles of both faces.
        std::map<int, Vec3> faceSums, neighbourSums;
        std::map<int, float> valence;
        for (const Face &face : faces)
            for (std::size_t k = 0; k < face.corners.size(); ++k) {
                const int a = face.corners[k].vertex;
                const int b = face.corners[(k + 1) % face.corners.size()].vertex;
                edgeSums[std::minmax(a, b)] += middle(face);
                faceSums[a] += middle(face);
                neighbourSums[a] += points[b];
                valence[a] += 1;
            }
        ByHand finer = *this;
        finer.faces.clear();
        for (const auto &[vertex, n] : valence)
            finer.points[vertex] =
                (faceSums[vertex] / n + neighbourSums[vertex] / n + points[vertex] * (n - 2)) / n;
        std::map<std::pair<int, int>, int> edgeVertex;
        for (const auto &[edge, sum] : edgeSums) {
            edgeVertex[edge] = int(finer.points.size());
            finer.points.push_back((points[edge.first] + points[edge.second] + sum) / 4.0f);
        }
        for (const Face &face : faces) {
            const int centre = int(finer.points.size()), n = int(face.corners.size());
            finer.points.push_back(middle(face));
            for (int k = 0; k < n; ++k) {
                const Corner &c = face.corners[k], &after = face.corners[(k + 1) % n],
                             &before = face.corners[(k + n - 1) % n];
                const int right = edgeVertex[std::minmax(c.vertex, after.vertex)];
                const int left = edgeVertex[std::minmax(c.vertex, before.vertex)];
                if (n != 4) {
                    finer.faces.push_back(
                        {{{c.vertex, 0, 0}, {right, 1, 0}, {centre, 1, 1}, {left, 0, 1}},
                         face.piece + std::uint32_t(k)});
                    continue;
                }
                const Corner &across = face.corners[(k + 2) % 4];
                finer.faces.push_back({{c,
                                        {right, (c.u + after.u) / 2, (c.v + after.v) / 2},
                                        {centre, (c.u + across.u) / 2, (c.v + across.v) / 2},
                                        {left, (c.u + before.u) / 2, (c.v + before.v) / 2}},
                                       face.piece});
            }
        }
        *this = std::move(finer);
    }

    /// Where each vertex of a mesh of quadrilaterals goes in the end.
    std::map<int, Vec3> limits() const {
        std::map<int, Vec3> edges, diagonals, result;
        std::map<int, float> valence;
        for (const Face &face : faces)
            for (int k = 0; k < 4; ++k) {
                const int a = face.corners[k].vertex;
                edges[a] += points[face.corners[(k + 1) % 4].vertex];
                diagonals[a] += points[face.corners[(k + 2) % 4].vertex];
                valence[a] += 1;
            }
        for (const auto &[a, n] : valence)
            result[a] = (points[a] * (n * n) + edges[a] * 4.0f + diagonals[a]) / (n * (n + 5));
        return result;
    }
};

TEST(SubdivisionSurfaces, AreWhereRefinementByHandEnds) {
    for (const Mesh &mesh : meshes()) {
        if (!mesh.isClosed || !mesh.faces.creases.empty() ||
            mesh.faces.scheme != SubdivisionRecord::Scheme::CatmullClark)
            continue;
        const auto surface = made(mesh);
        ByHand byHand(mesh);
        for (int level = 1; level <= 4; ++level) {
            byHand.refine();
            const auto limits = byHand.limits();
            for (const auto &face : byHand.faces)
                for (const auto &corner : face.corners) {
                    const Point p = at(*surface, corner.u, corner.v, face.piece);
                    EXPECT_LT(length(p.P - limits.at(corner.vertex)), 2e-6)
                        << mesh.name << " piece " << face.piece << " " << corner.u << " "
                        << corner.v;
                }
        }
    }
}

TEST(SubdivisionSurfaces, ChordErrorIsCertifiedAndTrianglesAreCounted) {
    for (const Mesh &mesh : meshes()) {
        const auto surface = made(mesh);
        for (DiceRate rate :
             {DiceRate{1e9f, 1e9f}, {1e9f, 0.1f}, {1e9f, 1e-2f}, {1e9f, 3e-3f}, {0.2f, 1e9f}}) {
            const DicedMesh diced = surface->dice(rate);
            EXPECT_LE(diced.chordError, rate.chordError + 1e-5f) << mesh.name;
            EXPECT_LE(sampledChordError(*surface, diced, 3), diced.chordError) << mesh.name;
            EXPECT_EQ(surface->triangleCount(rate), double(diced.triangles.size())) << mesh.name;
            for (const auto &t : diced.triangles)
                for (int k = 0; k < 3; ++k)
                    EXPECT_LE(length(diced.positions[t[k]] - diced.positions[t[(k + 1) % 3]]),
                              rate.edgeLength);
            if (mesh.isClosed) {
                EXPECT_EQ(borderEdges(diced), 0) << mesh.name << " " << rate.chordError;
            }
        }
    }
}

/// Faces of very different sizes and bends beside each other are cut differently.
TEST(SubdivisionSurfaces, FacesOfAllRatesShareTheirEdges) {
    std::mt19937 random(4);
    std::uniform_real_distribution<float> uniform(-1, 1);
    for (Mesh mesh : {prism(5, false), prism(7, true), cube()})
        for (int trial = 0; trial < 10; ++trial) {
            for (std::size_t i = 0; i < mesh.points.size(); ++i)
                mesh.points[i] += (trial % 3 == 0 && i < 6 ? 6.0f : 0.3f) * uniform(random);
            const auto surface = made(mesh);
            const DicedMesh diced = surface->dice({1e9f, 0.02f});
            std::map<std::uint32_t, std::size_t> trianglesOf;
            for (std::uint32_t piece : diced.pieces)
                ++trianglesOf[piece];
            EXPECT_EQ(borderEdges(diced), 0) << mesh.name << " " << trial;
            EXPECT_EQ(trianglesOf.size(), surface->domain().pieces);
            EXPECT_LE(sampledChordError(*surface, diced, 3), diced.chordError) << mesh.name;
        }
}

TEST(SubdivisionSurfaces, NormalsTurnAsTheirDerivativesSay) {
    const float h = 1e-3f;
    for (const Mesh &mesh : meshes()) {
        const auto surface = made(mesh);
        for (std::uint32_t piece = 0; piece < surface->domain().pieces; ++piece)
            for (float u : {0.31f, 0.62f})
                for (float v : {0.27f, 0.81f}) {
                    Vec3 dNdu, dNdv, Ng;
                    SurfaceAnswer answer;
                    answer.Ng = {&Ng.x, &Ng.y, &Ng.z};
                    answer.dNgdu = {&dNdu.x, &dNdu.y, &dNdu.z};
                    answer.dNgdv = {&dNdv.x, &dNdv.y, &dNdv.z};
                    surface->evaluate({1, &piece, &u, &v}, answer);
                    const auto unit = [&](float du, float dv) {
                        return normalize(at(*surface, u + du, v + dv, piece).Ng);
                    };
                    const Vec3 byU = (unit(h, 0) - unit(-h, 0)) / (2 * h);
                    const Vec3 byV = (unit(0, h) - unit(0, -h)) / (2 * h);
                    const float scale = 1 + length(byU) + length(byV);
                    EXPECT_LT(length(byU - dNdu), 2e-2f * scale) << mesh.name << " " << piece;
                    EXPECT_LT(length(byV - dNdv), 2e-2f * scale) << mesh.name << " " << piece;
                }
    }
}

TEST(SubdivisionSurfaces, AreFiniteEverywhere) {
    for (const Mesh &mesh : meshes()) {
        const auto surface = made(mesh);
        EXPECT_GT(surface->area(), 0) << mesh.name;
        for (std::uint32_t piece = 0; piece < surface->domain().pieces; ++piece)
            for (float u : {0.0f, 1e-7f, 0.5f, 1.0f})
                for (float v : {0.0f, 0.25f, 1 - 6e-8f, 1.0f}) {
                    const Point p = at(*surface, u, v, piece);
                    for (Vec3 x : {p.P, p.Ng, p.dPdu, p.dPdv})
                        EXPECT_TRUE(isFinite(x)) << mesh.name << " " << piece;
                    EXPECT_GT(length(p.Ng), 0) << mesh.name << " " << piece << " " << u << " " << v;
                }
    }
}

TEST(SubdivisionSurfaces, VariablesOfAllClasses) {
    const Mesh body = prism(5, false); // Two pentagons, then five quadrilaterals.
    std::vector<float> vertex, face, corner;
    for (int i = 0; i < 10; ++i)
        vertex.push_back(float(i * i));
    for (int i = 0; i < 7; ++i)
        face.push_back(float(10 * i));
    for (int i = 0; i < 30; ++i)
        corner.push_back(float(100 + i));
    const auto of = [](const char *name, StorageClass storage, std::vector<float> values) {
        return parameter(name, storage, ValueType::Float, std::move(values));
    };
    const auto surface =
        made(body,
             {of("one", StorageClass::Constant, {5}), of("face", StorageClass::Uniform, face),
              of("even", StorageClass::Varying, vertex), of("smooth", StorageClass::Vertex, vertex),
              of("corner", StorageClass::FaceVarying, corner),
              of("loose", StorageClass::FaceVertex, corner)});
    const auto value = [&](const char *name, float u, float v, std::uint32_t piece) {
        return variable(*surface, name, u, v, piece).value[0];
    };
    EXPECT_EQ(value("one", 0.3f, 0.8f, 4), 5);
    // Pieces 0 to 4 are face 0, whose vertices are 4, 3, 2, 1, 0; piece 12 is face 4: 2, 3, 8, 7.
    EXPECT_EQ(value("face", 0.3f, 0.8f, 3), 0);
    EXPECT_EQ(value("face", 0.3f, 0.8f, 12), 40);
    EXPECT_FLOAT_EQ(value("even", 0, 0, 1), 9);
    EXPECT_FLOAT_EQ(value("even", 1, 0, 1), (9 + 4) / 2.0f);
    EXPECT_FLOAT_EQ(value("even", 0, 1, 1), (9 + 16) / 2.0f);
    EXPECT_FLOAT_EQ(value("even", 1, 1, 1), (16 + 9 + 4 + 1 + 0) / 5.0f);
    EXPECT_FLOAT_EQ(value("even", 0.5f, 0, 12), (4 + 9) / 2.0f);
    EXPECT_FLOAT_EQ(value("even", 1, 1, 12), 64);
    EXPECT_FLOAT_EQ(variable(*surface, "even", 0.5f, 0.5f, 12).du[0], ((9 - 4) + (64 - 49)) / 2.0f);
    EXPECT_FLOAT_EQ(value("corner", 0, 0, 12), 100 + 10 + 8);
    EXPECT_FLOAT_EQ(value("corner", 1, 1, 12), 100 + 10 + 8 + 2);
    // Each corner's value is its own: a region of one face, with sharp corners.
    EXPECT_NEAR(value("loose", 0, 0, 12), 100 + 10 + 8, 1e-4);
    EXPECT_NEAR(value("loose", 1, 0, 12), 100 + 10 + 8 + 1, 1e-4);
    // As positions are subdivided: x of the mesh as a variable is the surface's x.
    std::vector<float> x, xOfCorners;
    for (int i = 0; i < 10; ++i)
        x.push_back(body.points[std::size_t(3 * i)]);
    for (int i : body.faces.vertices)
        xOfCorners.push_back(x[std::size_t(i)]);
    const auto same = made(body, {of("x", StorageClass::Vertex, x),
                                  of("joined", StorageClass::FaceVertex, xOfCorners)});
    for (std::uint32_t piece = 0; piece < 15; ++piece)
        for (float u : {0.0f, 0.4f, 0.9f}) {
            const Point p = at(*same, u, 0.7f, piece);
            for (const char *name : {"x", "joined"}) {
                const Value found = variable(*same, name, u, 0.7f, piece);
                EXPECT_NEAR(found.value[0], p.P.x, 1e-6) << name;
                EXPECT_NEAR(found.du[0], p.dPdu.x, 1e-5) << name;
            }
            EXPECT_FLOAT_EQ(variable(*same, "s", u, 0.7f, piece).value[0], u);
        }
}

TEST(BadSubdivisionSurfaces, AreReportedAndLeftOut) {
    const auto reported = [](Mesh mesh) {
        DiagnosticList diagnostics;
        const auto surfaces = makeSurfaces(
            record(mesh.faces,
                   {parameter("P", StorageClass::Vertex, ValueType::Point, mesh.points)}),
            {}, diagnostics);
        return std::pair{surfaces.size(), diagnostics.text()};
    };
    Mesh twice = mesh("", {{0, 1, 1, 2}}, {0, 0, 0, 1, 0, 0, 0, 1, 0});
    EXPECT_EQ(reported(twice).first, 0u);
    EXPECT_NE(reported(twice).second, "");
    Mesh alone = grid(1, 1, 0);
    EXPECT_EQ(reported(alone).first, 0u);
    EXPECT_NE(reported(alone).second.find("interpolateboundary"), std::string::npos);
    Mesh flat = cube();
    flat.points.assign(24, 0.25f);
    EXPECT_EQ(reported(flat).first, 0u);
    Mesh stray = cube();
    stray.faces.creases = {{{0, 7}, 2}};
    EXPECT_EQ(reported(stray).first, 1u);
    EXPECT_NE(reported(stray).second.find("no edge"), std::string::npos);
}

} // namespace
} // namespace candela
