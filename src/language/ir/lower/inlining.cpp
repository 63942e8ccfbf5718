// SPDX-License-Identifier: Apache-2.0
#include "language/ir/lower/inlining.h"

#include "language/ir/lower/lowering.h"

#include <fmt/format.h>

namespace candela::ir {

namespace {

/// "a() calls b() calls c()": the bodies that are being written, at most the first and last few.
std::string chainOf(const Lowering &lowering) {
    constexpr size_t shown = 3;
    std::string chain;
    const size_t count = lowering.frames.size();
    for (size_t k = 1; k < count; ++k) { // The first frame is the shader.
        if (k > shown && k + shown < count) {
            chain += " calls ...";
            k = count - shown - 1;
            continue;
        }
        chain += (k > 1 ? " calls " : "") + lowering.frames[k].function->name + "()";
    }
    return chain;
}

/// Instructions of the body that is being written once more.
size_t copiedNow(const Lowering &lowering) {
    const auto start = lowering.inlining.copyStart;
    return start ? *start - lowering.b.budget().left() : 0;
}

void refuse(Lowering &lowering, const sl::Place &where) {
    const std::string chain = chainOf(lowering);
    if (chain.empty())
        lowering.messages.error(
            where, fmt::format("the shader is too large to compile: here it comes to more than {} "
                               "operations; make it shorter, or move what repeats into a loop",
                               mostInstructions));
    else
        lowering.messages.error(
            where, fmt::format("the shader is too large to compile: each call of a function writes "
                               "its body once more, and these come to more than {} operations "
                               "where {}; call them in a loop, or less often",
                               mostCopied, chain));
}

} // namespace

bool isTooLarge(Lowering &lowering, const sl::Place &where) {
    Inlining &inlining = lowering.inlining;
    inlining.visited += inlining.copyStart ? 1 : 0;
    if (!inlining.refused &&
        (lowering.b.budget().exceeded() || inlining.visited > 16 * mostCopied ||
         inlining.copied + copiedNow(lowering) > mostCopied)) {
        inlining.refused = true;
        refuse(lowering, where);
        lowering.messages.close();
    }
    return inlining.refused;
}

BodyScope::BodyScope(Lowering &lowering, const sl::Function &function) : lowering_(lowering) {
    Inlining &inlining = lowering.inlining;
    const bool isNew = inlining.seen.insert(&function).second;
    outermost_ = !isNew && !inlining.copyStart;
    if (outermost_)
        inlining.copyStart = lowering.b.budget().left();
}

BodyScope::~BodyScope() {
    if (!outermost_)
        return;
    lowering_.inlining.copied += copiedNow(lowering_);
    lowering_.inlining.copyStart.reset();
}

} // namespace candela::ir
