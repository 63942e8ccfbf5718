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
    explicit Reporter(DiagnosticSink &sink) : sink_(sink) {}

    void error(const Place &, std::string message);
    void warning(const Place &, std::string message);

    int errorCount() const { return errors_; }
    /// So many errors that the rest would only be noise.
    bool hopeless() const { return errors_ >= errorLimit; }

    static constexpr int errorLimit = 100;
    static constexpr int warningLimit = 100;

private:
    bool isNew(const Place &, const std::string &message);

    DiagnosticSink &sink_;
    int errors_ = 0, warnings_ = 0;
    std::set<std::tuple<const SourceFile *, int, int, std::string>> said_;
};

} // namespace candela::sl
