// SPDX-License-Identifier: Apache-2.0
// Meshes of triangles, split by Loop's rules so often that they look smooth, with every vertex
// where it would go in the end.
#pragma once

#include "foundation/base/vec3.h"
#include "interface/ri/primitive_record.h"

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace candela {

class LoopRefinement {
public:
    /// Null, and a sentence, if the mesh is no surface. The record's numbers must be within bounds,
    /// and its faces triangles.
    static std::unique_ptr<LoopRefinement> of(const SubdivisionRecord &, int vertices, int levels,
                                              std::string &why);
    /// How often meshes of so many faces are split: as often as makes half a million triangles at
    /// most, and as often as creases last. It depends on no position, so that meshes that move
    /// keep their triangles.
    static int levelsFor(const SubdivisionRecord &);
    virtual ~LoopRefinement() = default;

    /// A place in a face: what it has of the ways from the first corner to the second and third.
    using Place = std::array<float, 2>;
    struct Triangle {
        std::array<int, 3> vertices;
        int face = 0; ///< That it is a part of.
        std::array<Place, 3> places;
        bool isHole = false; ///< Or at a boundary that is not interpolated.
    };
    /// In the order of the faces; those that are holes too.
    const std::vector<Triangle> &triangles() const { return triangles_; }
    /// Creases along what is no edge, which have no effect.
    int strayCreases() const { return strayCreases_; }

    /// Values at the mesh's vertices, `components` floats each, where those of the triangles go.
    virtual std::vector<float> limit(std::span<const float> values, int components) const = 0;
    /// The normals of these positions at the corners of all triangles; not of unit length. Those of
    /// a vertex are the same but across creases.
    virtual std::vector<Vec3> normals(std::span<const float> positions) const = 0;

protected:
    std::vector<Triangle> triangles_;
    int strayCreases_ = 0;
};

} // namespace candela
