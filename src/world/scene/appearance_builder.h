// SPDX-License-Identifier: Apache-2.0
// Shapes with attributes become appearances: which code shades them, with which parameters, under
// which lights.
#pragma once

#include "world/scene/scene_state.h"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>

namespace candela {

class AppearanceBuilder {
public:
    AppearanceBuilder(SceneState &, ShaderLibrary &);

    /// Adds what a shape looks like under the attributes, `turned` if its orientation is reversed.
    /// Its offset and signs follow once it is diced. False if its shader can't be had.
    bool add(std::uint32_t shape, const std::shared_ptr<const Attributes> &, bool turned,
             const Presence &);

    /// The surface shader of what has these attributes, if it moves points: a surface shader that
    /// sets P displaces too.
    std::optional<ShaderInstance> movingShader(const Attributes &,
                                               const std::set<std::string> &variables);

    /// What is known before dicing: by appearance, its shape.
    const std::vector<std::uint32_t> &shapes() const { return shapes_; }
    /// The surface shines by itself, or has an area light.
    bool shines(std::int32_t appearance) const;
    bool isOpaque(std::int32_t appearance) const;
    /// Completes the appearances with what dicing has found, and the codes with what they shade.
    void finish();

private:
    struct Shading {
        int code;
        std::int32_t parameterOffset;
    };
    Shading shadingOf(const Attributes &, const std::set<std::string> &variables);
    int numberOf(std::shared_ptr<ShaderCode>);
    int lightSetOf(const Attributes &);
    /// The number of the volume; 0 where there is none, also where it can't be had.
    std::int32_t mediumOf(const ShaderRecord *, const OtherShaders &);
    SurfaceMedia mediaOf(const Attributes &);

    SceneState &state_;
    ShaderLibrary &library_;
    std::vector<std::uint32_t> shapes_;
    /// By shaders, overriding variables and, of shaders that ask for them, attributes.
    std::map<std::tuple<OtherShaders, std::set<std::string>, const Attributes *>, Shading>
        shadings_;
    std::map<const ShaderCode *, int> codeNumbers_;
    std::map<std::vector<int>, int> lightSets_;
    std::map<std::pair<const ShaderRecord *, OtherShaders>, std::int32_t> media_;
    /// By what they do: a body's faces may each have been told of its Interior.
    std::map<std::pair<const ShaderCode *, std::vector<float>>, std::int32_t> sameMedia_;
};

} // namespace candela
