// SPDX-License-Identifier: Apache-2.0
// Procedural primitives (RI 3.2, 5.7) as part of the stream: what they stand for is read in their
// place. Private to the room.
#pragma once

#include "interface/ri/stream_sink.h"
#include "interface/rib/answering_program.h"

#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace candela {

struct ProceduralSettings {
    bool trusted = false; ///< Programs of others are run.
    AnswerLimits limits;
};

/// The programs of RunProgram. One that has answered waits for its next line.
class ProceduralPrograms {
public:
    ProceduralPrograms(DiagnosticSink &diagnostics, const ProceduralSettings &settings)
        : diagnostics_(diagnostics), settings_(settings) {}

    /// Sends a line to the program that a command names (a file, and arguments between blanks) and
    /// reads its answer into the sink. What goes wrong is reported.
    void run(const SourceLocation &, const std::string &command, const std::string &line,
             StreamSink &);

private:
    using Program = std::unique_ptr<AnsweringProgram>;
    Program take(const SourceLocation &, const std::string &command, const StreamSink &);
    void read(const SourceLocation &, const std::string &command, AnsweringProgram &, StreamSink &);
    void error(const SourceLocation &, const std::string &command, const std::string &problem);

    DiagnosticSink &diagnostics_;
    ProceduralSettings settings_;
    std::map<std::string, std::vector<Program>> waiting_; ///< By their commands.
    std::set<std::string> bad_;                           ///< Not to be asked again.
    bool refused_ = false;                                ///< Said once.
};

} // namespace candela
