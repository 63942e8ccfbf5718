// SPDX-License-Identifier: Apache-2.0
// What displaces which shapes.
#pragma once

#include "world/displacement/shader_displacement.h"

#include <map>
#include <set>
#include <string>

namespace candela {

class DisplacementBuilder {
public:
    /// `systems`: named coordinate systems, those of the camera among them. All must outlive it.
    DisplacementBuilder(ShaderLibrary &, const Options &, ir::LightRule,
                        const std::map<std::string, Matrix4> &systems, const Camera &);

    /// How the thing is displaced: by its displacement shader, and then by its surface shader if
    /// that moves points. The second is to be given a surface that the first has displaced.
    /// Null: it is not.
    std::shared_ptr<const ShaderDisplacement> byDisplacement(const DisplacedThing &);
    std::shared_ptr<const ShaderDisplacement> bySurface(const DisplacedThing &,
                                                        const ShaderInstance &);

    /// Once all shapes are diced.
    void report(DiagnosticSink &) const;

private:
    /// Null: nothing displaces.
    const ShaderInstance *instanceOf(const std::shared_ptr<const ShaderRecord> &,
                                     const std::set<std::string> &variables);
    void prepare(const ShaderCode &);
    std::shared_ptr<const ShaderDisplacement> make(const ShaderInstance &,
                                                   const std::shared_ptr<const ShaderRecord> &,
                                                   const DisplacedThing &);

    ShaderLibrary &library_;
    const Options &options_;
    const ir::LightRule rule_;
    const std::map<std::string, Matrix4> &systems_;
    const Camera &camera_;
    std::map<std::pair<const ShaderRecord *, std::set<std::string>>, std::optional<ShaderInstance>>
        instances_;
    std::set<const ShaderCode *> prepared_;
    /// What was moved how far.
    std::vector<std::shared_ptr<DisplacementBounds>> bounds_;
};

/// Whether two displacements make the same of a surface in its own space, as far as some of its
/// points tell: then what stands in two places may be one shape.
bool displaceAlike(const Surface &, const ShaderDisplacement &, const ShaderDisplacement &);

} // namespace candela
