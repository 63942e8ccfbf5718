// SPDX-License-Identifier: Apache-2.0
// What each request does to the options, attributes and transformation, once it is known to be
// legal where it stands. Private to the room: GraphicsState is the way in.
#pragma once

#include "interface/ri/declarations.h"
#include "interface/ri/error_policy.h"
#include "interface/ri/graphics_state_settings.h"
#include "interface/ri/request_table.h"
#include "interface/ri/scene_builder.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace candela {

class StateHandlers {
public:
    StateHandlers(SceneBuilder &, ShaderLookup &, ErrorPolicy &, GraphicsStateSettings);

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__));
#include "interface/ri/requests.def"

    /// Around the replay of an object: attributes and transformation are restored, and Transform
    /// and Identity are relative to the transformation of the instance.
    void instanceBegin();
    void instanceEnd();

    std::optional<std::string> findArchive(const std::string &name,
                                           const SourceLocation &where) const;
    /// Reports a warning the first time that this `about` comes up.
    void warnOnce(const SourceLocation &, const std::string &about, const std::string &message);

private:
    using Token = ParsedToken;
    using SharedParameters = std::vector<ShaderLookup::ParameterType>;

    struct AttributeState {
        Attributes values;
        bool inside = false; ///< Orientation is the opposite of the coordinate system's own.
        std::shared_ptr<const Attributes> snapshot; ///< Of `values`; null after a change.
    };
    struct LightState {
        std::vector<std::shared_ptr<const LightRecord>> all;
        std::map<std::string, int> byHandle; ///< Handle to index.
    };
    /// All that FrameBegin and WorldBegin save.
    struct GlobalState {
        Options options;
        AttributeState attributes;
        Matrix4 ctm, base;
        LightState lights;
    };

    void error(const SourceLocation &, const char *request, const std::string &message);
    /// True if all are finite; reports it otherwise.
    bool finite(const SourceLocation &, const char *request, std::initializer_list<float>);

    // Attributes and transformation.
    Attributes &edit();
    std::shared_ptr<const Attributes> currentAttributes();
    MotionTransform currentTransform() const { return {{{options_.camera.shutterOpen, ctm_}}}; }
    void setTransform(const SourceLocation &, const char *request, const Matrix4 &);
    void concatenate(const SourceLocation &, const char *request, const Matrix4 &);
    std::optional<BasisRecord> basisOf(const SourceLocation &, const BasisArgument &, int step);

    // Parameters.
    std::optional<Token> tokenOf(const TokenValue &, const char *request);
    Declaration guess(const TokenValue &, const Token &, const char *request,
                      const std::string &qualifiedName);
    std::vector<Parameter> categorised(const TokenList &, const char *request,
                                       const std::string &category);
    ParameterList parameters(const SourceLocation &, const TokenList &, const char *request);
    ShaderRecord shader(const SourceLocation &, const char *request, ShaderKind,
                        const std::string &name, const TokenList &);
    std::optional<Declaration> shaderParameterType(const TokenValue &, const Token &,
                                                   const char *request, const std::string &shader,
                                                   const std::optional<SharedParameters> &known);
    void setSearchPath(Parameter &);
    void checkIntegrator(const SourceLocation &, const std::string &name);
    std::optional<QuantizeRecord> displayQuantize(ParameterList &);

    // Lights and primitives.
    void addLight(const SourceLocation &, const char *request, const std::string &name,
                  const Handle &, const TokenList &, bool area);
    LightUnits lightUnits(const SourceLocation &);
    bool lightShadows(const SourceLocation &);
    void emit(const SourceLocation &, const char *request, ShapeRecord, const TokenList &);
    ParameterList primitiveVariables(const SourceLocation &, const char *request,
                                     const TokenList &);
    void emitPolygons(const SourceLocation &, const char *request, PolygonsRecord,
                      const TokenList &);
    void saveGlobals();
    void restoreGlobals();

    SceneBuilder &builder_;
    ShaderLookup &shaders_;
    ErrorPolicy &diagnostics_;
    GraphicsStateSettings settings_;

    Dictionary dictionary_;
    Options options_;
    AttributeState attributes_;
    Matrix4 ctm_;  ///< Camera (current) from object space.
    Matrix4 base_; ///< What Identity goes back to: world space inside a world block.
    LightState lights_;
    bool inWorld_ = false;

    std::vector<GlobalState> savedGlobals_;
    std::vector<AttributeState> savedAttributes_;
    std::vector<Matrix4> savedTransforms_, savedBases_;
    std::set<std::string> warned_;
};

} // namespace candela
