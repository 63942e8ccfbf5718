// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/inline_archives.h"

#include <algorithm>

namespace candela {

void InlineArchives::begin(const SourceLocation &where, const std::string &name) {
    open_ = std::make_unique<Open>(Open{where, name, {}});
}

void InlineArchives::keep(RequestId id, Call call) {
    if (id == RequestId::ArchiveEnd && open_->inner == 0)
        return end();
    open_->inner += id == RequestId::ArchiveBegin ? 1 : id == RequestId::ArchiveEnd ? -1 : 0;
    open_->calls.push_back(std::move(call));
}

void InlineArchives::end() {
    blocks_.back().archives[open_->name] = std::make_shared<const Calls>(std::move(open_->calls));
    open_.reset();
}

void InlineArchives::reportOpen() {
    if (!open_)
        return;
    diagnostics_.error(open_->where, "ArchiveBegin is never closed by ArchiveEnd in this file; the "
                                     "archive '" +
                                         open_->name + "' is left out");
    open_.reset();
}

std::shared_ptr<const InlineArchives::Calls> InlineArchives::find(const std::string &name) const {
    for (auto block = blocks_.rbegin(); block != blocks_.rend(); ++block)
        if (auto found = block->archives.find(name); found != block->archives.end())
            return found->second;
    return nullptr;
}

void InlineArchives::followBlocks(RequestId id) {
    if (id == RequestId::FrameBegin || id == RequestId::WorldBegin)
        blocks_.push_back({id, {}});
    if (id != RequestId::FrameEnd && id != RequestId::WorldEnd)
        return;
    const RequestId begin =
        id == RequestId::FrameEnd ? RequestId::FrameBegin : RequestId::WorldBegin;
    // The first block is the file's. An end without a beginning closes nothing.
    const auto found = std::find_if(blocks_.rbegin(), blocks_.rend() - 1,
                                    [&](const Block &block) { return block.begin == begin; });
    if (found != blocks_.rend() - 1)
        blocks_.erase(found.base() - 1, blocks_.end());
}

} // namespace candela
