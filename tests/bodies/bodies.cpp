// SPDX-License-Identifier: Apache-2.0
#include "tests/bodies/bodies.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>

namespace candela::test {

namespace {

using Point = std::array<double, 3>;
using Face = std::array<Point, 4>;

std::vector<double> flatten(const std::vector<Point> &points, double away) {
    std::vector<double> values;
    for (const Point &p : points)
        for (double coordinate : p)
            values.push_back(coordinate + away);
    return values;
}

/// A face of the cube of half-width 1, its corners so that (P1-P0)x(P2-P0) points outward.
Face cubeFace(int axis, double sign) {
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    Face face;
    const double around[4][2] = {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
    for (int i = 0; i < 4; ++i) {
        face[i][axis] = sign;
        face[i][next] = around[i][0] * sign;
        face[i][last] = around[i][1];
    }
    return face;
}

std::vector<Face> cube() {
    std::vector<Face> faces;
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {-1., 1.})
            faces.push_back(cubeFace(axis, sign));
    return faces;
}

std::vector<Point> pointsOf(const std::vector<Face> &faces) {
    std::vector<Point> points;
    for (const Face &face : faces)
        points.insert(points.end(), face.begin(), face.end());
    return points;
}

/// A cube whose upper side has a square hole, and over that a smaller box without a floor. The
/// first face is the one with the hole; `hole` is the hole's loop.
struct Chimney {
    std::vector<Face> faces;
    Face hole;
};

Chimney chimney() {
    Chimney body;
    body.faces.push_back(cubeFace(2, 1));
    body.hole = body.faces[0];
    for (int axis = 0; axis < 3; ++axis)
        for (double sign : {-1., 1.})
            if (axis < 2 || sign < 0)
                body.faces.push_back(cubeFace(axis, sign));
    for (Point &p : body.hole)
        p[0] *= .25, p[1] *= .25;
    for (int i = 0; i < 4; ++i) {
        Point a = body.hole[i], b = body.hole[(i + 1) % 4], c = b, d = a;
        c[2] = d[2] = 1.5;
        body.faces.push_back({a, b, c, d});
    }
    Face lid = body.hole;
    for (Point &p : lid)
        p[2] = 1.5;
    body.faces.push_back(lid);
    return body;
}

std::string polygon(const Face &face, double away) {
    return "Polygon \"P\" " + array(flatten({face.begin(), face.end()}, away)) + "\n";
}

std::string polygons(double away) {
    std::string rib;
    for (const Face &face : cube())
        rib += polygon(face, away);
    return rib;
}

std::string generalPolygons(double away) {
    const Chimney body = chimney();
    std::string rib = "GeneralPolygon [4 4] \"P\" " +
                      array(flatten(pointsOf({body.faces[0], body.hole}), away)) + "\n";
    for (std::size_t i = 1; i < body.faces.size(); ++i)
        rib += polygon(body.faces[i], away);
    return rib;
}

/// Corners in the same place are one vertex.
struct Mesh {
    std::vector<Point> vertices;
    std::vector<double> indices;
    void add(const Face &face) {
        for (const Point &p : face) {
            std::size_t i = 0;
            while (i < vertices.size() && vertices[i] != p)
                ++i;
            if (i == vertices.size())
                vertices.push_back(p);
            indices.push_back(double(i));
        }
    }
};

std::string pointsPolygons(double away) {
    Mesh mesh;
    for (const Face &face : cube())
        mesh.add(face);
    return "PointsPolygons [4 4 4 4 4 4] " + array(mesh.indices) + " \"P\" " +
           array(flatten(mesh.vertices, away)) + "\n";
}

std::string pointsGeneralPolygons(double away) {
    const Chimney body = chimney();
    Mesh mesh;
    std::vector<double> loops, counts;
    for (std::size_t i = 0; i < body.faces.size(); ++i) {
        mesh.add(body.faces[i]);
        loops.push_back(1), counts.push_back(4);
        if (i == 0)
            mesh.add(body.hole), loops[0] = 2, counts.push_back(4);
    }
    return "PointsGeneralPolygons " + array(loops) + " " + array(counts) + " " +
           array(mesh.indices) + " \"P\" " + array(flatten(mesh.vertices, away)) + "\n";
}

std::string bilinearPatches(double away) {
    std::string rib;
    for (const Face &f : cube())
        rib += "Patch \"bilinear\" \"P\" " + array(flatten({f[0], f[1], f[3], f[2]}, away)) + "\n";
    return rib;
}

/// A cube blown up: control points between the corners are moved outward, by sums that are the
/// same for a point in all of its sides.
std::string bicubicPatches(double away) {
    std::string rib;
    for (const Face &f : cube()) {
        std::vector<Point> net;
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                Point p;
                double squared = 0;
                for (int axis = 0; axis < 3; ++axis) {
                    const double along = f[0][axis] * (3 - i) * (3 - j) + f[1][axis] * i * (3 - j) +
                                         f[3][axis] * (3 - i) * j + f[2][axis] * i * j;
                    p[axis] = std::round(along / 3) / 3; // Thirds of the half-width.
                    squared += p[axis] * p[axis];
                }
                for (double &coordinate : p)
                    coordinate *= 1 + .15 * (3 - squared);
                net.push_back(p);
            }
        rib += "Patch \"bicubic\" \"P\" " + array(flatten(net, away)) + "\n";
    }
    return rib;
}

/// Two poles, to which whole sides collapse, and two rings of four points; around, it is periodic.
std::string bilinearMesh(double away) {
    std::vector<Point> net;
    for (auto [z, radius] : {std::pair{-2., 0.}, {-1., 1.5}, {1., 1.5}, {2., 0.}})
        for (int i = 0; i < 4; ++i) {
            const double turn = std::numbers::pi / 2 * i;
            net.push_back(
                {std::round(std::cos(turn)) * radius, std::round(std::sin(turn)) * radius, z});
        }
    return "PatchMesh \"bilinear\" 4 \"periodic\" 4 \"nonperiodic\" \"P\" " +
           array(flatten(net, away)) + "\n";
}

/// A ring, periodic both ways, about an axis that stands beside the origin.
std::string splineMesh(double away) {
    std::vector<Point> net;
    for (int j = 0; j < 6; ++j)
        for (int i = 0; i < 8; ++i) {
            const double turn = std::numbers::pi / 4 * i, tube = std::numbers::pi / 3 * j;
            const double radius = 2 + std::cos(tube);
            net.push_back({radius * std::cos(turn) - 1.8, radius * std::sin(turn), std::sin(tube)});
        }
    return "Basis \"b-spline\" 1 \"b-spline\" 1\n"
           "PatchMesh \"bicubic\" 8 \"periodic\" 6 \"periodic\" \"P\" " +
           array(flatten(net, away)) + "\n";
}

/// Catmull and Clark's cube, with one pair of its edges half sharp.
std::string subdividedCube(double away) {
    Mesh mesh;
    for (const Face &face : cube())
        mesh.add(face);
    return "SubdivisionMesh \"catmull-clark\" [4 4 4 4 4 4] " + array(mesh.indices) +
           " [\"crease\"] [4 1] " +
           array({mesh.indices[0], mesh.indices[1], mesh.indices[2], mesh.indices[3]}) +
           " [1.5] \"P\" " + array(flatten(mesh.vertices, away)) + "\n";
}

/// Loop's, of the cube's halved faces, with the edges of one of them half sharp.
std::string loopCube(double away) {
    Mesh mesh;
    for (const Face &face : cube())
        mesh.add(face);
    std::vector<double> triangles;
    for (std::size_t first = 0; first < mesh.indices.size(); first += 4)
        for (std::size_t k : {0, 1, 2, 0, 2, 3})
            triangles.push_back(mesh.indices[first + k]);
    return "SubdivisionMesh \"loop\" [3 3 3 3 3 3 3 3 3 3 3 3] " + array(triangles) +
           " [\"crease\"] [4 1] " +
           array({mesh.indices[0], mesh.indices[1], mesh.indices[2], mesh.indices[3]}) +
           " [1.5] \"P\" " + array(flatten(mesh.vertices, away)) + "\n";
}

/// The unit sphere as half a circle that is turned about z, both as rational parabolas.
std::string rationalSphere() {
    const double x[] = {1, 1, 0, -1, -1, -1, 0, 1, 1}, y[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    const double radius[] = {0, 1, 1, 1, 0}, z[] = {-1, -1, 0, 1, 1};
    std::vector<double> points;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 9; ++i) {
            const double w = (i % 2 ? std::sqrt(.5) : 1) * (j % 2 ? std::sqrt(.5) : 1);
            for (double number : {radius[j] * x[i] * w, radius[j] * y[i] * w, z[j] * w, w})
                points.push_back(number);
        }
    return "NuPatch 9 3 [0 0 0 1 1 2 2 3 3 4 4 4] 0 4 5 3 [0 0 0 1 1 2 2 2] 0 2 \"Pw\" " +
           array(points) + "\n";
}

std::string beside(double x, double z, const std::string &rib) {
    return "Translate " + std::to_string(x) + " 0 " + std::to_string(z) + "\n" + rib;
}

} // namespace

std::string array(const std::vector<double> &values) {
    std::string text = "[";
    for (double value : values) {
        char number[32];
        std::snprintf(number, sizeof number, "%.9g ", value);
        text += number;
    }
    return text + "]";
}

std::vector<Body> bodiesAway(double away) {
    return {{"Polygon", polygons(away)},
            {"GeneralPolygon", generalPolygons(away)},
            {"PointsPolygons", pointsPolygons(away)},
            {"PointsGeneralPolygons", pointsGeneralPolygons(away)},
            {"BilinearPatch", bilinearPatches(away)},
            {"BicubicPatch", bicubicPatches(away), true},
            {"BilinearMesh", bilinearMesh(away)},
            {"BicubicMesh", splineMesh(away), true},
            {"SubdivisionMesh", subdividedCube(away), true},
            {"LoopMesh", loopCube(away), true}};
}

std::vector<Body> bodiesWithNormals(bool inward) {
    std::string polygons, patches;
    for (const Face &f : cube()) {
        Point normal{};
        for (int axis = 0; axis < 3; ++axis)
            normal[axis] = (f[0][axis] + f[2][axis]) / (inward ? -2 : 2);
        const std::string N =
            " \"N\" " + array(flatten({normal, normal, normal, normal}, 0)) + "\n";
        const std::vector<Point> loop =
            inward ? std::vector{f[0], f[3], f[2], f[1]} : std::vector{f[0], f[1], f[2], f[3]};
        polygons += "Polygon \"P\" " + array(flatten(loop, 0)) + N;
        patches += "Patch \"bilinear\" \"P\" " +
                   array(flatten({loop[0], loop[1], loop[3], loop[2]}, 0)) + N;
    }
    return {{"Polygon", polygons}, {"BilinearPatch", patches}};
}

// Negative sweeps turn a quadric's outside round.
std::vector<Body> closedBodies() {
    std::vector<Body> bodies{
        {"Sphere", "Sphere 1 -1 1 360\n"},
        {"SphereZone", "Sphere 1 -.6 .8 360\nDisk -.6 .8 -360\nDisk .8 .6 360\n", true},
        {"Cylinder", "Cylinder 1 -1 1 360\nDisk -1 1 -360\nDisk 1 1 360\n", true},
        {"Cone", beside(0, -1, "Cone 3 2 360\nDisk 0 2 -360\n"), true},
        {"Paraboloid", beside(0, -1.2, "Paraboloid 1.5 0 2 360\nDisk 2 1.5 360\n"), true},
        {"Hyperboloid", "Hyperboloid 1 0 -1 .6 .8 1 360\nDisk -1 1 -360\nDisk 1 1 360\n", true},
        {"Washer",
         beside(-1.25, 0,
                "Cylinder 2 -.5 .5 360\nCylinder .5 -.5 .5 -360\n"
                "Hyperboloid .5 0 -.5 2 0 -.5 360\nHyperboloid .5 0 .5 2 0 .5 -360\n"),
         true, true},
        {"Torus", beside(-2, 0, "Torus 2 .8 0 360 360\n"), true, true},
        {"NuPatch", rationalSphere(), true},
        {"SphereSlices", "Sphere 1 -1 1 140\nRotate 140 0 0 1\nSphere 1 -1 1 220\n", true}};
    for (const Body &body : bodiesAway(0))
        bodies.push_back(body);
    return bodies;
}

} // namespace candela::test
