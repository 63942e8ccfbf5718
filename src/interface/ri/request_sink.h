// SPDX-License-Identifier: Apache-2.0
// The requests of the RenderMan Interface as calls: one method each, made from requests.def. The
// graphics state is a sink of them. stream_sink.h adds those that decide what comes.
#pragma once

#include "foundation/base/matrix4d.h"
#include "interface/ri/request_table.h"
#include "interface/ri/request_types.h"

#include <array>
#include <optional>
#include <string>
#include <variant>

namespace candela {

/// Of an option or attribute.
using StateValue = std::variant<double, std::string>;

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

    /// Where the file of that name is (Option "searchpath" `path`, which is "archive" or
    /// "procedural", --archive-path, the folder of the file that asks for it, the current folder);
    /// nothing if nowhere.
    virtual std::optional<std::string> locate(const char *path, const std::string &name,
                                              const SourceLocation &where) const = 0;
    /// How many pixels a box (xMin, xMax, yMin...) of the current space covers: rasterDetail().
    virtual float detailOf(const std::array<float, 6> &bound) const = 0;
    /// From the coordinate system of that name to the camera's: "camera", "world", one that has
    /// been named here, or "current", that of the current transformation. Nothing if there is none.
    virtual std::optional<Matrix4d> cameraFrom(const std::string &system) const = 0;
    /// What conditions call `name`: "Frame", or an attribute or option as "category:name", which
    /// "Attribute:" or "Option:" before it tell apart; the first value of several. Nothing if it is
    /// not set.
    virtual std::optional<StateValue> valueOf(const std::string &name) const = 0;
    /// True after a fatal error, or an error under ErrorHandler "abort": no more requests please.
    virtual bool stopped() const = 0;
};

} // namespace candela
