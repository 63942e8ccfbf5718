// SPDX-License-Identifier: Apache-2.0
// Does what decides on the stream: reads archives and procedurals in their place, keeps archives
// that are defined in it, leaves out what stands under conditions that do not hold; and hands all
// other requests on.
#pragma once

#include "interface/ri/stream_sink.h"
#include "interface/rib/conditions.h"
#include "interface/rib/inline_archives.h"
#include "interface/rib/procedurals.h"

#include <functional>
#include <string>
#include <vector>

namespace candela {

class StreamExpander final : public StreamSink {
public:
    /// Reads a file and makes its requests to this sink.
    using FileReader = std::function<void(const std::string &path)>;

    /// The sink and the diagnostics must outlive it.
    StreamExpander(RequestSink &sink, DiagnosticSink &diagnostics, FileReader readFile,
                   const ProceduralSettings & = {});

#define REQUEST(Name, handler, scopes, ...)                                                        \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_OF_BLOCKS(Name, handler, scopes, ...)                                              \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_OF_STREAM(Name, handler, scopes, ...)                                              \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#define REQUEST_LATER(Name, handler, scopes, consequence, ...)                                     \
    void handler(const SourceLocation &where CANDELA_PARAMETERS(__VA_ARGS__)) override;
#include "interface/ri/requests.def"

    bool skips() const override { return conditions_.skip() && !archives_.isOpen(); }
    bool stopped() const override { return sink_.stopped(); }
    std::optional<StateValue> valueOf(const std::string &name) const override {
        return sink_.valueOf(name);
    }
    std::optional<std::string> locate(const char *path, const std::string &name,
                                      const SourceLocation &where) const override {
        return sink_.locate(path, name, where);
    }
    std::optional<Matrix4d> cameraFrom(const std::string &system) const override {
        return sink_.cameraFrom(system);
    }
    float detailOf(const std::array<float, 6> &bound) const override {
        return sink_.detailOf(bound);
    }

    // Around the requests of each file, "-" for the standard input. What a file has opened of
    // archives and conditions ends with it.
    void beginFile(const std::string &path);
    void endFile();

private:
    bool holds(const SourceLocation &, const char *request, const std::string &expression);
    void read(const SourceLocation &, const char *request, const std::string &name);
    bool hasReadTooMany(const SourceLocation &, const char *request, const std::string &name);
    bool mayRead(const SourceLocation &, const char *request, const std::string &name,
                 const std::string &identity);
    void expand(const SourceLocation &, const std::string &generator, const Strings &arguments,
                const LooseFloats &bound);
    void runProgram(const SourceLocation &, const Strings &arguments, const LooseFloats &bound);

    RequestSink &sink_;
    DiagnosticSink &diagnostics_;
    FileReader readFile_;
    Conditions conditions_;
    InlineArchives archives_;
    ProceduralPrograms programs_;
    struct Reading {
        std::string identity; ///< The same for all names of a file.
        std::size_t conditions;
    };
    std::vector<Reading> open_; ///< Files and archives that are being read, one in the other.
    int nestedReadings_ = 0;    ///< Archives that archives have asked for so far.
    int deepReadings_ = 0;      ///< Those of them that are far down.
};

} // namespace candela
