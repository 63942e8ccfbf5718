// SPDX-License-Identifier: Apache-2.0
// Archives that stand in the stream itself, between ArchiveBegin and ArchiveEnd: kept as calls,
// made again by ReadArchive. Private to the room.
#pragma once

#include "foundation/base/diagnostics.h"
#include "interface/ri/request_table.h"
#include "interface/ri/stream_sink.h"

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace candela {

class InlineArchives {
public:
    using Call = std::function<void(StreamSink &)>;
    using Calls = std::vector<Call>;

    explicit InlineArchives(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {}

    /// One is being defined: what comes belongs to it.
    bool isOpen() const { return open_ != nullptr; }
    void begin(const SourceLocation &, const std::string &name);
    /// An archive in the open one counts as part of it, and is defined when that is read.
    void keep(RequestId, Call);
    /// The name means this archive from here on, up to the end of the frame or world.
    void end();
    /// At the end of the file that holds its beginning.
    void reportOpen();

    /// The archive of that name, or null.
    std::shared_ptr<const Calls> find(const std::string &name) const;
    /// Frames and worlds take what was defined in them along.
    void followBlocks(RequestId);

private:
    struct Open {
        SourceLocation where;
        std::string name;
        Calls calls;
        int inner = 0; ///< Archives in it that are open.
    };
    struct Block {
        RequestId begin; ///< FrameBegin or WorldBegin.
        std::map<std::string, std::shared_ptr<const Calls>> archives;
    };
    DiagnosticSink &diagnostics_;
    std::unique_ptr<Open> open_;
    std::vector<Block> blocks_{Block{RequestId::FrameBegin, {}}};
};

} // namespace candela
