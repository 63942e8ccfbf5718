// SPDX-License-Identifier: Apache-2.0
// Archives and procedural primitives.
#include "binding/c/calls.h"
#include "binding/c/comment_listener.h"
#include "interface/rib/rib_stream.h"

#include <array>
#include <cstdio>
#include <cstdlib>

using namespace candela;
using namespace candela::c;

void RiReadArchiveV(RtToken name, RtArchiveCallback callback, RtInt n, RtToken tokens[],
                    RtPointer values[]) {
    perform("RiReadArchive", [&](Context &ri) {
        const auto file = callback && !ri.sink().skips()
                              ? ri.sink().locate("archive", text(name), ri.at())
                              : std::nullopt;
        if (!file) // RIB that is written keeps the request; what has been recorded has no comments.
            return ri.sink().readArchive(ri.at(), text(name), ri.list(single, {n, tokens, values}));
        CommentListener listener(ri.sink(), callback);
        readRibFile(*file, listener, ri.diagnostics());
    });
}

void RiReadArchive(RtToken name, RtArchiveCallback callback, ...) {
    RI_GATHER(callback);
    RiReadArchiveV(name, callback, given.count(), given.tokens(), given.values());
}

RtToken RiArchiveBeginV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]) {
    perform("RiArchiveBegin", [&](Context &ri) {
        ri.sink().archiveBegin(ri.at(), text(name), ri.list(single, {n, tokens, values}));
    });
    return name;
}

RtToken RiArchiveBegin(RtToken name, ...) {
    RI_GATHER(name);
    return RiArchiveBeginV(name, given.count(), given.tokens(), given.values());
}

/// As printf() would print it.
static std::string formatted(const char *format, std::va_list arguments) {
    std::va_list again;
    va_copy(again, arguments);
    const int length = std::vsnprintf(nullptr, 0, format, again);
    va_end(again);
    std::string result(std::size_t(std::max(length, 0)) + 1, '\0');
    std::vsnprintf(result.data(), result.size(), format, arguments);
    result.pop_back();
    return result;
}

void RiArchiveRecord(RtToken type, RtToken format, ...) {
    std::va_list arguments;
    va_start(arguments, format);
    std::string record = formatted(format ? format : "", arguments);
    va_end(arguments);
    perform("RiArchiveRecord",
            [&](Context &ri) { ri.session().record(ri.at(), text(type), std::move(record)); });
}

// The standard's own procedurals have their arguments as strings.
static void standardProcedural(const char *call, const char *generator, RtPointer data,
                               RtInt strings, const RtFloat *bound) {
    perform(call, [&](Context &ri) {
        ri.sink().procedural(ri.at(), generator, texts(strings, static_cast<const RtToken *>(data)),
                             {floats(6, bound)});
    });
}

void RiProcDelayedReadArchive(RtPointer data, RtFloat) {
    standardProcedural("RiProcDelayedReadArchive", "DelayedReadArchive", data, 1, nullptr);
}

void RiProcRunProgram(RtPointer data, RtFloat) {
    standardProcedural("RiProcRunProgram", "RunProgram", data, 2, nullptr);
}

void RiProcDynamicLoad(RtPointer data, RtFloat) {
    standardProcedural("RiProcDynamicLoad", "DynamicLoad", data, 2, nullptr);
}

void RiProcFree(RtPointer data) { std::free(data); }

void RiProcedural(RtPointer data, const RtBound bound, RtProcSubdivFunc subdivide,
                  RtProcFreeFunc release) {
    if (subdivide == RiProcDelayedReadArchive) {
        standardProcedural("RiProcedural", "DelayedReadArchive", data, 1, bound);
    } else if (subdivide == RiProcRunProgram) {
        standardProcedural("RiProcedural", "RunProgram", data, 2, bound);
    } else if (subdivide == RiProcDynamicLoad) {
        standardProcedural("RiProcedural", "DynamicLoad", data, 2, bound);
    } else if (subdivide) {
        float detail = RI_INFINITY;
        perform("RiProcedural", [&](Context &ri) {
            std::array<float, 6> box{};
            std::copy(bound, bound + 6, box.begin());
            detail = std::min(ri.sink().detailOf(box), RI_INFINITY);
        });
        RiAttributeBegin();
        subdivide(data, detail);
        RiAttributeEnd();
    }
    if (release)
        release(data);
}
