// SPDX-License-Identifier: Apache-2.0
// The answers of `candela probe`, a line each.
#pragma once

#include "light/probe/probe.h"

#include <optional>
#include <string>

namespace candela {

/// Writes whole texts to standard output. What shaders print meanwhile goes to standard error, so
/// that lines are answers.
class AnswerStream {
public:
    AnswerStream();
    ~AnswerStream();
    AnswerStream(const AnswerStream &) = delete;

    /// False if it cannot be written (and never again): problem() says why.
    bool write(const std::string &text);
    const std::string &problem() const { return problem_; }

private:
    int file_;
    std::string problem_;
};

/// How answers look. Plain: "R G B total photometric half-width samples", as rtrace has it at
/// first; CSV: a row of names, and rows of the point, the direction and these.
enum class AnswerFormat { Plain, Csv };

/// The row of names, or nothing.
std::string answerHeader(AnswerFormat, ProbeQuantity);
std::string answerLine(AnswerFormat, const ProbePoint &, const ProbeAnswer &);
/// In the place of an answer to what was no point.
std::string missingAnswer(AnswerFormat);

/// The mean of all samples of the value: what totalradiance() makes of a radiance.
double totalOf(const ProbeAnswer &);

} // namespace candela
