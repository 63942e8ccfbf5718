// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/stream_expander.h"

#include "interface/rib/condition.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

namespace candela {

static constexpr int maximumArchiveDepth = 64;
/// Archives that read archives twice each grow fast.
static constexpr int maximumNestedReadings = 100000;

/// The same text for all names of a file.
static std::string identityOf(const std::string &path) {
    std::error_code error;
    auto canonical = std::filesystem::weakly_canonical(path, error);
    return error ? path : canonical.string();
}

/// No file has such a name.
static std::string identityOfInline(const std::string &name) { return '\0' + name; }

StreamExpander::StreamExpander(RequestSink &sink, DiagnosticSink &diagnostics, FileReader readFile)
    : sink_(sink), diagnostics_(diagnostics), readFile_(std::move(readFile)),
      conditions_(diagnostics), archives_(diagnostics) {}

void StreamExpander::beginFile(const std::string &path) {
    open_.push_back({identityOf(path), conditions_.depth()});
}

void StreamExpander::endFile() {
    archives_.reportOpen();
    conditions_.closeTo(open_.back().conditions);
    open_.pop_back();
}

// What the archive being defined keeps is judged when that is read.
#define FORWARDED(Name, handler, ...)                                                              \
    void StreamExpander::handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) {    \
        if (archives_.isOpen())                                                                    \
            return archives_.keep(RequestId::Name, [=](StreamSink &sink) {                         \
                sink.handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                                \
            });                                                                                    \
        if (conditions_.skip())                                                                    \
            return;                                                                                \
        sink_.handler(where CANDELA_ARGUMENTS(__VA_ARGS__));                                       \
        archives_.followBlocks(RequestId::Name);                                                   \
    }
#define REQUEST(Name, handler, scopes, ...) FORWARDED(Name, handler, __VA_ARGS__)
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...) FORWARDED(Name, handler, __VA_ARGS__)
#define REQUEST_LATER(Name, handler, scopes, consequence, ...) FORWARDED(Name, handler, __VA_ARGS__)
#include "interface/ri/requests.def"

/// RIB 3.03 and its successors differ in nothing that is read here.
void StreamExpander::version(const SourceLocation &, float) {}

void StreamExpander::archiveBegin(const SourceLocation &where, const std::string &name,
                                  const TokenList &parameters) {
    if (archives_.isOpen())
        archives_.keep(RequestId::ArchiveBegin,
                       [=](StreamSink &sink) { sink.archiveBegin(where, name, parameters); });
    else if (!conditions_.skip())
        archives_.begin(where, name);
}

void StreamExpander::archiveEnd(const SourceLocation &where) {
    if (archives_.isOpen())
        archives_.keep(RequestId::ArchiveEnd, [=](StreamSink &sink) { sink.archiveEnd(where); });
    else if (!conditions_.skip())
        diagnostics_.error(where, "ArchiveEnd without ArchiveBegin");
}

void StreamExpander::readArchive(const SourceLocation &where, const std::string &name,
                                 const TokenList &parameters) {
    if (archives_.isOpen())
        return archives_.keep(RequestId::ReadArchive,
                              [=](StreamSink &sink) { sink.readArchive(where, name, parameters); });
    if (conditions_.skip())
        return;
    if (const auto calls = archives_.find(name)) {
        if (!mayRead(where, name, identityOfInline(name)))
            return;
        open_.push_back({identityOfInline(name), conditions_.depth()});
        for (const InlineArchives::Call &call : *calls)
            if (!stopped())
                call(*this);
        return endFile();
    }
    const auto path = sink_.findArchive(name, where);
    if (!path)
        diagnostics_.error(where,
                           "ReadArchive: there is no archive '" + name +
                               "': none is defined by ArchiveBegin here, and none (a regular "
                               "file) is in the search path \"archive\", beside this file or "
                               "in the current folder");
    else if (mayRead(where, name, identityOf(*path)))
        readFile_(*path);
}

/// Reported if not.
bool StreamExpander::mayRead(const SourceLocation &where, const std::string &name,
                             const std::string &identity) {
    if (std::ranges::find(open_, identity, &Reading::identity) != open_.end())
        diagnostics_.error(where, "ReadArchive: '" + name + "' would read itself without end");
    else if (int(open_.size()) > maximumArchiveDepth)
        diagnostics_.error(where, "ReadArchive: archives are nested more than " +
                                      std::to_string(maximumArchiveDepth) + " deep");
    else if (open_.size() > 1 && ++nestedReadings_ > maximumNestedReadings)
        diagnostics_.error(where, "ReadArchive: '" + name + "' is left out: archives read " +
                                      std::to_string(maximumNestedReadings) + " others already");
    else
        return true;
    return false;
}

bool StreamExpander::holds(const SourceLocation &where, const char *request,
                           const std::string &expression) {
    try {
        return conditionHolds(expression, [&](const std::string &name) { return valueOf(name); });
    } catch (const ConditionError &error) {
        diagnostics_.error(where, std::string(request) + ": '" + expression.substr(0, 100) +
                                      "': " + error.what() + "; it is taken as false");
        return false;
    }
}

void StreamExpander::ifBegin(const SourceLocation &where, const std::string &expression,
                             const TokenList &parameters) {
    if (archives_.isOpen())
        archives_.keep(RequestId::IfBegin,
                       [=](StreamSink &sink) { sink.ifBegin(where, expression, parameters); });
    else
        conditions_.begin(where, [&] { return holds(where, "IfBegin", expression); });
}

void StreamExpander::elseIf(const SourceLocation &where, const std::string &expression,
                            const TokenList &parameters) {
    if (archives_.isOpen())
        archives_.keep(RequestId::ElseIf,
                       [=](StreamSink &sink) { sink.elseIf(where, expression, parameters); });
    else
        conditions_.elseIf(where, "ElseIf", [&] { return holds(where, "ElseIf", expression); });
}

void StreamExpander::otherwise(const SourceLocation &where) {
    if (archives_.isOpen())
        archives_.keep(RequestId::Else, [=](StreamSink &sink) { sink.otherwise(where); });
    else
        conditions_.elseIf(where, "Else", [] { return true; });
}

void StreamExpander::ifEnd(const SourceLocation &where) {
    if (archives_.isOpen())
        archives_.keep(RequestId::IfEnd, [=](StreamSink &sink) { sink.ifEnd(where); });
    else
        conditions_.end(where);
}

} // namespace candela
