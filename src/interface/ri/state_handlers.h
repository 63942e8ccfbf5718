// SPDX-License-Identifier: Apache-2.0
// What each request does to the options, attributes and transformation, once it is known to be
// legal where it stands: a table of handlers over the state that they share. Private to the room:
// GraphicsState is the way in.
#pragma once

#include "interface/ri/frame_state.h"
#include "interface/ri/graphics_state_settings.h"
#include "interface/ri/parameter_reader.h"
#include "interface/ri/request_diagnostics.h"
#include "interface/ri/request_sink.h"
#include "interface/ri/resources.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

class StateHandlers {
public:
    StateHandlers(SceneBuilder &, ShaderLookup &, RequestDiagnostics &, GraphicsStateSettings);

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__));
#include "interface/ri/requests.def"

    /// Around the requests of a motion block; times in increasing order.
    void beginMotion(const std::vector<double> &times);
    void endMotion(const SourceLocation &);

    std::optional<std::string> locate(const char *path, const std::string &name,
                                      const SourceLocation &where) const;
    float detailOf(const std::array<float, 6> &bound) const;
    std::optional<Matrix4d> cameraFrom(const std::string &system) const;
    std::optional<StateValue> valueOf(const std::string &name) const;

private:
    /// A motion block: what its requests, of one kind, have said so far.
    struct OpenMotion {
        std::vector<double> times;
        std::vector<TransformSample> samples;
        bool fromBase = false; ///< Transform, Identity: they replace what there is.
        std::vector<Color> colors;
        std::vector<ShaderRecord> shaders;
        std::function<void(ShaderRecord)> useShader; ///< What the request does with it.
        std::vector<std::shared_ptr<const PrimitiveRecord>> primitives;
    };
    void endTransformation(const SourceLocation &, const OpenMotion &);
    /// In motion blocks colours are samples, the first of which counts from now on, and all when
    /// there is one for each time. False outside of them.
    bool addToMotion(const Color &, Color &first, SharedInTime<Color> &all);
    /// In motion blocks shaders wait for the block's end.
    void withMotion(ShaderRecord, std::function<void(ShaderRecord)> use);
    void tellPrimitive(std::shared_ptr<const PrimitiveRecord>);

    /// What the blocks inside frames and worlds save.
    struct SavedBlock {
        TransformState transform;
        std::shared_ptr<Attributes> attributes; ///< Null: they go on.
        std::shared_ptr<const std::map<std::string, CurrentTransform>> scopedSystems;
    };
    void saveBlock(bool attributes);
    void restoreBlock();
    void saveFrame();
    void keepLightsInTheWorld();
    void restoreFrame();

    void report(const SourceLocation &, const char *request, TransformDefect);
    /// In motion blocks these are samples, which endMotion() puts to use.
    void concatenate(const SourceLocation &, const char *request, const TransformSample &);
    void replace(const SourceLocation &, const char *request, const TransformSample &);
    /// The one of that name that is in force here; null if there is none.
    const CurrentTransform *coordinateSystemOf(const std::string &name) const;
    /// True, and a warning, if the current transformation is singular.
    bool isFlat(const SourceLocation &, const char *request, const char *what);
    ShaderRecord shader(const SourceLocation &, const char *request, ShaderKind,
                        const std::string &name, const TokenList &);
    using Shader = std::shared_ptr<const ShaderRecord>;
    void setShader(const SourceLocation &, const char *request, ShaderKind, std::uint32_t own,
                   Shader Attributes::*, const std::string &name, const TokenList &);
    void setOrNone(const SourceLocation &, const char *request, ShaderKind, std::uint32_t own,
                   Shader Attributes::*, const std::string &name, const TokenList &);
    void tellLight(LightRecord);
    void switchOnEverywhere(const SourceLocation &, const Handle &);
    ShaderRecord pictureShader(const SourceLocation &, const char *request, ShaderKind,
                               const std::string &name, const TokenList &);
    /// Hands an order for a texture on, its parameters read.
    void order(const SourceLocation &, TextureOrder, const TokenList &);
    void addLight(const SourceLocation &, const char *request, const std::string &name,
                  const Handle &, const TokenList &, bool area);
    void emit(const SourceLocation &, const char *request, ShapeRecord, const TokenList &);
    void readTags(const SourceLocation &, const SubdivisionTags &, SubdivisionRecord &);

    SceneBuilder &builder_;
    RequestDiagnostics &diagnostics_;
    GraphicsStateSettings settings_;
    ParameterReader parameters_;
    ObjectDefinition object_;
    Resources resources_;
    int lightLists_ = 0; ///< Frames and worlds that have ended, with their lights.

    FrameState state_;
    std::optional<OpenMotion> motion_;
    std::vector<FrameState> savedFrames_;
    std::vector<SavedBlock> savedBlocks_;
};

} // namespace candela
