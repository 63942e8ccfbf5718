// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/stream_expander.h"

#include "interface/rib/condition.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

namespace candela {

static constexpr int maximumArchiveDepth = 64;
/// Archives that read archives twice each grow fast, all the more the deeper they go. What is
/// refused counts too: it has been looked for.
static constexpr int maximumNestedReadings = 100000, maximumDeepReadings = 10000;
static constexpr std::size_t deepFrom = 8;

/// The same text for all names of a file.
static std::string identityOf(const std::string &path) {
    std::error_code error;
    auto canonical = std::filesystem::weakly_canonical(path, error);
    return error ? path : canonical.string();
}

/// No file has such a name.
static std::string identityOfInline(const std::string &name) { return '\0' + name; }

StreamExpander::StreamExpander(RequestSink &sink, DiagnosticSink &diagnostics, FileReader readFile,
                               const ProceduralSettings &procedurals)
    : sink_(sink), diagnostics_(diagnostics), readFile_(std::move(readFile)),
      conditions_(diagnostics), archives_(diagnostics), programs_(diagnostics, procedurals) {}

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
    if (!conditions_.skip())
        read(where, "ReadArchive", name);
}

/// The archive of that name, in this place.
void StreamExpander::read(const SourceLocation &where, const char *request,
                          const std::string &name) {
    if (hasReadTooMany(where, request, name))
        return;
    if (const auto calls = archives_.find(name)) {
        if (!mayRead(where, request, name, identityOfInline(name)))
            return;
        open_.push_back({identityOfInline(name), conditions_.depth()});
        for (const InlineArchives::Call &call : *calls)
            if (!stopped())
                call(*this);
        return endFile();
    }
    const auto path = sink_.locate("archive", name, where);
    if (!path)
        diagnostics_.error(where,
                           std::string(request) + ": there is no archive '" + name +
                               "': none is defined by ArchiveBegin here, and none (a regular "
                               "file) is in the search path \"archive\", beside this file or "
                               "in the current folder");
    else if (mayRead(where, request, name, identityOf(*path)))
        readFile_(*path);
}

/// Reported if so, once: millions may follow.
bool StreamExpander::hasReadTooMany(const SourceLocation &where, const char *request,
                                    const std::string &name) {
    if (open_.size() < 2)
        return false;
    const bool isDeep = open_.size() > deepFrom;
    const int most = isDeep ? maximumDeepReadings : maximumNestedReadings;
    int &readings = isDeep ? deepReadings_ : nestedReadings_;
    if (readings < most)
        return ++readings, false;
    if (readings++ == most)
        diagnostics_.error(where,
                           std::string(request) + ": '" + name +
                               "' and others behind it are left out: archives have asked for " +
                               std::to_string(most) + " others already" +
                               (isDeep ? ", " + std::to_string(deepFrom) + " deep and more" : ""));
    readings = most + 1;
    return true;
}

/// Reported if not.
bool StreamExpander::mayRead(const SourceLocation &where, const char *request,
                             const std::string &name, const std::string &identity) {
    const std::string what = std::string(request) + ": '" + name + "'";
    if (std::ranges::find(open_, identity, &Reading::identity) != open_.end())
        diagnostics_.error(where, what + " would read itself without end");
    else if (int(open_.size()) > maximumArchiveDepth)
        diagnostics_.error(where, what + " is left out: archives are nested more than " +
                                      std::to_string(maximumArchiveDepth) + " deep");
    else
        return true;
    return false;
}

void StreamExpander::procedural(const SourceLocation &where, const std::string &generator,
                                const Strings &arguments, const LooseFloats &bound) {
    if (archives_.isOpen())
        archives_.keep(RequestId::Procedural, [=](StreamSink &sink) {
            sink.procedural(where, generator, arguments, bound);
        });
    else if (!conditions_.skip())
        expand(where, generator, arguments, bound);
}

/// PRMan's second form, whose arguments are parameters.
void StreamExpander::procedural2(const SourceLocation &where, const std::string &generator,
                                 const std::string &boundGenerator, const TokenList &parameters) {
    if (archives_.isOpen())
        return archives_.keep(RequestId::Procedural2, [=](StreamSink &sink) {
            sink.procedural2(where, generator, boundGenerator, parameters);
        });
    if (conditions_.skip())
        return;
    const auto file = std::ranges::find_if(parameters.all, [](const TokenValue &parameter) {
        return parameter.token == "filename" || parameter.token.ends_with(" filename");
    });
    if (generator != "DelayedReadArchive2")
        diagnostics_.error(where, "Procedural2: '" + generator +
                                      "' is unknown: expected \"DelayedReadArchive2\"; the "
                                      "primitive is left out");
    else if (file == parameters.all.end() || file->strings.size() != 1)
        diagnostics_.error(where, "Procedural2: expected \"string filename\" and a name; the "
                                  "primitive is left out");
    else
        expand(where, "DelayedReadArchive", file->strings, {});
}

/// In an attribute block: a primitive changes nothing around it.
void StreamExpander::expand(const SourceLocation &where, const std::string &generator,
                            const Strings &arguments, const LooseFloats &bound) {
    const bool archive = generator == "DelayedReadArchive";
    if (generator == "DynamicLoad")
        return diagnostics_.warning(where, "Procedural: \"DynamicLoad\" asks for machine code of "
                                           "another renderer, which cannot be run here; the "
                                           "primitive is left out");
    if (!archive && generator != "RunProgram")
        return diagnostics_.error(where, "Procedural: '" + generator +
                                             "' is unknown: expected \"DelayedReadArchive\" or "
                                             "\"RunProgram\"; the primitive is left out");
    if (arguments.empty())
        return diagnostics_.error(where, "Procedural: expected the name of " +
                                             std::string(archive ? "an archive" : "a program") +
                                             "; the primitive is left out");
    sink_.attributeBegin(where);
    if (archive)
        read(where, "DelayedReadArchive", arguments.front());
    else
        runProgram(where, arguments, bound);
    sink_.attributeEnd(where);
}

void StreamExpander::runProgram(const SourceLocation &where, const Strings &arguments,
                                const LooseFloats &bound) {
    // Programs may ask for themselves, with other arguments: depth and number bound that.
    const std::string identity = "\0program " + std::to_string(open_.size());
    if (!mayRead(where, "RunProgram", arguments.front(), identity))
        return;
    std::array<float, 6> box{};
    float detail = std::numeric_limits<float>::infinity();
    if (bound.values.size() == box.size()) {
        std::ranges::copy(bound.values, box.begin());
        detail = detailOf(box);
    }
    // RI_INFINITY
    const std::string size = std::to_string(std::min(detail, 1e30f));
    open_.push_back({identity, conditions_.depth()});
    programs_.run(where, arguments.front(), size + " " + (arguments.size() > 1 ? arguments[1] : ""),
                  *this);
    endFile();
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
