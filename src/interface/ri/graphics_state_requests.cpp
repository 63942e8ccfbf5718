// SPDX-License-Identifier: Apache-2.0
// GraphicsState's requests: from the table, all judged and then run or recorded; by hand, those
// that define objects and motion.
#include "interface/ri/graphics_state.h"
#include "interface/ri/state_handlers.h"

#include <algorithm>

namespace candela {

static constexpr int maximumInstanceDepth = 64;
/// Objects that instance objects grow fast: this is more than any machine's memory holds.
static constexpr std::int64_t maximumReplayed = 10'000'000;

// A recorded request holds copies of its arguments.
#define REQUEST(Name, handler, scopes, ...)                                                        \
    void GraphicsState::handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) {     \
        switch (judge(RequestId::Name, where)) {                                                   \
        case Verdict::Drop: break;                                                                 \
        case Verdict::Run: handlers_->handler(where CANDELA_ARGUMENTS(__VA_ARGS__)); break;        \
        case Verdict::Record:                                                                      \
            record([=](GraphicsState &state) {                                                     \
                state.handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                               \
            });                                                                                    \
        }                                                                                          \
    }
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    void GraphicsState::handler(                                                                   \
        const SourceLocation &where CANDELA_PARAMETER_TYPES(__VA_ARGS__)) {                        \
        if (judge(RequestId::Name, where) != Verdict::Drop)                                        \
            handlers_->warnOnce(where, #Name, #Name ": this version " consequence);                \
    }
#include "interface/ri/requests.def"

void GraphicsState::objectBegin(const SourceLocation &where, const Handle &handle) {
    if (judge(RequestId::ObjectBegin, where) == Verdict::Drop)
        return;
    recording_ = std::make_shared<ObjectDefinition>();
    objectHandle_ = handle.text;
}

void GraphicsState::objectEnd(const SourceLocation &where) {
    if (judge(RequestId::ObjectEnd, where) == Verdict::Drop)
        return;
    objects_[objectHandle_] = std::move(recording_);
}

void GraphicsState::objectInstance(const SourceLocation &where, const Handle &handle) {
    Verdict verdict = judge(RequestId::ObjectInstance, where);
    if (verdict == Verdict::Drop)
        return;
    auto found = objects_.find(handle.text);
    if (found == objects_.end())
        return policy_.error(where,
                             "ObjectInstance: no object '" + handle.text + "' has been defined");
    // A definition may outgrow the limit by its last request; here its instances are refused.
    const std::int64_t weight = found->second->weight;
    if (weight + (verdict == Verdict::Run ? replayed_ : 0) > maximumReplayed)
        return policy_.error(where, "ObjectInstance: the objects in object '" + handle.text +
                                        "' come to more than " + std::to_string(maximumReplayed) +
                                        " requests; the instance is left out");
    if (verdict == Verdict::Run) {
        replayed_ += weight;
        return replay(found->second);
    }
    if (found->second->depth >= maximumInstanceDepth)
        return policy_.error(where, "ObjectInstance: instances are nested more than " +
                                        std::to_string(maximumInstanceDepth) + " deep");
    // Bound now, so that an object cannot contain itself.
    recording_->depth = std::max(recording_->depth, found->second->depth + 1);
    record([object = found->second](GraphicsState &state) { state.replay(object); }, 1 + weight);
}

void GraphicsState::motionBegin(const SourceLocation &where, const LooseFloats &times) {
    Verdict verdict = judge(RequestId::MotionBegin, where);
    if (verdict == Verdict::Drop)
        return;
    motionRequest_.reset();
    if (!std::ranges::is_sorted(times.values) || times.values.empty())
        policy_.error(where, "MotionBegin: expected times in increasing order");
    handlers_->warnOnce(where, "MotionBegin",
                        "MotionBegin: this version draws moving things where they are at the "
                        "first time");
}

void GraphicsState::motionEnd(const SourceLocation &where) {
    if (judge(RequestId::MotionEnd, where) != Verdict::Drop)
        motionRequest_.reset();
}

} // namespace candela
