// SPDX-License-Identifier: Apache-2.0
// Points on flat triangles, as most scenes of rooms have them: evaluated from a table in current
// space, all lanes at once, whatever primitives they lie on.
#pragma once

#include "foundation/base/vec3.h"
#include "world/points/shading_points.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace candela {

struct SceneState;
struct SceneCode;
struct TrianglePoints;

/// A triangle of a primitive in current space, whose shading normal is its plane's.
struct FlatTriangle {
    Vec3 origin, edgeA, edgeB;
    Vec3 normal; ///< Of any length, turned as attributes say.
};

/// Nothing if the surface is curved there, or has normals of the user's.
std::optional<FlatTriangle> flatTriangle(const SceneState &, std::uint32_t primitive,
                                         std::uint32_t triangle);

/// P, which holds the origins of triangles, becomes the points at (u,v) on them; one component.
void walkAlongEdges(int count, const float *edgeA, const float *edgeB, const float *u,
                    const float *v, float *P);

class FlatTable {
public:
    /// Takes in the primitives of those codes that can be served from a table: all their
    /// surfaces are flat, and their shaders read nothing that only surfaces know.
    void build(SceneState &);
    /// SceneState::evaluate for a code that is served.
    void evaluate(const SceneState &, const TrianglePoints &, const SceneCode &,
                  ShadingPoints &) const;

private:
    static void takeSummaries(const SceneState &, const SceneCode &, int count, const int *summary,
                              ShadingPoints &);
    bool takePrimitive(const SceneState &, std::uint32_t primitive);

    std::vector<float> rows_;   ///< A row a triangle.
    std::vector<int> firstRow_; ///< Of each primitive.
};

} // namespace candela
