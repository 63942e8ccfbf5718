// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/graphics_state.h"

#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

namespace {

constexpr int maximumNesting = 10000;

const char *beginOf(int kind) {
    constexpr const char *names[] = {"FrameBegin",     "WorldBegin", "AttributeBegin",
                                     "TransformBegin", "SolidBegin", "ObjectBegin",
                                     "MotionBegin"};
    return names[kind];
}

} // namespace

GraphicsState::GraphicsState(SceneBuilder &builder, ShaderLookup &shaders, ErrorPolicy &policy,
                             GraphicsStateSettings settings)
    : policy_(policy), diagnostics_(policy),
      handlers_(
          std::make_unique<StateHandlers>(builder, shaders, diagnostics_, std::move(settings))) {}

GraphicsState::~GraphicsState() = default;

std::optional<std::string> GraphicsState::locate(const char *path, const std::string &name,
                                                 const SourceLocation &where) const {
    return handlers_->locate(path, name, where);
}

float GraphicsState::detailOf(const std::array<float, 6> &bound) const {
    return handlers_->detailOf(bound);
}

std::optional<Matrix4d> GraphicsState::cameraFrom(const std::string &system) const {
    return handlers_->cameraFrom(system);
}

std::optional<StateValue> GraphicsState::valueOf(const std::string &name) const {
    return handlers_->valueOf(name);
}

bool GraphicsState::isOpen(BlockKind kind) const {
    return std::ranges::find(blocks_, kind, &Block::kind) != blocks_.end();
}

unsigned GraphicsState::place() const {
    unsigned motion =
        !blocks_.empty() && blocks_.back().kind == BlockKind::Motion ? scope::InMotion : 0;
    if (isOpen(BlockKind::Object))
        return scope::InObject | motion;
    return (isOpen(BlockKind::World) ? scope::InWorld : scope::Outside) | motion;
}

bool GraphicsState::isLegal(RequestId id, const SourceLocation &where) {
    unsigned here = place();
    if ((here & ~describe(id).legalScopes) == 0)
        return true;
    reportScope(id, where, here);
    return false;
}

void GraphicsState::reportScope(RequestId id, const SourceLocation &where, unsigned place) {
    const RequestDescription &request = describe(id);
    std::string name(request.name);
    unsigned wrong = place & ~request.legalScopes;
    if (wrong & scope::InMotion)
        policy_.error(where, name + " is not legal between MotionBegin and MotionEnd");
    else if ((wrong & scope::InObject) && name.ends_with("Begin"))
        policy_.error(where, name + " is not legal between ObjectBegin and ObjectEnd");
    else if (wrong & scope::InObject)
        diagnostics_.warnOnce(where, "scope:" + name,
                              name + " has no effect between ObjectBegin and ObjectEnd: an object "
                                     "takes its attributes from its instances");
    else if (wrong & scope::Outside)
        policy_.error(where, name + " is legal only between WorldBegin and WorldEnd");
    else if (id == RequestId::WorldBegin || id == RequestId::FrameBegin)
        policy_.error(where, name + " is not legal between WorldBegin and WorldEnd");
    else
        diagnostics_.warnOnce(where, "scope:" + name,
                              name + " has no effect between WorldBegin and WorldEnd: WorldBegin "
                                     "has frozen the options");
}

bool GraphicsState::isMotionSample(RequestId id) const {
    return !blocks_.empty() && blocks_.back().kind == BlockKind::Motion &&
           (describe(id).legalScopes & scope::Moves);
}

bool GraphicsState::admit(RequestId id, const SourceLocation &where) {
    return !stopped() && !nestsInWorld(id, where) && isLegal(id, where) &&
           (!isMotionSample(id) || takeMotionSample(id, where)) && nest(id, where);
}

bool GraphicsState::nestsInWorld(RequestId id, const SourceLocation &where) {
    const bool isWorld = id == RequestId::WorldBegin || id == RequestId::WorldEnd;
    const bool begins = id == RequestId::WorldBegin || id == RequestId::FrameBegin;
    if (!isWorld && !begins && id != RequestId::FrameEnd)
        return false;
    const BlockKind kind = isWorld ? BlockKind::World : BlockKind::Frame;
    if (begins) {
        const auto world = std::ranges::find(blocks_, BlockKind::World, &Block::kind);
        if (place() != scope::InWorld || !where.file ||
            (world->where.file && *world->where.file == *where.file))
            return false;
        const std::string name(describe(id).name);
        diagnostics_.warnOnce(where, "inner " + name,
                              name + " within a world is taken for AttributeBegin");
        attributeBegin(where);
        if (!stopped())
            blocks_.back().standsFor = kind;
        return true;
    }
    std::size_t depth = blocks_.size();
    while (depth > 0 && blocks_[depth - 1].standsFor != kind)
        if (const Block &block = blocks_[--depth];
            block.kind == BlockKind::World || block.kind == BlockKind::Object)
            return false;
    if (depth == 0)
        return false;
    while (blocks_.size() > depth) {
        policy_.error(where, std::string(describe(id).name) + ": the " +
                                 beginOf(int(blocks_.back().kind)) + " at " +
                                 blocks_.back().where.text() + " is still open; it is closed here");
        if (stopped())
            return true;
        endInnermost(where);
    }
    blocks_.back().standsFor.reset();
    attributeEnd(where);
    return true;
}

bool GraphicsState::nest(RequestId id, const SourceLocation &where) {
    auto open = [&](BlockKind kind) {
        if (int(blocks_.size()) >= maximumNesting) {
            policy_.report(
                {Severity::Fatal,
                 where,
                 "blocks are nested more than " + std::to_string(maximumNesting) + " deep",
                 {},
                 1});
            return false;
        }
        blocks_.push_back({kind, where, {}});
        return true;
    };
    switch (id) {
    case RequestId::FrameBegin:
        if (isOpen(BlockKind::Frame)) {
            policy_.error(where, "FrameBegin is not legal inside a frame");
            return false;
        }
        return open(BlockKind::Frame);
    case RequestId::WorldBegin: return open(BlockKind::World);
    case RequestId::AttributeBegin: return open(BlockKind::Attribute);
    case RequestId::TransformBegin: return open(BlockKind::Transform);
    case RequestId::SolidBegin: return open(BlockKind::Solid);
    case RequestId::ObjectBegin: return open(BlockKind::Object);
    case RequestId::MotionBegin: return open(BlockKind::Motion);
    case RequestId::FrameEnd: return closeBlock(BlockKind::Frame, id, where);
    case RequestId::WorldEnd: return closeBlock(BlockKind::World, id, where);
    case RequestId::AttributeEnd: return closeBlock(BlockKind::Attribute, id, where);
    case RequestId::TransformEnd: return closeBlock(BlockKind::Transform, id, where);
    case RequestId::SolidEnd: return closeBlock(BlockKind::Solid, id, where);
    case RequestId::ObjectEnd: return closeBlock(BlockKind::Object, id, where);
    case RequestId::MotionEnd: return closeBlock(BlockKind::Motion, id, where);
    default: return true;
    }
}

bool GraphicsState::closeBlock(BlockKind kind, RequestId id, const SourceLocation &where) {
    std::string name(describe(id).name);
    // What a frame, world or object encloses cannot close what encloses it.
    bool small = kind != BlockKind::Frame && kind != BlockKind::World && kind != BlockKind::Object;
    bool known = false;
    for (auto block = blocks_.rbegin(); block != blocks_.rend() && !known; ++block) {
        known = block->kind == kind && !block->standsFor;
        if (small && (block->kind == BlockKind::Frame || block->kind == BlockKind::World ||
                      block->kind == BlockKind::Object || block->standsFor))
            break;
    }
    if (!known) {
        policy_.error(where, name + " without " + beginOf(int(kind)));
        return false;
    }
    while (blocks_.back().kind != kind) {
        policy_.error(where, name + ": the " + beginOf(int(blocks_.back().kind)) + " at " +
                                 blocks_.back().where.text() + " is still open; it is closed here");
        if (stopped()) // Nothing closes blocks any more.
            return false;
        endInnermost(where);
    }
    blocks_.pop_back();
    return true;
}

void GraphicsState::endInnermost(const SourceLocation &where) {
    switch (blocks_.back().kind) {
    case BlockKind::Frame: return frameEnd(where);
    case BlockKind::World: return worldEnd(where);
    case BlockKind::Attribute: return attributeEnd(where);
    case BlockKind::Transform: return transformEnd(where);
    case BlockKind::Solid: return solidEnd(where);
    case BlockKind::Object: return objectEnd(where);
    case BlockKind::Motion: // That requests are missing has been said by now.
        handlers_->endMotion(where);
        motion_.request.reset();
        return motionEnd(where);
    }
}

void GraphicsState::finish() {
    if (stopped())
        return;
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block)
        policy_.error(block->where,
                      std::string(beginOf(int(block->kind))) + " is never closed" +
                          (block->kind == BlockKind::World ? "; its world is not rendered" : ""));
    blocks_.clear();
}

} // namespace candela
