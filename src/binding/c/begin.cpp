// SPDX-License-Identifier: Apache-2.0
// Contexts: RiBegin and RiEnd, and what becomes of errors.
#include "binding/c/calls.h"
#include "render/render.h"

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <utility>

using namespace candela;
using namespace candela::c;

RtInt RiLastError = RIE_NOERROR;

namespace candela::c {

namespace {

Context *current = nullptr;
RtErrorHandler handler = RiErrorPrint;
bool isMissed = false; ///< That there is no context has been said.

void tell(RtInt code, RtInt severity, std::string message) {
    RiLastError = code;
    handler(code, severity, message.data());
}

/// Hands what is found on to the program's handler.
class Handled final : public DiagnosticSink {
public:
    void report(const Diagnostic &found) override {
        const RtInt severities[] = {RIE_INFO, RIE_WARNING, RIE_ERROR, RIE_SEVERE};
        tell(RIE_CONSISTENCY, severities[int(found.severity)], format(found));
    }
};

} // namespace

Context::Context() : found_(std::make_unique<Handled>()) {}
Context::~Context() = default;

bool Context::begin(const char *name) {
    RenderSettings settings;
    settings.quiet = true;
    std::string problem;
    session_ = Session::begin(text(name), settings, *found_, problem);
    if (!session_)
        tell(RIE_NOFILE, RIE_ERROR, "RiBegin: '" + text(name) + "' cannot be written: " + problem);
    return session_ != nullptr;
}

void Context::end() {
    const std::string problem = session_->end();
    if (!problem.empty())
        tell(RIE_SYSTEM, RIE_ERROR, "RiEnd: the RIB cannot be written: " + problem);
}

void perform(const char *call, const std::function<void(Context &)> &body) {
    if (!current) {
        if (!std::exchange(isMissed, true))
            tell(RIE_NOTSTARTED, RIE_ERROR,
                 std::string(call) + ": there is no context; RiBegin comes first");
        return;
    }
    try {
        current->beginCall(call);
        body(*current);
    } catch (const std::bad_alloc &) {
        tell(RIE_NOMEM, RIE_SEVERE, std::string(call) + ": there is not enough memory");
    } catch (const std::exception &error) {
        tell(RIE_BUG, RIE_SEVERE, std::string(call) + ": " + error.what());
    }
}

Gathered::Gathered(std::va_list list) {
    for (RtToken token; (token = va_arg(list, RtToken)) != RI_NULL;) {
        tokens_.push_back(token);
        values_.push_back(va_arg(list, RtPointer));
    }
}

} // namespace candela::c

void RiBegin(RtToken name) {
    isMissed = true; // If it fails, that is enough to say.
    try {
        auto context = std::make_unique<Context>();
        current = context->begin(name) ? context.release() : nullptr;
    } catch (const std::exception &error) {
        current = nullptr;
        tell(RIE_SYSTEM, RIE_SEVERE, std::string("RiBegin: ") + error.what());
    }
}

void RiEnd() {
    perform("RiEnd", [](Context &ri) { ri.end(); });
    delete std::exchange(current, nullptr);
    isMissed = false;
}

RtContextHandle RiGetContext() { return current; }

void RiContext(RtContextHandle context) { current = static_cast<Context *>(context); }

void RiErrorIgnore(RtInt, RtInt, char *) {}

void RiErrorPrint(RtInt, RtInt, char *message) { std::fprintf(stderr, "%s\n", message); }

void RiErrorAbort(RtInt code, RtInt severity, char *message) {
    RiErrorPrint(code, severity, message);
    if (severity >= RIE_ERROR)
        std::exit(1);
}

void RiErrorHandler(RtErrorHandler chosen) {
    handler = chosen ? chosen : RiErrorPrint;
    const std::pair<RtErrorHandler, const char *> known[] = {
        {RiErrorIgnore, RI_IGNORE}, {RiErrorPrint, RI_PRINT}, {RiErrorAbort, RI_ABORT}};
    for (const auto &[function, name] : known)
        if (chosen == function && current)
            perform("RiErrorHandler",
                    [&, name = name](Context &ri) { ri.sink().errorHandler(ri.at(), name); });
}
