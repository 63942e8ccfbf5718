// SPDX-License-Identifier: Apache-2.0
// Geometric primitives (RI 3.2, section 5) whose arguments are sent on as they are.
#include "binding/c/calls.h"

using namespace candela;
using namespace candela::c;

static int patchSize(const std::string &type) { return type == "bicubic" ? 4 : 2; }

// clang-format off
RI_LISTED(Sphere, thetaMax, (RtFloat radius, RtFloat zMin, RtFloat zMax, RtFloat thetaMax), (radius, zMin, zMax, thetaMax), sphere(ri.at(), radius, zMin, zMax, thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Cone, thetaMax, (RtFloat height, RtFloat radius, RtFloat thetaMax), (height, radius, thetaMax), cone(ri.at(), height, radius, thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Cylinder, thetaMax, (RtFloat radius, RtFloat zMin, RtFloat zMax, RtFloat thetaMax), (radius, zMin, zMax, thetaMax), cylinder(ri.at(), radius, zMin, zMax, thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Hyperboloid, thetaMax, (const RtFloat *point1, const RtFloat *point2, RtFloat thetaMax), (point1, point2, thetaMax), hyperboloid(ri.at(), point1[0], point1[1], point1[2], point2[0], point2[1], point2[2], thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Paraboloid, thetaMax, (RtFloat rMax, RtFloat zMin, RtFloat zMax, RtFloat thetaMax), (rMax, zMin, zMax, thetaMax), paraboloid(ri.at(), rMax, zMin, zMax, thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Disk, thetaMax, (RtFloat height, RtFloat radius, RtFloat thetaMax), (height, radius, thetaMax), disk(ri.at(), height, radius, thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Torus, thetaMax, (RtFloat majorRadius, RtFloat minorRadius, RtFloat phiMin, RtFloat phiMax, RtFloat thetaMax), (majorRadius, minorRadius, phiMin, phiMax, thetaMax), torus(ri.at(), majorRadius, minorRadius, phiMin, phiMax, thetaMax, ri.list(quadric, {n, tokens, values})))
RI_LISTED(Polygon, vertices, (RtInt vertices), (vertices), polygon(ri.at(), ri.list(polygonCounts(1, vertices, vertices), {n, tokens, values})))
RI_LISTED(GeneralPolygon, vertexCounts, (RtInt loops, const RtInt *vertexCounts), (loops, vertexCounts), generalPolygon(ri.at(), integers(loops, vertexCounts), ri.list(polygonCounts(1, sum(loops, vertexCounts), sum(loops, vertexCounts)), {n, tokens, values})))
RI_LISTED(Patch, type, (RtToken type), (type), patch(ri.at(), text(type), ri.list(ri.meshCounts(text(type), patchSize(text(type)), "nonperiodic", patchSize(text(type)), "nonperiodic"), {n, tokens, values})))
RI_LISTED(PatchMesh, vWrap, (RtToken type, RtInt uVertices, RtToken uWrap, RtInt vVertices, RtToken vWrap), (type, uVertices, uWrap, vVertices, vWrap), patchMesh(ri.at(), text(type), uVertices, text(uWrap), vVertices, text(vWrap), ri.list(ri.meshCounts(text(type), uVertices, text(uWrap), vVertices, text(vWrap)), {n, tokens, values})))
RI_LISTED(NuPatch, vMax, (RtInt uVertices, RtInt uOrder, const RtFloat *uKnots, RtFloat uMin, RtFloat uMax, RtInt vVertices, RtInt vOrder, const RtFloat *vKnots, RtFloat vMin, RtFloat vMax), (uVertices, uOrder, uKnots, uMin, uMax, vVertices, vOrder, vKnots, vMin, vMax), nuPatch(ri.at(), uVertices, uOrder, floats(uVertices + uOrder, uKnots), uMin, uMax, vVertices, vOrder, floats(vVertices + vOrder, vKnots), vMin, vMax, ri.list(nuPatchCounts(uVertices, uOrder, vVertices, vOrder), {n, tokens, values})))
RI_LISTED(Points, points, (RtInt points), (points), points(ri.at(), ri.list(pointCounts(points), {n, tokens, values})))
RI_LISTED(Curves, wrap, (RtToken type, RtInt curves, const RtInt *vertexCounts, RtToken wrap), (type, curves, vertexCounts, wrap), curves(ri.at(), text(type), integers(curves, vertexCounts), text(wrap), ri.list(ri.curveCounts(text(type), curves, vertexCounts, text(wrap)), {n, tokens, values})))
RI_LISTED(Blobby, strings, (RtInt leaves, RtInt codeCount, const RtInt *codes, RtInt floatCount, const RtFloat *numbers, RtInt stringCount, const RtToken *strings), (leaves, codeCount, codes, floatCount, numbers, stringCount, strings), blobby(ri.at(), leaves, integers(codeCount, codes), floats(floatCount, numbers), texts(stringCount, strings), ri.list(leafCounts(leaves), {n, tokens, values})))
RI_LISTED(Geometry, type, (RtToken type), (type), geometry(ri.at(), text(type), ri.list(single, {n, tokens, values})))
// clang-format on

RI_LISTED(PointsPolygons, vertices,
          (RtInt polygons, const RtInt *vertexCounts, const RtInt *vertices),
          (polygons, vertexCounts, vertices),
          pointsPolygons(ri.at(), integers(polygons, vertexCounts),
                         integers(sum(polygons, vertexCounts), vertices),
                         ri.list(polygonCounts(polygons, sum(polygons, vertexCounts),
                                               above(sum(polygons, vertexCounts), vertices)),
                                 {n, tokens, values})))

void RiPointsGeneralPolygons(RtInt polygons, const RtInt *loopCounts, const RtInt *vertexCounts,
                             const RtInt *vertices, ...) {
    RI_GATHER(vertices);
    RiPointsGeneralPolygonsV(polygons, loopCounts, vertexCounts, vertices, given.count(),
                             given.tokens(), given.values());
}

void RiPointsGeneralPolygonsV(RtInt polygons, const RtInt *loopCounts, const RtInt *vertexCounts,
                              const RtInt *vertices, RtInt n, RtToken tokens[],
                              RtPointer values[]) {
    perform("RiPointsGeneralPolygons", [&](Context &ri) {
        const int loops = sum(polygons, loopCounts), corners = sum(loops, vertexCounts);
        const VariableCounts counts = polygonCounts(polygons, corners, above(corners, vertices));
        ri.sink().pointsGeneralPolygons(ri.at(), integers(polygons, loopCounts),
                                        integers(loops, vertexCounts), integers(corners, vertices),
                                        ri.list(counts, {n, tokens, values}));
    });
}

void RiSubdivisionMesh(RtToken scheme, RtInt faces, const RtInt *vertexCounts,
                       const RtInt *vertices, RtInt tagCount, const RtToken *tags,
                       const RtInt *argumentCounts, const RtInt *numbers, const RtFloat *reals,
                       ...) {
    RI_GATHER(reals);
    RiSubdivisionMeshV(scheme, faces, vertexCounts, vertices, tagCount, tags, argumentCounts,
                       numbers, reals, given.count(), given.tokens(), given.values());
}

void RiSubdivisionMeshV(RtToken scheme, RtInt faces, const RtInt *vertexCounts,
                        const RtInt *vertices, RtInt tagCount, const RtToken *tags,
                        const RtInt *argumentCounts, const RtInt *numbers, const RtFloat *reals,
                        RtInt n, RtToken tokens[], RtPointer values[]) {
    perform("RiSubdivisionMesh", [&](Context &ri) {
        // Each tag has a number of integers and one of floats.
        RtInt integersOfTags = 0, floatsOfTags = 0;
        for (RtInt i = 0; i < tagCount; ++i) {
            integersOfTags += argumentCounts[2 * i];
            floatsOfTags += argumentCounts[2 * i + 1];
        }
        SubdivisionTags all;
        all.names = texts(tagCount, tags);
        all.argumentCounts = integers(2 * tagCount, argumentCounts);
        all.integers = integers(integersOfTags, numbers);
        all.floats = floats(floatsOfTags, reals);
        const int corners = sum(faces, vertexCounts);
        ri.sink().subdivisionMesh(
            ri.at(), text(scheme), integers(faces, vertexCounts), integers(corners, vertices), all,
            ri.list(polygonCounts(faces, corners, above(corners, vertices)), {n, tokens, values}));
    });
}

void RiHierarchicalSubdivisionMesh(RtToken scheme, RtInt faces, const RtInt *vertexCounts,
                                   const RtInt *vertices, RtInt tagCount, const RtToken *tags,
                                   const RtInt *argumentCounts, const RtInt *numbers,
                                   const RtFloat *reals, const RtToken *strings, ...) {
    RI_GATHER(strings);
    RiHierarchicalSubdivisionMeshV(scheme, faces, vertexCounts, vertices, tagCount, tags,
                                   argumentCounts, numbers, reals, strings, given.count(),
                                   given.tokens(), given.values());
}

void RiHierarchicalSubdivisionMeshV(RtToken scheme, RtInt faces, const RtInt *vertexCounts,
                                    const RtInt *vertices, RtInt tagCount, const RtToken *tags,
                                    const RtInt *argumentCounts, const RtInt *numbers,
                                    const RtFloat *reals, const RtToken *strings, RtInt n,
                                    RtToken tokens[], RtPointer values[]) {
    perform("RiHierarchicalSubdivisionMesh", [&](Context &ri) {
        // Each tag has a number of integers, one of floats and one of strings.
        RtInt counts[3] = {0, 0, 0};
        for (RtInt i = 0; i < 3 * tagCount; ++i)
            counts[i % 3] += argumentCounts[i];
        const int corners = sum(faces, vertexCounts);
        ri.sink().hierarchicalSubdivisionMesh(
            ri.at(), text(scheme), integers(faces, vertexCounts), integers(corners, vertices),
            texts(tagCount, tags), integers(3 * tagCount, argumentCounts),
            integers(counts[0], numbers), floats(counts[1], reals), texts(counts[2], strings),
            ri.list(polygonCounts(faces, corners, above(corners, vertices)), {n, tokens, values}));
    });
}
