// SPDX-License-Identifier: Apache-2.0
#include "render/probe_answers.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <unistd.h>

namespace candela {

namespace {
constexpr int pointColumns = 6, answerColumns = colorSamples + 4;
}

AnswerStream::AnswerStream() {
    std::fflush(stdout);
    file_ = dup(STDOUT_FILENO);
    dup2(STDERR_FILENO, STDOUT_FILENO);
}

AnswerStream::~AnswerStream() {
    std::fflush(stdout);
    dup2(file_, STDOUT_FILENO);
    close(file_);
}

bool AnswerStream::write(const std::string &text) {
    for (std::size_t done = 0; problem_.empty() && done < text.size();) {
        const ssize_t wrote = ::write(file_, text.data() + done, text.size() - done);
        if (wrote >= 0)
            done += std::size_t(wrote);
        else if (errno != EINTR)
            problem_ = std::strerror(errno);
    }
    return problem_.empty();
}

std::string answerHeader(AnswerFormat format, ProbeQuantity quantity) {
    if (format == AnswerFormat::Plain)
        return "";
    return quantity == ProbeQuantity::Irradiance
               ? "x,y,z,nx,ny,nz,E_R,E_G,E_B,E_total,lx,lx_half_width,samples\n"
               : "x,y,z,dx,dy,dz,L_R,L_G,L_B,L_total,cd_m2,cd_m2_half_width,samples\n";
}

std::string answerLine(AnswerFormat format, const ProbePoint &point, const ProbeAnswer &answer) {
    const char *comma = format == AnswerFormat::Csv ? "," : " ";
    std::string text;
    const auto add = [&](double value, const char *pattern) {
        text += (text.empty() ? "" : comma) + fmt::format(fmt::runtime(pattern), value);
    };
    if (format == AnswerFormat::Csv)
        for (const auto &triple : {point.P, point.direction})
            for (double value : triple)
                add(value, "{}");
    for (double value : answer.value)
        add(value, "{:.7g}");
    add(totalOf(answer), "{:.7g}");
    add(answer.photometric, "{:.7g}");
    add(answer.halfWidth, "{:.3g}");
    return text + comma + std::to_string(answer.samples) + "\n";
}

std::string missingAnswer(AnswerFormat format) {
    const char *comma = format == AnswerFormat::Csv ? "," : " ";
    const int columns = answerColumns + (format == AnswerFormat::Csv ? pointColumns : 0);
    std::string text = "nan";
    for (int k = 2; k < columns; ++k)
        text += std::string(comma) + "nan";
    return text + comma + "0\n";
}

double totalOf(const ProbeAnswer &answer) {
    double sum = 0;
    for (double value : answer.value)
        sum += value;
    return sum / colorSamples;
}

} // namespace candela
