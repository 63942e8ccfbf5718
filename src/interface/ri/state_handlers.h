// SPDX-License-Identifier: Apache-2.0
// What each request does to the options, attributes and transformation, once it is known to be
// legal where it stands. Private to the room: GraphicsState is the way in.
#pragma once

#include "foundation/base/matrix4d.h"
#include "interface/ri/declarations.h"
#include "interface/ri/error_policy.h"
#include "interface/ri/graphics_state_settings.h"
#include "interface/ri/object_record.h"
#include "interface/ri/request_table.h"
#include "interface/ri/scene_builder.h"

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace candela {

class StateHandlers {
public:
    StateHandlers(SceneBuilder &, ShaderLookup &, ErrorPolicy &, GraphicsStateSettings);

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__));
#include "interface/ri/requests.def"

    std::optional<std::string> findArchive(const std::string &name,
                                           const SourceLocation &where) const;
    /// Reports a warning the first time that this `about` comes up.
    void warnOnce(const SourceLocation &, const std::string &about, const std::string &message);
    /// To [0,1], with a warning where that changes `what`.
    void clampOpacity(const SourceLocation &, const char *what, std::span<float> values);

private:
    using Token = ParsedToken;
    using SharedParameters = std::vector<ShaderLookup::ParameterType>;

    struct CurrentTransform {
        Matrix4d matrix;   ///< Current (camera) from object space.
        bool flat = false; ///< It is singular: what stands under it is left out.
    };
    struct LightState {
        std::vector<std::shared_ptr<const LightRecord>> all;
        std::map<std::string, int> byHandle; ///< Handle to index.
    };
    /// All that FrameBegin and WorldBegin save.
    struct GlobalState {
        Options options;
        std::shared_ptr<Attributes> attributes;
        CurrentTransform ctm, base;
        std::map<std::string, CurrentTransform> coordinateSystems;
        LightState lights;
        ObjectNames objects;
    };
    /// The object that is being defined.
    struct OpenObject {
        std::string handle;
        ObjectNames::Entry entry;
        std::shared_ptr<ObjectRecord> record; ///< Null in a world, where the builder hears of it.
    };

    void error(const SourceLocation &, const char *request, const std::string &message);
    /// True if all are finite; reports it otherwise.
    bool finite(const SourceLocation &, const char *request, std::initializer_list<float>);

    // Attributes and transformation.
    /// For a change; what has been handed on stays as it is.
    Attributes &edit();
    std::shared_ptr<const Attributes> currentAttributes() const { return attributes_; }
    MotionTransform currentTransform() const {
        return {{{options_.camera.shutterOpen, ctm_.matrix.rounded()}}};
    }
    void setTransform(const SourceLocation &, const char *request, const Matrix4d &);
    void concatenate(const SourceLocation &, const char *request, const Matrix4d &);
    /// True, and a warning, if the current transformation is singular.
    bool isFlat(const SourceLocation &, const char *request, const char *what);
    void setScreen(const SourceLocation &);
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
    void tell(ObjectPart);
    void tellKeptObjects();
    void saveGlobals();
    void restoreGlobals();

    SceneBuilder &builder_;
    ShaderLookup &shaders_;
    ErrorPolicy &diagnostics_;
    GraphicsStateSettings settings_;

    Dictionary dictionary_;
    Options options_;
    std::shared_ptr<Attributes> attributes_ = std::make_shared<Attributes>();
    CurrentTransform ctm_;
    CurrentTransform base_; ///< What Identity goes back to: world space inside a world block.
    std::map<std::string, CurrentTransform> coordinateSystems_;
    LightState lights_;
    ObjectNames objects_;
    std::optional<OpenObject> openObject_;
    bool inWorld_ = false;

    std::vector<GlobalState> savedGlobals_;
    std::vector<std::shared_ptr<Attributes>> savedAttributes_;
    std::vector<CurrentTransform> savedTransforms_, savedBases_;
    std::set<std::string> warned_;
};

} // namespace candela
