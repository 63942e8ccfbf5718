// SPDX-License-Identifier: Apache-2.0
// Declared primitives become surfaces with shaders, and then triangles.
#pragma once

#include "world/scene/scene_state.h"

#include <map>
#include <set>
#include <string>
#include <utility>

namespace candela {

struct DeclaredPrimitive {
    std::shared_ptr<const PrimitiveRecord> record;
    std::shared_ptr<const Attributes> attributes;
    Matrix4 currentFromObject;
};

class PrimitiveBuilder {
public:
    PrimitiveBuilder(SceneState &, ShaderLibrary &, DiagnosticSink &);

    void add(const DeclaredPrimitive &);
    /// Dices all; what the rays will meet, a mesh a primitive. Offsets and the scene's extent are
    /// set, and the statistics.
    std::vector<RayMesh> dice();

private:
    struct Shading {
        int code;
        std::int32_t parameterOffset;
    };
    Shading shadingOf(const Attributes &, const std::set<std::string> &variables);
    int numberOf(std::shared_ptr<ShaderCode>);
    int lightSetOf(const Attributes &);
    void addSurface(std::shared_ptr<const Surface>, const DeclaredPrimitive &,
                    const Matrix4 &objectFromCurrent);
    RayMesh diceOne(std::size_t index, float coarsening);
    float coarseningForBudget() const;

    SceneState &state_;
    ShaderLibrary &library_;
    DiagnosticSink &sink_;
    std::map<std::pair<const ShaderRecord *, std::set<std::string>>, Shading> shadings_;
    std::map<const ShaderCode *, int> codeNumbers_;
    std::map<std::vector<int>, int> lightSets_;
    std::vector<bool> flat_; ///< By primitive: polygons, which dicing leaves as they are.
};

} // namespace candela
