// SPDX-License-Identifier: Apache-2.0
// The requests of the RenderMan Interface as calls: one method each, made from requests.def.
// Readers (RIB, the C API) call a sink; the graphics state, recorders and writers are sinks.
#pragma once

#include "interface/ri/request_table.h"
#include "interface/ri/request_types.h"

#include <optional>
#include <string>

namespace candela {

class RequestSink {
public:
    virtual ~RequestSink() = default;

#define REQUEST(Name, handler, scopes, ...)                                                        \
    virtual void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) = 0;
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...)                                              \
    virtual void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) = 0;
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    virtual void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) = 0;
#include "interface/ri/requests.def"

    /// Where ReadArchive finds the file of that name (searchpath "archive", --archive-path, the
    /// folder of the file that asks for it, the current folder); nothing if nowhere.
    virtual std::optional<std::string> findArchive(const std::string &name,
                                                   const SourceLocation &where) const = 0;
    /// True after a fatal error, or an error under ErrorHandler "abort": no more requests please.
    virtual bool stopped() const = 0;
};

} // namespace candela
