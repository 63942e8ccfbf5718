// SPDX-License-Identifier: Apache-2.0
// GraphicsState's requests: from the table, all judged and then run; by hand, those of motion
// blocks.
#include "interface/ri/graphics_state.h"
#include "interface/ri/state_handlers.h"

#include <algorithm>

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
    motionRequest_.reset();
    if (!std::ranges::is_sorted(times.values) || times.values.empty())
        policy_.error(where, "MotionBegin: expected times in increasing order");
    diagnostics_.warnOnce(where, "MotionBegin",
                          "MotionBegin: this version draws moving things where they are at the "
                          "first time");
}

void GraphicsState::motionEnd(const SourceLocation &where) {
    if (admit(RequestId::MotionEnd, where))
        motionRequest_.reset();
}

} // namespace candela
