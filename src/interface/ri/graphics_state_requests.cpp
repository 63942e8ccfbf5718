// SPDX-License-Identifier: Apache-2.0
// GraphicsState's requests: from the table, all judged and then run; by hand, those of motion
// blocks.
#include "interface/ri/graphics_state.h"
#include "interface/ri/state_handlers.h"

#include <algorithm>
#include <string>
#include <utility>

namespace candela {

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void GraphicsState::handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) {     \
        if (admit(RequestId::Name, where))                                                         \
            handlers_->handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                              \
    }
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    void GraphicsState::handler(                                                                   \
        const SourceLocation &where CANDELA_PARAMETER_TYPES(__VA_ARGS__)) {                        \
        if (admit(RequestId::Name, where))                                                         \
            diagnostics_.warnOnce(where, #Name, #Name ": this version " consequence);              \
    }
#include "interface/ri/requests.def"

void GraphicsState::motionBegin(const SourceLocation &where, const LooseFloats &times) {
    if (!admit(RequestId::MotionBegin, where))
        return;
    motion_ = {};
    const auto later = [](float a, float b) { return !(a < b); };
    if (times.values.empty() ||
        std::ranges::adjacent_find(times.values, later) != times.values.end())
        policy_.error(where, "MotionBegin: expected times in increasing order; what moves is drawn "
                             "where it is at the first of them");
    else
        motion_.times.assign(times.values.begin(), times.values.end());
}

void GraphicsState::motionEnd(const SourceLocation &where) {
    if (!admit(RequestId::MotionEnd, where))
        return;
    const MotionSoFar motion = std::exchange(motion_, {});
    if (!motion.request)
        return;
    const std::string name(describe(*motion.request).name);
    if (!motion.times.empty() && std::size_t(motion.samples) != motion.times.size())
        policy_.error(where, "MotionEnd: expected a " + name + " for each of the " +
                                 std::to_string(motion.times.size()) + " times, found " +
                                 std::to_string(motion.samples));
    handlers_->endMotion(where);
}

/// All that motion blocks may hold moves, but for what does not show.
static bool saysMotion(RequestId id) {
    switch (id) {
    case RequestId::ShadingRate:
    case RequestId::Bound:
    case RequestId::Detail: return false;
    default: return true;
    }
}

/// The first sample tells what the block is about; the others must be of the same kind. False for
/// those that do nothing.
bool GraphicsState::takeMotionSample(RequestId id, const SourceLocation &where) {
    if (motion_.request && *motion_.request != id) {
        policy_.error(where, "a motion block holds requests of one kind: expected " +
                                 std::string(describe(*motion_.request).name) + ", found " +
                                 std::string(describe(id).name));
        return false;
    }
    const bool moves = saysMotion(id) && !motion_.times.empty();
    const bool isFirst = motion_.samples++ == 0;
    motion_.request = id;
    if (isFirst && moves)
        handlers_->beginMotion(motion_.times);
    if (isFirst && !moves && !motion_.times.empty())
        diagnostics_.warnOnce(where, "motion of " + std::string(describe(id).name),
                              std::string(describe(id).name) +
                                  " does not move: it is done as it is at the first time");
    return isFirst || moves;
}

} // namespace candela
