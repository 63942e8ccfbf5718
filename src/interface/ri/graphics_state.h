// SPDX-License-Identifier: Apache-2.0
// The graphics state: a sink of requests that keeps options, attributes and transformations and
// tells a SceneBuilder of worlds (RI 3.2, section 4). This class judges where a request stands
// (scopes, nesting, motion blocks); what a request does is StateHandlers'.
#pragma once

#include "interface/ri/error_policy.h"
#include "interface/ri/graphics_state_settings.h"
#include "interface/ri/request_diagnostics.h"
#include "interface/ri/request_sink.h"
#include "interface/ri/scene_builder.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace candela {

class StateHandlers;

class GraphicsState final : public RequestSink {
public:
    /// All three must outlive it. Who else finds something wrong in the user's files is to report
    /// it to the same policy, which ErrorHandler sets.
    GraphicsState(SceneBuilder &, ShaderLookup &, ErrorPolicy &, GraphicsStateSettings = {});
    ~GraphicsState() override;

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...)                                              \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#include "interface/ri/requests.def"

    std::optional<std::string> locate(const char *path, const std::string &name,
                                      const SourceLocation &where) const override;
    float detailOf(const std::array<float, 6> &bound) const override;
    std::optional<Matrix4d> cameraFrom(const std::string &system) const override;
    std::optional<StateValue> valueOf(const std::string &name) const override;
    bool stopped() const override { return policy_.stopped(); }

    /// After the last request: reports blocks that are still open. A world that was never closed
    /// is not rendered.
    void finish();

private:
    enum class BlockKind { Frame, World, Attribute, Transform, Solid, Object, Motion };
    struct Block {
        BlockKind kind;
        SourceLocation where;
        std::optional<BlockKind> standsFor; ///< An attribute block: a frame or world in a world.
    };
    /// True if the request is to be done.
    bool admit(RequestId, const SourceLocation &);
    bool isLegal(RequestId, const SourceLocation &);
    /// Frames and worlds of archives that are read in a world are attribute blocks: opens and
    /// closes these, and is true then.
    bool nestsInWorld(RequestId, const SourceLocation &);
    void reportScope(RequestId, const SourceLocation &, unsigned place);
    bool isMotionSample(RequestId) const;
    bool takeMotionSample(RequestId, const SourceLocation &);
    unsigned place() const;
    bool isOpen(BlockKind) const;
    /// Keeps the stack of open blocks in step with a legal request; false if it must be dropped.
    bool nest(RequestId, const SourceLocation &);
    bool closeBlock(BlockKind, RequestId, const SourceLocation &);
    void endInnermost(const SourceLocation &);

    ErrorPolicy &policy_;
    RequestDiagnostics diagnostics_;
    std::unique_ptr<StateHandlers> handlers_;
    std::vector<Block> blocks_;
    /// The open motion block.
    struct MotionSoFar {
        std::vector<double> times; ///< Empty: it is faulty.
        std::optional<RequestId> request;
        int samples = 0;
    } motion_;
};

} // namespace candela
