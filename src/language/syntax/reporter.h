// SPDX-License-Identifier: Apache-2.0
// Where the stages of the front end report to: counts errors, says nothing twice, and stops
// talking when a file is hopeless.
#pragma once

#include <set>
#include <string>
#include <tuple>

#include "language/syntax/source.h"

namespace candela::sl {

class Reporter {
public:
    /// `tellsHints`: false, and hints are not told.
    explicit Reporter(DiagnosticSink &sink, bool tellsHints = true)
        : sink_(sink), tellsHints_(tellsHints) {}

    void error(const Place &, std::string message);
    void warning(const Place &, std::string message);
    /// A warning that is told once for all places where it holds.
    void warnOnce(const Place &, const std::string &message);
    /// A warning for the shader's author alone: the text may be meant as it stands.
    void hint(const Place &, std::string message);

    int errorCount() const { return errors_; }
    /// So many errors that the rest would only be noise.
    bool hopeless() const { return errors_ >= errorLimit; }

    static constexpr int errorLimit = 100;
    static constexpr int warningLimit = 100;

private:
    bool isNew(const Place &, const std::string &message);

    DiagnosticSink &sink_;
    bool tellsHints_;
    int errors_ = 0, warnings_ = 0;
    std::set<std::tuple<const SourceFile *, int, int, std::string>> said_;
    std::set<std::string> saidOnce_;
};

} // namespace candela::sl
