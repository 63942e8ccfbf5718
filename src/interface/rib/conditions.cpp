// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/conditions.h"

#include <string>
#include <string_view>

namespace candela {

static constexpr std::size_t maximumNesting = 10000;

void Conditions::begin(const SourceLocation &where, const std::function<bool()> &holds) {
    if (blocks_.size() == maximumNesting) {
        if (uncounted_++ == 0)
            diagnostics_.error(where, "IfBegin: conditions are nested more than " +
                                          std::to_string(maximumNesting) +
                                          " deep; what stands there is left out");
        blocks_.back().runs = false;
        return;
    }
    const bool skipped = skip();
    const bool runs = !skipped && holds();
    blocks_.push_back({where, runs, skipped || runs});
}

void Conditions::elseIf(const SourceLocation &where, const char *request,
                        const std::function<bool()> &holds) {
    if (uncounted_ > 0)
        return;
    if (blocks_.empty())
        return diagnostics_.error(where, std::string(request) + " without IfBegin");
    Block &block = blocks_.back();
    if (block.sawElse)
        diagnostics_.error(where, std::string(request) + " after the Else of the IfBegin at " +
                                      block.where.text() + "; what stands there is left out");
    block.runs = !block.wasRun && !block.sawElse && holds();
    block.wasRun |= block.runs;
    block.sawElse |= request == std::string_view("Else");
}

void Conditions::end(const SourceLocation &where) {
    if (uncounted_ > 0)
        --uncounted_;
    else if (blocks_.empty())
        diagnostics_.error(where, "IfEnd without IfBegin");
    else
        blocks_.pop_back();
}

void Conditions::closeTo(std::size_t depth) {
    uncounted_ = 0;
    for (; blocks_.size() > depth; blocks_.pop_back())
        diagnostics_.error(blocks_.back().where, "IfBegin is never closed by IfEnd in this file");
}

} // namespace candela
