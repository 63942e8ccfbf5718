// SPDX-License-Identifier: Apache-2.0
#include "world/shading/shader_messages.h"

#include <cstdio>
#include <mutex>

namespace candela {

ShaderMessages::ShaderMessages(DiagnosticSink &diagnostics) : diagnostics_(diagnostics) {
    callbacks_.context = this;
    // Lines of points that are shaded side by side come in any order but whole: POSIX locks the
    // stream for the time of a call.
    callbacks_.print = [](void *, const char *text) { std::fputs(text, stdout); };
    callbacks_.indexOutside = [](void *context, const char *file, std::int32_t line) {
        static_cast<ShaderMessages *>(context)->indexOutside(file, line);
    };
}

void ShaderMessages::indexOutside(std::string_view file, int line) {
    {
        std::shared_lock lock(mutex_);
        const auto lines = said_.find(file);
        if (lines != said_.end() && lines->second.contains(line))
            return;
    }
    auto name = std::make_shared<const std::string>(file);
    {
        std::lock_guard lock(mutex_);
        if (!said_[*name].insert(line).second)
            return;
    }
    diagnostics_.warning({std::move(name), line},
                         "an index here is outside the array at some points: the nearest element "
                         "is taken");
}

} // namespace candela
