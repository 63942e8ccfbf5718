// SPDX-License-Identifier: Apache-2.0
#include "interface/rib/procedurals.h"

#include "interface/rib/request_reader.h"

#include <fstream>
#include <sstream>
#include <unistd.h>
#include <utility>

namespace candela {

void ProceduralPrograms::error(const SourceLocation &where, const std::string &command,
                               const std::string &problem) {
    diagnostics_.error(where, "RunProgram: '" + command + "': " + problem);
}

void ProceduralPrograms::run(const SourceLocation &where, const std::string &command,
                             const std::string &line, StreamSink &sink) {
    if (!settings_.trusted) {
        if (!std::exchange(refused_, true))
            error(where, command,
                  "files run programs with --trust alone; what these would draw is left out");
        return;
    }
    if (bad_.contains(command))
        return;
    Program program = take(where, command, sink);
    std::string why;
    if (!program)
        return;
    if (program->ask(line + "\n", why))
        read(where, command, *program, sink);
    else
        error(where, command, why);
    if (program->isBad())
        bad_.insert(command);
    else if (!program->isDone() && !sink.stopped())
        waiting_[command].push_back(std::move(program));
}

/// A script that is not executable is given to the interpreter that it names.
static void prependInterpreter(std::vector<std::string> &words) {
    if (access(words.front().c_str(), X_OK) == 0)
        return;
    std::string first, word;
    std::getline(std::ifstream(words.front()), first);
    if (!first.starts_with("#!"))
        return;
    std::istringstream interpreter(first.substr(2));
    std::vector<std::string> before;
    while (interpreter >> word)
        before.push_back(word);
    words.insert(words.begin(), before.begin(), before.end());
}

/// One that waits, or a new one; reported if there is none.
ProceduralPrograms::Program ProceduralPrograms::take(const SourceLocation &where,
                                                     const std::string &command,
                                                     const StreamSink &sink) {
    std::vector<Program> &waiting = waiting_[command];
    if (!waiting.empty()) {
        Program program = std::move(waiting.back());
        waiting.pop_back();
        return program;
    }
    std::istringstream text(command);
    std::vector<std::string> words;
    for (std::string word; text >> word;)
        words.push_back(word);
    const auto file = words.empty() ? std::optional<std::string>()
                                    : sink.locate("procedural", words.front(), where);
    std::string why =
        "there is no such file in the search path \"procedural\", beside this file or "
        "in the current folder";
    if (file) {
        words.front() = file->find('/') == std::string::npos ? "./" + *file : *file;
        prependInterpreter(words);
        if (Program program = AnsweringProgram::start(words, settings_.limits, why))
            return program;
    }
    bad_.insert(command);
    error(where, command, why);
    return nullptr;
}

void ProceduralPrograms::read(const SourceLocation &where, const std::string &command,
                              AnsweringProgram &program, StreamSink &sink) {
    auto bytes = [&program](char *to, std::size_t most, std::string &failure) {
        return program.read(to, most, failure);
    };
    Lexer lexer(std::make_unique<ByteSource>(bytes), "answer of " + command, diagnostics_);
    lexer.endAtMark();
    RequestReader(std::move(lexer), sink, diagnostics_).run();
    if (!program.isDone() || program.isBad())
        return;
    if (const std::string verdict = program.verdict(); !verdict.empty())
        error(where, command, verdict);
}

} // namespace candela
