// SPDX-License-Identifier: Apache-2.0
#include "world/geometry/subdivision_refiner.h"

#include <opensubdiv/far/error.h>
#include <opensubdiv/far/topologyDescriptor.h>
#include <opensubdiv/far/topologyRefinerFactory.h>

#include <algorithm>
#include <cmath>

namespace candela {

namespace {

struct Descriptor {
    std::vector<int> creaseVertices, cornerVertices;
    std::vector<float> creaseSharpness, cornerSharpness;
    Far::TopologyDescriptor far;

    Descriptor(const SubdivisionRecord &mesh, int vertices) {
        for (const auto &crease : mesh.creases)
            for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i) {
                creaseVertices.insert(creaseVertices.end(),
                                      {crease.vertices[i], crease.vertices[i + 1]});
                creaseSharpness.push_back(std::min(crease.sharpness, infinitelySharp));
            }
        for (const auto &corner : mesh.corners) {
            cornerVertices.push_back(corner.vertex);
            cornerSharpness.push_back(std::min(corner.sharpness, infinitelySharp));
        }
        far.numVertices = vertices;
        far.numFaces = int(mesh.vertexCounts.size());
        far.numVertsPerFace = mesh.vertexCounts.data();
        far.vertIndicesPerFace = mesh.vertices.data();
        far.numCreases = int(creaseSharpness.size());
        far.creaseVertexIndexPairs = creaseVertices.data();
        far.creaseWeights = creaseSharpness.data();
        far.numCorners = int(cornerSharpness.size());
        far.cornerVertexIndices = cornerVertices.data();
        far.cornerWeights = cornerSharpness.data();
        far.numHoles = int(mesh.holes.size());
        far.holeIndices = mesh.holes.data();
    }
};

} // namespace

std::unique_ptr<Far::TopologyRefiner> refinerOf(const SubdivisionRecord &mesh, int vertices,
                                                std::string &why) {
    // What it would print is said by us, with file and line.
    Far::SetErrorCallback([](Far::ErrorType, const char *) {});
    Far::SetWarningCallback([](const char *) {});
    using Factory = Far::TopologyRefinerFactory<Far::TopologyDescriptor>;
    using Boundary = Sdc::Options::VtxBoundaryInterpolation;
    static constexpr Boundary boundaries[] = {Sdc::Options::VTX_BOUNDARY_NONE,
                                              Sdc::Options::VTX_BOUNDARY_EDGE_AND_CORNER,
                                              Sdc::Options::VTX_BOUNDARY_EDGE_ONLY};
    Sdc::Options rules;
    rules.SetVtxBoundaryInterpolation(boundaries[mesh.interpolateBoundary]);
    static constexpr Sdc::SchemeType schemes[] = {Sdc::SCHEME_CATMARK, Sdc::SCHEME_LOOP,
                                                  Sdc::SCHEME_BILINEAR};
    const Descriptor descriptor(mesh, vertices);
    std::unique_ptr<Far::TopologyRefiner> refiner(
        Factory::Create(descriptor.far, Factory::Options(schemes[int(mesh.scheme)], rules)));
    if (!refiner)
        why = "has faces that make no surface: an edge between a vertex and itself, or a vertex in "
              "too many faces";
    return refiner;
}

int levelsOfCreases(const SubdivisionRecord &mesh) {
    float longest = 0;
    const auto note = [&](float sharpness) {
        if (sharpness < infinitelySharp)
            longest = std::max(longest, sharpness);
    };
    for (const auto &crease : mesh.creases)
        note(crease.sharpness);
    for (const auto &corner : mesh.corners)
        note(corner.sharpness);
    return int(std::ceil(longest));
}

int strayCreasesOf(const SubdivisionRecord &mesh, const Far::TopologyRefiner &refiner) {
    int strays = 0;
    for (const auto &crease : mesh.creases)
        for (std::size_t i = 0; i + 1 < crease.vertices.size(); ++i)
            strays += refiner.GetLevel(0).FindEdge(crease.vertices[i], crease.vertices[i + 1]) < 0;
    return strays;
}

} // namespace candela
