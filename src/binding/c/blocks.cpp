// SPDX-License-Identifier: Apache-2.0
// Blocks, archives, conditions, handles and what else gives something back.
#include "binding/c/calls.h"

using namespace candela;
using namespace candela::c;

// clang-format off
RI_PLAIN(TransformBegin, (), transformBegin(ri.at()))
RI_PLAIN(TransformEnd, (), transformEnd(ri.at()))
RI_PLAIN(ResourceBegin, (), resourceBegin(ri.at()))
RI_PLAIN(ResourceEnd, (), resourceEnd(ri.at()))
RI_LISTED(Resource, type, (RtToken handle, RtToken type), (handle, type), resource(ri.at(), text(handle), text(type), ri.list(single, {n, tokens, values})))
RI_PLAIN(ObjectInstance, (RtObjectHandle handle), objectInstance(ri.at(), ri.nameOf(handle)))
RI_PLAIN(MotionBeginV, (RtInt n, const RtFloat *times), motionBegin(ri.at(), {floats(n, times)}))
RI_PLAIN(MotionEnd, (), motionEnd(ri.at()))
RI_PLAIN(ArchiveEnd, (), archiveEnd(ri.at()))
RI_LISTED(IfBegin, expression, (RtToken expression), (expression), ifBegin(ri.at(), text(expression), ri.list(single, {n, tokens, values})))
RI_LISTED(ElseIf, expression, (RtToken expression), (expression), elseIf(ri.at(), text(expression), ri.list(single, {n, tokens, values})))
RI_PLAIN(Else, (), otherwise(ri.at()))
RI_PLAIN(IfEnd, (), ifEnd(ri.at()))

// The steps of bases go with blocks that save attributes.
#define RI_OPENING(Name, PARAMETERS, ...)                                                          \
    void Ri##Name PARAMETERS {                                                                     \
        perform("Ri" #Name, [&](Context &ri) { ri.sink().__VA_ARGS__; ri.openBlock(); });          \
    }
#define RI_CLOSING(Name, ...)                                                                      \
    void Ri##Name() {                                                                              \
        perform("Ri" #Name, [&](Context &ri) { ri.sink().__VA_ARGS__; ri.closeBlock(); });         \
    }
RI_OPENING(FrameBegin, (RtInt number), frameBegin(ri.at(), number))
RI_CLOSING(FrameEnd, frameEnd(ri.at()))
RI_OPENING(WorldBegin, (), worldBegin(ri.at()))
RI_CLOSING(WorldEnd, worldEnd(ri.at()))
RI_OPENING(AttributeBegin, (), attributeBegin(ri.at()))
RI_CLOSING(AttributeEnd, attributeEnd(ri.at()))
RI_OPENING(SolidBegin, (RtToken operation), solidBegin(ri.at(), text(operation)))
RI_CLOSING(SolidEnd, solidEnd(ri.at()))
RI_CLOSING(ObjectEnd, objectEnd(ri.at()))
// clang-format on

RtObjectHandle RiObjectBegin() {
    RtObjectHandle result = nullptr;
    perform("RiObjectBegin", [&](Context &ri) {
        result = ri.newHandle();
        ri.sink().objectBegin(ri.at(), ri.nameOf(result));
        ri.openBlock();
    });
    return result;
}

void RiMotionBegin(RtInt n, ...) {
    std::va_list arguments;
    va_start(arguments, n);
    Floats times;
    for (RtInt i = 0; i < n; ++i)
        times.push_back(float(va_arg(arguments, double)));
    va_end(arguments);
    RiMotionBeginV(n, times.data());
}

RtToken RiDeclare(RtToken name, RtToken declaration) {
    perform("RiDeclare", [&](Context &ri) { ri.declare(text(name), text(declaration)); });
    return name;
}

// Lights (RI 3.2, 4.2.3)
using LightRequest = void (RequestSink::*)(const SourceLocation &, const std::string &,
                                           const Handle &, const TokenList &);
static RtLightHandle addLight(const char *call, LightRequest request, RtToken name, RtToken handle,
                              const Parameters &parameters) {
    RtLightHandle result = nullptr;
    perform(call, [&](Context &ri) {
        result = ri.newHandle(handle);
        (ri.sink().*request)(ri.at(), text(name), ri.nameOf(result), ri.list(single, parameters));
    });
    return result;
}

RtLightHandle RiLightSourceV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]) {
    return addLight("RiLightSource", &RequestSink::lightSource, name, RI_NULL, {n, tokens, values});
}
RtLightHandle RiLightSource(RtToken name, ...) {
    RI_GATHER(name);
    return RiLightSourceV(name, given.count(), given.tokens(), given.values());
}
RtLightHandle RiAreaLightSourceV(RtToken name, RtInt n, RtToken tokens[], RtPointer values[]) {
    return addLight("RiAreaLightSource", &RequestSink::areaLightSource, name, RI_NULL,
                    {n, tokens, values});
}
RtLightHandle RiAreaLightSource(RtToken name, ...) {
    RI_GATHER(name);
    return RiAreaLightSourceV(name, given.count(), given.tokens(), given.values());
}
RtLightHandle RiLightV(RtToken name, RtToken handle, RtInt n, RtToken tokens[],
                       RtPointer values[]) {
    return addLight("RiLight", &RequestSink::light, name, handle, {n, tokens, values});
}
RtLightHandle RiLight(RtToken name, RtToken handle, ...) {
    RI_GATHER(handle);
    return RiLightV(name, handle, given.count(), given.tokens(), given.values());
}
