// SPDX-License-Identifier: Apache-2.0
#include "interface/ri/request_diagnostics.h"

#include <algorithm>
#include <cmath>

namespace candela {

void RequestDiagnostics::error(const SourceLocation &where, const char *request,
                               const std::string &message) {
    policy_.error(where, std::string(request) + ": " + message);
}

void RequestDiagnostics::warning(const SourceLocation &where, const char *request,
                                 const std::string &message) {
    policy_.warning(where, std::string(request) + ": " + message);
}

void RequestDiagnostics::warnOnce(const SourceLocation &where, const std::string &about,
                                  const std::string &message) {
    if (isNew(about))
        policy_.warning(where, message);
}

bool RequestDiagnostics::finite(const SourceLocation &where, const char *request,
                                std::initializer_list<float> values) {
    const bool all = std::ranges::all_of(values, [](float value) { return std::isfinite(value); });
    if (!all)
        error(where, request, "expected finite numbers; the request is left out");
    return all;
}

void RequestDiagnostics::clampOpacity(const SourceLocation &where, const char *what,
                                      std::span<float> values) {
    bool beyond = false;
    for (float &value : values) {
        const float within = std::clamp(value, 0.0f, 1.0f);
        beyond |= within != value;
        value = within;
    }
    if (beyond)
        warnOnce(where, std::string("opacity:") + what,
                 std::string(what) + " goes beyond [0,1]; it is taken as 0 or 1 there");
}

} // namespace candela
