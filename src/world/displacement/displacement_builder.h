// SPDX-License-Identifier: Apache-2.0
// What displaces which shapes.
#pragma once

#include "world/displacement/shader_displacement.h"

#include <map>
#include <set>
#include <string>
#include <tuple>

namespace candela {

/// What displacement makes of a surface: by its deformation, then by its displacement shader, then
/// by its surface shader if that sets P.
struct DisplacedStages {
    std::shared_ptr<const Surface> own; ///< Before.
    /// What a shape of it is to have as its surface, and as what moves that (null: nothing does).
    std::shared_ptr<const Surface> surface;
    std::shared_ptr<const Displacement> mover;
    std::vector<std::shared_ptr<const ShaderDisplacement>> stages;
};

class DisplacementBuilder {
public:
    /// `systems`: named coordinate systems, those of the camera among them. All must outlive it.
    DisplacementBuilder(ShaderLibrary &, const Options &, ir::LightRule,
                        const std::map<std::string, Matrix4> &systems, const Camera &);

    /// `moving`: its surface shader, if that sets P.
    DisplacedStages displace(const DisplacedThing &, const std::optional<ShaderInstance> &moving);

    /// Once all shapes are diced.
    void report(DiagnosticSink &) const;

private:
    /// Null: there is none, or it does nothing.
    const ShaderInstance *instanceOf(ShaderKind, const ShaderRecord *, const DisplacedThing &);
    void prepare(const ShaderCode &);
    void add(const ShaderInstance &, const std::shared_ptr<const ShaderRecord> &, DisplacedThing,
             DisplacedStages &);

    ShaderLibrary &library_;
    const Options &options_;
    const ir::LightRule rule_;
    const std::map<std::string, Matrix4> &systems_;
    const Camera &camera_;
    std::map<std::tuple<const ShaderRecord *, OtherShaders, std::set<std::string>>,
             std::optional<ShaderInstance>>
        instances_;
    std::set<const ShaderCode *> prepared_;
    /// What was moved how far.
    std::vector<std::shared_ptr<DisplacementBounds>> bounds_;
};

/// Whether two displacements make the same of a surface in its own space, as far as some of its
/// points tell: then what stands in two places may be one shape.
bool displaceAlike(const DisplacedStages &, const DisplacedStages &);

} // namespace candela
